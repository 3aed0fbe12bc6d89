"""`tmm-report assemblies`: every way to put a mechanism together is listed, drawn, and chosen by its own sketch."""

from __future__ import annotations

import json
import re
import subprocess
from dataclasses import replace
from math import pi
from xml.etree import ElementTree

import browser
import numpy as np
import pytest
from conftest import FILES, read, stating
from notes import VARIANTS, program
from payloads import PAYLOADS
from typer.testing import CliRunner

from tmm_report import course, yamlread
from tmm_report.chapters.title.given import Title
from tmm_report.cli import app
from tmm_report.commands.assemblies.page import page
from tmm_report.commands.assemblies.ways import MOST, Assemblies, find
from tmm_report.i18n import Translator
from tmm_report.languages import LANGUAGES
from tmm_report.loading import loads

NAMES = [file.stem for file in FILES]
WAY = re.compile(r"^(\d+)(.*)\n  (sketch: \{.*\})$", re.M)

# A class III group with revolute pairs, data our own, found by trying: with the crank at 30° all six roots are real.
SIX = """\
language: en
mechanism:
  frame: {O: [0, 0], P: [160 mm, 90 mm], Q: [-40 mm, 160 mm]}
  links:
    1: {points: {O: 0, A: 20 mm}}
    2: {points: {A: 0, B: 220 mm}}
    3: {points: {B: 0, C: 150 mm, D: [-50 mm, -130 mm]}}
    4: {points: {P: 0, C: 230 mm}}
    5: {points: {Q: 0, D: 210 mm}}
  driver: {link: 1, speed: 60 rpm, zero: {angle: 30 deg}}
"""


def run(*arguments: object):
    return CliRunner().invoke(app, ["assemblies", *map(str, arguments)], env={"LANG": "C", "LC_ALL": "C"})


def stated(variant_text: str, sketch: str) -> course.Variant:
    """The variant with the line of a way instead of what it says of its assembly."""
    data = yamlread.loads(variant_text).data
    data["mechanism"] |= yamlread.loads(sketch).data | {"assembly": {}}
    return loads(json.dumps(data, ensure_ascii=False))


def unstated(variant: course.Variant) -> course.Variant:
    return stating(variant, mechanism=replace(variant.lever.mechanism, assembly=(), sketch={}))


def broken_lengths(found: Assemblies) -> list[tuple[int, str, float]]:
    """Links whose points are not where a rigid body has them, and slides off their guides: way, name, m."""
    wrong = []
    for number, way in enumerate(found.ways, 1):
        turns = {"0": 1.0, **way.turns}
        origins = {}
        for name, link in found.mechanism.links.items():
            places = np.array([way.places[p] - turns[name] * at for p, at in link.points.items()])
            origins[name] = places[0]
            wrong.append((number, name, float(np.abs(places - places[0]).max())))
        for slide in found.mechanism.slides:
            guide = found.mechanism.guides[slide.guide]
            along = turns[guide.link] * guide.direction
            foot = origins[guide.link] + turns[guide.link] * guide.through
            off = origins[slide.link] + turns[slide.link] * slide.through - foot
            turned = turns[slide.link] * slide.direction / along
            wrong += [(number, slide.guide, abs((off / along).imag)), (number, slide.guide, abs(turned.imag))]
    return [(number, name, off) for number, name, off in wrong if off > 1e-9]


def gaps(found: Assemblies) -> list[float]:
    """The greatest distance between the same points of two ways, m, of every two."""
    points = np.array([list(way.places.values()) for way in found.ways])
    return [float(np.abs(a - b).max()) for k, a in enumerate(points) for b in points[:k]]


def test_the_press_has_four_ways_and_its_own_sketch_chooses_one(tmp_path):
    done = run(VARIANTS / "press.yaml", "-o", tmp_path, "--lang", "en")
    assert done.exit_code == 0, done.output
    assert "I(0,1) → IV2(2,3,4,5)\nDriving link 1 at 90°; ways to assemble the mechanism: 4.\n" in done.output
    listed = WAY.findall(done.output)
    assert [number for number, _, _ in listed] == ["1", "2", "3", "4"]
    ((marked, sketch),) = [(mark, sketch) for _, mark, sketch in listed if mark]
    assert marked == " (stated by the variant)"
    # the rods hang from the basis, which hangs under the crank pin: C is sqrt(90² − 67.5²) under B
    assert "B: [0 mm, 40 mm], C: [-67.5 mm, -19.529 mm]" in sketch and "F: [67.5 mm, -204.53 mm]" in sketch
    found = find(read("press"))
    assert broken_lengths(found) == [] and min(gaps(found)) > 0.1


@pytest.mark.exhaustive
def test_six_ways_of_a_class_three_group(tmp_path):
    (tmp_path / "six.yaml").write_text(SIX, encoding="utf-8")
    done = run(tmp_path / "six.yaml", "-o", tmp_path / "out")
    assert done.exit_code == 0, done.output
    assert "III3(2,3,4,5)" in done.output and "at 30°; ways to assemble the mechanism: 6." in done.output
    listed = WAY.findall(done.output)
    assert len(listed) == 6 and not any(mark for _, mark, _ in listed)
    assert "The variant states none of them:" in done.output and "six.yaml:" in done.output
    found = find(loads(SIX))
    assert broken_lengths(found) == [] and min(gaps(found)) > 0.1
    assert [find(stated(SIX, sketch)).stated for _, _, sketch in listed] == [1, 2, 3, 4, 5, 6]


@pytest.mark.parametrize("name", NAMES)
def test_every_way_of_a_ready_variant_is_chosen_by_its_line(name):
    text = (VARIANTS / f"{name}.yaml").read_text(encoding="utf-8")
    found = find(read(name))
    count = len(found.ways)
    assert found.stated is not None and not found.more and not found.alike and not found.unsaid
    assert broken_lengths(found) == []
    if count > 1:
        again = [find(stated(text, sketch)) for sketch in found.sketches]
        assert [(len(one.ways), one.stated) for one in again] == [(count, k + 1) for k in range(count)]


@pytest.mark.parametrize(("name", "count"), [("crank_rocker", 2), ("compressor", 4), ("scotch_yoke", 1)])
def test_dyads_of_a_variant_that_states_nothing(name, count):
    found = find(unstated(read(name)))
    assert len(found.ways) == count and broken_lengths(found) == []
    assert (found.stated is None) == bool(found.unsaid) == (count > 1)


def test_the_angle_may_be_chosen(tmp_path):
    done = run(VARIANTS / "crank_rocker.yaml", "--angle", "-30 deg", "-o", tmp_path, "--lang", "en")
    assert done.exit_code == 0 and "Driving link 1 at −30°" in done.output
    for _, _, sketch in WAY.findall(done.output):  # A is 60 mm from O
        assert sketch.startswith("sketch: {A: [51.962 mm, -30 mm], B: [")


def test_the_angle_by_default_is_that_of_the_sketch_then_of_position_zero():
    press, crank = read("press"), read("crank_rocker")
    turned = replace(press.lever.mechanism, sketch={"B": 0.03 + 0.03j})
    assert find(stating(press, mechanism=turned)).phi == pytest.approx(pi / 4)
    assert find(unstated(press)).phi == pytest.approx(pi / 2)
    assert find(crank).phi == 0.0


def test_where_there_is_no_way(tmp_path):
    done = run(VARIANTS / "tangent.yaml", "--angle", "90 deg", "-o", tmp_path / "out", "--lang", "en")
    assert done.exit_code == 1
    assert "at 90° the mechanism cannot be assembled; choose another --angle" in done.output
    assert not (tmp_path / "out").exists()


def test_ways_that_no_sketch_tells_apart_are_named(tmp_path):
    """A stretched parallelogram is also a stretched antiparallelogram."""
    done = run(VARIANTS / "parallelogram_drive.yaml", "--angle", "0", "-o", tmp_path, "--lang", "en")
    assert done.exit_code == 0
    assert "Ways 1, 2, 3, 4 have every point in the same place" in done.output
    assert "have every point in the same place" in (tmp_path / "assemblies.html").read_text(encoding="utf-8")


def test_a_drawing_far_from_its_origin_has_more_digits():
    text = (VARIANTS / "crank_rocker.yaml").read_text(encoding="utf-8")
    data = yamlread.loads(text).data
    data["mechanism"]["frame"] = {"O": [1000, -2000], "C": [1000.2, -1999.98]}
    found = find(loads(json.dumps(data, ensure_ascii=False)))
    assert found.sketches[0].startswith("sketch: {A: [1000060 mm, -2000000 mm], B: [1000")
    assert [find(stated(json.dumps(data), sketch)).stated for sketch in found.sketches] == [1, 2]


def rockers(count: int) -> str:
    """So many rockers driven by one crank pin: 2 to this power is the number of ways."""
    links = ["1: {points: {O: 0, A: 50 mm}}"]
    for k in range(count):
        links += [f"a{k}: {{points: {{A: 0, B{k}: 180 mm}}}}", f"b{k}: {{points: {{O{k}: 0, B{k}: 150 mm}}}}"]
    fixed = ", ".join(f"O{k}: [{100 + 10 * k} mm, {20 * k} mm]" for k in range(count))
    body = f"frame: {{O: [0, 0], {fixed}}}, links: {{{', '.join(links)}}}, driver: {{link: 1, speed: 1}}"
    return f"mechanism: {{{body}}}"


@pytest.mark.exhaustive
def test_more_ways_than_are_shown(tmp_path):
    (tmp_path / "many.yaml").write_text(rockers(8), encoding="utf-8")
    done = run(tmp_path / "many.yaml", "-o", tmp_path, "--lang", "en")
    assert done.exit_code == 0, done.output
    assert f"more than {MOST} ways, the first of them are shown" in done.output
    assert len(WAY.findall(done.output)) == MOST
    text = (tmp_path / "assemblies.html").read_text(encoding="utf-8")
    assert text.count("<svg") == MOST and f"more than {MOST} ways" in text


def test_mistakes_are_told_as_for_solve(tmp_path):
    text = (VARIANTS / "crank_rocker.yaml").read_text(encoding="utf-8")
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text(text.replace("link: 1\n", "link: 9\n"), encoding="utf-8")
    free = tmp_path / "free.yaml"
    free.write_text(SIX.replace("Q: 0, D: 210 mm", "Q: 0, E: 210 mm"), encoding="utf-8")
    (tmp_path / "file").write_text("")
    crank = VARIANTS / "crank_rocker.yaml"
    for arguments, said in (
        ([wrong], r"wrong\.yaml:\d+:\d+: mechanism\.driver\.link: .*there is no link 9"),
        ([free], r"free\.yaml:\d+:\d+: mechanism\.links: mobility is W = 3·5 − 2·6 = 3"),
        ([tmp_path / "none.yaml"], r"none\.yaml"),
        ([crank, "--angle", "30 mm"], r"^--angle: 30 mm is a length \(mm\); expected: an angle \(rad\)"),
        ([crank, "--lang", "fr"], rf"^--lang: there is no language fr; known: {', '.join(LANGUAGES)}$"),
        ([crank, "-o", tmp_path / "file" / "out"], r"cannot write into"),
    ):
        done = run("--lang", "en", *arguments)
        assert done.exit_code == 2, arguments
        assert re.search(said, done.output), (arguments, done.output)


@pytest.mark.exhaustive
def test_names_that_yaml_might_take_for_something_else():
    names = {"A": "null", "B": "1e3", "C": "O'’", "D": "да", "P": "0x1F", "Q": "yes"}
    text = re.sub(r"\b[ABCDPQ]\b", lambda match: names[match[0]], SIX)
    found = find(loads(text))
    assert found.points == ["null", "1e3", "O'’", "да"] and len(found.ways) == 6
    assert [find(stated(text, sketch)).stated for sketch in found.sketches] == [1, 2, 3, 4, 5, 6]
    for figure in figures(html(found)):
        ElementTree.fromstring(figure)


def html(found: Assemblies, language: str = "en") -> str:
    return page(found, Translator(language))["assemblies.html"].decode()


def figures(text: str) -> list[str]:
    return re.findall(r"<svg\b.*?</svg>", text, re.S)


@pytest.mark.parametrize("payload", PAYLOADS.values(), ids=PAYLOADS)
def test_a_hostile_topic_is_text(payload):
    plain = html(find(replace(read("crank_rocker"), title=Title(topic="plain"))))
    text = html(find(replace(read("crank_rocker"), title=Title(topic=payload))))
    assert text.count("<") == plain.count("<") and text.count('"') <= plain.count('"') + 2 * payload.count(
        '"'
    )
    root = ElementTree.fromstring(re.search(r"<title>.*?</title>", text, re.S)[0])
    assert root.text == f"Ways to assemble the mechanism: {payload}"


@pytest.mark.parametrize("name", ["[bold red].yaml", "a\x1b[31m\u202eb.yaml", "<b>&.yaml"])
def test_odd_file_names(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    (tmp_path / name).write_bytes((VARIANTS / "crank_rocker.yaml").read_bytes())
    done = run("--", name)
    assert done.exit_code == 0, done.output
    assert "\x1b" not in done.output and "\u202e" not in done.output
    assert len(list(tmp_path.glob("*-assemblies/assemblies.html"))) == 1


def test_the_page_is_in_the_users_language_and_the_same_every_time(tmp_path):
    for folder in ("one", "two"):
        run(VARIANTS / "crank_rocker.yaml", "-o", tmp_path / folder)
    one, two = ((tmp_path / folder / "assemblies.html").read_bytes() for folder in ("one", "two"))
    assert one == two
    text = one.decode()
    assert '<html lang="ru">' in text and "Ways" not in text and "Способ 1" in text
    (first,) = [way for way in text.split("<section")[1:] if "stated" in way]
    (_, x, y), *_ = re.findall(r"<tr><td>(B)</td><td>(.*?)</td><td>(.*?)</td></tr>", first)
    assert "," in x + y and "." not in x + y  # decimal commas for reading, points in the line to be copied
    copied = re.search(r"<code>(.*)</code>", first)[1]
    assert f"B: [{x}, {y}]".replace(",", ".").replace(". ", ", ") == re.sub(
        " mm", "", re.search(r"B: \[.*?\]", copied)[0]
    )


@pytest.mark.exhaustive
def test_a_browser_opens_and_prints_it_without_a_network(tmp_path):
    run(VARIANTS / "press.yaml", "-o", tmp_path, "--lang", "en")
    file, pdf = tmp_path / "assemblies.html", tmp_path / "page.pdf"
    text = file.read_text(encoding="utf-8")
    assert re.search(r"Content-Security-Policy[^>]*default-src 'none'", text)
    assert not re.search(r"(?:src|href)\s*=|url\(|@import|<script", text)
    assert len(figures(text)) == 4
    seen = browser.seen("assemblies")
    assert seen.text == text and seen.console == [] and seen.asked == []
    pdf.write_bytes(seen.pdf)
    info = subprocess.run([program("pdfinfo"), str(pdf)], capture_output=True, text=True, check=True).stdout
    wide, tall = map(float, re.search(r"Page size:\s+([\d.]+) x ([\d.]+)", info).groups())
    assert (wide, tall) == pytest.approx((595.3, 841.9), abs=1.5)  # A4, points
    printed = subprocess.run(
        [program("pdftotext"), "-layout", str(pdf), "-"], capture_output=True, check=True
    )
    words = printed.stdout.decode()
    assert all(f"Way {k}" in words for k in (1, 2, 3, 4)) and "stated by the variant" in words

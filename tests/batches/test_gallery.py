"""The gallery: the committed one shows today's variants; a bad variant stops no other; the same bytes each time."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from urllib.parse import unquote
from xml.etree import ElementTree

import pytest
from conftest import ALL_FILES
from notes import NAMES, VARIANTS
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.commands.gallery.page import Markdown
from tmm_report.commands.gallery.run import variants

COMMITTED = Path(__file__).parents[2] / "docs" / "gallery"
HEADING = re.compile(r"^## (.+)$", re.M)


def run(*arguments: object):
    return CliRunner().invoke(app, ["gallery", *map(str, arguments)], env={"LANG": "C", "LC_ALL": "C"})


@pytest.fixture
def folder(tmp_path) -> Path:
    """Two variants that are solved, one that cannot be read and one that cannot be solved."""
    source = tmp_path / "my variants"
    source.mkdir()
    for name in ("tangent", "crank_rocker"):
        shutil.copy(VARIANTS / f"{name}.yaml", source)
    text = (VARIANTS / "tangent.yaml").read_text(encoding="utf-8")
    (source / "a_bad.yaml").write_text(text.replace("{link: 1}", "{link: 9}").replace("link: 1}", "link: 9}"))
    unsaid = (VARIANTS / "compressor.yaml").read_text(encoding="utf-8").replace("right, D: left}", "right}")
    (source / "unsaid.yaml").write_text(unsaid, encoding="utf-8")
    (source / "notes.txt").write_text("no variant")
    return source


def test_the_committed_gallery_shows_the_ready_variants():
    page = (COMMITTED / "README.md").read_text(encoding="utf-8")
    built = "python -m tmm_report gallery --lang en -o docs/gallery"
    assert HEADING.findall(page) == NAMES, built
    pictures = {f"{file.stem}.svg" for file in ALL_FILES}
    assert {file.name for file in COMMITTED.iterdir()} == {"README.md", *pictures}, built
    assert "Not solved" not in page and "Cannot be assembled" not in page
    assert not re.search("[\u0400-\u04ff]", page), built
    assert variants() == ALL_FILES


def test_every_link_of_the_committed_page_leads_somewhere():
    page = (COMMITTED / "README.md").read_text(encoding="utf-8")
    headings = {f"#{name}" for name in HEADING.findall(page)}
    links = re.findall(r"\]\(([^)]+)\)", page)
    assert len(links) == 3 * len(ALL_FILES)  # of the table, of the file, the picture
    lost = [link for link in links if link not in headings and not (COMMITTED / unquote(link)).is_file()]
    assert lost == []


def test_a_bad_variant_has_its_reason_and_the_others_go_on(folder, tmp_path):
    done = run(folder, "-o", tmp_path / "out", "--lang", "en")
    assert done.exit_code == 1, done.output
    page = (tmp_path / "out" / "README.md").read_text(encoding="utf-8")
    assert HEADING.findall(page) == ["a_bad", "crank_rocker", "tangent", "unsaid"]
    assert re.findall(r"^Not solved: (.*)$", page, re.M) and "there is no link 9" in page
    assert re.search(r"^Not solved: \d+:\d+: .*group II2\(4,5\) can be assembled in two ways", page, re.M)
    assert {file.name for file in (tmp_path / "out").iterdir()} == {
        "README.md",
        "crank_rocker.svg",
        "tangent.svg",
    }
    assert "(../my%20variants/tangent.yaml)" in page
    topic = "Crank-rocker mechanism of a conveyor drive"
    assert f"[{topic}](#crank_rocker)" in page and f"\n\n{topic}\n\n![{topic}](crank_rocker.svg)" in page
    assert f">{topic}</title>" in (tmp_path / "out" / "crank_rocker.svg").read_text("utf-8")
    assert f"{folder / 'unsaid.yaml'}:" in done.output and "a_bad.yaml:" in done.output


SHORT_ROD = """\
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 50 mm}}
    3: {points: [B], slides: x, mass: 1 kg}
  driver: {link: 1, speed: 60 rpm}
  assembly: {B: right}
loads: {gravity: 0}
"""


@pytest.mark.parametrize(("meant", "code"), [("", 1), ("allow_partial: true\n", 0)])
def test_a_mechanism_that_closes_over_part_of_the_cycle_shows_its_gaps(tmp_path, meant, code):
    (tmp_path / "short.yaml").write_text(SHORT_ROD + meant, encoding="utf-8")
    done = run(tmp_path, "-o", tmp_path / "out", "--lang", "en")
    page = (tmp_path / "out" / "README.md").read_text(encoding="utf-8")
    where = "rod AB = 50 mm cannot reach guide x for 30.00° < φ < 150.00° and 210.00° < φ < 330.00°"
    assert f"- Cannot be assembled over part of the cycle: {where.replace('<', '&lt;')}" in page
    assert "I(0,1) → II2(2,3)" in page and "Stroke" not in page and "balancing moment" not in page
    assert (tmp_path / "out" / "short.svg").is_file()
    assert done.exit_code == code, done.output
    assert (f"short.yaml: mechanism.links.2: {where}" in done.output) == bool(code)


def test_the_main_numbers_of_an_entry(folder, tmp_path):
    run(folder, "-o", tmp_path / "out", "--lang", "ru")
    page = (tmp_path / "out" / "README.md").read_text(encoding="utf-8")
    entry = page.split("## crank_rocker")[1].split("\n## ")[0]
    for text in ("Кривошипно-коромысловый механизм", "I(0,1) → II2(2,3)", "60,204°", "1,036", "−18,29 Н·м"):
        assert text in entry, text
    assert (
        float(re.search(r"1·10⁻(\S+)", entry)[1].translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789"))) >= 12
    )
    assert re.search(r"II2\(2,3\).*: 0,782$", entry, re.M)


def test_pictures_stand_on_white_and_fetch_nothing(folder, tmp_path):
    run(folder, "-o", tmp_path / "out")
    root = ElementTree.parse(tmp_path / "out" / "crank_rocker.svg").getroot()
    left, top, wide, tall = map(float, root.get("viewBox").split())
    first = next(root.iter("{http://www.w3.org/2000/svg}path"))
    corners = [tuple(map(float, pair.split())) for pair in re.split("[MLZ]", first.get("d")) if pair]
    assert first.get("fill") == "#FFFFFF" and len(corners) == 4
    (xs, ys) = zip(*corners, strict=True)
    assert (min(xs), max(xs)) == pytest.approx((left, left + wide), abs=2e-3)
    assert (min(ys), max(ys)) == pytest.approx((top, top + tall), abs=2e-3)
    assert "href" not in ElementTree.tostring(root, encoding="unicode")


@pytest.mark.exhaustive
def test_same_folder_same_bytes(folder, tmp_path):
    for out in ("one", "two"):
        run(folder, "-o", tmp_path / out)
    names = [file.name for file in (tmp_path / "one").iterdir()]
    assert len(names) == 3
    for name in names:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes(), name


def test_a_folder_without_variants_and_one_that_is_not_there(tmp_path):
    done = run(tmp_path, "-o", tmp_path / "out")
    assert done.exit_code == 2 and "no variants" in done.output
    assert run(tmp_path / "none", "-o", tmp_path / "out").exit_code == 2
    assert not (tmp_path / "out").exists()


def test_a_place_that_cannot_be_written(folder, tmp_path):
    (tmp_path / "file").write_text("")
    done = run(folder, "-o", tmp_path / "file" / "out")
    assert done.exit_code == 2 and "cannot write" in done.output


def test_a_users_text_stays_text():
    assert Markdown().escape("a|b *c* [d](e) <img> `f` _g_ h_i $k$ #") == (
        r"a\|b \*c\* \[d\](e) &lt;img&gt; \`f\` \_g\_ h_i \$k\$ \#"
    )

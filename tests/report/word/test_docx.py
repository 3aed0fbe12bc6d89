"""The file for word processors: its parts hold together, it says what the other notes say, and text stays text."""

from __future__ import annotations

import re
import subprocess
import sys
from collections import Counter
from dataclasses import replace
from functools import cache
from html import unescape
from itertools import pairwise
from pathlib import Path
from xml.etree.ElementTree import fromstring

import pytest
from conftest import solved
from docx_read import (
    WP,
    A,
    M,
    R,
    Reckoner,
    W,
    commands,
    disordered,
    document_of,
    marks,
    parts_of,
    style_of,
    text_of,
)  # fmt: skip
from exhaustive import FEW
from notes import NAMES, VARIANTS, note, render, static
from payloads import PAYLOADS

from tmm_report import render as of_depth
from tmm_report.chapters.title.given import Assignment, Signer, Title
from tmm_report.profiles import NAMES as PROFILES
from tmm_report.profiles import shipped, stated
from tmm_report.report.formats.docx import TWIPS

OWN = {
    "field": '" \\* MERGEFORMAT } { INCLUDETEXT "C:\\\\x" } DDEAUTO c:\\windows\\system32\\cmd.exe',
    "run": "</w:t></w:r><w:r><w:instrText> DDEAUTO x </w:instrText></w:r>",
    "ours": "<n:field says='DDE'/><n:ref to='x'/>",
    "entity": "<!DOCTYPE x [<!ENTITY a SYSTEM 'file:///etc/passwd'>]>&a;&#x41;", "cdata": "]]><![CDATA[x",
    "comment": "--> <!--tail-->",
}  # fmt: skip
MM = 36_000  # EMU
SOME = sorted({*FEW, *NAMES[::5]})
SAYS = re.compile(  # the fields that a note has
    r"(?:REF|PAGEREF) _\w+(?: \\r)? \\h|SEQ \w+ \\\* ARABIC(?: \\s 1)?(?: \\r 1)?|STYLEREF 1 \\s"
    r'|TOC \\o "1-2" \\h \\z \\u'
)


def of(name: str, language: str | None = None) -> bytes:
    return note(name, "docx", language)["note.docx"]


@cache
def root_of(name: str):
    return document_of(of(name))


# --- the parts


def test_its_parts_are_xml_that_is_named_and_led_to():
    """Each part has a kind, each relation its part, and none leads out of the file."""
    parts = parts_of(of("compressor"))
    for name, content in parts.items():
        if not name.endswith(".emf"):
            fromstring(content)
    kinds = parts["[Content_Types].xml"].decode()
    for name in parts:
        known = f'"/{name}"' in kinds or re.search(rf'Extension="{name.rpartition(".")[2]}"', kinds)
        assert known, name
    led = re.findall(
        'Id="([^"]*)" Type="([^"]*)" Target="([^"]*)"', parts["word/_rels/document.xml.rels"].decode()
    )
    assert all(f"word/{target}" in parts for _, _, target in led)
    assert all(kind.startswith("http://schemas.openxmlformats.org/") for _, kind, _ in led)
    asked = re.findall(r'r:(?:embed|id)="([^"]*)"', parts["word/document.xml"].decode())
    assert len(asked) > 20 and set(asked) <= {name for name, _, _ in led}
    assert not any(b"TargetMode" in content for content in parts.values())


def test_it_has_the_same_bytes_again_and_no_clock_in_it():
    file = of("hoist_drive", "ru")
    assert render(solved("hoist_drive"), "docx", "ru")["note.docx"] == file
    assert file.count(b"PK\x01\x02") == len(parts_of(file)) and re.search(
        rb"PK\x03\x04.{6}\x00\x00\x21\x00", file
    )


def test_its_properties_are_those_of_the_title():
    core = parts_of(of("compressor", "ru"))["docProps/core.xml"].decode()
    for said in (
        "title>Двухцилиндровый воздушный компрессор<",
        "creator>Иванов И. И.<",
        "language>ru-RU<",
        ">2026-01-01T",
    ):
        assert said in core
    styles = {
        language: parts_of(of("compressor", language))["word/styles.xml"].decode()
        for language in ("ru", "en")
    }
    assert 'lang w:val="ru-RU"' in styles["ru"] and 'lang w:val="en-GB"' in styles["en"]


@pytest.mark.parametrize("name", SOME)
def test_elements_stand_in_the_order_of_the_standard(name):
    """Word opens no file in which they do not (ECMA-376, part 1, annex A)."""
    for part, content in parts_of(of(name)).items():
        if part.startswith("word/") and part.endswith(".xml"):
            assert not disordered(fromstring(content)), part
    root = root_of(name)
    for cell in root.iter(f"{W}tc"):
        assert cell[-1].tag == f"{W}p"
    for one, other in pairwise(root[0]):
        assert {one.tag, other.tag} != {f"{W}tbl"}  # Word would join them
    assert not [one for one in root.iter() if one.tag.startswith("{tmm-report}")]
    assert not [one for one in root.iter(f"{W}p") for inner in one if inner.tag in (f"{W}p", f"{W}tbl")]
    assert not [one for one in root.iter() if (one.tail or "").strip()]
    pictures = [one.get("id") for one in root.iter(f"{WP}docPr")]
    assert len(pictures) == len(set(pictures))


@pytest.mark.parametrize("name", SOME)
def test_what_clings_to_a_formula_is_a_part_of_it(name):
    """Else a line may begin with a stop, as word processors break beside a formula."""
    loose, apart = [], []
    for paragraph in root_of(name).iter(f"{W}p"):
        if style_of(paragraph).startswith("Table"):
            continue
        for before, after in pairwise(paragraph):
            kinds = [one.tag == f"{M}oMath" for one in (before, after)]
            stop = kinds == [True, False] and re.match("[.,;:)»]", text_of(after))
            if stop or (kinds == [False, True] and re.search(r"(^|\s)[(«]+$", text_of(before))):
                loose.append(text_of(paragraph))
        for formula in paragraph.iter(f"{M}oMath"):
            for before, after in pairwise(formula):
                if before.find(f"{M}rPr") is not None and re.fullmatch("[.,;:)»]+", text_of(after)):
                    apart.append(text_of(formula))
    assert not loose and not apart


# --- numbers, references


@pytest.mark.parametrize("name", SOME)
def test_what_word_reckons_is_what_stands_there(name):
    """Numbers of headings, formulas, figures and tables, and references to them: each reckoned again."""
    reckons(root_of(name))


def reckons(root):
    reckoned, known = Reckoner(root), marks(root)
    assert reckoned.said and not [one for one in reckoned.said if one[1] != one[2]]
    assert len({one.get(f"{W}id") for one in root.iter(f"{W}bookmarkStart")}) == len(known)
    assert all(len(mark) <= 40 and re.fullmatch(r"_\w+", mark) for mark in known)
    refs = [(command.split(), said) for command, said in commands(root) if command.startswith("REF")]
    assert refs
    for (_, mark, *switches), said in refs:
        text, paragraph = known[mark]
        assert said == (reckoned.numbers[id(paragraph)] if "\\r" in switches else text), mark


@pytest.mark.parametrize("name", SOME)
def test_the_contents_name_every_heading_and_lead_to_it(name):
    leads(root_of(name))


def leads(root):
    numbers, known = Reckoner(root).numbers, marks(root)
    lines = [one for one in root.iter(f"{W}p") if style_of(one).startswith("TOC")]
    heads = [
        one
        for one in root.iter(f"{W}p")
        if style_of(one) in ("Heading1", "Heading2", "Structural", "Appendix")
    ]
    assert len(lines) == len(heads) > 3
    for line, head in zip(lines, heads, strict=True):
        number = numbers.get(id(head), "")
        said = " ".join(f"{number} {text_of(head)}".split())
        assert "".join(text_of(line).split()) == "".join(said.split())
        link = line.find(f"{W}hyperlink")
        assert known[link.get(f"{W}anchor")][1] is head
    says = [command for command, _ in commands(root)]
    assert says.count('TOC \\o "1-2" \\h \\z \\u') == 1 and sum(
        one.startswith("PAGEREF") for one in says
    ) == len(lines)


def test_so_they_do_where_there_are_appendices():
    """Their headings are numbered by their letters, which no word processor counts."""
    root = document_of(of_depth(solved("compressor"), "docx", "ru", "course")["note.docx"])
    assert sum(style_of(one) == "Appendix" for one in root.iter(f"{W}p")) > 2
    reckons(root)
    leads(root)


# --- what it says


def words(page: str) -> str:
    html = static(page).partition("<main>")[2].partition("</main>")[0]
    return re.sub(r'<svg.*?</svg>|<math class="again".*?</math>', " ", html, flags=re.S)


@pytest.mark.parametrize("name", SOME)
def test_it_prints_every_number_of_the_other_note(name):
    """In its text, tables and formulas, as often as in HTML."""
    html = words(note(name, "html")["note.html"].decode())
    wanted = Counter(
        re.findall(
            r"\d+[.,]\d+",
            re.sub(r"<[^>]+>", " ", re.sub(r"<(?:h\d|nav).*?</(?:h\d|nav)>", " ", html, flags=re.S)),
        )
    )
    said = " ".join(text_of(one) for one in root_of(name).iter() if one.tag in (f"{W}r", f"{M}r"))
    found = Counter(re.findall(r"\d+[.,]\d+", said))
    assert len(wanted) > 10 and not {
        one: (count, found[one])
        for one, count in wanted.items()
        if count > found[one] and not re.fullmatch(r"\d\.\d+", one)
    }


@pytest.mark.parametrize("name", ["compressor", "cam_press"])
def test_tables_have_their_rows_heads_and_widths(name):
    """Cell by cell those of the HTML; a head is repeated on each page; widths are those of the columns."""
    root, html = root_of(name), words(note(name, "html")["note.html"].decode())
    there = [
        re.findall("<tr>.*?</tr>", one, flags=re.S)
        for one in re.findall(r"<table.*?</table>", html, flags=re.S)
    ]
    here = [one for one in root.iter(f"{W}tbl") if one.find(f"{W}tblPr/{W}tblBorders") is not None]
    assert len(there) == len(here) > 10
    room = (
        11906
        - int(root.find(f".//{W}pgMar").get(f"{W}left"))
        - int(root.find(f".//{W}pgMar").get(f"{W}right"))
    )
    for table, rows in zip(here, there, strict=True):
        drawn = table.findall(f"{W}tr")
        heads = [row.find(f"{W}trPr/{W}tblHeader") is not None for row in drawn]
        assert len(drawn) == len(rows) and heads == [True, *[False] * (len(rows) - 1)]
        widths = [int(one.get(f"{W}w")) for one in table.iter(f"{W}gridCol")]
        assert sum(widths) <= room + len(widths)
        for row, other in zip(drawn, rows, strict=True):
            assert [int(one.get(f"{W}w")) for one in row.iter(f"{W}tcW")] == widths
            cells = re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", other, flags=re.S)
            plain = [same(re.sub(r"<[^>]+>", "", one)) for one in cells]
            assert [same(text_of(one)) for one in row.iter(f"{W}tc")] == plain


def same(text: str) -> str:
    """Letters and digits alone: an index stands behind or before another, a space is thin or none."""
    return "".join(
        sorted(re.sub(r"[\s\u200b\u2009\u2060‾]", "", unescape(text)).replace("″", "′′").replace("‴", "′′′"))
    )


@pytest.mark.parametrize("name", SOME)
def test_pictures_have_the_size_that_the_other_note_draws(name):
    """To a hundredth of a millimetre, in the text and in the picture's own file."""
    root, file = root_of(name), parts_of(of(name))
    html = note(name, "html")["note.html"].decode().partition("<main>")[2].partition("</main>")[0]
    sizes = re.findall(r'<svg[^>]*width="([\d.]+)mm" height="([\d.]+)mm"', html)
    there = Counter((round(float(wide), 2), round(float(tall), 2)) for wide, tall in sizes)
    here = list(root.iter(f"{WP}extent"))
    drawn = [(int(one.get("cx")) / MM, int(one.get("cy")) / MM) for one in here]
    assert len(drawn) == sum(there.values())
    for wide, tall in drawn:
        if abs(wide - 100) < 3 and tall < 8:
            continue  # the bar, which has margins of its own here
        assert any(abs(wide - x) < 0.011 and abs(tall - y) < 0.011 for x, y in there), (wide, tall)
    blips = [one.get(f"{R}embed") for one in root.iter(f"{A}blip")]
    led = dict(
        re.findall(
            'Id="([^"]*)" Type="[^"]*" Target="([^"]*)"', file["word/_rels/document.xml.rels"].decode()
        )
    )
    for blip, (wide, tall) in zip(blips, drawn, strict=True):
        frame = [
            int.from_bytes(file[f"word/{led[blip]}"][24 + 4 * k : 28 + 4 * k], "little") for k in range(4)
        ]
        assert frame[2] / 100 == pytest.approx(wide, abs=0.011) and frame[3] / 100 == pytest.approx(
            tall, abs=0.011
        )


# --- the page


def test_its_pages_are_those_of_its_profile():
    results = solved("crank_rocker")
    for name in PROFILES:
        profile = shipped(name)
        variant = replace(results.variant, profile=profile)
        file = render(replace(results, variant=variant), "docx", "ru")["note.docx"]
        root, parts = document_of(file), parts_of(file)
        section = root[0][-1]
        margins = section.find(f"{W}pgMar")
        for side in ("left", "right", "top", "bottom"):
            assert int(margins.get(f"{W}{side}")) / 56.693 == pytest.approx(
                getattr(profile.margins, side), abs=0.02
            )
        styles = parts["word/styles.xml"].decode()
        assert f'<w:sz w:val="{2 * profile.text.size:.0f}"/>' in styles
        body = re.search('styleId="BodyText">.*?</w:style>', styles)[0]
        assert f'w:line="{240 * profile.text.spacing:.0f}"' in body
        assert abs(int(re.search('firstLine="([0-9]+)"', body)[1]) / 56.693 - profile.text.indent) < 0.02
        head = re.search('styleId="Structural">.*?</w:style>', styles)[0]
        assert ("<w:caps/>" in head) == profile.headings.structural.capitals
        assert ("<w:pageBreakBefore/>" in head) == profile.headings.structural.new_page
        shown, empty = ("header", "footer") if profile.above else ("footer", "header")
        assert b" PAGE " in parts[f"word/{shown}.xml"] and b" PAGE " not in parts[f"word/{empty}.xml"]
        title = next(one for one in root.iter(f"{W}sectPr"))
        assert title.find(f"{W}headerReference").get(f"{R}id") == "titleheader"


def test_frames_are_named_led_to_and_stand_at_their_places():
    """Of all sheets: the header that a section names, its picture from edge to edge of the frame, the fields in it."""
    results = solved("crank_rocker")
    profile = stated("gost", {"frames": True, "margins": {"left": "37 mm"}, "text": {"size": 16}})
    framed = replace(results, variant=replace(results.variant, profile=profile))
    files = parts_of(of_depth(framed, "docx", "ru", "course")["note.docx"])
    led = {one.get("Id"): one.get("Target") for one in fromstring(files["word/_rels/document.xml.rels"])}
    sections = list(fromstring(files["word/document.xml"]).iter(f"{W}sectPr"))
    opening = [one for one in sections if one.find(f"{W}titlePg") is not None]
    assert len(opening) == 1 and opening[0] is sections[1]
    seen = set()
    for section in sections:
        paper = section.find(f"{W}pgSz")
        wide, tall = (int(paper.get(f"{W}{side}")) / TWIPS for side in ("w", "h"))
        for one in section.iter(f"{W}headerReference"):
            name = led[one.get(f"{R}id")]
            seen.add(name)
            header = fromstring(files[f"word/{name}"])
            assert not disordered(header)
            (place,) = header.iter(f"{WP}anchor")
            left, above = (int(text.text) / MM for text in place.iter(f"{WP}posOffset"))
            size = place.find(f"{WP}extent")
            across, down = (int(size.get(side)) / MM for side in ("cx", "cy"))
            assert (left, above) == (19.75, 4.75)
            assert (across, down) == pytest.approx((wide - 24.5, tall - 9.5), abs=0.02)
            counted = [one.get(f"{W}instr").strip() for one in header.iter(f"{W}fldSimple")]
            form = {"titleheader.xml": [], "openingheader.xml": ["PAGE", "NUMPAGES"]}.get(name, ["PAGE"])
            assert counted == form
            image = fromstring(files[f"word/_rels/{name}.rels"])[0].get("Target")
            assert files[f"word/{image}"][40:44] == b" EMF"
    assert len(seen) > 3 and all(f"/word/{name}".encode() in files["[Content_Types].xml"] for name in seen)
    assert not any("frame" in name or "opening" in name for name in parts_of(of("crank_rocker")))


def test_large_pictures_stand_on_sheets_of_their_own():
    """Lying A4 and larger paper, in sections between those of the text; no section is empty."""
    root = root_of("compressor")
    sizes = [(int(one.get(f"{W}w")), int(one.get(f"{W}h"))) for one in root.iter(f"{W}pgSz")]
    turned = [one.get(f"{W}orient") for one in root.iter(f"{W}pgSz")]
    assert (16838, 11906) in sizes and (11906, 16838) in sizes
    assert 20000 < max(map(max, sizes)) <= 31680, (
        "Word takes no paper of more than 22 inches: MS-OI29500, 17.6.13"
    )
    assert [(wide > tall) for wide, tall in sizes] == [one == "landscape" for one in turned]
    held, blocks = [], list(root[0])
    for block in blocks:
        held.append(block)
        if block.find(f"{W}pPr/{W}sectPr") is not None:
            assert any(text_of(one) or one.find(f".//{WP}inline") is not None for one in held)
            held = []
    assert len(held) > 1


# --- a student's text


def test_a_students_text_is_printed_and_is_no_field():
    results = solved("compressor")
    everything = " ¶ ".join([*PAYLOADS.values(), *OWN.values(), "a\x00b\x0cc\x1bd\ufffe"])
    texts = {name: everything for name, text in vars(Title()).items() if isinstance(text, str)}
    title = Title(**texts, lines=(everything,), signed=(Signer(everything, everything),))
    loads = results.variant.lever.loads
    forces = tuple(replace(force, name=everything) for force in loads.forces)
    lever = replace(results.variant.lever, loads=replace(loads, forces=forces))
    variant = replace(results.variant, title=title, lever=lever, assignment=Assignment(data=(everything,)))
    file = render(replace(results, variant=variant), "docx", "en")["note.docx"]
    root, parts = document_of(file), parts_of(file)
    for command, _ in commands(root):
        assert SAYS.fullmatch(command), command
    allowed = {one.tag for one in root_of("compressor").iter()} | {f"{W}spacing"}
    assert {one.tag for one in root.iter()} <= allowed
    printed = "".join(text_of(root).replace("\u200b", "").split())
    foot = "".join(text_of(fromstring(parts["word/titlefooter.xml"])).replace("\u200b", "").split())
    for literal in (*PAYLOADS.values(), *OWN.values(), "a?b?c?d?"):
        packed = "".join(literal.split())
        assert packed in printed and packed in foot, literal
    assert "root:" not in printed and "???" not in printed


def test_a_template_that_nests_and_strews_gives_a_document():
    """Text without a paragraph gets one; a paragraph within another stands behind it."""
    results = solved("crank_rocker")
    own = (
        "{% block introduction %}loose {{ m.p(m.p('inner'), 'tail') }} <b>strewn</b>"
        "{{ m.itemise([m.p('deep'), 'flat']) }}"
        "{% call m.frontpage(m.p('head')) %}words{% endcall %}{% endblock %}"
    )
    variant = replace(results.variant, template=(own.encode(), "department.j2"))
    root = document_of(render(replace(results, variant=variant), "docx", "en")["note.docx"])
    texts = [text_of(one).strip() for one in root.iter(f"{W}p")]
    for wanted in ("loose", "inner", "tail", "<b>strewn</b>", "deep", "words"):
        assert any(wanted in one for one in texts), wanted
    assert not [one for one in root.iter(f"{W}p") for inner in one.iter(f"{W}p") if inner is not one]


# --- the command


@pytest.mark.parametrize(("formats", "loaded"), [("html,tex", False), ("docx", True)])
def test_only_who_asks_for_it_loads_it(tmp_path, formats, loaded):
    code = (
        "import sys\nfrom tmm_report.cli import main\n"
        "try:\n    main()\nexcept SystemExit:\n    pass\n"
        "own = ('docx', 'omml', '.emf', 'office_math', 'word.package')\n"
        "print(any(part in name for name in sys.modules for part in own))"
    )
    variant = str(VARIANTS / "crank_rocker.yaml")
    command = [sys.executable, "-c", code, "solve", variant, "--format", formats, "-o", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, cwd=Path(__file__).parents[3])
    assert done.stdout.splitlines()[-1] == str(loaded), done.stdout + done.stderr
    assert (tmp_path / "out" / "note.docx").is_file() == loaded

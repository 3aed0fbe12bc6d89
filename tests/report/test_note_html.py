"""The HTML note as a browser shows it: headless Chromium opens it, measures it and prints it."""

from __future__ import annotations

import re
import subprocess

import browser
import pytest
from browser import Seen
from exhaustive import many
from notes import NAMES, note, program
from pdf_words import POINT, pages
from spoken import EVERY, LAID_OUT, read_in

from tmm_report.report.paper import measure

MM = 96 / 25.4  # CSS pixels


@pytest.fixture(params=many(["compressor-ru", "compressor-en", "shaper-ru", "hoist_drive-ru"], quick=0))
def seen(request) -> Seen:
    """A note opened in the browser at A4's text width."""
    return browser.seen(request.param)


def test_console_has_no_errors(seen):
    assert seen.console == []


def test_nothing_is_fetched(seen):
    text = seen.text
    assert [name for name in seen.asked if not name.startswith("data:")] == []
    assert re.search(r"Content-Security-Policy[^>]*default-src 'none'", text)
    assert not re.search(r"(?:src|href)\s*=\s*[\"'](?!#|data:)", text)
    assert not re.search(r"url\((?!['\"]?(?:data:|#))|@import", text)
    assert seen.measures["images"] == 0


def test_formulas_and_figures_are_there(seen):
    text, page = seen.text, seen.measures
    maths = re.findall(r"<math(?=[ >])[^>]*>", text)
    assert len(page["maths"]) == len(maths) > 100
    # a minus sign that is repeated where a line breaks is as low as 5 px
    least = [4.9 if 'class="again"' in tag else 5 for tag in maths]
    assert all(w > 1 and h > low for (w, h), low in zip(page["maths"], least, strict=True))
    assert len(page["figures"]) == len(re.findall(r"<figure[ >]", text)) >= 7
    # at a dead point all vectors of a plan lie on one line
    assert all(max(box) > 30 * MM and min(box) > 2 * MM for box in page["figures"])
    assert page["errors"] == 0 and page["fonts"] and set(page["fonts"]) == {"loaded"}


def test_links_lead_somewhere(seen):
    assert seen.measures["broken"] == []


def test_page_does_not_scroll_sideways(seen):
    page = seen.measures
    assert page["page"] <= page["shown"] and page["overlong"] == 0


quick_or_all = pytest.mark.parametrize("quick", many([True, False]), ids=["two", "others"])


@pytest.mark.exhaustive
@quick_or_all
def test_nothing_printed_is_wider_than_the_text(quick):
    """What is wider makes the browser shrink the whole note, its drawings with it."""
    pages = browser.in_print(quick)
    assert len(pages) == (2 if quick else len(NAMES) + len(EVERY) - 2)
    assert {name: page["wide"] for name, page in pages.items() if page["wide"]} == {}
    for name, page in pages.items():
        assert page["text"] == pytest.approx(browser.text_of(name) * browser.PIXELS, abs=1)


@pytest.mark.exhaustive
@quick_or_all
def test_formulas_are_as_wide_as_they_are_reckoned(quick):
    """The metrics by which lines are broken against the browser's own layout."""
    maths = [one for page in browser.in_print(quick).values() for one in page["maths"]]
    off = []
    for text, wide in maths:
        plain = re.sub(r' xmlns="[^"]*"', "", text).replace("&nbsp;", "\N{NO-BREAK SPACE}")
        if wide > 20 and not 0.98 < measure.mathematics(plain) / wide < 1.15:
            off.append((measure.mathematics(plain), wide, plain[:300]))
    assert len(maths) > (50 if quick else 5000) and off == []
    assert sum(wide > 20 for _, wide in maths) > (2 if quick else 20)


@pytest.mark.exhaustive
def test_a_long_formula_breaks_at_a_sign_that_is_repeated():
    text = browser.PAGES["wide-ru"]().decode()
    ends = re.findall(
        r'class="again" aria-hidden="true"><mo form="infix">(.)</mo></math><br/>\s*'
        r'<math><mo form="infix">(.)</mo>', text,
    )  # fmt: skip
    assert len(ends) == text.count('class="again"') > 3 and all(one == other for one, other in ends)
    assert "·" not in {one for one, _ in ends}


def test_no_line_begins_with_the_stop_behind_a_formula():
    """Between a formula of the running text and the sign behind it no line may end."""
    text = note("compressor", "html", "en")["note.html"].decode()
    kept = r"<nobr>[^<]*<math.*?</math>\u2060[.,;:)]*</nobr>"
    assert len(re.findall(kept, text)) > 50
    assert not re.search(r"</math>\u2060?[.,;:)](?![^<]*</(?:div|th)>)", re.sub(kept, "", text))


def test_tables_and_figures_fit_a_printed_page(seen):
    """Nothing that must stay whole in the text is larger than the text area of A4."""
    page = seen.measures
    assert all(width <= 185 * MM and height <= 257 * MM for width, height in page["tables"])
    assert all(width <= 185 * MM and height <= 250 * MM for width, height in page["inText"])


@pytest.mark.exhaustive
@pytest.mark.parametrize("language", many(LAID_OUT))
def test_prints_to_a4(language, tmp_path):
    pdf = tmp_path / "note.pdf"
    pdf.write_bytes(browser.seen(f"compressor-{language}").pdf)
    info = subprocess.run([program("pdfinfo"), str(pdf)], capture_output=True, text=True, check=True).stdout
    assert re.search(r"Page size:\s+59[45]\.\d+ x 84[12]\.\d+ pts \(A4\)|Page size:\s+595 x 842", info), info
    found = pages(pdf.read_bytes())
    assert len(found) > 50 and sum(len(page.words) for page in found) > 1000
    # nothing is cut at the right edge of its sheet
    assert all(word.right <= page.wide - 10 * POINT for page in found for word in page.words)


@pytest.mark.parametrize("name", NAMES)
def test_every_variant_makes_a_note_in_each_language(name):
    for language in read_in(name):
        text = note(name, "html", language)["note.html"].decode()
        assert f'lang="{language}"' in text and "<math" in text
        assert not re.search(
            r"\bnan\b|\binf\b|-0(?![\d.,])|e-1\d\b",
            re.sub(r"<style.*?</style>|<svg.*?</svg>|<script.*?</script>", "", text, flags=re.S),
        )

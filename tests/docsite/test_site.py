"""The documentation site: its pages are gathered with their links and formulas, and built without a broken link."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

import pytest
import theory_formulas as formulas
from pages_of_docs import PAGES, ROOT
from site_pages import GUIDES, _name, relinked

from tmm_report.report.sources import SOURCES

DOCS = ROOT / "docs"
THEORY = {page: text for page, text in PAGES.items() if page.startswith("docs/theory/")}
ASKED = sorted({found.groups() for text in THEORY.values() for found in formulas.LINE.finditer(text)})


def test_a_readme_is_the_page_of_its_folder():
    assert _name(DOCS / "gallery" / "README.md", DOCS) == "gallery/index.md"
    assert _name(DOCS / "variant.md", DOCS) == "variant.md"


def test_links_lead_to_pages_of_the_site_or_lose_their_address():
    places = {(ROOT / file).resolve(): page for page, file in GUIDES.items()}
    places |= {DOCS / "variant.md": "variant.md", DOCS / "theory" / "cams.md": "theory/cams.md"}
    text = "[a](../variant.md#limits) [b](../../tmm_report/README.md) [c](../../tests/conftest.py) [d](https://x.org)\n"
    code = "```md\n[a](../../variants/x.yaml)\n```\n"
    done = relinked(text + code, DOCS / "theory" / "cams.md", "theory/cams.md", places, set())
    assert done == "[a](../variant.md#limits) [b](../program.md) c [d](https://x.org)\n" + code


def test_theory_has_its_sources_and_formulas():
    books = [
        book
        for text in THEORY.values()
        for found in formulas.BOOKS.finditer(text)
        for book in found[1].split()
    ]
    assert {*books} <= {*SOURCES} and len({*books}) >= 12
    assert len(THEORY) > 10 and len(ASKED) > 70
    for page, text in THEORY.items():
        assert page.endswith("index.md") or (formulas.LINE.search(text) and "## Sources" in text), page


RUSSIAN = {page: text for page, text in PAGES.items() if page.startswith("docs/ru/theory/")}


def test_theory_says_the_same_in_russian():
    """The same pages, of the same formulas in the same order, with as many headings and the same books."""
    assert {page.replace("/ru/", "/") for page in RUSSIAN} == set(THEORY)
    for page, text in RUSSIAN.items():
        english = THEORY[page.replace("/ru/", "/")]
        for mark in (formulas.LINE, formulas.BOOKS, re.compile("^(#+) ", re.M), re.compile(r"^(\|)", re.M)):
            assert mark.findall(text) == mark.findall(english), page
        prose = re.sub(r"<!--.*?-->|`[^`]*`|\([^)]*\)", "", text)
        assert not re.search(r"[A-Za-z]{4,}", prose), page
        paragraphs = [len(re.split(r"\n\n+", one.strip())) for one in (text, english)]
        assert paragraphs[0] == paragraphs[1], page


def test_a_formula_of_a_russian_page_has_russian_letters():
    line = "<!-- formula: rotor rotor_e -->\n<!-- sources: balancing -->"
    russian, english = (formulas.filled(line, language) for language in ("ru", "en"))
    told = [text.partition("\n- ")[0] for text in (russian, english)]  # without the books
    assert [bool(re.search("[а-я]{5,}", text)) for text in told] == [True, False]
    assert re.findall("<mi>(.*?)</mi>", russian.partition("</div>")[0]) == re.findall(
        "<mi>(.*?)</mi>", english.partition("</div>")[0]
    )


def test_a_formula_is_the_symbols_of_the_note_without_its_numbers():
    found = formulas.formula("rotor", "rotor_e", "en")
    assert "data-q" not in found and '<math><mi>e</mi><mo form="infix">=</mo><mfrac>' in found
    assert "of the mass centre" in found or "eccentricity" in found
    with pytest.raises(formulas.NoFormula, match="rotor_D_per"):
        formulas.formula("rotor", "no_such", "en")


@pytest.mark.exhaustive
@pytest.mark.parametrize("variant", sorted({variant for variant, _ in ASKED}))
def test_every_formula_of_the_theory_is_in_the_note(variant):
    for name, key in ASKED:
        if name == variant:
            for language in ("en", "ru"):
                found = formulas.formula(variant, key, language)
                assert found.count("<math>") >= 1 and "data-q" not in found, key
                assert not re.search(r"<mn[^>]*>\d+[.,]\d{3,}", found), key  # a number of the variant


# --- built


class Links(HTMLParser):
    """What a page points to, what it fetches, and its anchors."""

    def __init__(self, text: str):
        super().__init__()
        self.to: list[str] = []
        self.fetched: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        self.anchors |= {given[key] for key in ("id", "name") if given.get(key)}
        if tag == "a" and given.get("href"):
            self.to.append(given["href"])
        source = given.get("src") or given.get("href")
        loads = tag in ("script", "img", "iframe") or (
            tag == "link" and given.get("rel") in ("stylesheet", "icon")
        )
        if source and loads:
            self.fetched.append(source)


@pytest.fixture(scope="module")
def site(tmp_path_factory) -> Path:
    pytest.importorskip("zensical")
    place = tmp_path_factory.mktemp("site") / "site"
    env = os.environ | {"PYTHONPATH": str(ROOT)}
    command = [sys.executable, str(ROOT / "tools" / "docsite"), "-o", str(place)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, env=env)
    assert done.returncode == 0, done.stdout + done.stderr
    return place


@pytest.mark.exhaustive
def test_every_page_is_built_and_nothing_leads_nowhere(site):
    pages = {
        page: Links(page.read_text("utf-8")) for page in site.rglob("*.html") if page.parent.name != "notes"
    }
    missing = []
    for page, links in pages.items():
        if page.name == "404.html":
            continue
        for to in [*links.to, *links.fetched]:
            if re.match(r"[a-z]+:|//|#$", to):
                continue
            place, _, anchor = unquote(to).partition("#")
            target = (page.parent / place.partition("?")[0]).resolve() if place else page
            if target.is_dir():
                target /= "index.html"
            if not target.exists() or (anchor and target in pages and anchor not in pages[target].anchors):
                missing.append((str(page.relative_to(site)), to))
    assert not missing
    names = {page.relative_to(site).as_posix() for page in pages}
    for page in PAGES:
        if page.startswith("docs/"):
            name = page.removeprefix("docs/").replace("README.md", "index.md")
            assert name.removesuffix(".md") + ".html" in names, page
    assert {"format/mechanism.html", "ru/format/mechanism.html", "theory/gears.html"} <= names


@pytest.mark.exhaustive
def test_nothing_is_fetched_from_elsewhere(site):
    for page in site.rglob("*.html"):
        links = Links(page.read_text("utf-8"))
        assert not [one for one in links.fetched if re.match(r"https?:|//", one)], page


@pytest.mark.exhaustive
def test_the_two_languages_lead_to_each_other(site):
    assert 'lang="en"' in (site / "index.html").read_text("utf-8")
    assert 'lang="ru"' in (site / "ru" / "index.html").read_text("utf-8")
    english, russian = (Links((site / name).read_text("utf-8")) for name in ("index.html", "ru/index.html"))
    assert any(to.endswith("ru/index.html") for to in english.to)
    assert any((site / "ru" / to).resolve() == site / "index.html" for to in russian.to)

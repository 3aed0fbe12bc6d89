"""The HTML note as a browser shows it: headless Chromium opens it, measures it and prints it."""

from __future__ import annotations

import html
import json
import re
import subprocess
from pathlib import Path

import pytest
from notes import NAMES, note, program

from tmm_report.languages import LANGUAGES

QUIET = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-extensions",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
]  # fmt: skip
MM = 96 / 25.4  # CSS pixels

# What the page itself can tell; it is put into a copy of the note, never into the note.
PROBE = """
<pre id="probe"></pre><script>
window.addEventListener("load", () => document.fonts.ready.then(() => {
  const box = e => { const r = e.getBoundingClientRect(); return [r.width, r.height]; };
  const right = e => e.getBoundingClientRect().right;
  const all = s => [...document.querySelectorAll(s)];
  const broken = all('a[href^="#"]').filter(a => !document.getElementById(decodeURIComponent(a.hash.slice(1))));
  document.getElementById("probe").textContent = "PROBE" + JSON.stringify({
    maths: all("math").map(box), figures: all("figure svg").map(box), tables: all("table").map(box),
    images: all("img").length, broken: broken.map(a => a.hash), fonts: [...document.fonts].map(f => f.status),
    page: document.documentElement.scrollWidth, shown: document.documentElement.clientWidth,
    asked: performance.getEntriesByType("resource").map(e => e.name.slice(0, 200)),
    errors: all("merror, parsererror").length, lang: document.documentElement.lang,
    overlong: all("math").filter(m => right(m) > right(m.closest("section, main, body")) + 1).length,
  }) + "EBORP";
}));
</script></body>
"""


def chromium(folder: Path, page: Path, *options: str) -> subprocess.CompletedProcess[str]:
    browser = program("chromium", "chromium-browser", "google-chrome")
    command = [
        browser,
        *QUIET,
        f"--user-data-dir={folder / 'profile'}",
        "--enable-logging=stderr",
        *options,
        page.as_uri(),
    ]
    return subprocess.run(
        command, capture_output=True, text=True, timeout=120, encoding="utf-8", errors="replace"
    )


@pytest.fixture(scope="module", params=["compressor-ru", "compressor-en", "shaper-ru", "hoist_drive-ru"])
def seen(request, tmp_path_factory):
    """A note opened in the browser at A4's text width: its measures and the console."""
    name, language = request.param.split("-")
    folder = tmp_path_factory.mktemp("browser")
    text = note(name, "html", language)["note.html"].decode()
    page = folder / "note.html"
    # the note forbids itself every script, the probe's too; its copy may run one
    probed = text.replace("Content-Security-Policy", "x-policy").replace("</body>", PROBE)
    page.write_text(probed, encoding="utf-8")
    done = chromium(folder, page, "--dump-dom", "--window-size=1000,1200", "--virtual-time-budget=20000")
    measured = re.search(r"PROBE(.*?)EBORP", done.stdout.split('id="probe"')[-1], re.S)
    assert measured, done.stderr[-2000:]
    return text, json.loads(html.unescape(measured[1])), done.stderr


def test_console_has_no_errors(seen):
    _, _, console = seen
    assert not re.findall(r".*CONSOLE.*", console)


def test_nothing_is_fetched(seen):
    text, page, _ = seen
    assert [name for name in page["asked"] if not name.startswith("data:")] == []
    assert re.search(r"Content-Security-Policy[^>]*default-src 'none'", text)
    assert not re.search(r"(?:src|href)\s*=\s*[\"'](?!#|data:)", text)
    assert not re.search(r"url\((?!['\"]?(?:data:|#))|@import", text)
    assert page["images"] == 0


def test_formulas_and_figures_are_there(seen):
    text, page, _ = seen
    assert len(page["maths"]) == len(re.findall(r"<math[ >]", text)) > 100
    assert all(width > 1 and height > 5 for width, height in page["maths"])
    assert len(page["figures"]) == len(re.findall(r"<figure[ >]", text)) >= 7
    # at a dead point all vectors of a plan lie on one line
    assert all(max(box) > 30 * MM and min(box) > 2 * MM for box in page["figures"])
    assert page["errors"] == 0 and page["fonts"] and set(page["fonts"]) == {"loaded"}


def test_links_lead_somewhere(seen):
    assert seen[1]["broken"] == []


def test_page_does_not_scroll_sideways(seen):
    _, page, _ = seen
    assert page["page"] <= page["shown"] and page["overlong"] == 0


def test_tables_and_figures_fit_a_printed_page(seen):
    """Nothing that must stay whole is larger than the text area of A4."""
    _, page, _ = seen
    assert all(width <= 185 * MM and height <= 257 * MM for width, height in page["tables"])
    assert all(width <= 185 * MM and height <= 250 * MM for width, height in page["figures"])


@pytest.mark.parametrize("language", LANGUAGES)
def test_prints_to_a4(language, tmp_path):
    page, pdf = tmp_path / "note.html", tmp_path / "note.pdf"
    page.write_bytes(note("compressor", "html", language)["note.html"])
    chromium(tmp_path, page, f"--print-to-pdf={pdf}", "--no-pdf-header-footer")
    info = subprocess.run([program("pdfinfo"), str(pdf)], capture_output=True, text=True, check=True).stdout
    assert re.search(r"Page size:\s+59[45]\.\d+ x 84[12]\.\d+ pts \(A4\)|Page size:\s+595 x 842", info), info
    words = subprocess.run(
        [program("pdftotext"), "-bbox", str(pdf), "-"], capture_output=True, text=True, check=True
    ).stdout
    edges = [float(x) for x in re.findall(r'xMax="([\d.]+)"', words)]
    assert len(edges) > 1000 and max(edges) <= 595.5 - 10  # nothing is cut at the right edge of the sheet


@pytest.mark.parametrize("name", NAMES)
def test_every_variant_makes_a_note_in_both_languages(name):
    for language in LANGUAGES:
        text = note(name, "html", language)["note.html"].decode()
        assert f'lang="{language}"' in text and "<math" in text
        assert not re.search(
            r"\bnan\b|\binf\b|-0(?![\d.,])|e-1\d\b",
            re.sub(r"<style.*?</style>|<svg.*?</svg>|<script.*?</script>", "", text, flags=re.S),
        )

"""Offences against the norm, planted one at a time in the files of a note: what the norm control must name."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple

Files = dict[str, bytes]
HTML, TEX, LOG, PDF = "note.html", "note.tex", "note.log", "note.pdf"
_SVG = re.compile(r"(<figure id=\"figure2\">\s*<svg.*?)(</g></g></svg>)", re.S)
_TEXT = re.compile(r'<text x="(?P<x>[-\d.]+)" y="(?P<y>[-\d.]+)"')


class Offence(NamedTuple):
    """`check`: the key under which it must be named, at the file."""

    name: str
    check: str
    file: str
    plant: Callable[[Files], Files]


def edit(file: str, pattern: str, new: str) -> Callable[[Files], Files]:
    """The first place of a pattern, and there must be one, is written otherwise."""

    def plant(files: Files) -> Files:
        text, count = re.subn(pattern, new, files[file].decode(), count=1, flags=re.S)
        assert count == 1, pattern
        return files | {file: text.encode()}

    return plant


def every(file: str, pattern: str, new: str) -> Callable[[Files], Files]:
    def plant(files: Files) -> Files:
        text, count = re.subn(pattern, new, files[file].decode(), flags=re.S)
        assert count, pattern
        return files | {file: text.encode()}

    return plant


def both(*plants: Callable[[Files], Files]) -> Callable[[Files], Files]:
    def plant(files: Files) -> Files:
        for one in plants:
            files = one(files)
        return files

    return plant


def log(text: str) -> Callable[[Files], Files]:
    return lambda files: files | {LOG: f"This is pdfTeX\n\n{text}\n".encode()}


def pdf(contents: bytes) -> Callable[[Files], Files]:
    return lambda files: files | {PDF: pages(b"0 0 595 842 re f", contents)}


def pages(*contents: bytes) -> bytes:
    """A PDF whose pages are drawn by these operators."""
    kids = " ".join(f"{3 + 2 * k} 0 R" for k in range(len(contents))).encode()
    objects = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [%s] /Count %d /MediaBox [0 0 595 842] >>" % (kids, len(contents)),
    ]
    for k, content in enumerate(contents):
        objects.append(b"<< /Type /Page /Parent 2 0 R /Contents %d 0 R >>" % (4 + 2 * k))
        objects.append(b"<< /Length %d >>\nstream\n%s\nendstream" % (len(content), content))
    out, places = b"%PDF-1.4\n", []
    for number, body in enumerate(objects, 1):
        places.append(len(out))
        out += b"%d 0 obj\n%s\nendobj\n" % (number, body)
    table = b"".join(b"%010d 00000 n \n" % place for place in places)
    size = len(objects) + 1
    return out + (
        b"xref\n0 %d\n0000000000 65535 f \n%strailer\n<< /Size %d /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n"
        % (size, table, size, len(out))
    )


def letter(where: str) -> Callable[[Files], Files]:
    """One lettering more in the second figure, beside the first of it: `where` puts it."""

    def plant(files: Files) -> Files:
        text = files[HTML].decode()
        figure = _SVG.search(text)
        assert figure
        first = _TEXT.search(figure[1])
        box = re.search(r'viewBox="([-\d.]+) ([-\d.]+) ', figure[1])
        assert first and box
        places = {
            "on a lettering": (float(first["x"]), float(first["y"])),
            "at the edge": (float(box[1]) - 5, float(box[2]) + 20),
        }
        x, y = places[where]
        more = f'<text x="{x}" y="{y}"><tspan font-size="3.2">Щ</tspan></text>'
        return files | {HTML: (text[: figure.end(1)] + more + text[figure.end(1) :]).encode()}

    return plant


def line(files: Files) -> Files:
    """A line through the first lettering of the second figure."""
    text = files[HTML].decode()
    figure = _SVG.search(text)
    first = _TEXT.search(figure[1]) if figure else None
    assert figure and first
    x, y = float(first["x"]), float(first["y"]) - 1
    more = f'<path d="M{x - 9} {y}L{x + 9} {y}" stroke="#000000" stroke-width="0.35"/>'
    at = text.index("<text", figure.start())
    return files | {HTML: (text[:at] + more + text[at:]).encode()}


_CELL = r'(data-q="E" data-k="{row}" data-t="governor_equilibrium">)[\d,]+'
LINK = r'<a href="#{0}">\d+</a>'
OFFENCES = (
    # --- references ---
    Offence("a figure that no sentence names", "unreferenced", HTML, every(HTML, LINK.format("figure3"), "")),
    Offence("a table that no sentence names", "unreferenced", HTML, every(HTML, LINK.format("table3"), "")),
    Offence("a figure that the LaTeX does not name", "unreferenced", TEX,
            every(TEX, r"\\hyperlink\{figure3\}\{3\}", "")),
    Offence("a figure named behind itself", "late", HTML,
            both(every(HTML, LINK.format("figure3"), ""),
                 edit(HTML, r"(<figcaption>[^<]*3 [–—] .*?</figure>)", r'\1<p><a href="#figure3">3</a></p>'))),
    Offence("a table named behind itself", "late", HTML,
            both(every(HTML, LINK.format("table3"), ""),
                 edit(HTML, r"(</main>)", r'<p><a href="#table3">3</a></p>\1'))),
    Offence("figures named in another order", "disorder", HTML,
            edit(HTML, LINK.format("figure2"), '<a href="#figure3">3</a>, <a href="#figure2">2</a>')),
    Offence("a reference to nothing", "nowhere", HTML,
            edit(HTML, LINK.format("figure2"), r'\g<0>, <a href="#figure99">99</a>')),
    # --- numbers that follow one another ---
    Offence("a figure's number left out", "gap", HTML, every(HTML, r"figure4\b", "figure5")),
    Offence("a table's number left out", "gap", HTML, every(HTML, r"table5\b", "table6")),
    Offence("a formula's number left out", "gap", HTML, every(HTML, r'id="formula2\.7"', 'id="formula2.71"')),
    Offence("a section's number left out", "gap", HTML, every(HTML, r"section2\.2\b", "section2.4")),
    Offence("a formula's number twice in the LaTeX", "gap", TEX,
            edit(TEX, r"\\NoteFormula\{formula2\.7\}\{2\.7\}", r"\\NoteFormula{formula2.6}{2.6}")),
    # --- numbers ---
    Offence("a head without its unit", "unit", HTML,
            edit(HTML, r"(id=\"table4\".*?<mi>E</mi></math>), Н", r"\1")),
    Offence("a result without its unit", "unit", HTML,
            edit(HTML, r'(<mn data-q="E"[^>]*>[^<]*</mn>)<mspace[^>]*/><mtext>[^<]*</mtext>(</math>,</div>)',
                 r"\1\2")),
    Offence("a point in a column of commas", "decimal", HTML, edit(HTML, _CELL.format(row=3), r"\g<1>2868.9")),
    Offence("a point in a formula of the LaTeX", "decimal", TEX, edit(TEX, r"(\d)\{,\}(\d)", r"\1.\2")),
    Offence("noise in a column", "noise", HTML, edit(HTML, _CELL.format(row=3), r"\g<1>0,0013")),
    Offence("noise as a result", "noise", HTML,
            edit(HTML, r'(<mn data-q="governor_delta"[^>]*>)[^<]*', r"\g<1>6,9·10⁻¹⁴")),
    Offence("another last digit", "twice", HTML, edit(HTML, _CELL.format(row=5), r"\g<1>3130,9")),
    Offence("another last digit in one formula, between rounded columns", "twice", HTML,
            edit(HTML, r'(id="formula2\.7".*?<mn data-q="E"[^>]*>)3130,6<', r"\g<1>3130,7<")),
    Offence("1.1 and 1.09999", "twice", HTML,
            edit(HTML, r'(<mn data-q="governor_a"[^>]*>)0,08<', r"\g<1>0,0799999<")),
    Offence("one value to other digits", "twice", HTML,
            edit(HTML, r'(<mn data-q="governor_F_0"[^>]*>)2440,9<', r"\g<1>2441<")),
    # --- drawings ---
    Offence("a drawing without its scale", "scale", HTML,
            edit(HTML, r"(<figcaption>)[^<]*2 [–—] .*?(</figcaption>)", r"\1Рисунок 2 — Регулятор\2")),
    Offence("lettering on lettering", "lettering", HTML, letter("on a lettering")),
    Offence("lettering over the edge", "lettering", HTML, letter("at the edge")),
    Offence("a line through lettering", "crossed", HTML, line),
    # --- paper ---
    Offence("a table over the margin", "margin", HTML,
            edit(HTML, r'(id="table5".*?<tr>.*?<th[^>]*>)', r"\g<1><math><mn>" + "9" * 80 + "</mn></math>")),
    Offence("a formula over the margin", "margin", HTML,
            edit(HTML, r'(id="formula2\.7"><div class="math"><math>)',
                 r"\1<mn>" + "8" * 80 + "</mn>")),
    Offence("a picture over the margin", "margin", HTML,
            edit(HTML, r'(<figure id="figure3">\s*<svg [^>]*width=")[\d.]+mm', r"\g<1>181mm")),
    Offence("a box that TeX finds too wide", "margin", LOG,
            log(r"Overfull \hbox (12.5pt too wide) in paragraph at lines 100--102")),
    Offence("a page with one line", "empty", PDF, pdf(b"100 700 300 18 re f 290 28 10 12 re f")),
    # --- letters ---
    Offence("a letter that no face has", "glyph", HTML, edit(HTML, r"<p>", "<p>機")),
    Offence("a letter that was lost", "glyph", TEX, 
            edit(TEX, r"(\\begin\{document\})", "\\1\N{REPLACEMENT CHARACTER}")),
    Offence("a letter that TeX misses", "glyph", LOG,
            log("Missing character: There is no ӂ in font larm1200!")),
)  # fmt: skip

"""Remake the faces of the notes: `python tools/fonts.py FOLDER`, with fonttools and brotli installed.

FOLDER holds LiberationSerif-Regular.ttf, -Bold.ttf and -Italic.ttf 2.1.5 (Debian's package fonts-liberation2).
Writes the subsets `templates/fonts/NoteSerif-*.woff2` (renamed, for "Liberation" is a reserved font name), each beside
it unpacked, as Typst reads it (`.ttf`, `.otf`), and `templates/fonts/widths.json`, how far each letter of these faces
and of the formulas' one advances; the formulas' face loses the shapes for an index of an index, a quarter of it. The
same fonts give the same bytes.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

FONTS = Path(__file__).resolve().parent.parent / "templates" / "fonts"
STYLES = {"Regular": "regular", "Bold": "bold", "Italic": "italic"}
MATH = "STIXTwoMath-subset.woff2"
SETS = [
    (0x20, 0x7E), (0xA0, 0xFF),  # Latin
    (0x11E, 0x11F), (0x130, 0x131), (0x15E, 0x15F), (0x16A, 0x16B),  # and what a Kazakh name has of it
    (0x391, 0x3A9), (0x3B1, 0x3C9), (0x3D1, 0x3D1), (0x3D5, 0x3D5),  # Greek
    (0x401, 0x401), (0x404, 0x404), (0x406, 0x407), (0x40E, 0x44F), (0x451, 0x451), (0x454, 0x454), (0x456, 0x457),
    (0x45E, 0x45E), (0x490, 0x493), (0x49A, 0x49B), (0x4A2, 0x4A3), (0x4AE, 0x4B1), (0x4BA, 0x4BB), (0x4D8, 0x4D9),
    (0x4E8, 0x4E9),  # Cyrillic: Russian, Ukrainian, Belarusian, Kazakh
    (0x300, 0x304), (0x2010, 0x2015), (0x2018, 0x201E), (0x2020, 0x2022), (0x2026, 0x2026), (0x202F, 0x202F),
    (0x2030, 0x2033), (0x2039, 0x203A), (0x203E, 0x203E), (0x2044, 0x2044), (0x2070, 0x208E), (0x20AC, 0x20AC),
    (0x2116, 0x2116), (0x2190, 0x2195), (0x2202, 0x2202), (0x2206, 0x2206), (0x2211, 0x2212), (0x221A, 0x221A),
    (0x221E, 0x221E), (0x222B, 0x222B), (0x2248, 0x2248), (0x2260, 0x2260), (0x2264, 0x2265),
]  # fmt: skip


def main(folder: Path) -> None:
    widths = {}
    for style, key in STYLES.items():
        font = TTFont(folder / f"LiberationSerif-{style}.ttf", recalcTimestamp=False)
        subset(font)
        renamed(font, style)
        font.flavor = "woff2"
        font.save(FONTS / f"NoteSerif-{style}.woff2")
        unpacked(font, FONTS / f"NoteSerif-{style}.ttf")
        widths[key] = advances(font)
    math = TTFont(FONTS / MATH, recalcTimestamp=False)
    once_smaller(math)
    math.save(FONTS / MATH)
    unpacked(math, (FONTS / MATH).with_suffix(".otf"))
    widths["math"] = advances(math)
    text = json.dumps(widths, ensure_ascii=False, separators=(",", ":"))
    (FONTS / "widths.json").write_text(text.replace('},"', '},\n"') + "\n", "utf-8")


def unpacked(font: TTFont, file: Path) -> None:
    font.flavor = None
    font.save(file)


def subset(font: TTFont) -> None:
    options = Options()
    options.hinting = False
    options.layout_features = ["kern", "liga", "locl", "mark"]
    options.name_IDs = ["*"]
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=[code for first, last in SETS for code in range(first, last + 1)])
    subsetter.subset(font)


def once_smaller(font: TTFont) -> None:
    """The face of formulas with one smaller shape a letter, that of an index; an index of an index is the letter."""
    for lookup in font["GSUB"].table.LookupList.Lookup:
        for table in lookup.SubTable:
            for letter, shapes in getattr(table, "alternates", {}).items():
                table.alternates[letter] = shapes[:1]
    options = Options()
    options.hinting = False
    options.layout_features = ["ssty", "dtls", "flac"]
    options.desubroutinize = True  # what is said in full compresses better
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=font.getBestCmap())
    subsetter.subset(font)


def renamed(font: TTFont, style: str) -> None:
    """Another name for the changed face; what is said of rights and the licence stays."""
    names = {
        1: "Note Serif",
        2: style,
        3: f"Note Serif {style}",
        4: f"Note Serif {style}",
        6: f"NoteSerif-{style}",
    }
    for record in list(font["name"].names):
        if record.nameID in names:
            record.string = names[record.nameID]
        elif record.nameID not in (0, 5, 13, 14):  # rights, version, licence and where it stands
            font["name"].removeNames(record.nameID, record.platformID, record.platEncID, record.langID)


def advances(font: TTFont) -> dict[str, int]:
    """How far each letter advances, thousandths of the size."""
    em = font["head"].unitsPerEm
    by_code = sorted(font.getBestCmap().items())
    return {chr(code): round(1000 * font["hmtx"][glyph][0] / em) for code, glyph in by_code}


if __name__ == "__main__":
    main(Path(sys.argv[1]))

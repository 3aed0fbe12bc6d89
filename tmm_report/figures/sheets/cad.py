"""A sheet as DXF R2010 by ezdxf: true millimetres, a layer a kind of line, letters as text.

Only here ezdxf is known. The same sheet gives the same bytes: no date and no number of its own stands in the file.
"""

from __future__ import annotations

import io
import math
from typing import Any

from tmm_report.figures.drawing import COLOURS, Arc, Arrow, Circle, Item, Path, Pen, Text
from tmm_report.figures.sheets.lines import CENTRE, DASHED, HALF, LONG, MAIN, PHANTOM, SHORT, THIN
from tmm_report.figures.sheets.sheet import Sheet
from tmm_report.figures.sheets.strokes import Letters

TYPES = {
    "GOST_DASHED": DASHED,
    "GOST_LONG": LONG,
    "GOST_SHORT": SHORT,
    "GOST_CENTRE": CENTRE,
    "GOST_PHANTOM": PHANTOM,
}
LAYERS = {  # type of line, mm wide
    "FRAME": ("CONTINUOUS", MAIN), "MAIN": ("CONTINUOUS", MAIN), "HALF": ("CONTINUOUS", HALF),
    "THIN": ("CONTINUOUS", THIN), "DASHED": ("GOST_DASHED", HALF), "CENTRE": ("GOST_CENTRE", HALF),
    "PHANTOM": ("GOST_PHANTOM", HALF), "LONG": ("GOST_LONG", HALF), "SHORT": ("GOST_SHORT", HALF),
    "FILL": ("CONTINUOUS", THIN), "TEXT": ("CONTINUOUS", THIN),
}  # fmt: skip
BROKEN = {DASHED: "DASHED", LONG: "LONG", SHORT: "SHORT", CENTRE: "CENTRE", PHANTOM: "PHANTOM"}
STYLE, FONT = (
    "GOST",
    "isocpeur.ttf",
)  # narrow drawing letters that CAD programs have, or what they put in their place


def dxf(sheet: Sheet) -> bytes:
    """Raises ImportError where ezdxf is not installed."""
    import ezdxf  # an extra

    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        drawn = ezdxf.new("R2010", units=4)  # mm
        _prepare(drawn)
        space = drawn.modelspace()
        frame, _ = sheet.frame
        for item in frame:
            thick = isinstance(item, Path) and item.pen is not None and item.pen.width >= MAIN
            _add(space, item, "FRAME" if thick else "")
        for block in sheet.blocks:
            for item in block.items:
                _add(space, item)
        for letters in sheet.letters:
            _write(space, letters)
        drawn.header["$EXTMIN"], drawn.header["$EXTMAX"] = (
            (0, 0, 0),
            (sheet.format.wide, sheet.format.tall, 0),
        )
        out = io.StringIO()
        drawn.write(out)
        return out.getvalue().encode("utf-8")
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before


def _prepare(drawn: Any) -> None:
    for name, dash in TYPES.items():
        signed = [length if n % 2 == 0 else -length for n, length in enumerate(dash)]
        drawn.linetypes.add(name, [sum(dash), *signed])
    for name, (kind, wide) in LAYERS.items():
        drawn.layers.add(name, linetype=kind, lineweight=round(100 * wide))
    drawn.styles.add(STYLE, font=FONT)


def layer(pen: Pen) -> str:
    if pen.dash:
        return BROKEN[pen.dash]
    return "MAIN" if pen.width >= MAIN else "HALF" if pen.width >= HALF else "THIN"


def _add(space: Any, item: Item, on: str = "") -> None:
    match item:
        case Path():
            for stroke in item.strokes:
                points = [(z.real, z.imag) for z in stroke]
                if item.fill and len(points) > 2:
                    _fill(space, item.fill, item.opacity).paths.add_polyline_path(points, is_closed=True)
                if item.pen is not None and len(points) > 1:
                    look = {"layer": on or layer(item.pen)}
                    if len(points) == 2:
                        space.add_line(*points, dxfattribs=look)
                    else:
                        space.add_lwpolyline(points, close=item.closed, dxfattribs=look)
        case Circle():
            centre = (item.centre.real, item.centre.imag)
            if item.fill:
                _fill(space, item.fill, 1.0).paths.add_edge_path().add_arc(centre, item.radius)
            if item.pen is not None:
                space.add_circle(centre, item.radius, dxfattribs={"layer": on or layer(item.pen)})
        case Arc():
            low, high = sorted((math.degrees(item.start), math.degrees(item.end)))
            look = {"layer": on or layer(item.pen)}
            space.add_arc((item.centre.real, item.centre.imag), item.radius, low, high, dxfattribs=look)
        case Arrow():  # its line to the very tip, by which it is measured
            _add(space, Path(((item.start, item.end),), item.pen), on)
            _add(space, item.parts[1], on)
        case Text():
            raise TypeError("letters have their own way")


def _fill(space: Any, fill: str, opacity: float) -> Any:
    hatch = space.add_hatch(color=7, dxfattribs={"layer": "FILL"})
    if fill != "black":  # black is what is drawn with, white on a dark screen
        code = COLOURS[fill]
        hatch.rgb = tuple(round(255 - opacity * (255 - int(code[i : i + 2], 16))) for i in (0, 2, 4))
    return hatch


def _write(space: Any, letters: Letters) -> None:
    """As text, fitted between the ends of its strokes: as wide in whatever face a program puts in place of FONT."""
    from ezdxf.enums import TextEntityAlignment

    for run in letters.runs:
        look = {"layer": "TEXT", "style": STYLE, "height": run.tall, "width": letters.squeeze}
        if letters.turned:
            look["rotation"] = 180.0
        start, end = (letters.place(run.at + more) for more in (0.0, letters.squeeze * run.wide))
        text = space.add_text(literal(run.text), dxfattribs=look)
        text.set_placement((start.real, start.imag), (end.real, end.imag), TextEntityAlignment.FIT)
        for bar in letters.bars(run):
            _add(space, Path((tuple(map(letters.place, bar)),), Pen(THIN)), "TEXT")


def literal(text: str) -> str:
    """Text in which nothing is a command of DXF."""
    return text.replace("%%", "%%%" * 2).replace("^", "^ ").replace("\\U+", "\\ U+").replace("\\M+", "\\ M+")

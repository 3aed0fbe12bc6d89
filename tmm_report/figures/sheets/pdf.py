"""Drawings as pages of one PDF 1.4, each of its own size: lines, curves and fills alone, so that no font is needed.

The same drawings give the same bytes. Source: ISO 32000-1, 7.5, 8.5; a circle is four cubic curves, 0.03 % off.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from zlib import compress

from tmm_report.figures.drawing import COLOURS, Arc, Arrow, Circle, Drawing, Item, Path, Pen, Text
from tmm_report.figures.primitives import written

POINT = 72 / 25.4  # points of a millimetre


def pdf(pages: Sequence[Drawing], title: str) -> bytes:
    """One page a drawing; texts are to be strokes by now."""
    numbers = [4 + 2 * n for n in range(len(pages))]
    kids = " ".join(f"{n} 0 R" for n in numbers)
    heading = ("\ufeff" + title).encode("utf-16-be", "replace").hex()
    objects = [b"<</Type/Catalog/Pages 2 0 R>>", f"<</Type/Pages/Kids[{kids}]/Count {len(pages)}>>".encode()]
    objects.append(f"<</Title<{heading}>/Producer(tmm-report)>>".encode())
    for n, page in zip(numbers, pages, strict=True):
        wide, tall = (f"{POINT * size:.4f}" for size in page.size)
        head = f"<</Type/Page/Parent 2 0 R/MediaBox[0 0 {wide} {tall}]/Resources<<>>/Contents {n + 1} 0 R>>"
        drawn = compress("\n".join(_content(page)).encode())
        objects += [
            head.encode(),
            b"<</Filter/FlateDecode/Length %d>>stream\n%s\nendstream" % (len(drawn), drawn),
        ]
    return _file(objects)


def _file(objects: Sequence[bytes]) -> bytes:
    text, places = b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n", list[int]()
    for n, one in enumerate(objects, 1):
        places.append(len(text))
        text += b"%d 0 obj\n%s\nendobj\n" % (n, one)
    table = b"".join(b"%010d 00000 n \n" % place for place in places)
    count = len(objects) + 1
    end = b"trailer<</Size %d/Root 1 0 R/Info 3 0 R>>\nstartxref\n%d\n%%%%EOF\n" % (count, len(text))
    return text + b"xref\n0 %d\n0000000000 65535 f \n%s" % (count, table) + end


def _content(page: Drawing) -> Iterator[str]:
    left, bottom, _, _ = page.box
    yield f"1 J 1 j {POINT:.8f} 0 0 {POINT:.8f} {-POINT * left:.4f} {-POINT * bottom:.4f} cm"
    for item in page.items:
        yield from _drawn(item)


def _drawn(item: Item) -> Iterator[str]:
    match item:
        case Path():
            end = " h" if item.closed else ""
            strokes = " ".join(_polyline(stroke) + end for stroke in item.strokes)
            yield _look(item.pen, item.fill, item.opacity, strokes)
        case Circle():
            yield _look(item.pen, item.fill, 1.0, _curve(item.centre, item.radius, 0.0, math.tau) + " h")
        case Arc():
            yield _look(item.pen, "", 1.0, _curve(item.centre, item.radius, item.start, item.end))
        case Arrow():
            for part in item.parts:
                yield from _drawn(part)
        case Text():
            raise TypeError("letters are strokes on a sheet")


def _look(pen: Pen | None, fill: str, opacity: float, drawn: str) -> str:
    if not drawn or (pen is None and not fill):
        return ""
    inks = [f"{_colour(fill, opacity)} rg"] if fill else []
    if pen is not None:
        dash = " ".join(map(written, pen.dash))
        inks.append(f"{_colour(pen.colour, 1.0)} RG {written(pen.width)} w [{dash}] 0 d")
    return f"{' '.join(inks)} {drawn} {'B' if fill and pen else 'f' if fill else 'S'}"


def _colour(name: str, opacity: float) -> str:
    """On white paper."""
    code = COLOURS[name]
    shares = (int(code[i : i + 2], 16) / 255 for i in (0, 2, 4))
    return " ".join(written(1 - opacity * (1 - one)) for one in shares)


def _polyline(points: Sequence[complex]) -> str:
    return " ".join(f"{_at(z)} {'l' if n else 'm'}" for n, z in enumerate(points))


def _curve(centre: complex, radius: float, start: float, end: float) -> str:
    count = max(1, math.ceil(abs(end - start) / (math.pi / 2) - 1e-9))
    step = (end - start) / count
    reach = 4 / 3 * math.tan(step / 4)
    pieces = [f"{_at(centre + cmath.rect(radius, start))} m"]
    for n in range(count):
        one, other = (cmath.rect(radius, start + step * (n + more)) for more in (0, 1))
        places = (centre + one * (1 + 1j * reach), centre + other * (1 - 1j * reach), centre + other)
        pieces.append(" ".join(map(_at, places)) + " c")
    return " ".join(pieces)


def _at(z: complex) -> str:
    return f"{written(z.real)} {written(z.imag)}"

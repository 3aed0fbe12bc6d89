"""Contours as a drawing for CAD and for machines that cut: DXF R12 (AC1009), in mm.

R12 is plain text that every program reads, and needs closed polylines, circles and layers alone: a writer of it is
these lines, a library would be megabytes. Source: Autodesk, DXF reference, R12.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from tmm_report.records import dataclass

HEADER = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n"


@dataclass(frozen=True, eq=False)
class Outline:
    """A closed polyline through points, x + iy, mm."""

    points: Sequence[complex]


@dataclass(frozen=True, eq=False)
class Ring:
    """A circle, mm."""

    centre: complex
    radius: float


def dxf(layers: Mapping[str, Iterable[Outline | Ring]]) -> bytes:
    """The drawing, layer by layer; their names are Latin letters."""
    drawn = [line for layer, shapes in layers.items() for shape in shapes for line in _drawn(shape, layer)]
    text = "\n".join(["0", "SECTION", "2", "ENTITIES", *drawn, "0", "ENDSEC", "0", "EOF", ""])
    return (HEADER + _layers(list(layers)) + text).replace("\n", "\r\n").encode("ascii")


def _layers(names: Sequence[str]) -> str:
    rows = [f"0\nLAYER\n2\n{name}\n70\n0\n62\n{k}\n6\nCONTINUOUS\n" for k, name in enumerate(names, 1)]
    table = f"0\nTABLE\n2\nLAYER\n70\n{len(rows)}\n{''.join(rows)}0\nENDTAB\n"
    return f"0\nSECTION\n2\nTABLES\n{table}0\nENDSEC\n"


def _drawn(shape: Outline | Ring, layer: str) -> Iterator[str]:
    if isinstance(shape, Ring):
        yield from ("0", "CIRCLE", "8", layer, *_at(shape.centre), "40", _number(shape.radius))
        return
    yield from ("0", "POLYLINE", "8", layer, "66", "1", *_at(0j), "70", "1")
    for point in shape.points:
        yield from ("0", "VERTEX", "8", layer, *_at(point))
    yield from ("0", "SEQEND", "8", layer)


def _at(point: complex) -> tuple[str, ...]:
    return "10", _number(point.real), "20", _number(point.imag), "30", "0.0"


def _number(x: float) -> str:
    return f"{x + 0.0:.6f}"

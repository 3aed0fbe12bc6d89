"""Lines of a printed PDF, mm of paper, y up: what a ruler measures on the page."""

from __future__ import annotations

import re
import zlib
from collections.abc import Iterator
from functools import cache
from itertools import pairwise

MM = 25.4 / 72  # of a point of PDF
_STREAM = re.compile(rb"stream\r?\n")
_ENDS = frozenset((b"S", b"f", b"B", b"b", b"s", b"n"))  # of a path
Matrix = tuple[float, float, float, float, float, float]
Stroke = tuple[complex, ...]


@cache
def strokes(pdf: bytes) -> list[Stroke]:
    """All paths of straight lines in the order in which they are drawn; curves are left out."""
    return [stroke for stream in _streams(pdf) for stroke in _strokes(stream)]


def arrows(pdf: bytes) -> list[complex]:
    """From the start to the tip of each line that a triangle follows."""
    pairs = pairwise(strokes(pdf))
    return [other[0] - one[0] for one, other in pairs if len(one) == 2 and len(other) in (3, 4)]


def _streams(pdf: bytes) -> Iterator[bytes]:
    whole = memoryview(pdf)
    for match in _STREAM.finditer(pdf):
        try:
            content = zlib.decompressobj().decompress(whole[match.end() :])
        except zlib.error:
            continue
        if b" l\n" in content or b" l " in content:
            yield content


def _strokes(content: bytes) -> Iterator[Stroke]:
    """Paths under the matrices that stand over them."""
    matrix: Matrix = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
    saved: list[Matrix] = []
    path: list[complex] = []
    # Typst has no space before what begins by its own sign
    words = content.replace(b"/", b" /").replace(b"[", b" [").split()
    for k, word in enumerate(words):
        if word == b"l" or word == b"m":
            if word == b"m" and path:
                yield tuple(path)
                path = []
            path.append(_under(matrix, float(words[k - 2]), float(words[k - 1])))
        elif word == b"c":
            path = []  # a curve
        elif word in _ENDS and path:
            yield tuple(path)
            path = []
        elif word == b"cm":
            matrix = _times(tuple(map(float, words[k - 6 : k])), matrix)  # type: ignore[arg-type]
        elif word == b"q":
            saved.append(matrix)
        elif word == b"Q" and saved:
            matrix = saved.pop()


def _times(a: Matrix, b: Matrix) -> Matrix:
    return (
        a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3],
        a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3],
        a[4] * b[0] + a[5] * b[2] + b[4], a[4] * b[1] + a[5] * b[3] + b[5],
    )  # fmt: skip


def _under(m: Matrix, x: float, y: float) -> complex:
    return MM * complex(m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5])

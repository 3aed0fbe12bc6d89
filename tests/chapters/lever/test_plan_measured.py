"""Plans measured on the paper, as SVG and as TikZ: every vector is as long as what was read off it says."""

from __future__ import annotations

import re

import pytest
from conftest import solved

from tmm_report.chapters.lever.plans.draw import plan_picture
from tmm_report.figures.drawing import svg, tikz

SOME = ["compressor", "quick_return", "parallelogram_drive", "hacksaw", "press"]
NEAR = 0.1  # mm
XY = r"([-\d.]+)[ ,]([-\d.]+)"
ARROW = re.compile(rf'<g data-q="([^"]+)"[^>]*><path d="M{XY}L[^"]*"[^>]*/><path d="M{XY}L')
PAIR = re.compile(rf"\\path\[draw[^\]]*\] \({XY}\) -- [^;]*;\n\\path\[fill[^\]]*\] \({XY}\)")


def length(numbers: tuple[str, ...]) -> float:
    x0, y0, x1, y1 = map(float, numbers)
    return abs(complex(x1 - x0, y1 - y0))


@pytest.mark.parametrize("name", SOME)
def test_vectors_are_as_long_as_is_read_in_html_and_in_latex(name):
    measured = 0
    for one in solved(name).lever.plans.drawn:
        for plan in (one.velocity, one.acceleration):
            picture = plan_picture(plan)
            shown = [(found[0], length(found[1:])) for found in ARROW.findall(svg(picture))]
            for key, mm in shown:
                if plan.per_mm.get(key):
                    assert mm == pytest.approx(plan.values[key] / plan.scale, abs=NEAR), key
                    measured += 1
            same = sorted(length(found) for found in PAIR.findall(tikz(picture)))
            assert len(same) >= len(shown) > 3
            assert all(min(abs(mm - other) for other in same) < 0.01 for _, mm in shown)
    assert measured > 20

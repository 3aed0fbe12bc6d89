"""The diagram of s over s′ as it is drawn: axes, the curve, its tangents, where the axis of the cam may stand."""

from pathlib import Path

import numpy as np
import pytest

from tmm_report.chapters.cams.cam.draw import zone as draw_zone
from tmm_report.course import solve
from tmm_report.figures.drawing import THICK
from tmm_report.figures.primitives import Circle, Text
from tmm_report.figures.primitives import Path as Stroke
from tmm_report.loading import loads

TEXT = Path(__file__).parents[3].joinpath("statements/cam_from_pressure_angles.yaml").read_text("utf-8")


@pytest.fixture(scope="module", params=["[-12 mm, 0]", "[0, 0]", "[9 mm, 0]"])
def drawn(request):
    found = solve(loads(TEXT.replace("[-12 mm, 0]", request.param))).lever.cams.cams[0]
    zone = found.cam.sized
    mu = draw_zone.scale(found, zone)
    return found, zone, mu, draw_zone.drawing(found, zone, mu)


def letters(drawing):
    """Places of the letters, by their base and what stands above it."""
    texts = [item for item in drawing.items if isinstance(item, Text)]
    return {
        (part.base, part.sup): text.at for text in texts for part in text.parts if not isinstance(part, str)
    }


def test_letters_stand_at_their_axes_and_places(drawn):
    found, zone, mu, drawing = drawn
    of = letters(drawing)
    across, up = of["s", "′"], of["s", ""]
    assert across.real > 3 * abs(across.imag) and up.imag > 3 * abs(up.real)
    made, best = (
        complex(e, -s0) / mu for e, s0 in ((found.offset, found.start), (zone.best.e, zone.best.s0))
    )
    if abs(made - best) > 8:
        assert abs(of["O", ""] - made) < abs(of["O", ""] - best)
        assert abs(of["O", "*"] - best) < abs(of["O", "*"] - made)


def test_curve_tangents_and_places(drawn):
    found, zone, mu, drawing = drawn
    strokes = [item for item in drawing.items if isinstance(item, Stroke)]
    curve = next(np.array(one.strokes[0]) for one in strokes if one.pen == THICK)
    S, slope, _ = zone.law.of(np.linspace(0.01, 6.27, 500))
    away = [np.abs(curve - complex(x, y) / mu).min() for x, y in zip(slope, S, strict=True)]
    assert max(away) < 0.5  # every place of the law is on the curve
    assert curve.imag.max() == pytest.approx(found.lift / mu)
    tangents = [one.strokes[0] for one in strokes if one.pen == draw_zone.TANGENT]
    assert len(tangents) == 3
    for (start, end), limit in zip(tangents, (zone.rise, zone.back, zone.rise), strict=True):
        assert abs(abs((end - start).real) / abs((end - start).imag) - np.tan(limit)) < 1e-9
    for start, end in tangents[:2]:  # the whole curve lies on one side
        off = ((curve - start) * np.conj(end - start)).imag / abs(end - start)
        assert min(off.max(), -off.min()) < 1e-6
    dots = [item.centre for item in drawing.items if isinstance(item, Circle) and item.radius == 1.0]
    expected = [complex(e, -s0) / mu for e, s0 in ((found.offset, found.start), (zone.best.e, zone.best.s0))]
    assert np.allclose(sorted(dots, key=abs), sorted(expected, key=abs), atol=1e-9)

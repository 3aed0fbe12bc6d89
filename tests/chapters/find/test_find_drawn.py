"""The chart of two unknowns: lines on which a demand is met, against those that are known."""

import numpy as np

from tmm_report.chapters.find.draw import PENS, _zeros, meeting
from tmm_report.figures.drawing import Path


def grid(low, high, parts=16):
    x, y = (np.linspace(a, b, parts + 1) for a, b in zip(low, high, strict=True))
    return np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1)


def test_a_circle_is_one_closed_line_on_its_radius():
    places = grid((-1, -1), (1, 1), 32)
    z = places[..., 0] + 1j * places[..., 1]
    points = _zeros(z, np.abs(z) - 0.7)
    assert np.isnan(points).sum() == 1 and np.isnan(points[-1])
    assert np.allclose(np.abs(points[:-1]), 0.7, atol=2e-3) and abs(points[0] - points[-2]) < 1e-12


def test_where_there_are_no_values_there_is_no_line():
    places = grid((0, 0), (1, 1))
    z = places[..., 0] + 1j * places[..., 1]
    for missing, ends in ((z.real < 0.5, (0.5, 1)), (z.real > 0.5, (0, 0.5))):
        points = _zeros(z, np.where(missing, np.nan, z.imag - 0.3))
        sound = points[np.isfinite(points)]
        assert (sound.real.min(), sound.real.max()) == ends and np.allclose(sound.imag, 0.3)
    assert not _zeros(z, z.real + 1).size


def test_the_first_unknown_goes_to_the_right_and_the_second_up():
    """Demand 1 is met at x = 12, demand 2 at y = 5; the field, of 10 … 20 by 0 … 7, is at 0.1 to a millimetre."""
    places = grid((10, 0), (20, 7))
    rest = places - np.array([12.0, 5.0])
    drawing = meeting(places, rest, [(12 + 5j, "")], (("x",), ("y",)), (("a",), ("b",)), str)
    lines = [
        [
            item.strokes[0]
            for item in drawing.items
            if isinstance(item, Path) and item.pen == pen and len(item.strokes[0]) > 2
        ]
        for pen in PENS
    ]
    ((upright,), (level,)) = lines
    assert np.allclose(np.real(upright), 20) and np.ptp(np.imag(upright)) > 69
    assert np.allclose(np.imag(level), 50) and 99 < np.ptp(np.real(level)) <= 100

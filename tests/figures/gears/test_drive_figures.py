"""The drive's diagrams on paper: drawn lengths are the readings, rays are parallel to the lines, rims meet."""

import pytest

from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.gears.drive.block import DriveModel, build
from tmm_report.chapters.gears.drive.draw import diagrams as figures
from tmm_report.chapters.gears.drive.draw.scheme import scheme
from tmm_report.chapters.gears.drive.draw.sketch import CLEAR
from tmm_report.figures.drawing import Arrow, Path, Text
from tmm_report.quantity.paper import ACCURACY

STAGES = [
    {"kind": "planetary", "scheme": "sun-ring", "ratio": 6.56, "module": "5 mm", "satellites": 3}
    | {"teeth": [20, 46, 112], "input": "sun", "output": "carrier", "fixed": "ring"},
    {"kind": "spur", "ratio": -2, "module": "6 mm", "centre_distance": "130 mm"},
]


@pytest.fixture(scope="module")
def found():
    return drive.solve(build(DriveModel.model_validate({"speed": "3000 rpm", "stages": STAGES}), ACCURACY))


@pytest.fixture(scope="module")
def picture(found):
    return figures.velocities(found.stages, found.plans, found.speed)


def strokes(picture, colour=None):
    """Straight lines of the picture (of one colour), as pairs of ends."""
    paths = [item for item in picture.items if isinstance(item, Path) and item.pen]
    return [s for p in paths if colour in (None, p.pen.colour) for s in p.strokes if len(s) == 2]


def test_a_velocity_is_as_long_as_it_is_read(found, picture):
    drawn = [a.end - a.start for a in picture.items if isinstance(a, Arrow)]
    for name, v in found.plans.velocity.items():
        if v:
            assert min(abs(vector - v) for vector in drawn) < 1e-9, name


def test_the_lines_of_a_member_in_both_diagrams_are_parallel(found, picture):
    """Of each colour, the line of linear velocities and the ray from the pole."""
    h = found.plans.pole
    for line in found.plans.lines:
        if not line.s:
            continue
        along = line.ends[1] - line.ends[0]
        rays = [b - a for a, b in strokes(picture) if abs(abs((b - a).imag) - h) < 1e-9]
        lines = [b - a for a, b in strokes(picture)]
        near = [ray for ray in rays if abs(ray.real - line.s) < 1e-9]
        assert near, line.members
        assert abs((near[0].conjugate() * along).imag) / abs(along) < 0.005  # the reading of s, mm
        longer = [one for one in lines if abs((one.conjugate() * along).imag) < 1e-6 * abs(one) * abs(along)]
        assert longer, line.members


def test_rims_in_mesh_stand_on_both_sides_of_the_pitch_point(found):
    sketch = scheme(found.stages, found.plans, found.speed)
    flat = [item.strokes[0][0].imag for item in sketch.items if isinstance(item, Path) and _level(item)]
    for spot in found.plans.spots:
        if not spot.axis:
            y = spot.y / found.plans.length_scale
            assert any(abs(at - y - CLEAR) < 1e-6 for at in flat), spot.name
            assert any(abs(at - y + CLEAR) < 1e-6 for at in flat), spot.name


def _level(path):
    start, end = path.strokes[0][0], path.strokes[0][-1]
    return len(path.strokes) == 1 and abs(start.imag - end.imag) < 1e-9


def test_every_member_is_named_in_the_scheme(found):
    picture = figures.kinematic_scheme(found.stages, found.plans, found.speed)
    named = {
        part.base
        for t in picture.items
        if isinstance(t, Text)
        for part in t.parts
        if not isinstance(part, str)
    }
    assert {m.name for m in found.train.members} <= named

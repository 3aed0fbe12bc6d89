"""A mass centre off its link is tied to it in the scheme, so that it does not float beside."""

from pathlib import Path

import pytest

from tmm_report import course, loading
from tmm_report.figures.drawing import THIN
from tmm_report.figures.schemes.bodies import FLOATS, Body, held_at
from tmm_report.figures.schemes.view import view_of

TIPPER = (Path(__file__).parents[1] / "statements" / "tipper_by_cylinder.yaml").read_text("utf-8")
BAR = Body(bars=((0j, 50 + 0j),))
PLATE = Body(plate=(0j, 50 + 0j, 25 + 30j))


@pytest.mark.parametrize(
    ("body", "centre", "ends"),
    [
        (BAR, 20 + 3j, ()),  # near it
        (BAR, 20 + 15j, (0j, 50 + 0j)),
        (BAR, 40 - 15j, (50 + 0j, 0j)),
        (BAR, 70 + 0j, (50 + 0j,)),  # in line with it
        (PLATE, 25 + 10j, ()),  # within it
        (PLATE, 25 - 10j, (0j, 50 + 0j)),
        (Body(blocks=((5 + 5j, 1 + 0j),)), 5 + 20j, (5 + 5j,)),
        (Body(outlines=((0j, 9j, 9 + 0j),)), 30 + 0j, ()),  # a cam or a wheel is drawn itself
        (Body(), 30 + 0j, ()),
    ],
)
def test_it_is_tied_to_the_nearest_part_of_its_link(body, centre, ends):
    assert set(held_at(body, centre)) == set(ends)


@pytest.mark.parametrize("position", [0, 10, 29])
def test_the_body_of_the_tipper_has_its_mass_centre(position):
    lever = course.solve(loading.loads(TIPPER)).lever
    table, mechanism, mu = (
        lever.kinematics.table,
        lever.kinematics.linkage.mechanism,
        lever.plans.length_scale,
    )
    places = {point: table.place(point) + 0 * table.phi for point in mechanism.point_names}
    turns = {link: table.turn(link) + 0 * table.phi for link in mechanism.moving}
    view = view_of(mechanism, places, turns, mu, position)
    thin = [stroke for item in view.links() if getattr(item, "pen", None) == THIN for stroke in item.strokes]
    at = {point: complex(place[position]) / mu for point, place in places.items()}
    tied = sorted(round(abs(end - at["S3"]), 6) for end, other in thin if abs(other - at["S3"]) < 1e-9)
    assert tied == sorted(round(abs(at[end] - at["S3"]), 6) for end in "OB") and min(tied) > FLOATS

"""Followers of cams to 40 digits: against the distance that a circle keeps, against doubles, against differences."""

from __future__ import annotations

import numpy as np
import pytest
from test_cam import PAIRS, SLIDING, linkage_of, text

from tmm_report import loading
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import cycle_of
from tmm_report.mechanics.rivals import exact
from tmm_report.mechanics.rivals.exact.cams import coordinate
from tmm_report.mechanics.rivals.exact.numbers import context, point
from tmm_report.mechanics.rivals.exact.numbers import exact as number
from tmm_report.mechanics.rivals.exact.scheme import Body

POINTS = ", ".join(
    f"[{k * 15} deg, {40 + 5 * np.cos(k * np.pi / 6) + 3 * np.sin(k * np.pi / 12):.4f} mm]" for k in range(24)
)
POLAR = f"{{follower: 2, roller: {{at: B, radius: 8 mm}}, profile: {{polar: [{POINTS}]}}}}"
FLAT = f"{{follower: 2, flat: {{at: B}}, profile: {{polar: [{POINTS}]}}}}"


def linkage(name: str) -> motion.Linkage:
    if name in PAIRS:
        return linkage_of(name)
    return assemble(
        loading.loads(text(SLIDING, {"polar": POLAR, "flat on points": FLAT}[name])).lever.mechanism
    )


NAMES = [*PAIRS, "polar", "flat on points"]


@pytest.mark.parametrize("name", NAMES)
def test_the_programs_follower_moves_as_the_exact_one_to_rounding(name: str) -> None:
    cycle = cycle_of(linkage(name))
    phi = np.array([0.03, 1.0, 2.5, 4.0, 5.5])
    found, solution = motion.solve(cycle.linkage, phi), exact.motion(cycle, phi)
    for kind, own in (
        ("place", found.places), ("velocity", found.velocities), ("acceleration", found.accelerations),
    ):  # fmt: skip
        assert solution.pairs[kind].error(own) < 2e-14
        assert solution.pairs[kind].error(own * (1 + 1e-12)) > 2e-14


@pytest.mark.parametrize("name", NAMES)
def test_the_coordinate_has_its_own_differences_as_derivatives(name: str) -> None:
    cam = linkage(name).mechanism.cams[0]
    with context().workdps(90):
        phi, h = number(1.0), context().mpf(10) ** -20
        before, here, after = (coordinate(cam, phi + way * h) for way in (-1, 0, 1))
        assert abs((after.z - before.z) / (2 * h) - here.d) < 1e-35
        assert abs((after.d - before.d) / (2 * h) - here.dd) < 1e-35


@pytest.mark.exhaustive
def test_a_roller_on_a_circle_keeps_its_distance_from_the_circles_centre() -> None:
    built = linkage("circle")
    cycle, cam = cycle_of(built), built.mechanism.cams[0]
    for phi in (0.5, 3.0, 5.0):
        B = exact.at(cycle, phi).row("B", Body.place)[0] - point(cam.axis)
        centre = point(cam.given.curve.centre) * context().expj(number(phi))
        assert abs(abs(B - centre) - number(cam.given.curve.radius) - number(cam.roller)) < 1e-41

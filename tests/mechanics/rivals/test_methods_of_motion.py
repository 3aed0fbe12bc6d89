"""The motion by every method: all agree with the groups as far as each promises, and none goes astray in silence
that says it would not."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import schemes
from conftest import solved
from exhaustive import many
from higher_schemes import drawn

from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.assur_groups import decompose
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide, ZeroAngle
from tmm_report.mechanics.lever.motion import linkage_of
from tmm_report.mechanics.rivals.motion.constraints import corrected, runge_kutta
from tmm_report.mechanics.rivals.motion.coordinates import Coordinates
from tmm_report.mechanics.rivals.motion.every import MOTIONS, PLAIN_NEWTON, motion_method

COUNT = 24
VARIANTS = (
    "crank_rocker", "shaper", "press", "whitworth", "scotch_yoke", "elliptic_trammel", "engine_four_stroke",
    "jaw_crusher", "v_engine", "loom", "hacksaw", "quick_return",
)  # fmt: skip
PROMISED = {  # relative, of places, velocities, accelerations
    "newton": (1e-14, 1e-14, 3e-14),
    "constraints_corrected": (1e-14, 1e-14, 3e-14),
    "root_finder": (1e-7, 1e-7, 1e-7),
    "constraints_dop853": (1e-8, 1e-8, 1e-8),
    "constraints": (1e-5, 1e-4, 1e-4),
    "drawing_0.01": (2e-4, 6e-4, 8e-4),
    "drawing_0.1": (4e-3, 1e-2, 3e-2),
    "drawing_0.5": (2e-2, 5e-2, 0.15),
}


def cycle(name: str) -> Cycle:
    return solved(name).lever.kinematics.cycle


def slider_crank(crank: float, offset: float = 0.0, zero: float = 0.3, size: float = 1.0) -> Cycle:
    """With a rod of length 1; position 0 at angle `zero`."""
    links = [
        Link("0", {"O": 0j}),
        Link("1", {"O": 0j, "A": crank * size + 0j}),
        Link("2", {"A": 0j, "B": size + 0j}),
        Link("3", {"B": 0j}),
    ]
    guide = Guide("x", "0", 1j * offset * size, 1 + 0j)
    made = Mechanism(
        {one.name: one for one in links}, Driver("1", 7.0, ZeroAngle(zero)), {"x": guide}, [Slide("3", "x")]
    )
    return cycle_of(linkage_of(decompose(made), [1]))


def errors(found, exact) -> tuple[float, ...]:
    """Of places, velocities, accelerations, relative to the largest; nan where something is lost."""
    pairs = [(getattr(found, of), getattr(exact, of)) for of in ("places", "velocities", "accelerations")]
    return tuple(np.max(np.abs(one - other)) / np.max(np.abs(other)) for one, other in pairs)


def lost(found, exact) -> int:
    """How many positions that exist were not found."""
    return int((exact.closes & ~found.closes).sum())


def run(key: str, of: Cycle, count: int = COUNT):
    return (PLAIN_NEWTON if key == PLAIN_NEWTON.key else motion_method(key)).run(of, count)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", VARIANTS)
def test_every_method_finds_the_motion_of_the_groups(name):
    of = cycle(name)
    exact = run("groups", of)
    for key, promised in PROMISED.items():
        assert motion_method(key).refuses(of) is None
        off = errors(run(key, of), exact)
        assert all(error <= bound for error, bound in zip(off, promised, strict=True)), (key, off)


@pytest.mark.parametrize("name", VARIANTS)
def test_angular_rates_agree_too(name):
    of = cycle(name)
    exact, found = run("groups", of), run("newton", of)
    for link in of.linkage.mechanism.moving:
        for rate in ("turn", "angular_velocity", "angular_acceleration"):
            one, other = getattr(found, rate)(link), getattr(exact, rate)(link)
            assert one == pytest.approx(other, rel=1e-11, abs=1e-11 * (1 + np.abs(other).max()))


def test_the_keys_are_unlike_and_their_methods_are_found_by_them():
    keys = [method.key for method in MOTIONS]
    assert len(set(keys)) == len(keys) and set(PROMISED) < set(keys) and "parallelogram" in keys
    with pytest.raises(KeyError):
        motion_method("plain_newton")


@pytest.mark.parametrize("key", [*PROMISED, "parallelogram"])
def test_the_equations_of_pairs_say_nothing_of_a_cam(key):
    assert motion_method(key).refuses(cycle("cam_press")) is not None


# ---------------------------------------------------------------- the constraint equations


@pytest.mark.parametrize(("name", "sign"), schemes.ROOTED)
def test_the_constraint_equations_hold_of_all_dyads_on_moving_links(name, sign):
    """Their Jacobian is the derivative of the equations, and their rates are the groups'."""
    of = Cycle(schemes.linkage(schemes.SCHEMES[name](), sign), 0.1234)
    exact = of.motion(of.once(8))
    c, phi = Coordinates(of.linkage), exact.phi
    q = c.read(exact)
    left, J = c.equations(q, phi)
    assert np.abs(left).max() < 1e-14
    steps = 1e-6 * np.eye(c.count)
    slopes = [(c.residual(q + step, phi) - c.residual(q - step, phi)) / 2e-6 for step in steps]
    assert np.abs(J - np.stack(slopes, axis=-1)).max() < 1e-7
    assert max(errors(c.motion(phi, q, *c.rates(q, phi)), exact)) < 1e-12


def test_the_right_side_of_accelerations_is_what_differentiating_leaves():
    """−(Φ_q q')' along the motion with q'' = 0, by differences, of the mechanism with all kinds of pairs."""
    of = Cycle(schemes.linkage(schemes.SCHEMES["compound"]()), 0.1234)
    exact = of.motion(of.once(8))
    c = Coordinates(of.linkage)
    q = c.read(exact)
    rate, _ = c.rates(q, exact.phi)
    step = 1e-6
    ahead, behind = (
        np.einsum("pij,pj->pi", c.equations(q + way * rate, exact.phi)[1], rate) for way in (step, -step)
    )
    assert c.bend(q, rate) == pytest.approx(-(ahead - behind) / (2 * step), abs=1e-7)


# ---------------------------------------------------------------- integration


def test_the_integrated_places_err_by_the_fourth_power_of_the_step():
    of = cycle("crank_rocker")
    exact = run("groups", of, 12)
    off = [errors(runge_kutta(of, 12, steps), exact)[0] for steps in (2, 4, 8)]
    assert [np.log2(a / b) for a, b in pairwise(off)] == pytest.approx([4, 4], abs=0.5)


def test_joints_drift_apart_unless_they_are_closed_again():
    of = cycle("crank_rocker")
    c = Coordinates(of.linkage)

    def apart(motion) -> float:
        return float(np.abs(c.residual(c.read(motion), motion.phi)).max())

    assert apart(runge_kutta(of, 12, 2)) > 1e-6
    assert apart(corrected(of, 12, 2)) < 1e-14


# ---------------------------------------------------------------- where methods fail


@pytest.mark.parametrize("count", [12, 36])
@pytest.mark.parametrize(("crank", "offset"), [(0.99, 0.0), (0.9999, 0.0), (0.9, 0.0999)])
def test_newton_with_its_step_in_hand_passes_a_near_dead_point(crank, offset, count):
    of = slider_crank(crank, offset)
    assert max(errors(run("newton", of, count), run("groups", of, count))) < 1e-9


def test_the_textbooks_newton_and_the_library_jump_there_and_say_nothing():
    of = slider_crank(0.9999)
    exact = run("groups", of, 12)
    for key in ("plain_newton", "root_finder"):
        found = run(key, of, 12)
        assert lost(found, exact) == 0 and errors(found, exact)[0] > 0.5


@pytest.mark.parametrize("key", ["newton", "constraints_corrected"])
@pytest.mark.parametrize("count", many([35, 12, 36]))
@pytest.mark.parametrize(("crank", "offset"), [(0.999, 0.0), (1.0, 0.0), (0.9, 0.15), (0.9, 0.1), (1.2, 0.0)])
def test_what_is_checked_is_right_or_refused(key, crank, offset, count):
    """Near-dead points, change points, closure lost over a part of the turn."""
    of = slider_crank(crank, offset)
    found, exact = run(key, of, count), run("groups", of, count)
    assert not (found.closes & ~exact.closes).any()
    both = found.closes
    assert both.any() and np.abs(found.places - exact.places)[:, both].max() < 1e-7


def test_newton_reaches_what_lies_beyond_a_gap_backwards():
    of = slider_crank(0.9, 0.15)
    found, exact = run("newton", of, 36), run("groups", of, 36)
    assert np.isnan(exact.place("B")).sum() == 4 and lost(found, exact) == 0


def test_two_ways_that_overlap_are_not_joined():
    """Of this group the way forwards and the way backwards lead over one angle in two assemblies."""
    of = cycle_of(assemble(drawn("III3", 55).mechanism()))
    assert of.critical[-1].run.overlaps
    found, exact = run("newton", of, 12), run("groups", of, 12)
    assert (found.closes == exact.closes).all() and not found.closes.all()


@pytest.mark.parametrize("key", ["root_finder", "plain_newton", "newton"])
def test_what_does_not_settle_is_not_found(key):
    """In the gap no root exists at all."""
    of = slider_crank(0.9, 0.15)
    assert not run(key, of, 36).closes[~run("groups", of, 36).closes].any()


def test_a_change_point_ends_newtons_way():
    """Rod equal to crank: from 0.3 rad it is followed to 90° on one side and to −90° on the other."""
    found = run("newton", slider_crank(1.0), 36)
    known = found.closes
    assert (np.cos(found.phi[known]) > 0).all() and known.sum() == 19


def test_a_position_0_that_is_singular_or_none_at_all_breaks_the_method():
    with pytest.raises(ArithmeticError, match="singular"):
        run("newton", slider_crank(1.0, zero=np.pi / 2))
    for key in ("newton", "root_finder", "constraints"):
        with pytest.raises(ArithmeticError, match="cannot be assembled"):
            run(key, slider_crank(2.0, zero=np.pi / 2))


@pytest.mark.exhaustive
def test_a_library_that_finds_no_step_short_enough_breaks_down_in_words():
    with pytest.raises(ArithmeticError, match="assembly ends"):
        run("constraints_dop853", slider_crank(0.9, 0.15))


@pytest.mark.parametrize("size", [1e-6, 1e3])
def test_micrometres_and_kilometres_are_one_to_the_equations(size):
    of = slider_crank(0.4, 0.1, size=size)
    assert max(errors(run("newton", of), run("groups", of))) < 1e-14


def test_turns_of_a_cycle_and_the_sense_of_rotation_are_kept():
    of = cycle("engine_four_stroke")
    found = run("newton", of, 24)
    assert of.turns == 2 and found.place("B")[:13] == pytest.approx(found.place("B")[12:], abs=1e-15)
    assert found.velocity("B") == pytest.approx(run("groups", of).velocity("B"), abs=1e-12)


def test_a_driving_link_that_swings_is_followed_over_its_sweep():
    made = slider_crank(0.4).linkage.mechanism
    of = cycle_of(linkage_of(decompose(replace(made, driver=replace(made.driver, sweep=1.0))), [1]))
    for key in ("newton", "root_finder", "constraints_dop853"):
        assert max(errors(run(key, of, 10), run("groups", of, 10))) < 1e-8

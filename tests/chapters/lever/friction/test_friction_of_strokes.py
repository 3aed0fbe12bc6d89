"""Friction where a slider or a cylinder drives: by differences of places, beside the power along the stroke."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.problems import ProblemError

TESTS = Path(__file__).parents[3]
F, D, G = 0.1, 0.04, 0.15
OF_PIVOTS = f"pivots: {{coefficient: {F}, diameter: {D}}}"
FRICTION = f"\nfriction: {{{OF_PIVOTS}, guides: {{coefficient: {G}}}}}\n"
BOOM = (TESTS / "cases/explain/boom_by_cylinder.yaml").read_text("utf-8")
TEXTS = {
    "boom": "\n".join(line for line in BOOM.split("\n") if not line.startswith("friction")),
    "slider": (TESTS / "statements/slider_drives.yaml").read_text("utf-8"),
    "tipper": (TESTS / "statements/tipper_by_cylinder.yaml").read_text("utf-8"),
}
every = pytest.mark.parametrize("case", TEXTS)


@cache
def solved(case: str) -> course.LeverFound:
    return course.solve(loading.loads(TEXTS[case] + FRICTION)).lever


def rates(motion, pair, step, around):
    """Of the relative motion in a pair by the time, from places alone."""
    one, other = pair.links

    def angle(link):
        return [np.unwrap(np.angle(m.turn(link) + 0 * m.phi)) if link != "0" else 0 * m.phi for m in around]

    if pair.kind == "R":
        both = [b - a for a, b in zip(angle(one), angle(other), strict=True)]
        low, high = np.exp(1j * both[0]), np.exp(1j * both[1])
        return np.angle(high / low) / (2 * step)
    slider, carrier = pair.slider, pair.other(pair.slider)
    along = []
    for m in around:
        place = m.state.world(slider, pair.at[slider])
        u = m.turn(carrier) if carrier != "0" else 1.0
        origin = m.state.world(carrier, pair.at[carrier]) if carrier != "0" else pair.at[carrier]
        along.append(((place - origin) * np.conj(u * pair.along[carrier])).real)
    return (along[1] - along[0]) / (2 * step)


@every
def test_power_of_friction_by_differences_of_places(case):
    found = solved(case)
    friction, kinematics = found.friction, found.kinematics
    law = kinematics.stroke.law
    step = 1e-4 * law.period
    times = law.period * kinematics.turned / (2 * np.pi)
    off = np.abs(times[:, None] - np.array([0.0, law.period, *law.breaks])).min(axis=1)
    inside = np.flatnonzero(off > 2 * step)  # differences do not reach over a break
    turned = kinematics.turned[inside]
    phase = 2 * np.pi * step / law.period
    around = [kinematics.cycle.motion(turned + way * phase) for way in (-1, 1)]
    total = 0.0
    for one in found.kinetostatics.table.statics.reactions.values():
        size = np.abs(np.broadcast_to(one.force, kinematics.table.shape))[inside]
        arm = F * D / 2 if one.pair.kind == "R" else G
        total = total + arm * size * np.abs(rates(kinematics.table, one.pair, step, around))
    assert friction.table.total[inside] == pytest.approx(total, rel=1e-5, abs=1e-7 * np.max(total))


@every
def test_the_drive_gives_what_the_loads_take(case):
    """The power of the force along the stroke is that of the power balance, in which no reaction is."""
    found = solved(case)
    losses, solve = found.friction.table, found.kinetostatics.table
    omega = solve.motion.state.w[found.kinematics.linkage.mechanism.driver.link]
    expected = np.abs(solve.power * omega)
    moves = np.isfinite(expected)
    assert moves.sum() > 5
    assert losses.driving[moves] == pytest.approx(expected[moves], rel=1e-9, abs=1e-9 * expected[moves].max())
    speed = np.abs(found.kinematics.stroke.law.of_phase(solve.motion.phase)[1])
    still = speed == 0
    assert np.isnan(losses.reduced[still]).all()
    assert (losses.reduced * speed)[~still] == pytest.approx(losses.total[~still], rel=1e-12)


@every
def test_means_are_those_of_many_instants(case):
    found = solved(case)
    text = TEXTS[case].replace("positions: {", "positions: {diagram: 720, ", 1)
    text = text.replace("diagram: 36, ", "").replace("diagram: 40, ", "")
    many = course.solve(loading.loads(text + FRICTION)).lever.friction
    total, driving = many.diagram.total, many.diagram.driving
    mean = np.trapezoid(total) / (len(total) - 1)
    assert found.friction.mean_power == pytest.approx(mean, rel=2e-3)
    useful = np.trapezoid(driving) / (len(driving) - 1)
    assert found.friction.mean_efficiency == pytest.approx(useful / (useful + mean), rel=2e-3)


def test_reactions_with_friction_are_refused_with_a_cure():
    with pytest.raises(ProblemError) as caught:
        loading.loads(TEXTS["tipper"] + FRICTION.replace("}}\n", "}, corrected: true}\n"))
    (problem,) = caught.value.problems
    assert problem.path == ("friction", "corrected")
    assert "a stroke drives" in str(problem.wrong) and "leave corrected out" in str(problem.right)


@pytest.mark.parametrize(
    ("block", "cure"),
    [
        ("flywheel: {delta: 0.05}", "travel"),
        ("balancing: {}", "inertia forces"),
        ("harmonics: {}", "no turn"),
    ],
)
def test_what_wants_a_turning_link_says_what_to_do(block, cure):
    with pytest.raises(ProblemError) as caught:
        loading.loads(f"{TEXTS['tipper']}\n{block}\n")
    key = block.split(":")[0]
    (own,) = [one for one in caught.value.problems if "a stroke drives" in str(one.wrong)]
    assert own.path == (key,) and cure in str(own.right)

"""Friction of mechanisms with wheels: in pivots and guides alone, in equilibrium by a solver that shares no code."""

from functools import cache

import numpy as np
import pytest
from test_planets import KINDS, Alone, at, centre, finished, poses, rolls, text

from tmm_report import course, loading

F, D, G = 0.08, 0.03, 0.06  # of pivots, diameter of their journals, m; of guides
OF_PIVOTS = f"{{coefficient: {F}, diameter: {D}}}"
FRICTION = f"\nfriction: {{pivots: {OF_PIVOTS}, guides: {{coefficient: {G}}}, corrected: true}}\n"
CASES = [(kind, seed) for kind in KINDS for seed in range(5)]
every = pytest.mark.parametrize(
    ("kind", "seed"), CASES, ids=[f"{kind.__name__} {seed}" for kind, seed in CASES]
)


@cache
def solved(kind, seed, stated=FRICTION):
    rng = np.random.default_rng(300 + seed)
    made = finished(kind(rng), rng)
    return made, course.solve(loading.loads(text(made) + stated)).lever


def rails(made):
    """Guides that stand for rails."""
    return {f"g{one['carrier']}" for one in made.get("racks", []) if one.get("rolls")}


@every
def test_teeth_and_rails_take_nothing(kind, seed):
    made, found = solved(kind, seed)
    motion, statics = found.kinematics.table, found.kinetostatics.table.statics
    total = np.zeros(motion.shape)
    for one in statics.reactions.values():
        first, second = one.pair.links
        size = np.abs(np.broadcast_to(one.force, motion.shape))
        if one.pair.kind == "R":
            turn = motion.angular_velocity(second) - motion.angular_velocity(first)
            total += F * size * D / 2 * np.abs(turn)
        elif one.pair.kind == "P" and one.pair.name not in rails(made):
            total += G * size * np.abs(motion.velocity(made["slides"][second][0]))
    assert found.friction.table.total == pytest.approx(total, rel=1e-9)
    names = {loss.pair.name for loss in found.friction.table.pairs}
    assert not names & rails(made)
    assert not any(loss.pair.kind == "H" for loss in found.friction.table.pairs)


@every
def test_what_friction_takes_is_what_the_moment_gives_more(kind, seed):
    _, found = solved(kind, seed)
    assert found.friction.corrected.worst < 1e-9


def wrenches(alone, found, k, q):
    """Of friction on all links: against the relative motion by the rates of the solver of the test."""
    load = np.zeros(3 * len(alone.names))
    turn = {name: q[3 * n + 2] for n, name in enumerate(alone.names)} | {"0": 0.0}
    for loss in found.friction.corrected.table.pairs:
        (first, second), pressed = loss.pair.links, loss.pressing[k]
        if loss.pair.kind == "R":
            moment = -F * D / 2 * pressed * np.sign(turn[second] - turn[first])
            load += alone.row([(second, 0j, 0j, moment), (first, 0j, 0j, -moment)])
        else:
            point, _, angle = alone.made["slides"][second]
            n, along = alone.names.index(second), np.exp(1j * angle)
            arm = alone.place(second, point) - alone.pose[second][0]
            speed = complex(q[3 * n], q[3 * n + 1]) + 1j * turn[second] * arm
            force = -G * pressed * np.sign((speed * np.conj(along)).real) * along
            load += alone.row([(second, alone.place(second, point), force, 0.0)])
    return load


@every
def test_reactions_with_friction_are_in_equilibrium(kind, seed):
    """With the moments and forces of friction as loads, all links at once; the teeth press the flank of the whole."""
    made, found = solved(kind, seed)
    motion, corrected = found.kinematics.table, found.friction.corrected.table
    there = poses(made, motion)
    for k in (1, 4, 8):
        alone = Alone(made, at(there, k))
        acc = {
            "S": {name: motion.acceleration(centre(made, name))[k] for name in made["links"]},
            "e": {name: motion.angular_acceleration(name)[k] for name in made["links"]},
        }
        x, _ = alone.statics(acc, wrenches(alone, found, k, alone.rates()))
        scale = max(abs(one) for key, one in x.items() if key != "bal" and key[2] != "M")
        assert corrected.moment[k] == pytest.approx(x["bal"], abs=1e-8 * found.kinetostatics.table.scale[k])
        for loss in corrected.pairs:
            first, second = loss.pair.links
            if loss.pair.kind == "P":
                assert loss.pressing[k] == pytest.approx(abs(x[first, second, "N"]), abs=1e-8 * scale)
            elif len(motion.linkage.mechanism.links_at(loss.pair.name)) == 2:
                both = (
                    x.get((first, second, 0), x.get((second, first, 0))),
                    x.get((first, second, 1), x.get((second, first, 1))),
                )
                assert loss.pressing[k] == pytest.approx(abs(complex(*both)), abs=1e-8 * scale)


def test_a_rail_cannot_be_made_to_rub():
    made, _ = solved(rolls, next(s for k, s in CASES if k is rolls and rails(solved(rolls, s)[0])))
    (rail,) = rails(made)
    told = f"\nfriction: {{joints: {{{rail}: {{coefficient: 0.1}}}}}}\n"
    with pytest.raises(course.ProblemError) as caught:
        loading.loads(text(made) + told)
    (problem,) = caught.value.problems
    assert problem.path == ("friction", "joints", rail)
    assert "stands for the rail" in str(problem.wrong) and "contacts" in str(problem.right)

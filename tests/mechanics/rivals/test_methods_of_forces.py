"""Forces by every method: one system for all links, virtual work, force plans, all against groups."""

import dataclasses
from itertools import pairwise

import numpy as np
import pytest
from conftest import solved
from schemes import ROOTED, SCHEMES, linkage, random_loads

from tmm_report.chapters.lever.methods.scene import scene
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.forces.force_on_crank_gear import GearDrive
from tmm_report.mechanics.lever.forces.reactions import Load
from tmm_report.mechanics.rivals import force_plans, paper
from tmm_report.mechanics.rivals.forces import FORCES, force_method
from tmm_report.mechanics.rivals.model import Loaded
from tmm_report.mechanics.rivals.paper import ACCURACIES, Pen, round_scale, written

VARIANTS = (
    "compressor", "crank_rocker", "shaper", "press", "quick_return", "engine_four_stroke", "loom", "elliptic_trammel",
    "scotch_yoke", "parallelogram_drive", "cam_press", "v_engine",
)  # fmt: skip


def off(exact, found):
    """Largest error of a force, of a moment of a guide and of the balancing moment, by the largest of its kind."""
    rows = exact.reactions
    kinds = [
        [(one.force, found.reactions[key].force) for key, one in rows.items() if found.reactions],
        [
            (one.moment, found.reactions[key].moment)
            for key, one in rows.items()
            if found.reactions and one.pair.kind == "P"
        ],
        [(exact.balancing, found.balancing)],
    ]
    return [worst(pairs) for pairs in kinds]


def worst(pairs):
    """Relative error, endless where nothing was found; where there is no exact value, none is asked for."""
    size = max((np.nanmax(np.abs(true)) for true, _ in pairs), default=0.0) or 1.0
    errors = [0.0]
    for true, own in pairs:
        known = np.isfinite(true)
        assert known.any()
        errors.append(np.max(np.nan_to_num(np.abs(own - true), nan=np.inf)[known] / size))
    return max(errors)


def ways(task, *keys, count=24):
    return [force_method(key).run(task, count) for key in ("groups", *keys)]


@pytest.mark.parametrize("name", VARIANTS)
def test_one_system_for_all_links_finds_what_groups_find(name):
    """Class II to IV, guides at rest and moving, cams, a gear on the driving link, cycles of one turn and of two."""
    lever = solved(name).lever
    groups, system, power = ways(scene(lever.kinetostatics.given, lever.kinematics), "system", "virtual_work")
    assert max(off(groups, system)) < 1e-12
    assert off(groups, power)[2] < 1e-12
    assert set(system.reactions) == set(groups.reactions)


@pytest.mark.parametrize(("name", "sign"), ROOTED)
def test_every_kind_of_dyad_under_loads_on_every_link(name, sign):
    task = Loaded(Cycle(linkage(SCHEMES[name](), sign), 0.3), random_loads)
    groups, system, power = ways(task, "system", "virtual_work")
    assert max(off(groups, system)) < 1e-12
    assert off(groups, power)[2] < 1e-12
    plans = ways(task, *(f"drawing_{one:g}" for one in ACCURACIES))[1:]
    errors = [off(groups, found) for found in plans]
    assert max(errors[0]) < 3e-3
    for fine, rough in pairwise(errors):
        assert max(fine) < max(rough) < 60 * max(fine)


def test_a_plan_without_rounding_is_the_solution_by_groups(monkeypatch):
    """Lines of the plan are the equations of the groups: only reading and placing part them."""
    for room in (force_plans, paper):
        monkeypatch.setattr(room, "written", lambda x: x)
    task = Loaded(Cycle(linkage(SCHEMES["compound"](), -1), 0.3), random_loads)
    motion = task.cycle.motion(task.cycle.once(24))
    loads = random_loads(motion)
    exact = force_method("groups").run(task, 24)
    assert max(off(exact, force_plans.plans(motion, loads, 1e-11))) < 1e-11


def test_without_loads_there_are_no_forces():
    links = SCHEMES["four_bar"]().moving
    task = Loaded(
        Cycle(linkage(SCHEMES["four_bar"](), 1), 0.3), lambda motion: dict.fromkeys(links, Load(0j, 0.0))
    )
    for one in FORCES:
        found = one.run(task, 12)
        assert np.max(np.abs(found.balancing)) == 0
        assert all(np.max(np.abs(reaction.force)) == 0 for reaction in found.reactions.values())


@pytest.mark.parametrize("one_flank", [False, True])
def test_the_teeth_of_a_gear_push_in_the_frames_reaction(one_flank):
    scheme = SCHEMES["slider_crank"]()
    gear = GearDrive(0.04, np.radians(24), 0.7, one_flank)
    scheme = dataclasses.replace(scheme, driver=dataclasses.replace(scheme.driver, gear=gear))
    task = Loaded(Cycle(linkage(scheme, 1), 0.3), random_loads)
    groups, system, drawn = ways(task, "system", "drawing_0.01")
    assert max(off(groups, system)) < 1e-12
    assert max(off(groups, drawn)) < 1e-3


def test_groups_above_class_two_and_cams_have_no_plan_of_their_own():
    for name, word in (("press", "class II"), ("quick_return", "class II"), ("cam_press", "cam")):
        lever = solved(name).lever
        task = scene(lever.kinetostatics.given, lever.kinematics)
        refused = {one.key: one.refuses(task) for one in FORCES}
        drawn = [why for key, why in refused.items() if key.startswith("drawing")]
        assert len(drawn) == 3 and all(word in str(why) for why in drawn)
        assert all(why is None for key, why in refused.items() if not key.startswith("drawing"))


def test_a_position_that_does_not_close_has_no_forces_and_its_neighbours_have():
    task = Loaded(cycle_of(linkage(SCHEMES["four_bar"]((2.6, 1, 1, 1, 1, 1)), 1)), random_loads)
    closes = task.cycle.motion(task.cycle.once(36)).closes
    assert 5 < closes.sum() < 35
    for one in FORCES:
        found = one.run(task, 36)
        assert (np.isfinite(found.balancing) == closes).all()


def test_a_cycle_of_two_turns_has_loads_of_its_own_in_the_second():
    lever = solved("engine_four_stroke").lever
    task = scene(lever.kinetostatics.given, lever.kinematics)
    found = force_method("system").run(task, 36)
    own = force_method("groups").run(task, lever.kinematics.positions.table).balancing
    assert own == pytest.approx(lever.kinetostatics.table.balancing, rel=1e-12)
    first, second = found.balancing[:18], found.balancing[18:36]
    assert np.abs(first - second).max() > 0.1 * np.abs(first).max()


# ---------------------------------------------------------------- pencil and paper


def test_what_is_read_and_written_is_rounded_as_a_person_rounds():
    assert written(np.array([123456.0, -0.00123456, 0.0, 99999.6])) == pytest.approx(
        [123460, -0.0012346, 0, 100000]
    )
    assert round_scale(np.array([180.0, 181.0, 500.0, 0.37, 0.0]), 180.0) == pytest.approx(
        [1, 2, 4, 0.0025, 0.01]
    )
    pen = Pen(0.5, 0.001)
    assert pen.placed(np.array([1.26 + 2.74j])) == pytest.approx([1.5 + 2.5j])
    assert np.abs(pen.read(np.array([3 + 4.2j]))) == pytest.approx([5.0])
    assert pen.read(np.array([0j])) == pytest.approx([0j])
    assert pen.moment(np.array([0.0123, 5.0]), np.array([1.0, 0.0])) == pytest.approx([0.0125, 5.0])
    assert Pen(0.01, 1.0).placed(np.array([0.123456j])) == pytest.approx([0.123456j])


@pytest.mark.parametrize(
    "name", ["compressor", "crank_rocker", "hacksaw", "jaw_crusher", "v_engine", "whitworth"]
)
def test_plans_of_this_accuracy_read_as_the_notes_own(name):
    """Drawn there with an arm for every load, here with one for each link: both to 0.01 mm."""
    lever = solved(name).lever
    assert lever.kinetostatics is not None
    found = force_method("drawing_0.01").run(
        scene(lever.kinetostatics.given, lever.kinematics), lever.kinematics.positions.table
    )
    largest = np.abs(found.balancing).max()
    for drawn in lever.force_plans.drawn:
        assert drawn.balancing == pytest.approx(found.balancing[drawn.position], abs=1.5e-3 * largest)

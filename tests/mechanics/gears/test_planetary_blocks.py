"""The search for teeth in blocks: the same whatever their size, never many at once, ranked as the weight says."""

from dataclasses import replace

import numpy as np
import pytest

from tmm_report.mechanics.gears.planetary import sought as planetary_task
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import Reason, Task, ranked, search

RANGES = {"external": (12, 40), "rings": (20, 110), "satellites": (2, 3, 4)}
TASKS = [
    Task(p.SCHEMES["sun-ring"], 4.2, (0.005, 0.005), "wheel1", "carrier", **RANGES, shifted=2),
    Task(p.SCHEMES["external-internal"], 8.0, (0.005, 0.004), "wheel1", "carrier", **RANGES, shifted=2),
    Task(p.SCHEMES["external-external"], -5.0, (0.004, 0.004), "carrier", "wheel1", **RANGES),
    Task(p.SCHEMES["internal-internal"], 9.0, (0.003, 0.003), "carrier", "wheel1", **RANGES, tolerance=0.2),
    Task(p.SCHEMES["external-internal"], 8.0, (0.005, 0.005), "wheel1", "carrier", **RANGES, distance=0.13, shifted=2),
]  # fmt: skip


def solutions(task):
    found = search(task)
    return [
        (*found.teeth[:, i].tolist(), int(found.satellites[i])) for i in ranked(task, found)
    ], found.counts


@pytest.mark.exhaustive
@pytest.mark.parametrize("task", TASKS)
def test_blocks_of_another_size_find_the_same(task, monkeypatch):
    """Solutions in their order, and how many fail each condition."""
    wanted = solutions(task)
    for size in (1 << 9, 1 << 20):
        monkeypatch.setattr(planetary_task, "BLOCK", size)
        assert solutions(task) == wanted
    assert wanted[1][Reason.ACCEPTED] == len(wanted[0]) > 0


@pytest.mark.parametrize("task", TASKS)
def test_all_that_was_judged_is_what_was_counted(task):
    every = search(task, rejected=True)
    codes, numbers = np.unique(every.reasons, return_counts=True)
    assert dict(zip(map(Reason, codes), numbers.tolist(), strict=True)) == search(task).counts
    assert len(every.reasons) == every.examined


@pytest.mark.parametrize("modules", [(0.002, 0.002), (0.04, 0.002), (0.002, 0.04), (0.1, 0.0001)])
def test_no_block_is_much_larger_than_another(modules):
    """Whatever the modules: so many rows of teeth are in the memory at once, and no more."""
    task = replace(TASKS[1], modules=modules, external=(6, 120), rings=(10, 250))
    sizes = [block.shape[1] for block, _ in zip(planetary_task.blocks(task), range(40), strict=False)]
    assert max(sizes) <= 2 * planetary_task.BLOCK


def test_of_more_solutions_than_are_kept_the_best_stay():
    task = TASKS[1]
    full, counts = solutions(task)
    few = search(task, most=50)
    order = ranked(task, few)
    best = [(*few.teeth[:, i].tolist(), int(few.satellites[i])) for i in order]
    assert best == full[:50] and few.counts == counts and few.solutions == len(full)


def test_the_weight_takes_the_ranking_from_compact_to_near():
    """w = 0: the diameter never falls; w = 1: the deviation never falls, among those without multiples and shift."""
    task = TASKS[2]
    for weight in (0.0, 0.5, 1.0):
        some = replace(task, weight=weight)
        found = search(some)
        order = ranked(some, found)
        z, k = found.teeth[:, order], found.satellites[order]
        first = ~((z[0] % k == 0) | (z[3] % k == 0))
        size = some.sizes(z).overall[first]
        ratio = p.stage_ratio(p.basic_ratio(some.scheme, z), some.input, some.output)[first]
        miss = np.abs(ratio / some.ratio - 1) / some.tolerance
        score = (1 - weight) * np.log(size) + weight * miss
        assert (np.diff(score) > -1e-8).all()
    assert solutions(replace(task, weight=1.0))[0][0] != solutions(task)[0][0]


def test_a_stated_centre_distance_is_that_of_every_solution():
    found = search(TASKS[4])
    sizes = TASKS[4].sizes(found.teeth)
    assert found.solutions > 0 and (sizes.centre_distance == 0.13).all()
    away = np.abs(2 * (sizes.pitch_distances - 0.13)) / 0.005
    assert away.max() <= 2 + 1e-9

"""Tables and values of a planetary stage, and the list of all combinations of teeth with the reasons of rejection."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.planetary.limits import REASONS
from tmm_report.chapters.planetary.solve import Found, Given, all_candidates
from tmm_report.mechanics import planetary as p
from tmm_report.mechanics.planetary_search import Candidates, Reason, Task, multiples, ranked
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value, plain, plain_value
from tmm_report.quantity.wheel_words import DIAMETERS

Array = Any

WHEELS = N_("dimensions of the wheels of stage %(name)s")
MOTIONS = N_("motions of stage %(name)s with each member held")
SOLUTIONS = N_("teeth of stage %(name)s that satisfy every condition, best first")
CANDIDATES = Message(N_("combinations of teeth: the solutions, best first, then those rejected"))


def values(found: Found, prefix: str) -> Iterator[Value]:
    """The single numbers of the stage."""
    numbers = (
        ("u", found.ratio, "", N_("ratio of the stage, the second input at rest")),
        ("u_basic", found.basic, "", N_("ratio with the carrier stopped, wheel 1 to wheel 3")),
        ("delta_u", 100 * found.deviation, "%", N_("deviation of the ratio")),
        ("k", float(found.satellites), "", N_("number of satellites")),
        ("a_w", float(found.sizes.centre_distance), "m", N_("centre distance")),
        ("gap", found.gap, "m", N_("gap between the tip circles of neighbouring satellites")),
        ("assembly", float(found.assembly_number), "", N_("whole number of the assembly condition")),
        ("eta", found.efficiency, "", N_("efficiency of the stage")),
        ("solutions", float(len(found.ranking)), "", N_("how many solutions there are")),
    )
    for key, number, unit, meaning in numbers:
        yield plain_value(f"{prefix}_{key}", number, unit, Message(meaning))


def tables(found: Found, prefix: str) -> Iterator[Table]:
    """Sizes, motions with each member held, the solutions."""
    name = {"name": found.name}
    yield Table(f"{prefix}_wheels", Message(WHEELS, name), tuple(_wheels(found)))
    yield Table(f"{prefix}_motions", Message(MOTIONS, name), tuple(_motions(found)))
    columns = _combinations(found.given.task, found.candidates, found.ranking)
    yield Table(f"{prefix}_solutions", Message(SOLUTIONS, name), tuple(columns))


def _wheels(found: Found) -> Iterator[Column]:
    given, order = found.given, list(found.scheme.wheels)
    names = (given.names[0], *given.crowns, given.names[-2])
    yield plain("wheel", "", Message(N_("number of the wheel")), [names[i] for i in order])
    yield plain("z", "", Message(N_("number of teeth")), [found.teeth[i] for i in order])
    yield plain("x", "", Message(N_("shift coefficient")), found.sizes.shifts[order])
    for key, meaning in DIAMETERS.items():
        yield plain(key, "m", Message(meaning), found.sizes.diameters[key][order])


def _motions(found: Found) -> Iterator[Column]:
    motions, member = found.motions, found.given.member
    for key, meaning, pick in (
        ("held", N_("member that is held"), lambda m: m.held),
        ("input", N_("input member"), lambda m: m.input),
        ("output", N_("output member"), lambda m: m.output),
    ):
        yield plain(key, "", Message(meaning), [member(pick(motion)) for motion in motions])
    for one in p.MEMBERS:
        about = Message(N_("speed of member %(name)s to that of the input"), {"name": member(one)})
        yield plain(f"omega_{member(one)}", "", about, [motion.speed[one] for motion in motions])
    about = Message(N_("speed of the satellites to that of the input"))
    yield plain("omega_satellite", "", about, [motion.satellite for motion in motions])
    yield plain("u", "", Message(N_("ratio of the angular velocities")), [motion.ratio for motion in motions])
    yield plain("eta", "", Message(N_("efficiency; not positive: locks")), [m.efficiency for m in motions])
    way = N_("flow of the power, carrier stopped: 1 from wheel 1 to wheel 3, −1 back")
    yield plain("power", "", Message(way), [motion.exponent for motion in motions])


def _combinations(task: Task, found: Candidates, order: Array) -> Iterator[Column]:
    """Teeth, satellites, ratio, deviation, of the candidates of the indices (n,)."""
    z, k = found.teeth[:, order], found.satellites[order]
    ratio = p.stage_ratio(p.basic_ratio(task.scheme, z), task.input, task.output)
    for wheel, key in ((0, "z1"), (1, "z2"), (2, "z2'"), (3, "z3")):
        if wheel != 2 or not task.scheme.single:
            yield plain(key, "", Message(N_("number of teeth")), z[wheel])
    yield plain("k", "", Message(N_("number of satellites; 0: any")), k)
    yield plain("u", "", Message(N_("ratio of the angular velocities")), ratio)
    yield plain("delta_u", "%", Message(N_("deviation of the ratio")), 100 * (ratio / task.ratio - 1))
    repeats = multiples(z, np.maximum(k, 1)) & (k > 0)
    about = N_("1: teeth of a central wheel are a multiple of the satellites' number")
    yield plain("multiple", "", Message(about), repeats.astype(int))


# --- every combination


def candidates(given: Given) -> Table:
    """Every combination of teeth judged: the solutions, best first, then the others, the nearest to success first."""
    found = all_candidates(given)
    good = ranked(given.task, found)
    bad = np.flatnonzero(found.reasons != Reason.ACCEPTED)
    z = found.teeth[:, bad]
    ratio = p.stage_ratio(p.basic_ratio(given.task.scheme, z), given.task.input, given.task.output)
    with np.errstate(invalid="ignore"):
        miss = np.abs(ratio - given.task.ratio)
    order = np.concatenate([good, bad[np.lexsort((miss, -found.reasons[bad].astype(int)))]])
    verdict = found.reasons[order]
    columns = (
        *_combinations(given.task, found, order),
        plain("verdict", "", Message(N_("why the combination is rejected")), verdict),
    )
    return Table("candidates", CANDIDATES, columns)


def listing(table: Table, translate: Callable[[str], str] = str) -> Iterator[str]:
    """The table of `candidates` as rows of text: a head, then one combination in each line."""
    *numbers, verdict = table.columns
    words = {int(reason): translate(text) for reason, text in REASONS.items()}
    yield "".join(f"{column.key:>{_width(column.key)}}" for column in numbers)
    formats = ["{:" + f"{_width(column.key)}{_form(column.key)}" + "}" for column in numbers]
    line = "".join(formats) + "  {}"
    rows = zip(*(np.asarray(column.values).tolist() for column in numbers), strict=True)
    for row, code in zip(rows, np.asarray(verdict.values).tolist(), strict=True):
        yield line.format(*row, words[code])


def _width(key: str) -> int:
    return 11 if key in ("u", "delta_u", "multiple") else 6


def _form(key: str) -> str:
    return {"u": ".5g", "delta_u": ".2f"}.get(key, "d")

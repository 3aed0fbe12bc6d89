"""What a user is told where a planetary stage cannot be had: which condition fails, and what would work."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import (
    KEPT,
    LARGEST_SHIFTED,
    LEAST_CONTACT,
    Candidates,
    Reason,
    Task,
    coaxial,
    extent,
    in_contact,
    judge,
    no_interference,
    not_undercut,
    ranked,
    ratio_holds,
    search,
)
from tmm_report.mechanics.gears.planetary.sought import coaxiality_gap
from tmm_report.mechanics.gears.rack_mistakes import of_rack
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

Array = Any
Teeth = tuple[int, int, int, int]

ALL_SATELLITES = tuple(range(2, 9))
FEW = 1_000_000  # combinations of which all ratios are looked at for an advice
ALL = 10**9
NEAR = 0.8  # of the ratio: what is farther off is no advice
REASONS = {
    Reason.ACCEPTED: N_("accepted"),
    Reason.RATIO: N_("the ratio is out of the tolerance"),
    Reason.COAXIALITY: N_("no coaxiality"),
    Reason.UNDERCUT: N_("undercut of teeth"),
    Reason.INTERFERENCE: N_("interference of the internal pair"),
    Reason.CONTACT: N_("the contact ratio is too small"),
    Reason.NEIGHBOURHOOD: N_("the planet gears touch one another"),
    Reason.ASSEMBLY: N_("the planet gears cannot be assembled"),
}
CONTACT = N_("the profile shift leaves a contact ratio under %(least)s")
FOR_EXAMPLE = N_("for example, teeth %(teeth)s with %(count)s planet gears do")


def check(task: Task) -> None:
    """Raises ProblemError where the rack cuts no teeth."""
    if problems := list(of_rack(task.rack, ("rack",))):
        raise ProblemError(problems)


# --- no teeth at all


def no_solution(task: Task, found: Candidates) -> ProblemError:
    """The ratio is out of reach, or only with these satellites, or no teeth pass at all."""
    values = {
        "ratio": f"{task.ratio:.5g}",
        "tolerance": f"{100 * task.tolerance:.3g}",
        "count": _listed(task.satellites),
    }
    wrong = N_("no teeth give the ratio %(ratio)s within %(tolerance)s %% with %(count)s planet gears")
    return ProblemError([mistake(wrong, ("ratio",), _nearby(task, found), **values)])


def _nearby(task: Task, found: Candidates) -> Message:
    """What would work near a task that no teeth fulfil; `found`: what became of its combinations."""
    return _other_satellites(task, found) or _by_shift(task) or _reachable(task)


def _best(task: Task) -> tuple[Teeth, int] | None:
    found = search(task)
    order = ranked(task, found)
    if not len(order):
        return None
    return _teeth(found.teeth[:, order[0]]), int(found.satellites[order[0]])


def _example(task: Task, text: str) -> Message | None:
    best = _best(task)
    return None if best is None else Message(text, {"teeth": _shown(task, best[0]), "count": best[1]})


def _other_satellites(task: Task, found: Candidates) -> Message | None:
    """Only what fails by the satellites may do with another number of them."""
    if not found.count(Reason.NEIGHBOURHOOD) + found.count(Reason.ASSEMBLY):
        return None
    return _example(replace(task, satellites=ALL_SATELLITES), FOR_EXAMPLE)


def _by_shift(task: Task) -> Message | None:
    if task.shifted:
        return None
    text = N_("with coaxiality: shift, for example, teeth %(teeth)s with %(count)s planet gears do")
    return _example(replace(task, shifted=LARGEST_SHIFTED), text)


def _reachable(task: Task) -> Message:
    """The range of ratios of the wanted sign and the nearest of them; of very many combinations the nearest alone."""
    wide = extent(task) > FEW
    tolerance = min(NEAR, 8 * task.tolerance) if wide else np.inf
    found = search(
        replace(task, tolerance=tolerance, weight=1.0 if wide else 0.0), most=KEPT if wide else ALL
    )
    return _nearest(task, found, tolerance)


def _nearest(task: Task, found: Candidates, tolerance: float) -> Message:
    ratio = p.stage_ratio(p.basic_ratio(task.scheme, found.teeth), task.input, task.output)
    near = np.flatnonzero(np.isfinite(ratio))
    same = near[np.sign(ratio[near]) == np.sign(task.ratio)]
    near = same if len(same) else near
    if not len(near):
        return Message(N_("allow wider ranges of teeth, or other planet gears"))
    best = near[np.argmin(np.abs(ratio[near] - task.ratio))]
    values = {
        "low": f"{ratio[near].min():.4g}",
        "high": f"{ratio[near].max():.4g}",
        "near": f"{ratio[best]:.5g}",
        "teeth": _shown(task, _teeth(found.teeth[:, best])),
    }
    text = N_(
        "this scheme gives ratios from %(low)s to %(high)s, the nearest is %(near)s with teeth %(teeth)s"
    )
    if np.isfinite(tolerance):
        text = N_("the nearest ratio that was found is %(near)s with teeth %(teeth)s")
    return Message(text, values)


# --- the teacher's teeth


def check_teeth(task: Task, teeth: Teeth, found: Candidates, order: Array) -> int:
    """The best number of satellites for the teeth. Raises ProblemError with every condition that fails."""
    counts = np.array(sorted(task.satellites, key=lambda k: (abs(k - 3), k)))
    columns = np.repeat(np.array(teeth)[:, None], len(counts), axis=1)
    reasons = judge(task, columns, counts)
    if np.any(good := reasons == Reason.ACCEPTED):
        return int(counts[good][0])
    best = min(counts, key=lambda k: len(_failures(task, teeth, int(k))))
    problems = _failures(task, teeth, int(best))
    if any(problem.right is None for problem in problems):
        example = _first(task, found, order) if len(order) else _nearby(task, found)
        problems = [replace(problem, right=problem.right or example) for problem in problems]
    raise ProblemError(problems)


def _first(task: Task, found: Candidates, order: Array) -> Message:
    """The best of the solutions as an example."""
    teeth = _shown(task, _teeth(found.teeth[:, order[0]]))
    return Message(FOR_EXAMPLE, {"teeth": teeth, "count": int(found.satellites[order[0]])})


def _failures(task: Task, teeth: Teeth, k: int) -> list[Problem]:
    z = np.array(teeth)[:, None]
    found = []
    if not ratio_holds(task, z)[0]:
        found.append(_ratio(task, teeth))
    if not coaxial(task, z)[0]:
        return [*found, _coaxiality(task, teeth)]  # without one centre distance there are no sizes
    sizes = task.sizes(z)
    if not not_undercut(task, z, sizes)[0]:
        found.append(_undercut(task, teeth))
    if not no_interference(task, z, sizes)[0]:
        found.append(_interference(task, teeth))
    if not in_contact(task, z, sizes)[0]:
        found.append(mistake(CONTACT, ("teeth",), None, least=LEAST_CONTACT))
    if p.neighbourhood_gap(sizes, k)[0] <= 0:
        found.append(_neighbourhood(sizes, k))
    if not p.assembles(task.scheme, z, k)[0]:
        found.append(_assembly(task, teeth, k))
    return found


def _ratio(task: Task, teeth: Teeth) -> Problem:
    ratio = float(p.stage_ratio(p.basic_ratio(task.scheme, np.array(teeth)), task.input, task.output))
    values = {
        "ratio": f"{ratio:.5g}",
        "wanted": f"{task.ratio:.5g}",
        "tolerance": f"{100 * task.tolerance:.3g}",
    }
    wrong = N_("the teeth give the ratio %(ratio)s, further than %(tolerance)s %% from %(wanted)s")
    return mistake(wrong, ("teeth",), None, **values)


def _coaxiality(task: Task, teeth: Teeth) -> Problem:
    z = np.array(teeth)
    one, other = (
        f"{1e3 * m * s / 2:.5g}" for m, s in zip(task.modules, p.teeth_sums(task.scheme, z), strict=True)
    )
    wrong = N_("the two meshes have different centre distances, %(one)s mm and %(other)s mm")
    right = None
    if coaxiality_gap(task, z) <= LARGEST_SHIFTED and task.shifted == 0:
        right = Message(N_("coaxiality: shift makes up such a difference by profile shift"))
    return mistake(wrong, ("teeth",), right, one=one, other=other)


def _undercut(task: Task, teeth: Teeth) -> Problem:
    z = np.array(teeth)
    least = p.least_teeth(task.rack, task.sizes(z).shifts)
    outside = [k for k, kind in enumerate(p.kinds(task.scheme)) if kind == p.EXTERNAL]
    worst = min(outside, key=lambda k: teeth[k] - least[k])
    wrong = N_("the wheel with %(teeth)s teeth is undercut")
    right = Message(
        N_("at least %(least)s teeth are not undercut"), {"least": int(np.ceil(least[worst] - 1e-9))}
    )
    return mistake(wrong, ("teeth",), right, teeth=teeth[worst])


def _interference(task: Task, teeth: Teeth) -> Problem:
    wrong = N_("the teeth of the planet gear and of the ring interfere: %(teeth)s")
    return mistake(wrong, ("teeth",), None, teeth=_shown(task, teeth))


def _neighbourhood(sizes: p.Sizes, k: int) -> Problem:
    gap = float(p.neighbourhood_gap(sizes, k)[0])
    ratio = float((sizes.largest_satellite / (2 * sizes.centre_distance))[0])
    most = int(np.ceil(np.pi / np.arcsin(min(1.0, ratio)))) - 1
    wrong = N_("%(count)s planet gears overlap by %(gap)s mm")
    right = Message(N_("there is room for %(most)s"), {"most": most}) if most >= 2 else None
    return mistake(wrong, ("satellites",), right, count=k, gap=f"{-1e3 * gap:.4g}")


def _assembly(task: Task, teeth: Teeth, k: int) -> Problem:
    good = [n for n in ALL_SATELLITES if p.assembles(task.scheme, np.array(teeth), n)]
    wrong = N_("%(count)s equally spaced planet gears cannot be assembled with these teeth")
    right = Message(N_("%(counts)s planet gears can"), {"counts": _listed(good)}) if good else None
    return mistake(wrong, ("satellites",), right, count=k)


def _teeth(column: Array) -> Teeth:
    z1, z2, z2_, z3 = (int(teeth) for teeth in column)
    return z1, z2, z2_, z3


def _shown(task: Task, teeth: Teeth) -> str:
    return "[" + _listed(teeth if not task.scheme.single else (teeth[0], teeth[1], teeth[3])) + "]"


def _listed(numbers: Sequence[int]) -> str:
    return ", ".join(str(number) for number in numbers)

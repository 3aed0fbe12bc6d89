"""The self-test: every ready variant solved, the worst errors by variant and kind of quantity told."""

from __future__ import annotations

import platform
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path

import numpy as np

from tmm_report import __version__, load, solve
from tmm_report.commands.talk import Talk
from tmm_report.commands.verify.found import of_functions, row, single
from tmm_report.commands.verify.reference import Reference, read
from tmm_report.course import Results
from tmm_report.i18n import said
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass
from tmm_report.resources import data_root, references_root

LIMIT = 1e-12  # of the largest number of a row
COLUMNS: Mapping[str, tuple[str, ...]] = {
    N_("angles"): ("angle",),
    N_("places"): ("place",),
    N_("velocities"): ("velocity", "angular velocity"),
    N_("accelerations"): ("acceleration", "angular acceleration"),
    N_("reactions"): ("reaction", "couple"),
    N_("moments"): ("moment",),
    N_("gears and others"): ("value",),
}
"""Heads of the columns -> kinds of quantities in them."""
WORDS = {
    "angle": N_("angle of the driving link"),
    "place": N_("place of point %(name)s"),
    "velocity": N_("velocity of point %(of)s"),
    "acceleration": N_("acceleration of point %(of)s"),
    "angular velocity": N_("angular velocity of link %(name)s"),
    "angular acceleration": N_("angular acceleration of link %(name)s"),
    "reaction": N_("reaction in pair %(name)s"),
    "couple": N_("moment of the reaction in pair %(name)s"),
    "moment": N_("balancing moment"),
}
NARROW = 7  # letters of an error: no column is narrower
INVOLUTE = "involute"  # the reference of that function and its inverse, of which the variants use but a part
MOST_TOLD = 10  # wrong numbers of one variant


@dataclass(frozen=True)
class Wrong:
    """A number that is not what it should be. `place`: number of its position, None of a single value."""

    kind: str
    name: str
    place: int | None
    error: float
    limit: float

    @property
    def text(self) -> Message:
        sizes = {"error": f"{self.error:.1e}", "limit": f"{self.limit:.1e}"}
        if self.place is None:
            text = N_("value %(name)s: the error is %(error)s, allowed is %(limit)s")
            return Message(text, {"name": self.name, **sizes})
        text = N_("%(what)s, position %(place)s: the error is %(error)s, allowed is %(limit)s")
        what = Message(WORDS[self.kind], {"name": self.name, "of": self.name})
        return Message(text, {"what": what, "place": str(self.place), **sizes})


@dataclass(frozen=True)
class Outcome:
    """A variant held against its reference: kind -> worst error; what is wrong; the largest error that is allowed."""

    worst: Mapping[str, float]
    wrong: Sequence[Wrong]
    numbers: int
    allowed: float


def run(names: Sequence[str], language: str, talk: Talk) -> bool:
    """Tell the worst errors of the named variants, or of all and of the involute function; whether all numbers are
    right. Raises ProblemError."""
    talk.speak(language)
    say = partial(said, language)
    chosen = _chosen(names)
    talk.tell(_machine())
    heads = [f"{say(head):>{NARROW}}" for head in COLUMNS]
    first = max(map(len, chosen), default=0)
    talk.tell("  ".join([" " * first, *heads]))
    done: dict[str, Outcome] = {}
    for name, path in chosen.items():
        talk.stage(Message(N_("verifying %(name)s"), {"name": name}))
        if (outcome := _outcome(name, path, talk)) is None:
            continue
        done[name] = outcome
        talk.tell("  ".join([f"{name:<{first}}", *_cells(outcome, heads)]))
        for wrong in outcome.wrong[:MOST_TOLD]:
            talk.warn(Message(N_("%(name)s: %(wrong)s"), {"name": name, "wrong": wrong.text.render(say)}))
    outcomes, lost = list(done.values()), len(chosen) - len(done)
    _sum_up(outcomes, len(done.keys() - {INVOLUTE}), talk)
    if lost:
        talk.warn(Message(N_("not verified: %(count)s variants"), {"count": str(lost)}))
    return not lost and not any(outcome.wrong for outcome in outcomes)


def _chosen(names: Sequence[str]) -> dict[str, Path | None]:
    """The ready variants by name, and the functions. Raises ProblemError for names that are none of theirs."""
    ready: dict[str, Path | None] = {
        path.stem: path for path in sorted((data_root() / "variants").glob("*.yaml"))
    }
    if unknown := [name for name in names if name not in ready]:
        right = Message(N_("one of %(words)s"), {"words": ", ".join(ready)})
        text = N_("%(name)s is none of the ready variants")
        raise ProblemError([mistake(text, (), right, name=name) for name in unknown])
    return {name: ready[name] for name in ready if name in names} or {**ready, INVOLUTE: None}


def _outcome(name: str, path: Path | None, talk: Talk) -> Outcome | None:
    """Of a ready variant, or of the functions; None, told, where there is no reference, or where the variant, which is
    right, is refused."""
    try:
        reference = read(references_root() / f"{name}.json")
        if path is None:
            return _values(of_functions(exact.name for exact in reference.values), reference)
        return verified(solve(load(path)), reference)
    except FileNotFoundError:
        talk.warn(Message(N_("%(name)s has no reference"), {"name": name}))
    except ProblemError as error:
        for problem in error.problems:
            talk.warn(problem)
    return None


def verified(results: Results, reference: Reference) -> Outcome:
    """The numbers of the results against those of the reference."""
    worst: dict[str, float] = {}
    wrong: list[Wrong] = []
    count = 0
    at = np.array(reference.positions, dtype=int)
    for exact in reference.rows:
        errors = exact.errors(row(results, exact.kind, exact.name)[at])
        worst[exact.kind] = max(worst.get(exact.kind, 0.0), float(errors.max()))
        count += errors.size
        for k in np.flatnonzero(~(errors <= reference.limits)):
            limit = float(reference.limits[k])
            wrong.append(Wrong(exact.kind, exact.name, int(at[k]), float(errors[k]), limit))
    found = single(results, [exact.name for exact in reference.values])
    values = _values(found, reference)
    allowed = float(max([LIMIT, *reference.limits]))
    return Outcome({**worst, **values.worst}, [*wrong, *values.wrong], count + values.numbers, allowed)


def _values(found: Mapping[str, float], reference: Reference) -> Outcome:
    """Single numbers against those of the reference."""
    pairs = [(exact, np.array([found.get(exact.name, np.nan)])) for exact in reference.values]
    errors = {exact.name: float(exact.errors(number)[0]) for exact, number in pairs}
    wrong = [Wrong("value", name, None, error, LIMIT) for name, error in errors.items() if not error <= LIMIT]
    worst = {"value": max(errors.values())} if errors else {}
    return Outcome(worst, wrong, len(errors), LIMIT)


def _cells(outcome: Outcome, heads: Sequence[str]) -> list[str]:
    """The worst error of every column, as wide as its head."""
    cells = []
    for head, kinds in zip(heads, COLUMNS.values(), strict=True):
        errors = [outcome.worst[kind] for kind in kinds if kind in outcome.worst]
        cells.append(f"{max(errors):.1e}".rjust(len(head)) if errors else " " * len(head))
    return cells


def _machine() -> Message:
    """What the numbers were found with."""
    values = {
        "version": __version__,
        "python": platform.python_version(),
        "numpy": np.__version__,
        "system": f"{platform.system()} {platform.machine()}",
    }
    return Message(N_("tmm-report %(version)s, Python %(python)s, numpy %(numpy)s, %(system)s"), values)


def _sum_up(outcomes: Sequence[Outcome], variants: int, talk: Talk) -> None:
    worst = max((error for outcome in outcomes for error in outcome.worst.values()), default=0.0)
    numbers, wrong = sum(o.numbers for o in outcomes), sum(len(o.wrong) for o in outcomes)
    values = {
        "numbers": str(numbers),
        "variants": str(variants),
        "worst": f"{worst:.1e}",
        "wrong": str(wrong),
        "limit": f"{LIMIT:.0e}",
    }
    if wrong:
        text = N_(
            "wrong: %(wrong)s of %(numbers)s numbers in %(variants)s variants; the worst error is %(worst)s"
        )
        talk.warn(Message(text, values))
    else:
        text = N_("right: %(numbers)s numbers in %(variants)s variants; the worst error is %(worst)s")
        talk.tell(Message(text, values))

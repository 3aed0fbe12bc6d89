"""Students' works made up: a solved variant's numbers read off plans, with one mistake of a named kind, or none.

world = World.made(("compressor", "shaper"), others=4)
work = planted(world, np.random.default_rng(1), "shifted")
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tmm_report import course, loading
from tmm_report.grading.expected import expected
from tmm_report.grading.model import KINDS, OF_WHOLE, Answered, Answers, Asked, Expected, Judged, Name
from tmm_report.judging.judge import default_floor, judge
from tmm_report.problems import ProblemError

Array = Any
Numbers = dict[Name, Array]
VARIANTS = Path(__file__).parents[2] / "variants"
TOPOLOGIES = ("compressor", "shaper", "jaw_crusher", "slider_crank_offset")
LIMIT = 5.0
PLAN, READ = 50.0, 0.5  # mm: the longest vector of a plan, and how well it is read
DIGITS = 4  # that a student writes


@dataclass(frozen=True, eq=False)
class Plant:
    """The mistake that was made. `names`: the columns that it made wrong, of `among`, those in which it was made."""

    kind: str
    detail: str
    names: frozenset[Name]
    among: frozenset[Name]


@dataclass(frozen=True, eq=False)
class Work:
    """One work: whose variant it is, what was handed in, which mistakes are in it."""

    topology: str
    id: str
    expected: Expected
    answers: Answers
    plants: tuple[Plant, ...]

    def judged(self) -> dict[Name, Judged]:
        return {
            name: judge(self.expected[name], column.values, column.given, limit=LIMIT)
            for name, column in self.answers.columns.items()
        }


# ---------------------------------------------------------------- variants


@dataclass(frozen=True, eq=False)
class World:
    """The variants of a year by topology and id."""

    variants: Mapping[str, Mapping[str, Expected]]

    @classmethod
    def made(cls, topologies: Sequence[str] = TOPOLOGIES, others: int = 6, seed: int = 0) -> World:
        rng = np.random.default_rng(seed)
        return cls({name: _family(name, others, rng) for name in topologies})


def _family(name: str, others: int, rng: np.random.Generator) -> dict[str, Expected]:
    """A ready variant and others of the same topology with other lengths and speed, that go all round."""
    text = (VARIANTS / f"{name}.yaml").read_text("utf-8")
    found = {f"{name}-00": expected(course.solve(loading.loads(text)))}
    while len(found) <= others:
        try:
            results = course.solve(loading.loads(_changed(text, rng)))
        except ProblemError:
            continue
        if results.lever is not None and not results.lever.kinematics.gaps:
            found[f"{name}-{len(found):02d}"] = expected(results)
    return found


def _changed(text: str, rng: np.random.Generator) -> str:
    """The text of a variant with every length of its links changed by up to 15 %."""
    head, rest = text.split("  links:", 1)
    links, tail = rest.split("  driver:", 1)
    links = re.sub(r"([\d.]+) mm", lambda m: f"{float(m[1]) * rng.uniform(0.85, 1.15):.1f} mm", links)
    return f"{head}  links:{links}  driver:{tail}"


# ---------------------------------------------------------------- an honest work


def asked_of(variant: Expected) -> list[Name]:
    """The columns that a course asks for: rates as a plan gives them, without components, forces and moments."""
    tables = ("outputs_table", "rates_table", "reactions_table", "loads_table", "balancing_table")
    return [
        name
        for name, asked in variant.items()
        if name[0] in tables
        and not re.search(r"_[xy]$|^x_|^alpha_|^M_(lever|power|\d)", name[1])
        and asked.largest > 1e-6
    ]


def honest(variant: Expected, names: Sequence[Name], rng: np.random.Generator) -> Numbers:
    """What a student reads off his plans, who makes no mistake."""
    return {name: _read(variant[name], rng) for name in names}


def _read(asked: Asked, rng: np.random.Generator) -> Array:
    if asked.key.startswith("G_"):
        return np.array(asked.values)  # multiplied, not read off
    noise = rng.uniform(-READ, READ, len(asked.values)) * asked.largest / PLAN
    noise[-1] = noise[0]
    return asked.values + noise


def handed_in(id: str, numbers: Mapping[Name, Array], rows: Array) -> Answers:
    """The numbers written down in a few digits, at some of the rows."""
    return Answers(id, {name: _written(values, rows) for name, values in numbers.items()})


def _written(values: Array, rows: Array) -> Answered:
    rounded = np.array([float(f"{x:.{DIGITS}g}") for x in values])
    given = rows & np.isfinite(rounded)
    blank = ("",) * len(values)
    return Answered(np.where(given, rounded, np.nan), given, tuple(map(str, rounded)), blank)


def rows_of(rng: np.random.Generator, p: int) -> Array:
    """Which rows are answered: all but the last, which is the first again; all; or all but the first."""
    rows = np.ones(p, dtype=bool)
    rows[rng.choice([-1, -1, -1, 0])] = rng.random() < 0.25
    return rows


# ---------------------------------------------------------------- mistakes


@dataclass(frozen=True, eq=False)
class Scene:
    """What a mistake is made in."""

    own: Expected
    others: Mapping[str, Expected]
    numbers: Numbers
    rng: np.random.Generator

    def some(self, wanted: Callable[[Name, Asked], object]) -> list[Name]:
        """The columns as mistakes go: one alone, a few of one table and unit, all of a table, all there are."""
        able = [name for name in self.numbers if wanted(name, self.own[name])]
        if not able:
            return []
        first = able[self.rng.integers(len(able))]
        alike = [n for n in able if n[0] == first[0] and self.own[n].unit == self.own[first].unit]
        table = [n for n in able if n[0] == first[0]]
        scopes = ([first], alike, table, able)
        return scopes[self.rng.choice(4, p=[0.4, 0.3, 0.2, 0.1])]


Made = tuple[Numbers, str] | None


def _times(scene: Scene, names: Sequence[Name], by: float) -> Numbers:
    return {name: scene.numbers[name] * by for name in names}


def _sign(scene: Scene) -> Made:
    return _times(scene, scene.some(lambda n, a: a.signed and (a.values < 0).any()), -1), ""


def _modulus(scene: Scene) -> Made:
    names = scene.some(lambda n, a: a.signed and _both_signs(a))
    return {name: np.abs(scene.numbers[name]) for name in names}, ""


def _both_signs(asked: Asked) -> bool:
    """Whether enough of a column is negative, and positive, that its magnitudes are not its opposites."""
    loud = asked.values[np.abs(asked.values) > 2 * default_floor(asked)]
    return len(loud) > 0 and 0.3 <= (loud < 0).mean() <= 0.7


def _mm(scene: Scene) -> Made:
    by = 1e3 if scene.rng.random() < 0.8 else 1e-3
    return _times(scene, scene.some(lambda n, a: a.unit in ("m", "m/s", "m/s²", "N·m")), by), f"{by:g}"


def _rpm(scene: Scene) -> Made:
    by = 30 / np.pi
    return _times(scene, scene.some(lambda n, a: a.unit == "rad/s"), by), f"{by:.4g}"


def _degrees(scene: Scene) -> Made:
    by = 180 / np.pi
    return _times(scene, scene.some(lambda n, a: a.unit.startswith("rad")), by), f"{by:.4g}"


def _ten(scene: Scene) -> Made:
    k = int(scene.rng.choice([-2, -1, 1, 2]))
    return _times(scene, scene.some(lambda n, a: not a.angle), 10.0**k), f"10^{k}"


def _factor(scene: Scene) -> Made:
    by = float(scene.rng.choice([2.0, 0.5]))
    return _times(scene, scene.some(lambda n, a: not a.angle), by), f"{by:g}"


SPECIAL = (0.1, 0.5, 1 / 9.81, 2.0, 9.549, 10.0, 1.0)


def _scale(scene: Scene) -> Made:
    """Of a plan: all that is read off it. A column that does not change shows no scale, so some must."""
    by = float(np.exp(scene.rng.uniform(-1.2, 1.2)))
    if any(abs(np.log(by / one)) < 0.12 for one in SPECIAL):
        return None
    names = scene.some(lambda n, a: not a.angle)
    names = [n for n in names if scene.own[n].unit == scene.own[names[0]].unit]
    varies = [n for n in names if np.ptp(np.abs(scene.own[n].values)) > 0.3 * scene.own[n].largest]
    return (_times(scene, names, by), "") if varies else None


def _turns_given(scene: Scene) -> Made:
    by = 1 / (2 * np.pi)
    return _times(scene, scene.some(lambda n, a: a.unit == "rad/s"), by), f"{by:.4g}"


def _speed(scene: Scene) -> Made:
    """Another number taken for ω: velocities by its part, accelerations by its square."""
    by = float(scene.rng.choice([30 / np.pi, 1 / (2 * np.pi), 60.0]))
    squared = scene.rng.random() < 0.3
    names = scene.some(lambda n, a: a.unit in (("m/s²", "rad/s²") if squared else ("m/s",)))
    return _times(scene, names, by**2 if squared else by), f"{by:.4g}{'²' * squared}"


def _weight(scene: Scene) -> Made:
    return _times(scene, scene.some(lambda n, a: n[1].startswith(("F_I", "M_I"))), 9.81), "9.81"


def _coriolis(scene: Scene) -> Made:
    return _times(scene, scene.some(lambda n, a: n[1].endswith("_k")), 0.5), "0.5"


def _rows(scene: Scene) -> Made:
    n = len(next(iter(scene.numbers.values()))) - 1
    one, other = (int(row) for row in scene.rng.choice(np.arange(1, n), 2, replace=False))
    order = np.arange(n)
    order[[one, other]] = order[[other, one]]
    return _moved(scene, list(scene.numbers), order), f"{min(one, other)}, {max(one, other)}"


def _mass(scene: Scene) -> Made:
    return _times(scene, scene.some(lambda n, a: n[1].startswith("G_")), 1 / 9.81), f"{1 / 9.81:.4g}"


def _moved(scene: Scene, names: Sequence[Name], order: Array) -> Numbers:
    """Row k is given the number of position order[k]; the last row is the first again."""
    closed = [*order, order[0]]
    return {name: scene.numbers[name][closed] for name in names}


def _broad(scene: Scene) -> list[Name]:
    """The whole work, or one table of it."""
    tables = sorted({name[0] for name in scene.numbers})
    table = tables[scene.rng.integers(len(tables))]
    whole = scene.rng.random() < 0.7
    return [name for name in scene.numbers if whole or name[0] == table]


def _shifted(scene: Scene) -> Made:
    steps = int(scene.rng.choice([-6, -5, -4, -3, -2, -1, -1, -1, 1, 1, 1, 2, 3, 4, 5]))
    n = len(next(iter(scene.numbers.values()))) - 1
    detail = 6 if steps == -6 and n == 12 else steps
    return _moved(scene, _broad(scene), (np.arange(n) + steps) % n), f"{detail:+d}"


def _reversed(scene: Scene) -> Made:
    """Counted backwards; or the crank turned the other way, by which velocities change their signs besides."""
    n = len(next(iter(scene.numbers.values()))) - 1
    moved = _moved(scene, _broad(scene), -np.arange(n) % n)
    rates = [name for name in moved if _turns(scene.own[name])]
    if scene.rng.random() < 0.6 or not rates:
        return moved, ""
    return moved | {name: -moved[name] for name in rates}, "rotation"


def _turns(asked: Asked) -> bool:
    """Whether a column changes its sign with the sense of rotation."""
    return asked.unit in ("m/s", "rad/s") and bool((asked.values < 0).any())


def _swapped(scene: Scene) -> Made:
    names = list(scene.numbers)
    one = names[scene.rng.integers(len(names))]
    alike = [n for n in names if n != one and n[0] == one[0] and scene.own[n].unit == scene.own[one].unit]
    alike = [n for n in alike if {n[1][-2:], one[1][-2:]} != {"_n", "_t"}]
    if not alike:
        return None
    other = alike[scene.rng.integers(len(alike))]
    return {one: scene.numbers[other], other: scene.numbers[one]}, ""


def _component(scene: Scene) -> Made:
    able = [n for n in scene.numbers if n[1].endswith("_n")]
    if not able:
        return None
    normal = able[scene.rng.integers(len(able))]
    tangential = normal[0], normal[1][:-1] + "t"
    both = {normal: scene.numbers[tangential], tangential: scene.numbers[normal]}
    pick = scene.rng.integers(3)
    return (both if pick == 2 else {n: v for n, v in both.items() if (n == normal) == (pick == 0)}), ""


def _variant(scene: Scene) -> Made:
    ids = sorted(scene.others)
    id = ids[scene.rng.integers(len(ids))]
    return honest(scene.others[id], list(scene.numbers), scene.rng), id


MAKERS: dict[str, Callable[[Scene], Made]] = {
    "sign": _sign,
    "modulus": _modulus,
    "mm for m": _mm,
    "rpm for rad/s": _rpm,
    "degrees for radians": _degrees,
    "power of ten": _ten,
    "factor": _factor,
    "scale": _scale,
    "mass for weight": _mass,
    "weight for mass": _weight,
    "turns for radians": _turns_given,
    "speed": _speed,
    "coriolis": _coriolis,
    "rows": _rows,
    "shifted": _shifted,
    "reversed": _reversed,
    "swapped": _swapped,
    "component": _component,
    "variant": _variant,
}
OF_OTHER_TABLES = {"radius for diameter"}  # no table by positions shows it
assert set(MAKERS) == set(KINDS) - OF_OTHER_TABLES - set(OF_WHOLE)


def planted(world: World, rng: np.random.Generator, *kinds: str) -> Work:
    """A work with a mistake of each kind in other columns, or none; drawn again until the mistakes can be told.

    A mistake cannot be told, and is not planted, where the columns stay right with it, where two mistakes give the
    same numbers (the cycle counted backwards is the opposite sign in odd columns of a symmetric mechanism), or where
    one hits columns of another.
    """
    attempts = (_attempt(world, rng, kinds) for _ in range(1000))
    return next(work for work in attempts if work is not None)


def _attempt(world: World, rng: np.random.Generator, kinds: Sequence[str]) -> Work | None:
    topology = sorted(world.variants)[rng.integers(len(world.variants))]
    family = world.variants[topology]
    id = sorted(family)[rng.integers(len(family))]
    own, others = family[id], {key: one for key, one in family.items() if key != id}
    names = _picked(asked_of(own), rng)
    numbers, rows, plants = honest(own, names, rng), rows_of(rng, 13), []
    for kind in kinds:
        made = MAKERS[kind](Scene(own, others, dict(numbers), rng))
        wrong = _made_wrong(own, made[0], rows, kind) if made is not None else frozenset()
        if made is None or not _told(own, made[0], wrong, rows, kind, made[1]) or _overlap(made[0], plants):
            return None
        numbers |= made[0]
        plants.append(Plant(kind, made[1], wrong, frozenset(made[0])))
    return Work(topology, id, own, handed_in(id, numbers, rows), tuple(plants))


def _picked(names: list[Name], rng: np.random.Generator) -> list[Name]:
    """All that is asked, or the outputs with some of the other tables."""
    tables = sorted({name[0] for name in names} - {"outputs_table"})
    kept = {"outputs_table", *(t for t in tables if rng.random() < 0.8)}
    return [name for name in names if name[0] in kept]


def _overlap(numbers: Numbers, plants: Sequence[Plant]) -> bool:
    return any(name in plant.names for plant in plants for name in numbers)


def _made_wrong(own: Expected, numbers: Numbers, rows: Array, kind: str) -> frozenset[Name]:
    """The columns of which at least a third is wrong now; of two rows exchanged both."""
    most = 10.1 / 12 if kind == "rows" else 2 / 3
    return frozenset(name for name, values in numbers.items() if _share(own[name], values, rows) <= most)


def _share(asked: Asked, values: Array, rows: Array) -> float:
    judged = judge(asked, values, rows, limit=LIMIT)
    return float(judged.ok[rows].mean())


def _told(
    own: Expected, numbers: Numbers, wrong: frozenset[Name], rows: Array, kind: str, detail: str
) -> bool:
    """Whether the mistake shows, and not as the opposite sign."""
    if not wrong or (kind == "swapped" and len(wrong) < 2):
        return False
    if detail == "rotation" and not any(_turns(own[name]) for name in wrong):
        return False  # where velocities stay right, it is the cycle counted backwards
    if kind in ("sign", "modulus"):
        return True
    return any(_share(own[name], -numbers[name], rows) < 0.7 for name in wrong)

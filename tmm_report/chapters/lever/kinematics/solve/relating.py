"""The motion of one point or link from that of others on the same link or guide, with the numbers of a position.

x_P = x_Q + l cos(φ + δ), v_P = v_Q + ω × QP, a_P = a_Q + ε × QP − ω² QP; of two points of a link ω and ε follow.
Of a guide: relative velocity, Coriolis and sliding acceleration. Source: Artobolevsky, ch. 4; Levitsky, ch. 3.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.kinematics.solve import points_and_links as q
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.vector_equations import Branch, relations, turns_with
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Formula, Negative, Var, cos, expr, sin, sqrt
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.ways import Known, Line
from tmm_report.quantity.written import Equation, Unknown

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

SAME_TURN = N_("Link %(link)s turns with link %(other)s.")
EQUATIONS = N_("Equations of group %(group)s at this position, in symbols and with numbers, solved together:")
STILL = N_("Link %(link)s is the driving link: its rotation is stated, and uniform.")
BY_LAW = N_(
    "Link %(link)s is the driving link: its law by the time is stated, and its derivatives are its rates."
)


def place(found: Kinematics, known: Known) -> Iterator[Line]:
    """A coordinate of a point from another point of its link."""
    axis, _, point = known.own.partition("_")
    motion, k = _at(found, known)
    one = _reference(motion, point)
    if one is None or not np.isfinite(motion.place(point)[k]):
        return
    link, other = one
    arm = _arm(motion, link, other, point)
    turned = Var(Symbol("phi", link), float(np.angle(motion.turn(link)[k])), "deg")
    delta = Var(Symbol("delta", other + point), float(np.angle(arm)), "deg")
    length = Var(Symbol("l", other + point), float(abs(arm)), "m")
    body = _coordinate(motion, k, axis, other) + length * {"x": cos, "y": sin}[axis](turned + delta)
    yield Formula(Symbol(axis, point), body, "m", scale=0.0)


def rate(found: Kinematics, known: Known) -> Iterator[Line]:
    """A velocity, an acceleration or an angular rate from those of other points and links."""
    motion, k = _at(found, known)
    if not np.isfinite(motion.state.w[motion.linkage.mechanism.driver.link] + 0 * motion.phi).ravel()[0]:
        return
    key = known.own[:-2] if known.own.endswith(("_x", "_y")) else known.own
    letter, _, name = key.partition("_")
    if letter in ("w", "e"):
        yield from _turning(motion, k, letter, name, known)
        return
    if name in motion.linkage.mechanism.point_names:
        yield from _of_point(motion, k, letter, name)
        return
    for relation in relations(motion.linkage):
        for branch in relation.branches:
            if key in (branch.v_key, *(branch.a_key(part) for part in ("n", "t", "k", "r"))):
                yield from _of_branch(found, known, branch, key)
                return
            if name in (branch.start, branch.end):
                yield from _of_coinciding(found, known, branch, letter, name)
                return


# ---------------------------------------------------------------- points of a link


def _of_point(motion: Motion, k: int, letter: str, point: str) -> Iterator[Line]:
    one = _reference(motion, point)
    if one is None:
        return
    link, other = one
    w, e = _rate(motion, k, "w", link), _rate(motion, k, "e", link)
    dx = _coordinate(motion, k, "x", point) - _coordinate(motion, k, "x", other)
    dy = _coordinate(motion, k, "y", point) - _coordinate(motion, k, "y", other)
    vectors = (motion.velocity, motion.acceleration)[letter == "a"]
    base = complex(np.asarray(vectors(other) + 0 * motion.phi)[k])
    x: list[Expr] = (
        [] if other in motion.linkage.mechanism.links[FRAME].points else [_part(letter, other, "x", base)]
    )
    y: list[Expr] = [] if not x else [_part(letter, other, "y", base)]
    if letter == "v":
        x, y = [*x, -(w * dy)], [*y, w * dx]
    else:
        x, y = [*x, -(e * dy), -(w**2 * dx)], [*y, e * dx, -(w**2 * dy)]
    for axis, terms in (("x", x), ("y", y)):
        of = q.point_rate(letter, point).components["xy".index(axis)]
        formula = Formula(of.sign, _total(terms), of.unit, scale=0.0, meaning=of.meaning)
        if np.isfinite(formula.value):
            yield formula


def _turning(motion: Motion, k: int, letter: str, link: str, known: Known) -> Iterator[Line]:
    """ω = QP × (v_P − v_Q)/QP², and ε likewise; of a link with one point the link that it turns with."""
    mechanism = motion.linkage.mechanism
    if link == mechanism.driver.link:
        yield Message(STILL if mechanism.driver.law is None else BY_LAW, {"link": link})
        return
    for group in motion.linkage.groups:
        other = turns_with(group).get(link)
        if other is not None:
            yield Message(SAME_TURN, {"link": link, "other": other})
            of = q.link_rate(letter, link)
            yield Formula(of.sign, _rate(motion, k, letter, other), of.unit, scale=0.0)
            return
    wheel = next((one for one in motion.linkage.structure.coupled if one.link == link), None)
    if wheel is not None:
        yield _meshing(motion, k, letter, wheel)
        return
    yield from _together(motion, known, letter, link)
    points = mechanism.links[link].points
    ends = max(((a, b) for a in points for b in points), key=lambda ab: abs(points[ab[0]] - points[ab[1]]))
    if points[ends[0]] == points[ends[1]]:
        return
    a, b = ends
    dx = _coordinate(motion, k, "x", b) - _coordinate(motion, k, "x", a)
    dy = _coordinate(motion, k, "y", b) - _coordinate(motion, k, "y", a)
    vectors = (motion.velocity, motion.acceleration)[letter == "e"]
    base = "v" if letter == "w" else "a"
    va, vb = (complex(np.asarray(vectors(p) + 0 * motion.phi)[k]) for p in ends)
    vx = _part(base, b, "x", vb) - _part(base, a, "x", va)
    vy = _part(base, b, "y", vb) - _part(base, a, "y", va)
    length = Var(Symbol("l", a + b), float(abs(points[b] - points[a])), "m")
    of = q.link_rate(letter, link)
    formula = Formula(of.sign, (dx * vy - dy * vx) / length**2, of.unit, scale=0.0)
    if np.isfinite(formula.value):
        yield formula


def _meshing(motion: Motion, k: int, letter: str, wheel: Coupled) -> Formula:
    """ω of a link that a mesh moves by the rate of the other link, relative to a moving carrier; ε likewise."""
    of, mesh = q.link_rate(letter, wheel.link), wheel.mesh
    if wheel.by_slides:
        ways = [(wheel.by, wheel.rate, mesh.along)] if wheel.by != FRAME else []
        ways += [(mesh.carrier, wheel.share, mesh.carried.along)] if mesh.carried is not None else []
        terms: list[Expr] = [
            Var(Symbol("i", f"{link}→{wheel.link}"), rate, "1/m") * _along(motion, k, letter, link, way)
            for link, rate, way in ways
        ]
        return Formula(of.sign, _total(terms), of.unit, scale=0.0)
    ratio = Var(Symbol("i", f"{wheel.by}→{wheel.link}"), wheel.rate, "")
    if mesh.carrier == FRAME:
        return Formula(of.sign, ratio * _rate(motion, k, letter, wheel.by), of.unit, scale=0.0)
    carrier = _rate(motion, k, letter, mesh.carrier)
    if wheel.by == FRAME:
        return Formula(of.sign, (1 - ratio) * carrier, of.unit, scale=0.0)
    relative = _rate(motion, k, letter, wheel.by) - carrier
    return Formula(of.sign, carrier + ratio * relative, of.unit, scale=0.0)


def _along(motion: Motion, k: int, letter: str, link: str, way: complex) -> Var:
    """The velocity or acceleration of a slider along its guide."""
    base = "v" if letter == "w" else "a"
    vector = (motion.state.v, motion.state.a)[letter == "e"][link]
    along = float(np.ravel(dot(np.asarray(vector) + 0 * motion.phi, way))[k])
    return Var(Symbol(base, link), along, q.UNITS[base])


def _together(motion: Motion, known: Known, letter: str, link: str) -> Iterator[Line]:
    """The linear equations of a group above class II, whose unknowns are found together: k·x = b, or d."""
    group = next((g for g in motion.linkage.groups if link in g.links), None)
    if not isinstance(group, HigherGroup) or not known.has(f"contours.k33_{group.group.label}"):
        return
    label = group.group.label
    unknown = [known(f"{letter}_{root}") for root in _roots(group)]
    unknown += [known(f"contours.s{'12'[letter == 'e']}_{pair.name}") for pair in group.loops.sliding]
    yield Message(EQUATIONS, {"group": label})
    for n in range(1, len(unknown) + 1):
        terms = [known(f"contours.k{n}{j}_{label}") * _left(x) for j, x in enumerate(unknown, 1)]
        right = known(f"contours.{'bd'[letter == 'e']}{n}_{label}")
        total = _total(terms) - right
        yield Equation(total, numbers=False)
        yield Equation(total)


def _roots(group: HigherGroup) -> list[str]:
    """The link by which each unknown direction goes."""
    found: dict[int, str] = {}
    for link in group.links:
        root = group.loops.directions[link].root
        if isinstance(root, int):
            found.setdefault(root, link)
    return [found[n] for n in range(group.loops.angles)]


def _left(var: Var) -> Unknown:
    return Unknown(var.symbol, var.number, var.unit, var.digits, None, var.meaning)


# ---------------------------------------------------------------- relative motion


def _of_branch(found: Kinematics, known: Known, branch: Branch, key: str) -> Iterator[Line]:
    motion, k = _at(found, known)
    quantity = q.rates(found.linkage)[key]
    w, e = _rate(motion, k, "w", branch.link), _rate(motion, k, "e", branch.link)
    part = key.rpartition("_")[2]
    body: Expr
    if branch.arm is not None:
        a, b = branch.arm
        size = abs(complex(np.asarray(motion.place(b) - motion.place(a) + 0 * motion.phi)[k]))
        length = Var(Symbol("l", a + b), size, "m")
        body = {"n": w**2, "t": abs(e)}.get(part, abs(w)) * length
    elif part == "k":
        body = 2 * abs(w) * known(branch.v_key)
    else:
        body = _apart(found, known, branch, "a" if key.startswith("a") else "v")
    formula = Formula(quantity.sign, body, quantity.unit, scale=0.0)
    if np.isfinite(formula.value):
        yield formula


def _apart(found: Kinematics, known: Known, branch: Branch, letter: str) -> Expr:
    """The size of what the motion of the end has beyond that of the start; of accelerations without Coriolis'."""
    parts = []
    for axis in ("x", "y"):
        part: Expr = expr(known(f"{letter}_{branch.end}_{axis}"))
        if branch.start is not None:
            part = part - known(f"{letter}_{branch.start}_{axis}")
        if letter == "a" and branch.has_bend:
            part = part - known(f"{branch.a_key('k')}_{axis}")
        parts.append(part)
    return sqrt(parts[0] ** 2 + parts[1] ** 2)


def _of_coinciding(found: Kinematics, known: Known, branch: Branch, letter: str, name: str) -> Iterator[Line]:
    """A point of one link at the place of a joint of another: the motion of the end less that along the guide."""
    for n, axis in enumerate(("x", "y")):
        ends = {"end": branch.end, "start": branch.start}
        other, sign = (ends["start"], 1) if name == branch.end else (ends["end"], -1)
        terms: list[Expr] = [expr(known(f"{letter}_{other}_{axis}"))] if other is not None else []
        keys = [branch.v_key]
        if letter == "a":
            parts = ("n", "t") if branch.turns else ("k", "r")
            keys = [branch.a_key(p) for p in parts if branch.has_bend or p in "tr"]  # type: ignore[arg-type]
        for key in keys:
            if key.rpartition("_")[0] != f"{letter}_{name}" and known.has(f"{key}_{axis}"):
                part = known(f"{key}_{axis}")
                terms.append(expr(part) if sign > 0 else -part)
        of = q.point_rate(letter, name).components[n]
        if terms:
            yield Formula(of.sign, _total(terms), of.unit, scale=0.0, meaning=of.meaning)


# ---------------------------------------------------------------- numbers


def _at(found: Kinematics, known: Known) -> tuple[Motion, int]:
    return (found.diagram if known.fine else found.table), known.row or 0


def _reference(motion: Motion, point: str) -> tuple[str, str] | None:
    """The link that carries a point, and another point of it: a pivot, if it has one."""
    mechanism = motion.linkage.mechanism
    link = motion.linkage.carriers[point]
    others = [p for p in mechanism.links[link].points if p != point]
    others.sort(key=lambda p: len(mechanism.links_at(p)) < 2)
    return (link, others[0]) if others and link != FRAME else None


def _arm(motion: Motion, link: str, start: str, end: str) -> complex:
    points = motion.linkage.mechanism.links[link].points
    return complex(points[end] - points[start])


def _coordinate(motion: Motion, k: int, axis: str, point: str) -> Var:
    z = complex(np.asarray(motion.place(point) + 0 * motion.phi)[k])
    return Var(Symbol(axis, point), z.real if axis == "x" else z.imag, "m")


def _part(letter: str, point: str, axis: str, number: complex) -> Var:
    of = q.point_rate(letter, point).components["xy".index(axis)]
    return Var(of.sign, number.real if axis == "x" else number.imag, of.unit, meaning=of.meaning)


def _rate(motion: Motion, k: int, letter: str, link: str) -> Var:
    of = q.link_rate(letter, link)
    values = motion.angular_velocity(link) if letter == "w" else motion.angular_acceleration(link)
    return Var(of.sign, float(np.asarray(values + 0 * motion.phi)[k]), of.unit, meaning=of.meaning)


def _total(terms: list[Expr]) -> Expr:
    total = terms[0]
    for one in terms[1:]:
        total = total - one.body if isinstance(one, Negative) else total + one
    return total

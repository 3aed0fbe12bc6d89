"""One branch of a vector equation as it is drawn: its known parts laid off, its unknown part read."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.lever.plans.drafting.plan import Role, Sense
from tmm_report.chapters.lever.plans.drafting.sheet import Sheet
from tmm_report.mechanics.calculus.vectors import unit
from tmm_report.mechanics.lever.vector_equations import Branch
from tmm_report.quantity.formula import Formula, Symbol, Term, Var
from tmm_report.quantity.written import segment_of
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Line:
    """A branch as drawn: from its start (and the end of its known part) along a direction of the paper."""

    branch: Branch
    place: complex  # of its start, world, m
    arm: complex  # world, m; the guide's direction where the branch slides
    z_start: complex
    z_bend: complex
    letter: str  # lettering of the vertex at z_bend

    @property
    def direction(self) -> complex:
        return unit(1j * self.arm if self.branch.turns else self.arm)


def coinciding(sheet: Sheet, branch: Branch, carrier: str, place: complex) -> list[Formula]:
    """Letter the start of a branch, a point of the known link `carrier`; read it where it was not drawn before."""
    if branch.start is None:
        return []
    known = sheet.has(branch.start)
    sheet.absolute(branch.start, sheet.pen.place(sheet.images[carrier].of(place)))
    return [] if known else [sheet.read_point(branch.start)]


def line_from(
    sheet: Sheet, branch: Branch, place: complex, arm: complex, z: complex
) -> tuple[Line, list[Formula]]:
    """Draw the known part of a branch from its start at `z`: in accelerations its normal or Coriolis part."""
    letter = sheet.letter(branch.start) if branch.start else sheet.pole
    if bends(sheet, branch):
        letter, formulas = _bend(sheet, branch, arm, z, letter)
        return Line(branch, place, arm, z, sheet.vertices[letter], letter), formulas
    if sheet.kind == "a" and branch.has_bend:
        sheet.nothing(branch.a_key("n" if branch.turns else "k"))
    return Line(branch, place, arm, z, z, letter), []


def bends(sheet: Sheet, branch: Branch) -> bool:
    """Whether a branch has a normal or Coriolis part to be drawn: its link or guide turns."""
    return sheet.kind == "a" and branch.has_bend and branch.link in sheet.turning


def bend(sheet: Sheet, branch: Branch, arm: complex) -> complex:
    """The normal (towards the start) or Coriolis part (sliding velocity turned by 90° with the guide), m/s²."""
    v = sheet.velocity
    assert v is not None
    sliding = v.vector(branch.v_key) * v.scale
    if branch.turns:
        return complex(-(abs(sliding) ** 2) / abs(arm) * unit(arm))
    return 2j * (v.turns[branch.link] * v.scale).imag * sliding


def _bend(sheet: Sheet, branch: Branch, arm: complex, z: complex, start: str) -> tuple[str, list[Formula]]:
    """Lay the normal or Coriolis part off from the vertex `start` at `z`; the lettering of its end."""
    v = sheet.velocity
    assert v is not None
    speed = sheet.number(branch.v_key, v.values[branch.v_key])
    if branch.turns:
        key, size = branch.a_key("n"), speed**2 / length(sheet, branch, arm)
    else:
        w = sheet.number(f"w_{branch.link}", v.values[f"w_{branch.link}"])
        key, size = branch.a_key("k"), 2 * w * speed
    count = 1 + sum(s.role == "bend" and bool(s.key) for s in sheet.strokes)
    letter = sheet.letter_of_bend(f"{'n' if branch.turns else 'k'}{count}")
    z_bend = sheet.vertices[letter] = sheet.pen.place(z + bend(sheet, branch, arm) / sheet.scale)
    sheet.stroke(z, z_bend, key, "bend")
    value = sheet.write(key, size)
    sheet.laid[key] = start + letter
    laid = sheet.worked.laid_off(segment_of(start + letter), sheet.number(key, value.written) / sheet.mu)
    sheet.segments[start + letter] = sheet.pen.read(z_bend - z)
    return letter, [value, laid]


def length(sheet: Sheet, branch: Branch, arm: complex) -> Var:
    """The length of a turning branch's arm: of a rod it is given, between a pivot and a slider it is read."""
    assert branch.arm is not None
    mm = sheet.pen.read(arm / sheet.scales.length)
    points = sheet.linkage.mechanism.links[branch.link].points
    rigid = all(joint in points for joint in branch.arm)
    given = (
        float(np.abs(points[branch.arm[1]] - points[branch.arm[0]])) if rigid else mm * sheet.scales.length
    )
    return sheet.length(*branch.arm, given)


def rate_key(sheet: Sheet, branch: Branch) -> str:
    """Key of a branch's relative velocity, or of its tangential or sliding acceleration."""
    return branch.v_key if sheet.kind == "v" else branch.a_key("t" if branch.turns else "r")


def close(sheet: Sheet, line: Line, z: complex) -> list[Formula]:
    """Draw a branch's last vector to the vertex at `z` and read it off, where it is not known beforehand."""
    branch, key = line.branch, rate_key(sheet, line.branch)
    if branch.turns and branch.link not in sheet.turning:
        sheet.nothing(key)
        return []
    if bends(sheet, branch) and branch.start is not None:
        # the whole relative acceleration: other points of the link lie along it
        sheet.stroke(line.z_start, z, f"a_{branch.pair}", "relative", Symbol("a", branch.pair))
    role: Role = "relative" if sheet.kind == "v" else "rate"
    sheet.stroke(line.z_bend, z, key, "absolute" if line.letter == sheet.pole else role)
    return [sheet.read(key, line.letter, sheet.letter(branch.end))] if key not in sheet.values else []


def angular(sheet: Sheet, line: Line) -> list[Formula]:
    """Angular velocity or acceleration of a turning branch's link."""
    branch = line.branch
    if not branch.turns:
        return []
    key = rate_key(sheet, branch)
    arm = length(sheet, branch, line.arm)
    top = sheet.number(key, sheet.values[key])
    z = sheet.vertices[sheet.letter(branch.end)]
    turn = ((z - line.z_bend) / line.arm).imag if sheet.values[key] else 0.0
    ends = line.letter + sheet.letter(branch.end)
    sheet.senses.append(Sense(branch.link, ends, (branch.arm or ("", ""))[1], int(np.sign(turn))))
    return [sheet.write(sheet.rate(branch.link), top / arm, sheet.scale / float(arm.number))]


def terms(sheet: Sheet, branch: Branch, known: int = 1) -> list[Term]:
    """A branch as a side of a vector equation. `known` of its last vector: 1 the direction, 2 the magnitude too."""
    start = [Term(sheet.symbol(f"{sheet.kind}_{branch.start}"), known=2)] if branch.start else []
    along = "⟂ " + "".join(branch.arm) if branch.arm else f"∥ {branch.guide}"
    rate = Term(sheet.symbol(rate_key(sheet, branch)), known, along)
    if not bends(sheet, branch):
        return [*start, rate]
    note = "∥ " + "".join(reversed(branch.arm)) if branch.arm else f"⟂ {branch.guide}"
    return [*start, Term(sheet.symbol(branch.a_key("n" if branch.turns else "k")), 2, note), rate]

"""How the numbers of springs and dampers are found that the formulas of the note do not define at every position."""

from __future__ import annotations

from collections.abc import Callable

from tmm_report.chapters.lever.kinetostatics.solve.lengths import ties_of
from tmm_report.chapters.lever.kinetostatics.ties import End, Spring
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, sqrt
from tmm_report.quantity.ways import NAME, STATED, Known, Way

LENGTH = N_("The distance of the two points, by their coordinates.")
RATE = N_("The difference of the velocities of the two points along the line between them.")
FORCE = N_(
    "Of a spring its stiffness by what it is longer than free, of a damper its coefficient by the rate."
)
GIVEN = N_("The force by the rate of the length: what takes its points apart takes power from the mechanism.")
FREE_ANGLE = N_("Stated, or the moment at position 0 by the stiffness.")
AT_END = N_("The force along the line from its point to the other one.")


def _end(q: Known) -> End:
    """The tie whose number it is, by how it is called: c1."""
    of = q.parts[0]
    return next(end for end in ties_of(q.found.given) if end.of == of)


def _fixed(q: Known, point: str) -> bool:
    return point in q.found.kinematics.linkage.mechanism.links[FRAME].points


def _coordinate(q: Known, point: str, axis: str) -> Expr:
    return q(f"fixed_points:{point}.{axis}" if _fixed(q, point) else f"positions_table.{axis}_{point}")


def _difference(q: Known, axis: str) -> Expr:
    one, other = _end(q).tie.between
    return _coordinate(q, other, axis) - _coordinate(q, one, axis)


def _length(q: Known) -> Expr:
    return sqrt(_difference(q, "x") ** 2 + _difference(q, "y") ** 2)


def _faster(q: Known, axis: str) -> Expr:
    """What the second point goes faster than the first."""
    one, other = _end(q).tie.between
    if _fixed(q, one):
        return q(f"rates_table.v_{other}_{axis}")
    first = q(f"rates_table.v_{one}_{axis}")
    return -first if _fixed(q, other) else q(f"rates_table.v_{other}_{axis}") - first


def _rate(q: Known) -> Expr:
    along = _difference(q, "x") * _faster(q, "x") + _difference(q, "y") * _faster(q, "y")
    return along / q("l_{0}")


def _force(q: Known) -> Expr:
    if isinstance(_end(q).tie, Spring):
        return q("springs:{0}.c") * (q("l_{0}") - q("springs:{0}.l_0"))
    return q("dampers:{0}.b") * q("v_{0}")


def _power(q: Known) -> Expr:
    return -(q("F_{0}") * q("v_{0}"))


def _projection(axis: str) -> Callable[[Known], Expr]:
    def part(q: Known) -> Expr:
        one, _ = _end(q).tie.between
        along = q("ties_table.F_{0}") * _difference(q, axis) / q("ties_table.l_{0}")
        return along if q.parts[1] == one else -along

    return part


TURNS = N_("The angle of one link less that of the other, from position 0 on.")
TIES = (
    Way("torsion_springs.key torsion_springs.name torsion_springs.one torsion_springs.other", NAME),
    Way("torsion_springs.alpha_0", FREE_ANGLE, of="c M_0"),
    Way("torsion_springs.*", STATED),
    Way("twists_table.phi_*", TURNS, of="phi"),
    Way("springs.key springs.name dampers.key dampers.name *.one *.other *.link_one *.link_other", NAME),
    Way(
        "springs.l_F",
        N_("Stated, or the length at the position at which the preload is stated."),
        of="c F_0 l_0",
    ),
    Way("springs.l_0", N_("Stated, or by the preload and the length under it."), of="c F_0 l_F"),
    Way("springs.* dampers.b", STATED),
    Way("ties_table.l_*", LENGTH, of="phi", by=_length),
    Way("ties_table.v_*", RATE, of="phi l_{0}", by=_rate),
    Way("ties_table.F_*", FORCE, of="phi l_{0} v_{0}", by=_force),
    Way("ties_table.N_*", GIVEN, of="F_{0} v_{0}", by=_power),
    Way("loads_table.F_*,*_x", AT_END, of="ties_table.F_{0} ties_table.l_{0}", by=_projection("x")),
    Way("loads_table.F_*,*_y", AT_END, of="ties_table.F_{0} ties_table.l_{0}", by=_projection("y")),
    Way(
        "loads_table.F_*,*",
        AT_END,
        of="ties_table.F_{0} F_{0},{1}_x F_{0},{1}_y",
        by=lambda q: abs(q("ties_table.F_{0}")),
    ),
)

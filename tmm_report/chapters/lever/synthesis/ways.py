"""How the numbers of a synthesis are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Var, sqrt
from tmm_report.quantity.ways import AXIS, NAME, STATED, Known, Way

SMALLER = N_(
    "The smaller of the angle with the crank inwards and of what that outwards lacks to half a turn."
)
WAY = N_(
    "The least of the angles at the ends of the crank's way and where the crank lies along the frame on it."
)
PRESSURE = N_("Where the crank stands across the slide line, on its far side.")
TURNED = N_("The place of the point of the body, turned and moved with it.")
FREE = N_(
    "Stated; or free: chosen for the least pressure angle or the best transmission angle, by a grid over the family "
    "and ever finer ones; or the root at which the stated demand is met."
)
FAMILY = N_("The closed formulas of the chapter, at a value of what is free.")
PAIRS = N_("Stated; the precision points by Chebyshev's spacing, the angles linear in x and in y.")
LINEAR = N_("The three linear equations that Freudenstein's equation gives at the three pairs of angles.")
GREATEST = N_("The greatest over the range, by a grid and ever finer ones.")
LEAST = N_("The least over the range, by a grid and ever finer ones.")
TRACED = N_("The place of the point of the coupler, by the positions of the four-bar linkage.")
CIRCLE = N_("The circle through the three places of the point.")
TAKEN = N_("Of the rounded lengths: the extreme positions, or the stated ones, worked out with them.")
MET = N_("Of the analysed mechanism: between its exact extreme positions.")
ROUNDED = N_("The length as it is found; rounded to the stated step.")
CRANK = N_("The directions from the pivot of the crank to the first and the last place of its pin.")
PLACED = N_("By the distances along and across the middle position of the rocker, and its direction.")


def _pin(q: Known, pin: str, row: int = 0) -> tuple[Var, Var]:
    """Place of a pin in a position of a body, the first if no other is named."""
    table = q.book.tables["synthesis_poses"]
    return table.var(f"x_{pin}", row), table.var(f"y_{pin}", row)


def _pivot(q: Known, link: str) -> tuple[Var, Var]:
    return q(f"synthesis_{link}_pivot_x"), q(f"synthesis_{link}_pivot_y")


def _apart(one: tuple[Var, Var], other: tuple[Var, Var]) -> Expr:
    return sqrt((other[0] - one[0]) ** 2 + (other[1] - one[1]) ** 2)


WAYS = (
    Way("synthesis_crank", by=lambda q: _apart(_pivot(q, "crank"), _pin(q, "A"))),
    Way("synthesis_rocker", by=lambda q: _apart(_pivot(q, "rocker"), _pin(q, "B"))),
    Way("synthesis_rod", by=lambda q: _apart(_pin(q, "A"), _pin(q, "B"))),
    Way("synthesis_frame", by=lambda q: _apart(_pivot(q, "crank"), _pivot(q, "rocker"))),
    Way("synthesis_lengths.key", NAME),
    Way("synthesis_lengths.taken", ROUNDED, of="found"),
    Way(
        "synthesis_lengths.found",
        FAMILY,
        of="synthesis_K synthesis_stroke synthesis_swing synthesis_frame synthesis_x_1",
    ),
    Way(
        "synthesis_pairs.x synthesis_pairs.phi", PAIRS, of="synthesis_low synthesis_high synthesis_crank_from"
    ),
    Way("synthesis_pairs.y synthesis_pairs.psi", PAIRS, of="x synthesis_rocker_from synthesis_rocker_turn"),
    Way("synthesis_arc.phi", STATED),
    Way("synthesis_arc.*", TRACED, of="phi synthesis_point_x synthesis_point_y"),
    Way("synthesis_poses.x synthesis_poses.y synthesis_poses.angle", STATED),
    Way("synthesis_poses.*", TURNED, of="x y angle"),
    Way("synthesis_way_A", by=lambda q: _apart(_pin(q, "A"), _pin(q, "A", 1))),
    Way("synthesis_way_B", by=lambda q: _apart(_pin(q, "B"), _pin(q, "B", 1))),
    Way("synthesis_off_B", FREE, of="synthesis_way_B synthesis_off_A"),
    Way("synthesis_solutions.transmission", WAY, of="off_A off_B frame"),
    Way("synthesis_solutions.transmission", SMALLER, of="crank rod frame synthesis_rocker"),
    Way("synthesis_solutions.pressure", PRESSURE, of="crank rod synthesis_offset"),
    Way("synthesis_solutions.off_*", FREE, of="synthesis_way_A synthesis_way_B synthesis_crank"),
    Way(
        "synthesis_solutions.crank",
        FREE,
        of="synthesis_theta synthesis_half_chord synthesis_rocker synthesis_stroke synthesis_ratio synthesis_offset",
    ),
    Way("synthesis_solutions.*", FAMILY, of="synthesis_theta synthesis_rocker crank off_A off_B"),
    Way("synthesis_crank_pivot_* synthesis_rocker_pivot_*", CIRCLE, of="synthesis_crank synthesis_rocker"),
    Way(
        "synthesis_crank_angle synthesis_crank_way",
        CRANK,
        of="synthesis_crank_pivot_x synthesis_crank_pivot_y synthesis_crank",
    ),
    Way("synthesis_family.*", FAMILY, of="synthesis_theta synthesis_stroke synthesis_rocker synthesis_x_1"),
    Way("synthesis_course.x synthesis_course.phi", AXIS),
    Way("synthesis_course.*", FAMILY, of="x synthesis_k1 synthesis_k2 synthesis_k3"),
    Way(
        "synthesis_k1 synthesis_k2 synthesis_k3",
        LINEAR,
        of="synthesis_low synthesis_high synthesis_crank_from",
    ),
    Way("synthesis_error", GREATEST, of="synthesis_k1 synthesis_k2 synthesis_k3"),
    Way("synthesis_transmission", WAY, of="synthesis_turn_A synthesis_off_A synthesis_off_B"),
    Way("synthesis_transmission", LEAST, of="synthesis_k1 synthesis_k2 synthesis_k3"),
    Way("synthesis_transmission", SMALLER, of="synthesis_mu_inner synthesis_mu_outer"),
    Way(
        "synthesis_centre_x synthesis_centre_y synthesis_radius synthesis_guide_angle",
        CIRCLE,
        of="synthesis_point_x synthesis_point_y synthesis_crank synthesis_rod",
    ),
    Way(
        "synthesis_stroke_met synthesis_swing_met synthesis_K_met", MET, of="synthesis_stroke synthesis_swing"
    ),
    Way("synthesis_pressure_met synthesis_transmission_met", LEAST, of="synthesis_stroke synthesis_swing"),
    Way("synthesis_*_taken synthesis_misfit", TAKEN, of="synthesis_crank synthesis_rod synthesis_frame"),
    Way("synthesis_frame_x synthesis_frame_y", PLACED, of="synthesis_along synthesis_away synthesis_rise"),
    Way("synthesis_ratio", FREE, of="synthesis_theta synthesis_stroke"),
    Way("synthesis_crank", FREE, of="synthesis_theta synthesis_half_chord synthesis_stroke synthesis_ratio"),
    Way("synthesis_rocker", FREE, of="synthesis_phi_1 synthesis_psi_1"),
    Way("synthesis_offset", FREE, of="synthesis_x_1 synthesis_phi_1"),
    Way(
        "synthesis_pressure synthesis_transmission", LEAST, of="synthesis_crank synthesis_rod synthesis_phi_1"
    ),
    Way("synthesis_frame", FREE, of="synthesis_rocker synthesis_psi_1"),
    Way("synthesis_frame", FREE, of="synthesis_half_chord synthesis_rocker"),
    Way("synthesis_*", STATED),
)

"""How the numbers of kinematics are found that the formulas of the note do not define, or only approach."""

from __future__ import annotations

from tmm_report.chapters.lever.kinematics.solve.positions import STILL
from tmm_report.chapters.lever.kinematics.solve.relating import place, rate
from tmm_report.problems import N_
from tmm_report.quantity.formula import PI, Expr, Var
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.ways import NAME, Known, Way

CONTOURS = N_("Found from the closed vector loops of the groups, group by group in the order of assembly.")
RATES = N_(
    "Found analytically: the loops of the groups, differentiated with respect to time once for the velocities "
    "and twice for the accelerations, are linear equations. On a rigid link the motion of a point follows from "
    "that of another:"
)
NEAR = N_(
    "The determinant of the group's equations by the lengths of their rows: 1 far from a "
    "singular position, 0 in it."
)
DIGITS = N_("Of the 16 digits of a number those that the closeness to the singular position leaves.")
SPECIAL = N_(
    "Sought over the whole cycle between the diagram positions: where the determinant of the "
    "group is least or zero, or "
    "where the output's connecting link is in line."
)
OUTPUT = N_("The coordinate of the output less that in position 0.")
PSI = N_("The angle of the link less that in position 0, followed without jumps of a turn.")
TURNS = N_("The rate of the link that it turns with.")
INSTANT = N_("The instant that the variant asks for, by the angle turned or by the time.")
AT = N_("As at the positions of the table, at the instant that the variant asks for.")
LAW = N_("The law of the driving link at this time.")
STROKE = N_("The law of the stroke at this time.")
TRIANGLE = N_("From the places of the points of the triangle at this stroke.")
VECTOR = N_(
    "From the places of the ends of the stroke, and from their velocities and accelerations where the link that is "
    "found first turns at 1 rad/s."
)
POSITION_FUNCTION = N_("Derivative of the stroke with respect to the angle of the link that is found first.")
SIDES = N_("By the places of the points in their links, and of the guide, as the variant states them.")
ZERO = N_("Stated, or the angle at which the output that is named is in its extreme position.")
STROKES = N_(
    "From one extreme position of the output to the other; both are sought between the "
    "positions of the table."
)
EXTREME = N_("Over the whole cycle, sought where the derivative is zero and at both sides of a jump.")
CHOSEN = N_("Measured against the closed form over the cycle.")
TERMS = N_("From the projections of the group's loops, by their derivatives at the angles of this position.")
BY_SIZES = N_("Of the lengths and places that the variant states; it is the same in every position.")


def _stroke(q: Known) -> Expr:
    return q("S_{0}_max", "max") - q("S_{0}_min", "min")


def _ratio(q: Known) -> Expr:
    """The longer of both angles between the extreme positions by the shorter."""
    far, near = q.at("S_{0}_max", "S,max"), q.at("S_{0}_min", "S,min")
    turn = Var(Symbol("Phi"), float(q.found.cycle.sweep), "deg")
    there = abs(far - near)
    other = turn - there
    return there / other if there.value > other.value else other / there


def _analogue(q: Known, rate: str, power: int) -> Expr:
    """By the rate and the driving link's; of one that moves by a law, where it stands still there is no such way."""
    if not q.has("law_time"):
        omega = abs(q("omega"))
        return q(rate) / (omega if power == 1 else omega**2)
    driver = q.found.linkage.mechanism.driver
    own, epsilon = (q(f"rates_table.{letter}_{driver.link}") for letter in "we")
    if abs(own.number) <= STILL * driver.law.fastest:
        raise KeyError(rate)
    first = q(rate.replace(".A_", ".V_").replace(".epsilon_", ".omega_")) / own
    return first if power == 1 else (q(rate) - first * epsilon) / own**2


def _time(q: Known) -> Expr:
    if q.has("law_time"):
        return q("phi") / (2 * PI) * q("law_time")
    return q("phi") / abs(q("omega"))


def _shift(q: Known) -> Expr:
    """S of a slider along its guide, by its places here and in position 0."""
    travel = next(one for one in (*q.found.travels, *q.found.links) if one.output.name == q.parts[0])
    motion = q.found.diagram if q.fine else q.found.table
    at = travel.output.coordinate(motion)
    return Var(Symbol("s", q.parts[0]), at[q.row], "m") - Var(Symbol("s", f"{q.parts[0]},0"), at[0], "m")


WAYS = (
    Way("method.error method.accuracy", CHOSEN, of="method kind"),
    Way("contours.*", TERMS, of="positions_table.phi_* phi contours.det_*"),
    Way("contour_constants.value", BY_SIZES, of="key"),
    Way("contour_constants.*", NAME),
    Way("method.* special.kind special.of", NAME),
    Way("special.*", SPECIAL, of="kind of closeness phi_0"),
    Way("positions_table.sin_*", NEAR, of="contours.det_{0} phi"),
    Way("positions_table.digits_*", DIGITS, of="sin_{0}"),
    Way("positions_table.x_* positions_table.y_*", CONTOURS, worked=place),
    Way("positions_table.x_* positions_table.y_*", CONTOURS, of="phi phi_1"),
    Way("positions_table.phi_*", CONTOURS, of="phi phi_1"),
    Way("rates_table.*", RATES, worked=rate, of="phi omega law_*", beside=True),
    Way("outputs_table.t analogues_table.t", by=_time),
    Way("outputs_at.phi positions_at.phi rates_at.phi", INSTANT, of="t"),
    Way("outputs_at.t positions_at.t rates_at.t", INSTANT, of="phi"),
    Way("outputs_at.* positions_at.* rates_at.*", AT, of="phi t"),
    Way("outputs_table.phi_law", LAW, of="law_* t"),
    Way("outputs_table.S_*", by=_shift),
    Way("outputs_table.psi_*", PSI, of="positions_table.phi_{0}"),
    Way("outputs_table.omega_* outputs_table.epsilon_*", TURNS, of="rates_table.w_* rates_table.e_*"),
    Way("outputs_table.V_* outputs_table.A_*", OUTPUT, of="S_{0}"),
    Way("analogues_table.dS_*", by=lambda q: _analogue(q, "outputs_table.V_{0}", 1)),
    Way("analogues_table.ddS_*", by=lambda q: _analogue(q, "outputs_table.A_{0}", 2)),
    Way("analogues_table.dpsi_*", by=lambda q: _analogue(q, "outputs_table.omega_{0}", 1)),
    Way("analogues_table.ddpsi_*", by=lambda q: _analogue(q, "outputs_table.epsilon_{0}", 2)),
    Way("stroke_table.stroke stroke_table.stroke_v stroke_table.stroke_a", STROKE, of="law_* t"),
    Way("stroke_table.stroke_d*_*", VECTOR, of="stroke phi_law"),
    Way("stroke_table.stroke_s*", POSITION_FUNCTION, of="stroke stroke_gamma stroke_d*_*"),
    Way("stroke_table.stroke_transfer", by=lambda q: 1 / q("stroke_table.stroke_s1")),
    Way("stroke_table.*", TRIANGLE, of="stroke stroke_v stroke_arm stroke_rod"),
    Way("stroke_at.phi", INSTANT, of="t"),
    Way("stroke_at.t", INSTANT, of="phi"),
    Way("stroke_at.*", AT, of="phi t"),
    Way("stroke_arm stroke_rod stroke_gamma stroke_lag", SIDES, of="law_stroke law_time"),
    Way("H_*", STROKES, by=_stroke),
    Way("K_*", STROKES, by=_ratio),
    Way("S_*_* V_*_* A_*_*", EXTREME, of="omega law_time"),
    Way("phi_0", ZERO, of="omega H_* law_angle"),
)

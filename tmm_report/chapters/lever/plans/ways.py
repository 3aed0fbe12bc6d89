"""How the numbers of the plans are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, expr
from tmm_report.quantity.ways import NAME, STATED, Known, Way

SEGMENT = N_("Measured in the polygon, to the accuracy of the drawing.")
READ = N_("Found by the polygon: the measured segment times the scale of the polygon.")
ROUND = N_(
    "Chosen so that the largest vector fits the paper, from the usual scales, where the variant "
    "states no segment."
)
LINEAR = N_("By the drawing: the projections of the vectors of the contour of the row.")
SOLVED = N_("The equations of the rows above are solved together; the last row is their solution.")
SENSE = N_("Seen in the polygon: the vector, moved to the point, turns the link so.")
ANALYTIC = N_("The value of the analytical method at the position: of a vector its size.")
LARGEST = N_(
    "The largest of the differences in the tables that compare the methods, of those that can be read off."
)


def differ(q: Known) -> Expr:
    """In per cent of the mean of both."""
    graph, analytic = q("graph"), q("analytic")
    if graph.number * analytic.number < 0:
        raise KeyError("the signs differ")
    return 200 * (graph - analytic) / (graph + analytic)


def _analytic(q: Known) -> Expr:
    """An angular rate as it is, of a vector its size."""
    return expr(q.there("rates_table", q.own_text("key"), int(q.parts[0])))


WAYS = (
    Way("*.key *.unit senses_*.link senses_*.to senses_*.like senses_*.vector equations_*.contour", NAME),
    Way("senses_*.sense", SENSE, of="link vector to like"),
    Way("comparison_*.delta", by=differ),
    Way(
        "comparison_*.delta",
        N_("Twice the difference by the sum of both; 200 where the signs differ."),
        of="graph analytic",
    ),
    Way("comparison_*.graph", READ, of="key mu_v mu_a"),
    Way("comparison_*.analytic", ANALYTIC, of="key", by=_analytic),
    Way("segments_*.*", SEGMENT, of="accuracy"),
    Way("plan_values_v.*", READ, of="mu_v"),
    Way("plan_values_a.*", READ, of="mu_a"),
    Way("equations_*.*", LINEAR, of="contour right"),
    Way("mu_v", ROUND, of="chosen_* largest_v_*"),
    Way("mu_a", ROUND, of="chosen_* largest_a_*"),
    Way("mu_v mu_a", ROUND, of="accuracy"),
    Way("chosen_*", STATED),
    Way("largest_*", N_("The largest of its sizes at the positions of the polygons."), of="mu_v mu_a"),
    Way("accuracy", STATED),
    Way("delta_max", LARGEST, of="accuracy"),
)

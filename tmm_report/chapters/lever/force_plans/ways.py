"""How the numbers of the force plans are found that no formula of the note defines."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.kinetostatics.quantities.positions import ALONG_STROKE, BALANCING_MOMENT
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.ways import NAME, Known, Line, Way

ARM = N_("Measured on the scheme drawn to scale: from the point to the line of the force.")
LEVER_ARM = N_("Measured on the velocity polygon turned by 90°: from the pole to the line of the force.")
GRAPH = N_("Read off the force polygon: the length of the vector by the scale of the polygon.")
ANALYTIC = N_("The value of the analytical method at the position.")
ONE_FORCE = N_(
    "The inertia force and couple of the link put together to one force: h = M/F; it passes "
    "through the centre of percussion."
)
BY_OTHER = N_("The balancing moment by the other way, as the name says: by the reactions, or by the powers.")
FORCE_BY_OTHER = N_(
    "The balancing force along the stroke by the other way, as the name says: by the reactions, or by the powers."
)
WRITTEN = N_("The load at the position as it is written by hand, with five digits.")
TWICE = N_("Twice the difference by the sum of both; 200 where the signs differ.")
LARGEST = N_(
    "The largest of the differences in the tables that compare the methods, of those that can be read off."
)


def _differ(q: Known) -> Expr:
    """In per cent of the mean of both."""
    graph, analytic = q("graph"), q("analytic")
    if graph.number * analytic.number < 0:
        raise KeyError("the signs differ")
    return 200 * (graph - analytic) / (graph + analytic)


def _analytic(found: object, q: Known) -> Iterator[Line]:
    """The number of the analytical tables, where the reaction does not go by its other link."""
    name, position = q.own_text("key"), int(q.parts[0])
    tables = {BALANCING_MOMENT.key: "balancing_table", ALONG_STROKE.key: "drive_table"}
    return q.shown(tables.get(name, "reactions_table"), name, position)


def _of_link(key: str):  # type: ignore[no-untyped-def]
    return lambda found, q: q.shown("loads_table", key + q.own_text("link"), int(q.parts[0]))


WAYS = (
    Way("*.key *.unit *.force *.about *.point *.way reduced_*.link", NAME),
    Way("arms_*.arm", ARM, of="force about arm_mm mu_l"),
    Way("arms_*.arm_mm", ARM, of="force about accuracy"),
    Way("force_comparison_*.delta", TWICE, by=_differ, of="graph analytic"),
    Way("force_comparison_*.graph", GRAPH, of="key accuracy"),
    Way("force_comparison_*.analytic", ANALYTIC, worked=_analytic, of="key graph"),
    Way("reduced_*.F_I", WRITTEN, worked=_of_link("F_I")),
    Way("reduced_*.M_I", WRITTEN, worked=_of_link("M_I")),
    Way("reduced_*.h", by=lambda q: abs(q("M_I")) / q("F_I")),
    Way("reduced_*.*", ONE_FORCE, of="link"),
    Way("lever_arms_*.arm_mm", LEVER_ARM, of="force point accuracy"),
    Way(
        "lever_arms_*.moment",
        N_("The size of the force by its arm; above zero where it turns counter-clockwise."),
        of="size arm_mm",
    ),
    Way(
        "lever_arms_*.size",
        N_("The load at the position, of a couple one force of the pair that replaces it."),
        of="force",
    ),
    Way("lever_compared_*.moment", BY_OTHER, of="way"),
    Way("lever_compared_*.force", FORCE_BY_OTHER, of="way"),
    Way("lever_compared_*.delta", TWICE, of="way"),
    Way("delta_F_max", LARGEST, of="accuracy"),
)

"""By what method the numbers of the kinematics were found, and how far they may err."""

from __future__ import annotations

from markupsafe import Markup

from tmm_report.chapters.lever.kinematics.solve.method import own
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.mechanics.rivals.choice import Choice
from tmm_report.problems import N_
from tmm_report.quantity.model import Table
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell
from tmm_report.report.part import Failed
from tmm_report.report.words import method_name

ASKED = N_(
    "The positions, velocities and accelerations of the tables and diagrams are found by the method that the task "
    "names: %(method)s."
)
TAKEN = N_(
    "The positions, velocities and accelerations of the tables and diagrams are found by the cheapest method that "
    "holds the relative error %(accuracy)s: %(method)s."
)
ERRORS = N_(
    "By the largest value of each quantity the places of points differ from the closed form by %(place)s at most, "
    "their velocities by %(velocity)s, their accelerations by %(acceleration)s; checks of two ways against each other "
    "are judged by that."
)

WRITTEN_OUT = N_(
    "The formulas that are written out below are those of the closed form; the numbers of the tables and diagrams "
    "differ from their results by no more than these errors."
)
MISSED = N_(
    "The method by which the motion is found, %(method)s, errs by %(worst)s of the largest value, while the numbers "
    "are to hold %(accuracy)s: the solution must not be used."
)


def said(found: Kinematics, table: Table, page: Page) -> list[Markup]:
    """In sentences; nothing where the variant states no method."""
    choice = found.choice
    if choice is None:
        return []
    text = ASKED if choice.asked else TAKEN
    accuracy = page.shown(table, "accuracy", 0, digits=2, scale=0)
    lines = [page.t(text, method=named(choice, table, page), accuracy=accuracy)]
    if not own(choice):
        errors = {
            kind: page.shown(table, "error", row, digits=1, scale=0)
            for row, kind in enumerate(table["kind"].values)
        }
        lines += [page.t(ERRORS, **errors), page.t(WRITTEN_OUT)]
    return lines


def named(choice: Choice, table: Table, page: Page) -> Markup:
    """The method in words, with what its error depends on."""
    name = method_name(choice.taken, page.tr)
    return page.said(Cell(name, table.ref("method", 0)))


def failed(found: Kinematics, table: Table, page: Page) -> Failed:
    """In the conclusions: the method does not hold what is asked of it."""
    assert found.choice is not None
    errors = list(table["error"].values)
    worst = page.shown(table, "error", errors.index(max(errors)), digits=1, scale=0)
    accuracy = page.shown(table, "accuracy", 0, digits=2, scale=0)
    return Failed(page.t(MISSED, method=named(found.choice, table, page), worst=worst, accuracy=accuracy))

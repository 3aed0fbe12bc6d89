"""What the comparison of methods says: on the terminal, and as a page with charts."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

from markupsafe import Markup

from tmm_report.commands.methods.measured import SIZED, All, Measured
from tmm_report.course import Results, room
from tmm_report.figures.charts.logs import Series, loglog
from tmm_report.figures.drawing import Drawing
from tmm_report.i18n import NP_, Translator
from tmm_report.mechanics.rivals.model import Method, Trial
from tmm_report.mechanics.rivals.trials import by_method, worst
from tmm_report.problems import N_, Message
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.text import number, unit_text
from tmm_report.report.diagrams import letter
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.report.paper.layout import DASH, Table, worded
from tmm_report.report.words import method_name
from tmm_report.resources import data_root

KINDS = {
    "place": N_("places"),
    "velocity": N_("velocities"),
    "acceleration": N_("accelerations"),
    "reaction": N_("reactions"),
    "moment": N_("balancing moment"),
    "work": N_("work"),
    "angle": N_("angle"),
    "speed": N_("speed at the end"),
}
CHARTS = {
    "place": N_("Error of the places against the time of the calculation"),
    "velocity": N_("Error of the velocities against the time of the calculation"),
    "acceleration": N_("Error of the accelerations against the time of the calculation"),
    "reaction": N_("Error of the reactions against the time of the calculation"),
    "moment": N_("Error of the balancing moment against the time of the calculation"),
    "work": N_("Error of the work against the time of the calculation"),
    "angle": N_("Error of the angle against the time of the calculation"),
    "speed": N_("Error of the speed at the end against the time of the calculation"),
}
ADMITTED = Symbol("epsilon", NP_("index", "adm"))
LEAST = 1e-17  # what an error of nothing is drawn as
LOSES, BROKE = N_("finds nothing at some positions"), N_("breaks down: %(what)s")


class MethodsPage:
    """The words, tables and charts of the page."""

    def __init__(self, found: All, page: Page):
        self.found, self.page, self.t = found, page, page.t

    def name(self, method: Method[Any, Any]) -> str:
        return method_name(method, self.page.tr)

    def size(self, family: Measured) -> str:
        """What the counts of a family are."""
        return self.t(N_("Positions")) if family.key in SIZED else self.t(N_("Size of the task"))

    def table(self, family: Measured, caption: Any) -> Table:
        kinds = [self.t(N_("Error: %(what)s"), what=self.t(KINDS[kind])) for kind in family.kinds]
        heads = [
            self.t(N_("Method")),
            self.size(family),
            self.t(N_("Time, ms")),
            *kinds,
            self.t(N_("Remark")),
        ]
        rows = [
            [
                self.name(one.method) if first else "",
                counted(family, one),
                self.page.num(1e3 * one.seconds, digits=3),
                *(self._error(one, kind) for kind in family.kinds),
                self._remark(family, k),
            ]
            for k, (one, first) in enumerate(_led(family.rows))
        ]
        return worded(caption, heads, rows, (6, 2, 2, *(2 for _ in kinds), 3))

    def _error(self, one: Trial, kind: str) -> str:
        error = one.errors.get(kind, math.nan)
        return self.page.num(error, digits=1, scale=0) if error > 0 or error != error else "0"

    def _remark(self, family: Measured, row: int) -> Markup | str:
        one = family.rows[row]
        if one.broken is not None:
            return self.t(BROKE, what=one.broken)
        if any(error != error for error in one.errors.values()):
            return self.t(LOSES)
        return self.t(N_("none is both quicker and more accurate")) if row in family.front else DASH

    def refused(self, family: Measured) -> list[Markup]:
        return [
            self.t(N_("%(method)s: %(why)s"), method=self.name(method), why=self.page.message(why))
            for method, why in family.refused
        ]

    def charts(self, family: Measured) -> Iterator[tuple[Drawing, Markup]]:
        """A chart for each kind of quantity, with its caption."""
        for kind in family.kinds:
            yield self._chart(family, kind), self.t(CHARTS[kind])

    def _chart(self, family: Measured, kind: str) -> Drawing:
        series = []
        for own in by_method(family.rows):
            points = [complex(1e3 * one.seconds, max(LEAST, one.errors.get(kind, math.nan))) for one in own]
            front = [k for k, one in enumerate(own) if _first(family.rows, one) in family.front]
            series.append(Series(points, (self.name(own[0].method),), tuple(front)))
        tr = self.page.tr
        time = (*letter("t", tr), f", {self.page.unit('ms')}")
        error = letter("epsilon", tr)
        admitted = letter(ADMITTED, tr)
        return loglog(series, time, error, level=family.accuracy, named=admitted)

    def sentence(self, family: Measured) -> Markup:
        return self.page.message(cheapest_of(family, self.page.tr))


def _led(trials: Sequence[Trial]) -> Iterator[tuple[Trial, bool]]:
    """Every trial, and whether it is the first of its method."""
    before = ""
    for one in trials:
        yield one, one.method.key != before
        before = one.method.key


def _first(trials: Sequence[Trial], one: Trial) -> int:
    return next(k for k, other in enumerate(trials) if other is one)


def counted(family: Measured, one: Trial) -> str:
    """The size of a row's task: 12, or 12 + 36 where it is several together; a dash where the method takes its own."""
    return " + ".join(map(str, family.counts(one))) or "—"


def cheapest_of(family: Measured, tr: Translator) -> Message:
    """What is chosen of a family by the measured times."""
    asked = {"accuracy": number(family.accuracy, 2, tr.decimal, scale=0)}
    if family.best is None:
        return Message(N_("No method holds the relative error %(accuracy)s."), asked)
    return Message(
        N_(
            "The cheapest that holds the relative error %(accuracy)s: %(method)s, %(time)s ms, its error is %(error)s."
        ),
        {
            **asked,
            "method": method_name(family.best.method, tr),
            "time": number(1e3 * family.best.seconds, 3, tr.decimal),
            "error": number(worst(family.best.errors), 1, tr.decimal, scale=0),
        },
    )


def of_auto(found: All, tr: Translator) -> Message | None:
    """What `method: auto` takes, and whether it is what was measured here."""
    motion = found.motion
    if motion is None or found.auto is None:
        return None
    taken = next(one.method for one in motion.trials if one.method.key == found.auto)
    values = {"method": method_name(taken, tr)}
    if motion.best is not None and motion.best.method.key == found.auto:
        return Message(N_("The key method: auto takes the same by its table of costs: %(method)s."), values)
    text = N_(
        "The key method: auto takes another by its table of costs, which is the same on all machines: %(method)s."
    )
    return Message(text, values)


def lines(family: Measured, tr: Translator) -> Iterator[str]:
    """The table of a family on the terminal."""
    kinds = [tr.gettext(KINDS[kind]) for kind in family.kinds]
    wide = max(len(method_name(one.method, tr)) for one in family.trials)
    yield f"  {'':{wide}} {'':>7} {unit_text('ms', tr.language):>9}  " + "  ".join(
        f"{kind:>9}" for kind in kinds
    )
    for k, one in enumerate(family.rows):
        errors = [one.errors.get(kind, math.nan) for kind in family.kinds]
        cells = [
            f"{'—' if error != error else f'{error:.0e}':>{max(9, len(kind))}}"
            for error, kind in zip(errors, kinds, strict=True)
        ]
        mark = "*" if k in family.front else " "
        who = (
            f"{mark} {method_name(one.method, tr):{wide}} {counted(family, one):>7} {1e3 * one.seconds:>9.3f}"
        )
        yield "  ".join([who, *cells])


def page(found: All, results: Results, tr: Translator) -> dict[str, bytes]:
    """The page by its name, `methods.html`."""
    form = Page(Html(), tr, Numbering())
    functions = ("t", "math", "sym", "value", "num", "unit", "listed")
    given: dict[str, Any] = {
        "page": form,
        "title": results.variant.title,
        **{name: getattr(form, name) for name in functions},
    }
    given["m"] = template("macros.html.j2").make_module(dict(given))
    root = data_root() / "templates"
    auto = of_auto(found, tr)
    text = template("methods.html.j2").render(
        given,
        view=MethodsPage(found, form),
        found=found,
        auto=form.message(auto) if auto else None,
        counts=partial(_counts, found, results, form, given),
        style=Markup((root / "style.css").read_text("utf-8")),
    )
    return {"methods.html": form.numbering.resolved(text).encode()}


def _counts(found: All, results: Results, form: Page, given: dict[str, Any]) -> Markup | None:
    """How many positions are enough, as the note says it; None without a lever mechanism."""
    if found.counted is None or results.lever is None:
        return None
    asked = room("methods", "given").Comparison(found.accuracy)
    chapter = room("methods", "solve").Found(
        asked, results.lever.kinematics, found.accuracy, {}, found.counted
    )
    view = room("methods", "view").MethodsView(chapter, form)
    return Markup(template("chapters/lever/methods/counts.j2").render(given, view=view))

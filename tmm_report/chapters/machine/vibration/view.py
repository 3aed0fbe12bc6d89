"""View of vibration and its isolation."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.vibration.draw import scheme
from tmm_report.chapters.machine.vibration.equations import equation, solution
from tmm_report.chapters.machine.vibration.quantities import tables
from tmm_report.chapters.machine.vibration.solve import WORKING, Found, ratio_key
from tmm_report.chapters.machine.vibration.values import BASE
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.written import Equation
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import Line, chart, cycle_chart
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric, worded
from tmm_report.report.part import Part

HIGHEST = 6.0  # of a drawn magnification factor: a resonance without damping goes on to infinity
KINDS = {
    "tuned": N_("tuned, without damping"),
    "best": N_("with the best damping"),
    "lanchester": N_("damper without a spring"),
}


def parts(found: Found, page: Page) -> Iterator[Part]:
    view = VibrationView(found, page)
    if found.given.free:
        yield Part("machine/vibration/free", view)
        return
    yield Part("machine/vibration", view)
    if found.stood is not None or found.given.friction is not None or found.absorbed is not None:
        yield Part("machine/vibration/measures", view, concludes=False)


def picture(found: Found, page: Page) -> Drawing:
    """The machine on its isolators, for a list of many."""
    return scheme(found, page.tr.in_index(BASE))


class VibrationView(ChapterView):
    own = True  # ω is explained again where a crank had another

    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, tables(found))
        self.found, self.given = found, found.given

    def conclusions(self) -> Sequence[Markup]:
        if self.given.free or self.found.unbounded:
            return self._concluded()
        text = N_(
            "The machine on its isolators moves with the amplitude %(amplitude)s at %(eta)s times its natural "
            "frequency; the transmissibility is %(ratio)s."
        )
        if self.given.turning:
            text = N_(
                "The disc on its shaft oscillates with the amplitude %(amplitude)s at %(eta)s times its natural "
                "frequency; the transmissibility is %(ratio)s."
            )
        if self.given.base is not None:
            text = N_(
                "The machine on its isolators moves with the amplitude %(amplitude)s at %(eta)s times its natural "
                "frequency, which is %(ratio)s times that of the base."
            )
        told = {
            "amplitude": self.measured("amplitude"),
            "eta": self.number("eta"),
            "ratio": self.number(ratio_key(self.given)),
        }
        if self.found.shaking is not None:  # of its harmonics all together: the amplitude is that of one
            text = N_(
                "Shaken by its mechanism, the machine on its isolators moves by up to %(moved)s and transmits a "
                "force of up to %(base)s to the base."
            )
            told = {"moved": self.measured("moved_most"), "base": self.measured("handed_most")}
        said = [self.t(text, **told)]
        if self.s.has_formula("stiffness_each") and self.given.stiffness is None and not self.given.turning:
            text = N_("One isolator has the stiffness %(stiffness)s.")
            said.append(self.t(text, stiffness=self.measured("stiffness_each")))
        if self.found.absorbed is not None and not self.given.turning:
            text = N_(
                "A dynamic vibration absorber of %(mass)s on springs of %(stiffness)s would bring the machine to "
                "rest at the frequency of the force; it would itself oscillate with the amplitude %(swing)s."
            )
            keys = {"mass": "absorber", "stiffness": "absorber_stiffness", "swing": "absorber_swing"}
            said.append(self.t(text, **{name: self.measured(key) for name, key in keys.items()}))
        return [self.page.listed(said, " ")]

    def _concluded(self) -> Sequence[Markup]:
        """Of a free vibration; of a resonance whose amplitude something else bounds."""
        natural = self.number("natural")
        if self.found.unbounded:
            text = N_(
                "Alone the machine is in resonance without damping at %(natural)s rad/s, and its amplitude has no "
                "bound."
            )
            lines = [self.t(text, natural=natural)]
            if self.found.absorbed is not None:
                lines.append(self.t(N_("With the tuned absorber it stands still at this frequency.")))
            return lines
        if "decrement" not in self.s:
            return [self.t(N_("The natural frequency of the machine is %(natural)s rad/s."), natural=natural)]
        text = N_(
            "The natural frequency of the machine is %(natural)s rad/s; its free vibration dies away with the "
            "logarithmic decrement %(decrement)s."
        )
        return [self.t(text, natural=natural, decrement=self.number("decrement"))]

    # --- words

    @property
    def works(self) -> bool:
        """Whether the frequency lies in the range of well isolated machines."""
        return WORKING[0] <= self.found.eta <= WORKING[1]

    @property
    def steep(self) -> bool:
        """Whether the machine moves more than its base."""
        return self.s.number("gamma") > 1

    def given_values(self) -> Markup:
        return self.listed(self._stated)

    def explained_given(self) -> list[dict[str, Any]]:
        return self.explained(*self._stated)

    @cached_property
    def _stated(self) -> list[str]:
        """What the variant states, in the order of the model."""
        given, stand, hung = self.given, self.given.foundation, self.given.absorber
        several = given.isolators > 1
        stated = {
            "inertia": True,
            "isolators": several,
            "stiffness_each" if several else "stiffness": given.stiffness is not None,
            "deflection": True,
            "damping_each" if several else "damping": given.damping is not None,
            "zeta": given.damping_ratio is not None,
            "force": given.shaken is not None,
            "unbalance": True,
            "radius": True,
            "base": True,
            "direction": True,
            "omega": given.speed is not None,
            "wanted": True,
            "friction": True,
            "base_inertia": True,
            "base_stiffness": True,
            "base_damping": stand is not None and stand.damping > 0,
            "absorber": hung is not None and hung.inertia is not None,
            "absorber_springs": hung is not None and hung.springs > 1,
            "absorber_arm": True,
            "place": given.start.place != 0,
            "speed": given.start.rate != 0,
        }
        return [key for key, is_so in stated.items() if is_so]

    def equation(self) -> Equation:
        return equation(self.found)

    def equation_explained(self) -> list[dict[str, Any]]:
        """The displacement, and what the isolators have."""
        x = self.found.s.declared("x")
        return [
            self.page.explained("x", x.column(()), x.quantity.unit),
            *self.explained("damping", "stiffness"),
        ]

    def solution(self) -> Definition:
        return solution(self.found)

    # --- tables

    def response(self, caption: Any) -> Table:
        leave = ("beta", "lag", "omega") if self.given.base is not None else ("omega",)
        first, *others = self.columns("response", leave=leave)
        return numeric(caption, first, [self.column("response", "omega", "rpm"), *others])

    def harmonics(self, caption: Any) -> Table:
        first, *others = self.columns("harmonics", leave=("order", "omega"))
        leads = [self.column("harmonics", "omega", "rpm"), first, *others]
        return numeric(caption, self.column("harmonics", "order", digits=1), leads)

    def dampings(self, caption: Any) -> Table:
        leave = ("beta_peak", "eta_peak", "beta") if self.given.base is not None else ()
        return self.numeric(caption, "dampings", leave=leave)

    def swings(self, caption: Any) -> Table:
        return self.numeric(caption, "swings", digits=1)

    def absorbers(self, caption: Any) -> Table:
        table, page = self.table("absorbers"), self.page
        numbers = table.columns[1:]
        heads = [page.t("Absorber"), *(page.head(one.symbol(), one.quantity.printed) for one in numbers)]
        rows = [
            [
                page.word(self.t(KINDS[kind]), table, "kind", row),
                *(page.cell(table, one.key, row, digits=4) for one in numbers),
            ]
            for row, kind in enumerate(table["kind"].values)
        ]
        return worded(caption, heads, rows, (5, *(2 for _ in numbers)))

    # --- figures

    @cached_property
    def scheme(self) -> Drawing:
        return picture(self.found, self.page)

    @cached_property
    def curves(self) -> Graph:
        """Magnification factor, lag and transmissibility against ω/ω0, by damping ratio."""
        ratio = ratio_key(self.given)
        of = ["ratio"] if self.given.base is not None else ["beta", "lag", "ratio"]
        lines = [
            Line(
                self.of("curves", f"{key}_{k}"),
                f"ζ = {self.page.num(zeta, 3)}" if not panel else "",
                panel,
                most=math.inf if key == "lag" else HIGHEST,
            )
            for panel, key in enumerate(of)
            for k, zeta in enumerate(self.given.curves, 1)
        ]
        panels = [self.s.quantity(ratio if key == "ratio" else key) for key in of]
        return chart(lines, self.of("curves", "eta"), panels, self.page.tr)

    @cached_property
    def motion(self) -> Graph:
        """The motion from the start and its steady part."""
        lines = [Line(self.of("motion", "x"), str(self.t("motion")))]
        if not self.given.free:
            lines.append(Line(self.of("motion", "x_steady"), str(self.t("steady part"))))
        return chart(lines, self.of("motion", "t"), [lines[0].column.quantity], self.page.tr)

    @cached_property
    def turn(self) -> Graph:
        """Shaking force, motion and force on the base over a turn."""
        return cycle_chart(self.table("turn"), ("force", "x", "on_base"), self.page.tr)

    @cached_property
    def absorbed(self) -> Graph:
        """Magnification factor with each absorber."""
        names = {"beta": self.t("without an absorber")}
        names |= {f"beta_{k}": self.t(text) for k, text in enumerate(KINDS.values(), 1)}
        lines = [Line(self.of("absorbed", key), str(name), most=HIGHEST) for key, name in names.items()]
        return chart(lines, self.of("absorbed", "eta"), [self.s.quantity("beta")], self.page.tr)

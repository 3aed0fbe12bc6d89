"""View of vibration and its isolation."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.vibration.draw import scheme
from tmm_report.chapters.machine.vibration.formulas import VibrationFormulas
from tmm_report.chapters.machine.vibration.quantities import ratio
from tmm_report.chapters.machine.vibration.solve import WORKING, Found
from tmm_report.chapters.machine.vibration.values import BASE, quantity
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs, plot
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, Words, numeric, worded
from tmm_report.report.part import Part

HIGHEST = 6.0  # of a drawn dynamic coefficient: a resonance without damping goes on to infinity
KINDS = {
    "tuned": N_("tuned, without damping"),
    "best": N_("with the best damping"),
    "lanchester": N_("damper without a spring"),
}
PRINT = {"m": "mm", "rad": "deg"}  # a displacement as it is printed


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
    return scheme(found, page.tr.pgettext("index", BASE))


class VibrationView(VibrationFormulas):
    def __init__(self, found: Found, page: Page):
        super().__init__(found)
        self.page, self.t = page, page.t

    def conclusions(self) -> Sequence[Markup]:
        if self.given.free or self.found.unbounded:
            return self._concluded()
        text = N_(
            "The machine on its isolators moves with the amplitude %(amplitude)s at %(eta)s of its natural frequency; "
            "the force ratio is %(ratio)s."
        )
        if self.given.turning:
            text = N_(
                "The disc on its shaft swings with the amplitude %(amplitude)s at %(eta)s of its natural frequency; "
                "the force ratio is %(ratio)s."
            )
        if self.given.base is not None:
            text = N_(
                "The machine on its isolators moves with the amplitude %(amplitude)s at %(eta)s of its natural "
                "frequency, which is %(ratio)s of that of the base."
            )
        moved = self.number("amplitude", self.printed, digits=4)
        unit = self.page.unit(self.printed)
        amplitude = self.page.listed([moved, unit], "" if unit == "°" else " ")
        values = {"eta": self.number("eta", digits=4), "ratio": self.number(ratio(self.found), digits=3)}
        return [self.t(text, amplitude=amplitude, **values)]

    def _concluded(self) -> Sequence[Markup]:
        """Of a free vibration; of a resonance whose amplitude something else bounds."""
        natural = self.number("natural", digits=4)
        if self.found.unbounded:
            text = N_(
                "Alone the machine is in resonance without damping at %(natural)s rad/s, and its amplitude has no "
                "bound."
            )
            lines = [self.t(text, natural=natural)]
            if self.found.absorbed is not None:
                lines.append(self.t(N_("With the tuned absorber it stands still at this frequency.")))
            return lines
        if self.found.decrement is None:
            return [self.t(N_("The natural frequency of the machine is %(natural)s rad/s."), natural=natural)]
        text = N_(
            "The natural frequency of the machine is %(natural)s rad/s; its free vibration dies away with the "
            "logarithmic decrement %(decrement)s."
        )
        return [self.t(text, natural=natural, decrement=self.number("decrement", digits=4))]

    # --- words

    @property
    def printed(self) -> str:
        """Unit in which displacements are printed."""
        return PRINT[self.units.place]

    @property
    def works(self) -> bool:
        """Whether the frequency lies in the range of well isolated machines."""
        return WORKING[0] <= self.found.eta <= WORKING[1]

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        """A single number in running text."""
        return self.page.shown(self.of[key], unit=unit, **form)

    def sized(self, key: str, unit: str = "") -> Markup:
        """symbol = value unit."""
        return self.page.value(self.v(key, unit))

    def given_values(self) -> Markup:
        """What the variant states, in the order of the model."""
        given, place, hung = self.given, self.printed, self.given.absorber
        each = "_each" if given.isolators > 1 else ""
        stated = {
            "inertia": True,
            "isolators": given.isolators > 1,
            f"stiffness{each}": given.stiffness is not None,
            f"damping{each}": given.damping is not None,
            "zeta": given.ratio is not None,
            "force": given.force is not None,
            "unbalance": given.unbalance is not None,
            "radius": given.unbalance is not None,
            "base": given.base is not None,
            "direction": given.direction is not None,
            "omega": given.omega is not None,
            "wanted": given.wanted is not None,
            "friction": given.friction is not None,
            "base_inertia": given.foundation is not None,
            "base_stiffness": given.foundation is not None,
            "base_damping": given.foundation is not None and given.foundation.damping > 0,
            "absorber": hung is not None and hung.inertia is not None,
            "absorber_springs": hung is not None and hung.springs > 1,
            "absorber_arm": hung is not None and hung.arm is not None,
            "place": given.place != 0,
            "speed": given.speed != 0,
        }
        units = {"radius": "mm", "base": place, "direction": "deg", "absorber_arm": "mm", "place": place}
        return self.page.listed(self.sized(key, units.get(key, "")) for key, is_so in stated.items() if is_so)

    def where(self, *formulas: Formula) -> list[dict[str, Any]]:
        """Symbols of the chapter are its own: ω is explained again where a crank had another."""
        items = self.page.where(*formulas)
        return [{**item, "id": ("vibration", item["id"])} for item in items]

    # --- tables

    def _columns(self, name: str, units: dict[str, str], leave: Sequence[str] = ()) -> list[Any]:
        table = self.of.table(name)
        keys = [column.key for column in table.columns if column.key not in leave]
        return [self.page.column(table, key, units.get(key, "")) for key in keys]

    @property
    def _units(self) -> dict[str, str]:
        return {"omega": "rpm", "lag": "deg", "amplitude": self.printed}

    def response(self, caption: Any) -> Table:
        leave = ("beta", "lag") if self.given.base is not None else ()
        first, *others = self._columns("response", self._units, leave)
        return numeric(caption, first, others)

    def swings(self, caption: Any) -> Table:
        table = self.of.table("swings")
        first = self.page.column(table, "swing", digits=1)
        return numeric(caption, first, self._columns("swings", {"size": self.printed}, ("swing",)))

    def dampings(self, caption: Any) -> Table:
        leave = ("beta_peak", "eta_peak", "beta") if self.given.base is not None else ()
        first, *others = self._columns("dampings", {}, leave)
        return numeric(caption, first, others)

    def harmonics(self, caption: Any) -> Table:
        table = self.of.table("harmonics")
        return numeric(
            caption,
            self.page.column(table, "order", digits=1),
            self._columns("harmonics", self._units, ("order",)),
        )

    def absorbers(self, caption: Any) -> Table:
        table, page = self.of.table("absorbers"), self.page
        units = {"amplitude": self.printed, "absorber_swing": self.printed, "absorber_stiffness": "kN/m"}
        if self.given.turning:
            units.pop("absorber_stiffness")
        keys = [column.key for column in table.columns[1:]]
        heads = [
            page.t("Absorber"),
            *(page.head(table[key].symbol(), units.get(key, table[key].unit)) for key in keys),
        ]
        rows = [self._absorber(row, keys, units) for row in range(len(table))]
        return worded(caption, heads, rows, (5, *(2 for _ in keys)))

    def _absorber(self, row: int, keys: Sequence[str], units: dict[str, str]) -> list[Cell | Words]:
        table = self.of.table("absorbers")
        key = table["kind"].values[row]
        kind = self.t(KINDS[key])
        cells = [self.page.cell(table, key, row, units.get(key, ""), digits=4) for key in keys]
        return [Words(kind, table.ref("kind", row)), *cells]

    # --- figures

    @cached_property
    def scheme(self) -> Drawing:
        return picture(self.found, self.page)

    @cached_property
    def curves(self) -> Graph:
        """Dynamic coefficient, lag and force ratio against ω/ω0, by damping ratio."""
        table = self.of.table("curves")
        of = [
            ("beta", Symbol("beta"), ""),
            ("lag", Symbol("psi"), "deg"),
            ("ratio", quantity(self.found, ratio(self.found)).sign, ""),
        ]
        if self.given.base is not None:
            of = of[2:]
        drawn = [
            Curve(
                _low(table[f"{key}_{k}"].numbers(unit), unit),
                self._named(zeta) if not panel else "",
                panel,
                (),
            )
            for panel, (key, _, unit) in enumerate(of)
            for k, zeta in enumerate(self.given.curves, 1)
        ]
        along = table["eta"].quantity
        return plot(
            drawn, table["eta"].numbers(), along, [(symbol, unit) for _, symbol, unit in of], self.page.tr
        )

    def _named(self, zeta: float) -> str:
        return f"ζ = {self.page.num(zeta, 3)}"

    @cached_property
    def motion(self) -> Graph:
        """The motion from the start and its steady part."""
        table = self.of.table("motion")
        names = (self.t("motion"), self.t("steady part"))
        keys = ("x",) if self.given.free else ("x", "x_steady")
        drawn = [
            Curve(table[key].numbers(self.printed), str(name), 0, ())
            for key, name in zip(keys, names, strict=False)
        ]
        panel = [(Symbol(self.units.x), self.printed)]
        return plot(drawn, table["t"].numbers(), table["t"].quantity, panel, self.page.tr)

    @cached_property
    def turn(self) -> Graph:
        """Shaking force, motion and force on the base over a turn."""
        table = self.of.table("turn")
        graphs = CycleGraphs(np.asarray(table["phi"].values), 0, self.page.tr)
        units = {"force": "", "x": "mm", "on_base": ""}
        drawn = [Curve(table[key].numbers(unit), panel=k) for k, (key, unit) in enumerate(units.items())]
        return graphs.graph(
            drawn,
            [graphs.letter(table[key].symbol(), unit or table[key].unit) for key, unit in units.items()],
        )

    @cached_property
    def absorbed(self) -> Graph:
        """Dynamic coefficient with each absorber."""
        table = self.of.table("absorbed")
        names = {"beta": self.t("without an absorber")}
        names |= {f"beta_{k}": self.t(text) for k, text in enumerate(KINDS.values(), 1)}
        drawn = [Curve(_low(table[key].numbers(), ""), str(name), 0, ()) for key, name in names.items()]
        panel = [(Symbol("beta"), "")]
        return plot(drawn, table["eta"].numbers(), table["eta"].quantity, panel, self.page.tr)


def _low(values: Any, unit: str) -> Any:
    """A curve that ends where it leaves the sheet; a lag stays on it."""
    return values if unit else np.where(values <= HIGHEST, values, np.nan)

"""View of the speed governor: what is said of the centrifugal governor by itself; the parts of the chapter."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.governor.draw import brake, charts, scheme
from tmm_report.chapters.machine.governor.formulas.by_itself import DirectFormulas
from tmm_report.chapters.machine.governor.quantities import whole as q
from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.chapters.machine.governor.solve.whole import Found
from tmm_report.chapters.machine.governor.view.brake import BrakeView
from tmm_report.chapters.machine.governor.view.in_loop import LoopView
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.machine.governor.equilibrium import Arms, BellCrank
from tmm_report.problems import N_
from tmm_report.quantity.formula import Var
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric
from tmm_report.report.part import Part

UNITS = {  # of print, of the numbers that are given
    "l_1": "mm", "l_2": "mm", "e_1": "mm", "e_2": "mm", "x_0": "mm", "L": "mm", "a": "mm", "b": "mm", "r_0": "mm",
    "r_min": "mm",
    "n": "", "m": "", "m_0": "", "c": "N/mm", "F_0": "", "h": "mm", "F_fr": "", "k": "",
}  # fmt: skip
STABILITY = {
    "stable": N_("The speed grows as the sleeve rises: the governor is stable all over its lift."),
    "unstable": N_(
        "The governor is unstable: its speed falls as the sleeve rises, so the sleeve leaves every position for a stop."
    ),
    "flat": N_(
        "The governor is flat (isochronous): one speed holds the sleeve at every lift, so that it stays nowhere and "
        "goes from stop to stop at the least change of the speed."
    ),
    "partly": N_(
        "The governor is stable over a part of its lift only; where the speed falls, the sleeve does not stay."
    ),
}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/governor", GovernorView(found, page))
    book = page.once(q.book, found)
    if found.loop is not None:
        yield Part("machine/governor/loop", LoopView(found.loop, book, page))
    if found.brake is not None:
        yield Part("machine/governor/brake", BrakeView(found.brake, book, page))


def picture(found: Found, page: Page) -> Drawing:
    """The governor at a glance, for a list of many; of a brake alone nothing is drawn but its axes."""
    if found.direct is not None:
        return scheme.dimensioned(found.direct)
    assert found.brake is not None
    return brake.brake(found.brake)


class GovernorView:
    """The heading of the chapter and the centrifugal governor by itself; `found.direct` is None of a brake alone."""

    def __init__(self, found: Found, page: Page):
        self.found, self.page, self.t = found, page, page.t
        self.book = page.once(q.book, found)

    @property
    def name(self) -> str:
        return self.found.given.name

    @property
    def direct(self) -> DirectFound:
        assert self.found.direct is not None
        return self.found.direct

    @cached_property
    def formulas(self) -> DirectFormulas:
        return DirectFormulas(self.direct, self.book)

    @cached_property
    def places(self) -> Any:
        return self.book.tables["governor_equilibrium"]

    # ------------------------------------------------------------ words

    @property
    def kind(self) -> Markup:
        """What kind of governor it is."""
        geometry, weights = self.direct.given.geometry, self.direct.weights
        if isinstance(geometry, BellCrank):
            return self.t(N_("a governor with angle levers and a spring (Hartnell)"))
        if geometry.extension is not None:
            return self.t(N_("a governor with extended lower arms (Proell)"))
        if weights.stiffness or weights.preload:
            return self.t(N_("a governor with arms and a spring on the sleeve"))
        if weights.sleeve:
            return self.t(N_("a loaded governor with arms (Porter)"))
        return self.t(N_("a simple governor with arms (Watt)"))

    def given_values(self) -> Markup:
        chosen = self.direct.given.choice
        skipped = {"spring": ("c", "F_0"), "balls": ("m",), "sleeve": ("m_0",)}[chosen.what] if chosen else ()
        keys = [key for key in UNITS if f"governor_{key}" in self.book.values and key not in skipped]
        return self.page.values(self._given(key) for key in keys if self.book[f"governor_{key}"].value)

    def _given(self, key: str) -> Var:
        return self.book[f"governor_{key}"].var(UNITS[key])

    def explained(self) -> list[dict[str, Any]]:
        """Of the given numbers, and of the others that no formula explains."""
        keys = [
            key
            for key in UNITS
            if f"governor_{key}" in self.book.values and self.book[f"governor_{key}"].value
        ]
        return [
            self.page.explained(f"governor:{key}", of := self.book[f"governor_{key}"], UNITS[key] or of.unit)
            for key in keys
        ]

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        return self.page.shown(self.book[f"governor_{key}"], unit=unit, **form)

    def sized(self, key: str, unit: str = "") -> Markup:
        """symbol = value."""
        return self.page.value(self.book[f"governor_{key}"].var(unit))

    def wanted(self) -> Markup:
        """The speeds that were asked for."""
        choice = self.direct.given.choice
        assert choice is not None
        if choice.what == "spring":
            return self.t(
                N_("The spring is chosen for %(low)s rpm at the lower stop and %(high)s rpm at the upper one."),
                low=self.number("omega_0", "rpm"), high=self.number("omega_h", "rpm"),
            )  # fmt: skip
        text = {
            "balls": N_("The mass of the balls is chosen for %(speed)s rpm at the middle of the lift."),
            "sleeve": N_("The load of the sleeve is chosen for %(speed)s rpm at the middle of the lift."),
        }[choice.what]
        return self.t(text, speed=self.number("omega_chosen", "rpm"))

    def stability(self) -> Markup:
        return self.t(STABILITY[self.direct.word])

    def remedies(self) -> list[Markup]:
        """What would make it stable."""
        found = []
        if (
            "governor_stiffness_needed" in self.book.values
            and self.book["governor_stiffness_needed"].value > 0
        ):
            text = N_("a spring stiffer than %(c)s N/mm with the same force at the lower stop")
            found.append(self.t(text, c=self.number("stiffness_needed", "N/mm")))
        if "governor_preload_allowed" in self.book.values:
            text = N_("a force of the spring at the lower stop below %(force)s N with the same stiffness")
            found.append(self.t(text, force=self.number("preload_allowed")))
        return found

    # ------------------------------------------------------------ tables and pictures

    def mechanism(self, caption: Any) -> Table:
        """Geometry over the lift."""
        keys = ["H", "x", "alpha", "beta", "gamma", "theta", "r", "dr", "dy"]
        units = {
            "H": "mm",
            "x": "mm",
            "r": "mm",
            "alpha": "deg",
            "beta": "deg",
            "gamma": "deg",
            "theta": "deg",
        }
        kept = [key for key in keys if key in self.places and not self._same(key)]
        return self._table(caption, kept, units)

    def _same(self, key: str) -> bool:
        """Whether a column repeats another: the ball is on the pin."""
        geometry = self.direct.given.geometry
        on_pin = isinstance(geometry, Arms) and geometry.distance is None and geometry.extension is None
        return key == "x" and on_pin

    def equilibrium(self, caption: Any) -> Table:
        units = {"omega_g": "rad/s"}
        table = self._table(caption, ["A", "E", "omega_g", "C", "S"], units)
        return table

    def speeds(self, caption: Any) -> Table:
        """Speeds in rpm, with the band of insensitivity where there is friction."""
        keys = ["omega_g", *(["omega_low", "omega_up"] if self.direct.given.friction else [])]
        columns = [self.page.column(self.places, key, "rpm") for key in keys]
        if self.direct.given.friction:
            columns.append(self.page.column(self.places, "epsilon", "%", digits=4))
        return numeric(caption, self._lifts(), columns)

    def _table(self, caption: Any, keys: list[str], units: dict[str, str]) -> Table:
        columns = [self.page.column(self.places, key, units.get(key, "")) for key in keys]
        return numeric(caption, self._lifts(), columns)

    def _lifts(self) -> Column:
        return self.page.column(self.places, "z", "mm")

    @cached_property
    def drawing(self) -> Drawing:
        return scheme.dimensioned(self.direct, str(self.t(N_("Scheme of the governor"))))

    def scale(self) -> Markup:
        return self.page.value(scale_of("mu_l", 1 / scheme.drawn_scale(self.direct), "m/mm"))

    @cached_property
    def speed_chart(self) -> Drawing:
        words = N_("equilibrium"), N_("the sleeve begins to sink"), N_("the sleeve begins to rise")
        names = tuple(str(self.t(word)) for word in words)
        units = self.page.unit("mm"), self.page.unit("rpm")
        return charts.speeds(self.direct, self._num, units, (names[0], names[1], names[2]))

    @cached_property
    def force_chart(self) -> Drawing:
        units = self.page.unit("mm"), self.page.unit("rpm"), self.page.unit("N")
        return charts.controlling(self.direct, self._num, units)

    def _num(self, value: float) -> str:
        return self.page.num(value, 4)

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        if self.found.direct is None:
            return []
        text = N_(
            "The centrifugal governor works between %(low)s rpm and %(high)s rpm of its shaft, its non-uniformity is "
            "%(delta)s %%."
        )
        low, high = (self.number(f"omega_{end}", "rpm") for end in ("0", "h"))
        return [self.t(text, low=low, high=high, delta=self.number("delta", "%", digits=4)), self.stability()]

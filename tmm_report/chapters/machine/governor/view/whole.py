"""View of the speed governor: what is said of the centrifugal governor by itself; the parts of the chapter."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.governor import rows
from tmm_report.chapters.machine.governor.draw import brake, charts, scheme
from tmm_report.chapters.machine.governor.quantities import of_direct
from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.chapters.machine.governor.solve.whole import Found
from tmm_report.chapters.machine.governor.values import Values
from tmm_report.chapters.machine.governor.view.brake import BrakeView
from tmm_report.chapters.machine.governor.view.in_loop import LoopView, axis
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.machine.governor.equilibrium import Arms, BellCrank
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import named, scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric
from tmm_report.report.part import Part

GIVEN = (
    "l_1", "l_2", "e_1", "e_2", "x_0", "L", "a", "b", "r_0", "r_min", "n", "m", "m_0", "c", "F_0", "h", "F_fr", "k",
)  # fmt: skip
TILTS = ("alpha", "beta", "gamma", "theta")
MECHANISM = ("H", "alpha", "beta", "dx", "gamma", "r", "dr", "theta", "dy")
STABILITY = {
    "stable": N_("The speed grows as the sleeve rises: the governor is stable over its whole lift."),
    "unstable": N_(
        "The governor is unstable: its speed falls as the sleeve rises, so the sleeve leaves every position for a stop."
    ),
    "flat": N_(
        "The governor is flat (isochronous): one speed holds the sleeve at every lift, so that it stays nowhere and "
        "goes from stop to stop at the least change of the speed."
    ),
    "partly": N_(
        "The governor is stable over a part of its lift only; where the speed falls, the sleeve does not stay in place."
    ),
}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/governor", GovernorView(found, page))
    if found.loop is not None:
        yield Part("machine/governor/loop", LoopView(found.loop, page))
    if found.brake is not None:
        yield Part("machine/governor/brake", BrakeView(found.brake, page))


def picture(found: Found, page: Page) -> Drawing:
    """The governor at a glance, for a list of many; of a brake alone nothing is drawn but its axes."""
    if found.direct is not None:
        return scheme.dimensioned(found.direct)
    assert found.brake is not None
    return brake.brake(found.brake, words=page.tr.in_index)


class GovernorView(ChapterView):
    """The heading of the chapter and the centrifugal governor by itself; `found.direct` is None of a brake alone."""

    def __init__(self, found: Found, page: Page):
        own = found.direct
        super().__init__(page, own.s if own else Values(), of_direct(own) if own else ())
        self.found = found

    @property
    def direct(self) -> DirectFound:
        assert self.found.direct is not None
        return self.found.direct

    # ------------------------------------------------------------ formulas of the place at the middle of the lift

    @cached_property
    def _rows(self) -> dict[str, Formula]:
        return rows.formulas(self.direct)

    def row(self, *keys: str) -> list[Formula]:
        """By the keys of the columns, of those that this governor has."""
        return [self._rows[key] for key in keys if key in self._rows]

    def mechanism_formulas(self) -> list[Formula]:
        """From the lift to r, r' and y'."""
        return self.row(*MECHANISM)

    def middle(self) -> Markup:
        """The lift there."""
        unit = self.of("equilibrium", "z").quantity.printed
        return self.page.value(self.places.var("z", self.direct.middle, unit))

    def choice(self) -> list[Formula]:
        """Of what was not stated."""
        return self.formulas("F_0", "spring_top", "c", "m", "m_0")

    # ------------------------------------------------------------ words

    @property
    def kind(self) -> Markup:
        """What kind of governor it is."""
        geometry, weights = self.direct.given.geometry, self.direct.weights
        if isinstance(geometry, BellCrank):
            return self.t(N_("a governor with bell-crank levers and a spring (Hartnell)"))
        if geometry.extension is not None:
            return self.t(N_("a governor with extended lower arms (Proell)"))
        if weights.stiffness or weights.preload:
            return self.t(N_("a governor with arms and a spring on the sleeve"))
        if weights.sleeve:
            return self.t(N_("a loaded governor with arms (Porter)"))
        return self.t(N_("a simple governor with arms (Watt)"))

    def given_values(self) -> Markup:
        return self.listed(self._given())

    def _given(self) -> list[str]:
        """Formulas give and explain the others."""
        return [key for key in GIVEN if self.s.get(key) and not self.s.has_formula(key)]

    def explained_given(self) -> list[dict[str, Any]]:
        return self.explained(*self._given())

    def wanted(self) -> Markup:
        """The speeds that were asked for."""
        chosen = self.direct.given.choose
        assert chosen is not None
        if chosen.spring is not None:
            return self.t(
                N_("The spring is chosen for %(low)s rpm at the lower stop and %(high)s rpm at the upper one."),
                low=self.number("omega_0"), high=self.number("omega_h"),
            )  # fmt: skip
        text = N_("The load of the sleeve is chosen for %(speed)s rpm at the middle of the lift.")
        if chosen.balls is not None:
            text = N_("The mass of the balls is chosen for %(speed)s rpm at the middle of the lift.")
        return self.t(text, speed=self.number("omega_chosen"))

    def stability(self) -> Markup:
        return self.t(STABILITY[self.direct.word])

    def remedies(self) -> list[Markup]:
        """What would make it stable."""
        found = []
        if (self.s.get("stiffness_needed") or 0.0) > 0:
            text = N_("a spring stiffer than %(c)s N/mm with the same force at the lower stop")
            found.append(self.t(text, c=self.number("stiffness_needed")))
        if "preload_allowed" in self.s:
            text = N_("a force of the spring at the lower stop below %(force)s N with the same stiffness")
            found.append(self.t(text, force=self.number("preload_allowed")))
        return found

    # ------------------------------------------------------------ tables and pictures

    def mechanism(self, caption: Any) -> Table:
        """Geometry over the lift; the radius of the ball alone where it is on the pin."""
        leave = ("x",) if self._on_pin else ()
        keys = ["H", "x", *TILTS, "r", "dr", "dy"]
        return self._over_lift(caption, [key for key in keys if key in self.places and key not in leave])

    @property
    def _on_pin(self) -> bool:
        geometry = self.direct.given.geometry
        return isinstance(geometry, Arms) and geometry.distance is None and geometry.extension is None

    @property
    def places(self) -> model.Table:
        return self.table("equilibrium")

    def equilibrium(self, caption: Any) -> Table:
        return self._over_lift(caption, ["A", "E", "omega_g", "C", "S"])

    def _over_lift(self, caption: Any, keys: Sequence[str]) -> Table:
        return self.numeric(caption, "equilibrium", ["z", *keys])

    def speeds(self, caption: Any) -> Table:
        """Speeds in rpm, with the band of insensitiveness where there is friction."""
        columns = [self.column("equilibrium", "omega_g", "rpm")]
        if self.direct.given.sleeve.friction:
            columns += self.columns("equilibrium", ("omega_low", "omega_up"))
            columns.append(self.column("equilibrium", "epsilon", digits=4))
        return numeric(caption, self.column("equilibrium", "z"), columns)

    @cached_property
    def drawing(self) -> Drawing:
        return scheme.dimensioned(self.direct, str(self.t(N_("Scheme of the governor"))))

    def scale(self) -> Markup:
        return self.page.value(scale_of("mu_l", 1 / scheme.drawn_scale(self.direct), "m/mm"))

    @cached_property
    def speed_chart(self) -> Drawing:
        words = N_("equilibrium"), N_("the sleeve begins to sink"), N_("the sleeve begins to rise")
        names = [str(self.t(word)) for word in words]
        lift = self.of("curve", "z")
        axes = axis(self.page, lift.quantity), named(Symbol("n", "g"), "rpm", self.page.tr)
        return charts.speeds(self.direct, lift, axes, self._num, names)

    @cached_property
    def force_chart(self) -> Drawing:
        along, up = (axis(self.page, self.of("curve", key).quantity) for key in ("r", "C"))
        return charts.controlling(self.table("curve"), (along, up), self._num, self.page.unit("rpm"))

    def _num(self, value: float) -> str:
        return self.page.num(value, 4)

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        if self.found.direct is None:
            return []
        text = N_(
            "The centrifugal governor works between %(low)s rpm and %(high)s rpm of its shaft; its "
            "non-uniformity is %(delta)s %%."
        )
        low, high = (self.number(f"omega_{end}") for end in ("0", "h"))
        return [self.t(text, low=low, high=high, delta=self.number("delta")), self.stability()]

"""The numbers of the backlash with the expressions that the note prints of them, and the limits of measured sizes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.gears.spur.solve.backlash import Found
from tmm_report.chapters.gears.spur.values import Limited, Loosened
from tmm_report.mechanics.gears.backlash import Loose
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Var, arccos, cos, tan
from tmm_report.quantity.model import Column, text_column
from tmm_report.quantity.sheet import Computed, Q
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.gear_terms import involute
from tmm_report.quantity.terms.wheel_words import of_wheel

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.steps import Stage

LIMITS = N_("limits of the sizes by which the wheels of pair %(name)s are measured")
SYMBOLS = {
    "s": Symbol("s"), "W": Symbol("W"), "s_c": Symbol("s", "c", bar=True), "s_y": Symbol("s", "y", bar=True),
    "M": Symbol("M"),
}  # fmt: skip


PLACES = ("one", "two")
KEYS = ("stated", "wide", "thin", "field", "span_fall")


def loosened(stage: Stage, of: Found) -> Loosened:
    """Thinning of both wheels, the least and the greatest backlash."""
    return _Loosening(stage, of).s


class _Loosening:
    def __init__(self, stage: Stage, of: Found):
        self.stage, self.of = stage, of
        keys = (*KEYS, "turn_least", "turn_most")
        own = {
            f"{key}_{place}": _of_wheel(Loosened.DECLARED[f"{key}_{place}"], f"{key}_{name}", name)
            for key in keys
            for place, name in zip(PLACES, stage.names, strict=True)
        }
        self.s = Loosened(own, stage.prefix)
        self._stated()
        if of.known:
            self._distance("least", of.close)
        self._thinning()
        if of.known:
            self._backlash("least", of.close, of.least)
        if of.known and not of.single:
            self._distance("most", of.far)
            self._backlash("most", of.far, of.most)

    def _stated(self) -> None:
        s, stated = self.s, self.of.stated
        s.guaranteed, s.axes = stated.guaranteed, stated.axes
        if stated.by != "thickness":
            for place, number in zip(PLACES, stated.of_both("thinning") or (), strict=False):
                s.put(f"stated_{place}", number)
            for place, number in zip(PLACES, stated.of_both("tolerance") or (), strict=False):
                s.put(f"wide_{place}", number)

    def _thinning(self) -> None:
        s, of, g = self.s, self.of, self.stage.s
        if of.least is None or of.most is None:
            return
        for i, place in enumerate(PLACES):
            s.put(f"thin_{place}", self._thin(place, of.least[i]))
            if of.most[i] > of.least[i]:
                field = of.most[i] - of.least[i]
                s.put(f"field_{place}", self._of_teeth(f"wide_{place}", field) or field)
            if self.stage.found.inspected[i].span is not None:
                s.put(f"span_fall_{place}", s.var(f"thin_{place}") * cos(g.alpha))

    def _thin(self, place: str, number: float) -> Computed | float:
        """Of a wheel: as it is stated, by the rack or the span, or what the guaranteed backlash asks for."""
        s, st, g = self.s, self.stage, self.stage.s
        if (stated := self._of_teeth(f"stated_{place}", number)) is not None:
            return stated
        if not self.of.asked or not number:
            return number
        alpha_w = self._angle("least")
        wanted: Expr = s.guaranteed / (cos(alpha_w) * cos(g.beta_b) if st.helical else cos(alpha_w))
        there = self._left("least")
        wanted = wanted if there is None else wanted - there
        across = cos(alpha_w) * cos(g.beta) if st.helical else cos(alpha_w)
        return Computed(wanted * across / (2 * cos(st.alpha_t)), number)

    def _of_teeth(self, key: str, number: float) -> Computed | None:
        """What is stated of the rack or the span, as the teeth have it; None where it is that of the teeth."""
        if key not in self.s:
            return None
        own, alpha = self.s.var(key), self.stage.s.alpha
        return Computed(2 * own * tan(alpha) if self.of.stated.by == "rack" else own / cos(alpha), number)

    def _angle(self, end: str) -> Var:
        return self.s.var(f"alpha_{end}") if f"alpha_{end}" in self.s else self.stage.s.alpha_w

    def _left(self, end: str) -> Expr | None:
        """What the centre distance leaves of backlash; None of nothing."""
        if f"by_axes_{end}" in self.s:
            return self.s.var(f"by_axes_{end}")
        return self.stage.s.backlash if self.stage.found.loose else None

    def _distance(self, end: str, loose: Loose) -> None:
        """A limit of the centre distance, its angle, and the backlash that it leaves."""
        s, st, g = self.s, self.stage, self.stage.s
        if not s.get("axes"):
            return
        shorter = (end == "least") != st.internal
        s.put(f"a_{end}", g.a_w - s.axes if shorter else g.a_w + s.axes)
        a_w = s.var(f"a_{end}")
        angle = arccos(g.a * cos(st.alpha_t) / a_w)
        s.put(f"alpha_{end}", Computed(angle, float(np.degrees(loose.moved.alpha_w))))
        filled = involute(st.alpha_t) + 2 * g.x_sum * tan(g.alpha) / st.teeth_sum
        apart = involute(s.var(f"alpha_{end}")) - filled
        s.put(f"by_axes_{end}", Computed((-2 if st.internal else 2) * a_w * apart, loose.by_distance))

    def _backlash(self, end: str, loose: Loose, thin: tuple[float, float] | None) -> None:
        """What thinning adds, both along the working circles and along the normal, and the angles by which the wheels
        turn freely."""
        s, st, g = self.s, self.stage, self.stage.s
        parts, alpha_w, along = self._left(end), self._angle(end), None
        if thin is not None and any(thin):
            along = self._by_teeth(end, alpha_w)
        if parts is not None and along is not None:
            s.put(f"by_teeth_{end}", Computed(along, loose.circumferential - loose.by_distance))
            parts = parts + s.var(f"by_teeth_{end}")
        whole = parts if parts is not None else along
        s.put(
            f"j_w_{end}", loose.circumferential if whole is None else Computed(whole, loose.circumferential)
        )
        across = s.var(f"j_w_{end}") * cos(alpha_w)
        s.put(f"j_n_{end}", Computed(across * cos(g.beta_b) if st.helical else across, loose.normal))
        for i, place in enumerate(PLACES):
            turned = 2 * s.var(f"j_w_{end}") * cos(alpha_w) / st.wheels[i].d_b
            s.put(f"turn_{end}_{place}", Computed(turned, float(np.degrees(loose.turns[i]))))

    def _by_teeth(self, end: str, alpha_w: Var) -> Expr:
        """What the teeth of both wheels have lost, as an arc of the working circles."""
        s, st = self.s, self.stage
        both: Expr = s.thin_one + s.thin_two
        for key in (f"field_{place}" for place in PLACES if end == "most"):
            both = both + s.var(key) if key in s else both
        along = both / cos(st.s.beta) if st.helical else both
        return along * cos(st.alpha_t) / cos(alpha_w)


def _of_wheel(of: Q, key: str, name: str) -> Q:
    assert of.symbol is not None
    return of.called(of_wheel(of.symbol, name), key, wheel=name)


# ---------------------------------------------------------------- limits of the sizes


def limits(stage: Stage, of: Found) -> Iterator[Column]:
    """A row for each size of each wheel: without thinning, its deviations, its limits."""
    rows = of.limits
    names = [stage.names[row.i] for row in rows]
    letters = [of_wheel(SYMBOLS[row.size], stage.names[row.i]) for row in rows]
    yield text_column("wheel", Message(N_("number of the wheel")), names)
    yield text_column("size", Message(N_("quantity")), [row.size for row in rows])
    numbers = {
        "nominal": [row.nominal for row in rows],
        "first": [row.least for row in rows],
        "second": [row.most for row in rows],
        "first_off": [row.least - row.nominal for row in rows],
        "second_off": [row.most - row.nominal for row in rows],
    }
    for key, column in numbers.items():
        quantity = Limited.DECLARED[key].quantity
        own = letters if key == "nominal" else [_primed(letter, key) for letter in letters]
        yield Column(quantity, [x if math.isfinite(x) else math.nan for x in column], own)


def _primed(letter: Symbol, key: str) -> Symbol:
    prime = "′" if key.startswith("first") else "′′"
    if key.endswith("_off"):
        return Symbol(f"Delta{letter.base}", letter.sub, prime, letter.bar)
    return Symbol(letter.base, letter.sub, prime, letter.bar)

"""The least cam written out: what rise and return ask, the lowest place, the radius, the best offset."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.cam import quantities as q
from tmm_report.chapters.lever.cam.solve import CamFound
from tmm_report.mechanics.cams.least_size import Bound, Place, Zone
from tmm_report.quantity.formula import Expr, Formula, expr, sqrt, tan
from tmm_report.quantity.model import Book, Value

LIMITS: dict[Bound, str] = {"rise": "cam_alpha_limit", "dwell": "cam_alpha_limit", "return": "cam_alpha_back"}


class Sizing:
    """Formulas of the least size of a cam; `book`: of all cams."""

    def __init__(self, found: CamFound, zone: Zone, book: Book):
        self.found, self.zone, self.book, self.name = found, zone, book, found.cam.name

    def _value(self, key: str) -> Value:
        return self.book[f"{key}_{self.name}"]

    def _tan(self, bound: Bound) -> Expr:
        """Of the permitted pressure angle."""
        return tan(self._value(LIMITS[bound]).var())

    def _b(self, bound: Bound) -> Expr:
        return expr(0) if bound == "dwell" else self._value(f"cam_b_{bound}").var()

    def asked(self) -> Iterator[Formula]:
        """b of the rise, and of the return where it is limited."""
        table = self.book.tables[f"cam_least_{self.name}"]
        for row, kind in enumerate(q.demands(self.zone)):
            S, slope = (table.var(one.key, row) for one in (q.ASKED_S, q.ASKED_SLOPE))
            steep = slope / self._tan("rise" if kind == "rise" else "return")
            yield self._value(f"cam_b_{kind}").formula((steep if kind == "rise" else -steep) - S)

    def taken(self) -> Iterator[Formula]:
        """With the stated offset: the lowest place and the least radius."""
        place = self.zone.at(self.found.offset)
        yield from self._place(place, "", self._value("cam_offset").var() if place.e else None)

    @property
    def rounded(self) -> bool:
        return abs(self.found.pitch_base - self.zone.at(self.found.offset).radius) > 1e-12

    def base(self) -> Formula | None:
        """The base circle under the roller; None of an edge, whose pitch curve is the profile."""
        if not self.found.cam.roller:
            return None
        return self._value("cam_base").formula(
            self._value("cam_pitch_base").var() - self._value("cam_roller").var()
        )

    def best(self) -> Iterator[Formula]:
        """The best offset, and the cam that it gives."""
        place, value = self.zone.best, self._value("cam_e_best")
        if place.e:
            yield value.formula(self._best_offset(place))
        yield from self._place(place, "_best", value.var() if place.e else None)

    def _place(self, place: Place, which: str, e: Expr | None) -> Iterator[Formula]:
        s0, r0 = (self._value(f"cam_{key}_least{which}") for key in ("s0", "r0"))
        bound = place.by[0]
        if e is None:
            yield s0.formula(self._b(bound))
        elif bound == "dwell":
            yield s0.formula(e / self._tan(bound))
        else:
            aside = e / self._tan(bound)
            yield s0.formula(self._b(bound) - aside if bound == "rise" else self._b(bound) + aside)
        yield r0.formula(sqrt(s0.var() ** 2 + e**2) if e is not None else s0.var())

    def _best_offset(self, place: Place) -> Expr:
        """Where two bounds meet, or at the foot of the perpendicular on one."""
        first = place.by[0]
        if len(place.by) == 1:
            t = self._tan(first)
            foot = self._b(first) * t / (1 + t**2)
            return foot if first == "rise" else -foot
        other = place.by[1]
        if other == "return":
            inverse = [1 / self._tan(bound) for bound in place.by]
            if first == "rise":
                return (self._b(first) - self._b(other)) / (inverse[0] + inverse[1])
            return self._b(other) / (inverse[0] - inverse[1])
        return self._b(first) * self._tan(first) / 2

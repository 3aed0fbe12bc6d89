"""The least cam written out: what rise and return ask, the lowest place, the radius, the best offset."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.cams.cam import quantities as q
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.mechanics.cams.sizes.least_face import Face, TurnedFace
from tmm_report.mechanics.cams.sizes.least_size import Bound, Lever, Place, Zone
from tmm_report.mechanics.cams.sizes.rules import OF_CURVATURE, OF_RADIUS, OF_SHAFT
from tmm_report.quantity.formula import Expr, Formula, Number, arccos, cos, expr, sin, sqrt, tan
from tmm_report.quantity.model import Book, Table, Value

LIMITS: dict[str, str] = {"rise": "cam_alpha_limit", "dwell": "cam_alpha_limit", "return": "cam_alpha_back"}


class Sizing:
    """Formulas of the least size of a cam; `book`: of all cams."""

    kind = ""

    def __init__(self, found: CamFound, book: Book):
        self.found, self.book = found, book

    def _value(self, key: str) -> Value:
        return self.book[q.named(self.found, key)]

    @property
    def table(self) -> Table:
        return self.book.tables[q.named(self.found, "cam_least")]

    def asked(self) -> Iterator[Formula]:
        """What the law asks."""
        yield from ()

    def taken(self) -> Iterator[Formula]:
        """The least radius with the mechanism as it is."""
        yield from ()

    def best(self) -> Iterator[Formula]:
        """What would be smaller still."""
        yield from ()

    @property
    def by_shaft(self) -> bool:
        """Whether the shaft asks for more than the law."""
        if self.found.shaft is None:
            return False
        return self._value("cam_r0_shaft").value > self._value("cam_r0_least").value + 1e-12

    @property
    def rounded(self) -> bool:
        return abs(self.found.pitch_base - self._value("cam_r0_least").value) > 1e-12

    def base(self) -> Formula | None:
        """The base circle under the roller; None of an edge or a face, whose pitch curve is the profile."""
        if not self.found.cam.roller:
            return None
        return self._value("cam_base").formula(
            self._value("cam_pitch_base").var() - self._value("cam_roller").var()
        )


class LeverSizing(Sizing):
    """Of a swinging roller."""

    kind = "lever"

    def __init__(self, found: CamFound, lever: Lever, book: Book):
        super().__init__(found, book)
        self.lever = lever

    def taken(self) -> Iterator[Formula]:
        lever, lowest = self.lever, self.lever.lowest
        assert lowest is not None
        limit = self._value(LIMITS[lowest.way]).var()
        S, slope = (self.table.var(make(self.found).key, 0) for make in (q.asked_S, q.asked_slope))
        d, arm = self._value("cam_apart").var(), self._value("cam_arm").var()
        c = arm * (1 - slope if lever.alike else 1 + slope) * cos(limit) / d
        start = self._value("cam_start_least")
        yield start.formula(limit - arccos(c) - S if lowest.beyond else arccos(c) - limit - S)
        yield self._value("cam_r0_least").formula(self._radius(d, start.var()))

    def best(self) -> Iterator[Formula]:
        """The radius at the best distance of the pivots."""
        d, start = self._value("cam_apart_best").var(), self._value("cam_start_least_best").var()
        yield self._value("cam_r0_least_best").formula(self._radius(d, start))

    def _radius(self, d: Expr, start: Expr) -> Expr:
        arm = self._value("cam_arm").var()
        return sqrt(d**2 + arm**2 - 2 * d * arm * cos(start))


class FaceSizing(Sizing):
    """Under a flat face."""

    kind = "face"

    def taken(self) -> Iterator[Formula]:
        S, bend = (self.table.var(key, 0) for key in (q.asked_S(self.found).key, q.ASKED_BEND.key))
        yield self._value("cam_r0_least").formula(self._value("cam_curvature").var() - S - bend)


class TurnedFaceSizing(Sizing):
    """Under a flat face that swings."""

    kind = "turned face"

    def taken(self) -> Iterator[Formula]:
        away, d, start = (self._value(key).var() for key in ("cam_away", "cam_apart", "cam_start_least"))
        yield self._value("cam_r0_least").formula(away + d * sin(start))


class Rules:
    """What guides ask of roller and shaft, written out."""

    def __init__(self, found: CamFound, book: Book):
        self.found, self.book = found, book

    def _value(self, key: str) -> Value:
        return self.book[q.named(self.found, key)]

    def roller(self) -> Iterator[Formula]:
        radius, curvature = self._value("cam_pitch_base").var(), self._value("cam_rho_pitch").var()
        yield self._value("cam_roller_by_radius").formula(Number(OF_RADIUS) * radius)
        yield self._value("cam_roller_by_curvature").formula(Number(OF_CURVATURE) * curvature)
        if self.found.hollow is not None:
            hollow = self._value("cam_rho_hollow").var()
            yield self._value("cam_roller_by_hollow").formula(Number(OF_CURVATURE) * hollow)

    def shaft(self) -> Formula:
        by = Number(OF_SHAFT) * self._value("cam_shaft").var()
        rolls = bool(self.found.cam.roller)
        return self._value("cam_r0_shaft").formula(by + self._value("cam_roller").var() if rolls else by)


def sizing(found: CamFound, book: Book) -> Sizing | None:
    """None of a cam whose size is stated."""
    match found.cam.sized:
        case Zone() as zone:
            return SlidingSizing(found, zone, book)
        case Lever() as lever:
            return LeverSizing(found, lever, book)
        case Face():
            return FaceSizing(found, book)
        case TurnedFace():
            return TurnedFaceSizing(found, book)
    return None


class SlidingSizing(Sizing):
    """Of a sliding roller or edge."""

    kind = "sliding"

    def __init__(self, found: CamFound, zone: Zone, book: Book):
        super().__init__(found, book)
        self.zone = zone

    def _tan(self, bound: Bound) -> Expr:
        """Of the permitted pressure angle."""
        return tan(self._value(LIMITS[bound]).var())

    def _b(self, bound: Bound) -> Expr:
        return expr(0) if bound == "dwell" else self._value(f"cam_b_{bound}").var()

    def asked(self) -> Iterator[Formula]:
        """b of the rise, and of the return where it is limited."""
        for row, kind in enumerate(q.demands(self.found)):
            S, slope = (self.table.var(make(self.found).key, row) for make in (q.asked_S, q.asked_slope))
            steep = slope / self._tan("rise" if kind == "rise" else "return")
            yield self._value(f"cam_b_{kind}").formula((steep if kind == "rise" else -steep) - S)

    def taken(self) -> Iterator[Formula]:
        """With the stated offset: the lowest place and the least radius."""
        place = self.zone.at(self.found.offset)
        yield from self._place(place, "", self._value("cam_offset").var() if place.e else None)

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

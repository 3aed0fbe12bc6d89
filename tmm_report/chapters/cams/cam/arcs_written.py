"""A cam of base circle, flanks and nose written out: its sizes, and the follower where flank and nose meet, of one that
slides and whose line passes through the axis of the cam."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.cams.cam import quantities as q
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.mechanics.cams.arcs import ArcLaw, Slider
from tmm_report.quantity.formula import Expr, Formula, arccos, cos, sin, sqrt
from tmm_report.quantity.functions import arcsin, arctan
from tmm_report.quantity.model import Book, Value

CENTRAL = 1e-12  # m: an offset below it is none


def central(found: CamFound) -> bool:
    """Whether the textbook's formulas hold."""
    law = found.pieced
    return law is not None and isinstance(law.follower, Slider) and abs(law.follower.offset) < CENTRAL


class Written:
    """`book`: of all cams."""

    def __init__(self, found: CamFound, law: ArcLaw, book: Book):
        self.found, self.law, self.book = found, law, book

    def _value(self, key: str) -> Value:
        return self.book[q.named(self.found, key)]

    def _var(self, key: str) -> Expr:
        return self._value(key).var()

    def sizes(self) -> Iterator[Formula]:
        """What is not stated of nose, distance, lift, half angle and flank, each by those before it."""
        stated = set(self.law.outline.stated)
        radii = {"nose", "lift", "distance"}
        if len(radii & stated) < 2:
            yield self._by_half_angle(*(radii & stated))
            stated |= {"nose"} if "distance" in stated else {"distance"}
        yield from (self._third(key) for key in radii - stated)
        if "half_angle" not in stated:
            yield self._half_angle()
        elif "flank" not in stated:
            yield self._flank_radius()

    def _third(self, key: str) -> Formula:
        """Of nose, lift and distance by the others."""
        base, nose, lift, c = (self._var(f"cam_{one}") for one in ("base", "nose", "lift", "distance"))
        by = {"distance": base + lift - nose, "nose": base + lift - c, "lift": c + nose - base}
        return self._value(f"cam_{key}").formula(by[key])

    def _by_half_angle(self, known: str) -> Formula:
        """The nose by the distance, or the distance by the nose or the lift."""
        base, nose, lift, c = (self._var(f"cam_{one}") for one in ("base", "nose", "lift", "distance"))
        half = self._var("cam_half_angle")
        if self.law.outline.straight:
            by = {
                "distance": base - c * cos(half),
                "nose": (base - nose) / cos(half),
                "lift": lift / (1 - cos(half)),
            }
        else:
            flank = self._var("cam_flank")
            away = flank - base
            by = {
                "distance": flank - sqrt(away**2 + c**2 + 2 * away * c * cos(half)),
                "nose": sqrt((flank - nose) ** 2 - away**2 * sin(half) ** 2) - away * cos(half),
                "lift": lift * (2 * away - lift) / (2 * (away * (1 - cos(half)) - lift)),
            }
        return self._value("cam_nose" if known == "distance" else "cam_distance").formula(by[known])

    def _half_angle(self) -> Formula:
        base, nose, c = (self._var(key) for key in ("cam_base", "cam_nose", "cam_distance"))
        half = self._value("cam_half_angle")
        if self.law.outline.straight:
            return half.formula(arccos((base - nose) / c))
        flank = self._var("cam_flank")
        return half.formula(
            arccos(((flank - nose) ** 2 - (flank - base) ** 2 - c**2) / (2 * (flank - base) * c))
        )

    def _flank_radius(self) -> Formula:
        base, nose, c = (self._var(key) for key in ("cam_base", "cam_nose", "cam_distance"))
        aside = c * cos(self._var("cam_half_angle"))
        return self._value("cam_flank").formula(
            (c**2 + base**2 - nose**2 - 2 * base * aside) / (2 * (base - nose - aside))
        )

    def change(self) -> Iterator[Formula]:
        """The flank's angle; displacement, derivatives on both sides of the change, at both ends."""
        angle = self._value("cam_flank_angle")
        yield angle.formula(self._flank_angle())
        theta, left = angle.var(), self._value("cam_nose_angle")
        yield left.formula(self._var("cam_half_angle") - theta)
        on_flank, on_nose = self._flank(theta), self._nose(left.var())
        yield self._value("cam_S_change").formula(on_flank[0])
        yield self._value("cam_S1_change").formula(on_flank[1])
        yield self._value("cam_S2_start").formula(self._start())
        yield self._value("cam_S2_flank").formula(on_flank[2])
        yield self._value("cam_S2_nose").formula(on_nose)
        yield self._value("cam_S2_apex").formula(self._apex())

    def rates(self) -> Iterator[Formula]:
        """Velocity and accelerations, where a speed is stated."""
        if self.found.turn.omega is None:
            return
        omega = self._var("cam_omega")
        yield self._value("cam_v_change").formula(omega * self._var("cam_S1_change"))
        for key in ("start", "flank", "nose", "apex"):
            yield self._value(f"cam_a_{key}").formula(omega**2 * self._var(f"cam_S2_{key}"))

    # ------------------------------------------------------------ parts

    @property
    def _rolls(self) -> bool:
        return bool(self.found.cam.roller)

    def _to_roller(self, radius: Expr) -> Expr:
        """From the centre of an arc to the roller's, or the edge."""
        return radius + self._var("cam_roller") if self._rolls else radius

    def _leaning(self) -> Expr:
        """Sine of the angle of the normal to the first one where flank and nose meet."""
        sizes = (
            self._var("cam_distance"),
            self._var("cam_half_angle"),
            self._var("cam_flank"),
            self._var("cam_nose"),
        )
        c, half, flank, nose = sizes
        return c * sin(half) / (flank - nose)

    def _flank_angle(self) -> Expr:
        c, half, base = self._var("cam_distance"), self._var("cam_half_angle"), self._var("cam_base")
        if self.law.outline.straight:
            return arctan(c * sin(half) / self._to_roller(base))
        turned = arcsin(self._leaning())
        if self.found.cam.flat:
            return turned
        flank = self._var("cam_flank")
        far = self._to_roller(flank)
        return arctan(far * sin(turned) / (far * cos(turned) - (flank - base)))

    def _flank(self, theta: Expr) -> tuple[Expr, Expr, Expr]:
        base = self._var("cam_base")
        if self.law.outline.straight:
            far = self._to_roller(base)
            return (
                far * (1 / cos(theta) - 1),
                far * sin(theta) / cos(theta) ** 2,
                far * (2 - cos(theta) ** 2) / cos(theta) ** 3,
            )
        away = self._var("cam_flank") - base
        if self.found.cam.flat:
            return away * (1 - cos(theta)), away * sin(theta), away * cos(theta)
        far = self._to_roller(self._var("cam_flank"))
        root = sqrt(far**2 - away**2 * sin(theta) ** 2)
        return (
            root - away * cos(theta) - self._to_roller(base),
            away * sin(theta) - away**2 * sin(2 * theta) / (2 * root),
            away * cos(theta)
            - away**2 * cos(2 * theta) / root
            - away**4 * sin(2 * theta) ** 2 / (4 * root**3),
        )

    def _start(self) -> Expr:
        base = self._var("cam_base")
        if self.law.outline.straight:
            return self._to_roller(base)
        away = self._var("cam_flank") - base
        return away if self.found.cam.flat else away * (1 - away / self._to_roller(self._var("cam_flank")))

    def _nose(self, left: Expr) -> Expr:
        """Second derivative so far before the tip."""
        c = self._var("cam_distance")
        if self.found.cam.flat:
            return -(c * cos(left))
        far = self._to_roller(self._var("cam_nose"))
        root = sqrt(far**2 - c**2 * sin(left) ** 2)
        return -(c * cos(left) + c**2 * cos(2 * left) / root + c**4 * sin(2 * left) ** 2 / (4 * root**3))

    def _apex(self) -> Expr:
        c = self._var("cam_distance")
        return -c if self.found.cam.flat else -(c * (1 + c / self._to_roller(self._var("cam_nose"))))

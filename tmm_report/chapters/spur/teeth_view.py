"""View of the drawings of a spur pair: the mesh and what is read off it, zones of contact, blocking contour."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.spur import contour as blocking
from tmm_report.chapters.spur.mesh import READ, Mesh, Reading, mesh_of
from tmm_report.chapters.spur.solve import Found
from tmm_report.figures.blocking import contour
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.gearing import mesh_drawing
from tmm_report.figures.zones import zones
from tmm_report.mechanics.blocking import Lack
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula, Number, Var
from tmm_report.quantity.symbols import Symbol, segment
from tmm_report.report.layout import Table, worded
from tmm_report.report.page import Page

PAIRS = (N_("no pair"), N_("one pair"), N_("two pairs"), N_("three pairs"), N_("four pairs"))
LACKS = {
    "undercut": N_(
        "undercut of wheel %(wheel)s: the shift %(value)s is less than the least one %(bound)s by %(lack)s"
    ),
    "pointing": N_(
        "pointing of wheel %(wheel)s: the thickness of the tip is %(value)s m and must be at least %(bound)s m, "
        "%(lack)s m is wanting"
    ),
    "ratio": N_("smoothness: the contact ratio %(value)s is less than %(bound)s by %(lack)s"),
    "interference": N_(
        "interference at the root of wheel %(wheel)s: the active profile reaches %(lack)s m along the line of action "
        "beyond the end of the involute"
    ),
    "fouling": N_("the tips of the ring and the pinion overlap by %(degrees)s°"),
}
NONE = N_("wheels with such shifts cannot be put in mesh")
STUCK = N_("the tips of the ring and the pinion cannot pass each other")  # their overlap has no measure


class TeethView:
    """Pictures and readings of one pair; `label` begins the labels of its figures."""

    def __init__(self, found: Found, page: Page, label: str):
        self.found, self.page, self.label = found, page, label
        self.t, self.names = page.t, found.given.wheels
        self.wheel = 1 - found.teeth.small  # the larger: its angles are read off

    def num(self, value: float) -> str:
        return self.page.num(value, 4)

    # ------------------------------------------------------------ the mesh

    @property
    def mesh(self) -> Mesh:
        return mesh_of(self.found)

    @property
    def scale(self) -> str:
        """The scale of the drawing: 2:1, 1:2.5."""
        k = self.mesh.scale
        return f"{self.page.num(k)}:1" if k >= 1 else f"1:{self.page.num(1 / k)}"

    def drawing(self) -> Drawing:
        return mesh_drawing(self.mesh, self.names, self.num, str(self.t("Gear pair in mesh")))

    def zones(self) -> Drawing:
        return zones(self.mesh, self.num, self._pairs, str(self.t("Zones of contact")))

    def _pairs(self, count: int) -> str:
        return self.page.tr.gettext(PAIRS[count]) if count < len(PAIRS) else str(count)

    # ------------------------------------------------------------ what is read off

    @property
    def accuracy(self) -> str:
        return self.page.num(READ)

    def readings(self, caption: Any) -> Table:
        """Every value read off the drawing beside the computed one, with the difference in per cent."""
        rows = [
            [
                self._sign(r),
                self._measure(r, r.drawn),
                self._measure(r, r.computed),
                self.page.num(100 * r.error, places=3),
            ]
            for r in self.mesh.readings
        ]
        heads = [self.t("Value"), self.t("By the drawing"), self.t("Computed"), self.t("Difference, %%")]
        return worded(caption, heads, rows, (4, 3, 3, 3))

    def _sign(self, r: Reading) -> Markup:
        if r.wheel is None:
            return self.page.listed([self.page.sym(segment(r.key)), self.page.unit("mm")])
        bases = {"angle": ("phi", "gamma"), "pitch": ("tau", ""), "ratio": ("epsilon", "alpha")}
        base, sub = bases[r.key]
        if r.key == "ratio":
            symbols = [
                self.page.sym(Symbol(b, s + self.names[r.wheel])) for b, s in (bases["angle"], bases["pitch"])
            ]
            return self.page.listed(
                [self.page.sym(Symbol(base, sub)), " = ", symbols[0], "/", symbols[1]], ""
            )
        return self.page.sym(Symbol(base, sub + self.names[r.wheel]))

    def _measure(self, r: Reading, value: float) -> str:
        if r.wheel is None:
            return self.page.num(1e3 * value, places=2)
        return (
            self.page.num(value, 5)
            if r.key == "ratio"
            else self.page.num(math.degrees(value), places=3) + "°"
        )

    def graph_ratio(self) -> Formula:
        """The contact ratio read off the drawing."""
        angle, pitch = (self._reading(key) for key in ("angle", "pitch"))
        above = Var(Symbol("phi", "gamma" + self.names[self.wheel]), angle.drawn, "deg")
        below = Var(Symbol("tau", self.names[self.wheel]), pitch.drawn, "deg")
        return Formula("epsilon_gr", above / below)

    def difference(self) -> Formula:
        """By how many per cent it differs from the computed one."""
        ratio = self._reading("ratio")
        drawn, computed = (
            Var("epsilon_gr", ratio.drawn, digits=5),
            Var("epsilon_alpha", ratio.computed, digits=5),
        )
        return Formula("delta", abs(drawn - computed) / computed * Number(100), "%", digits=2)

    def _reading(self, key: str) -> Reading:
        return next(r for r in self.mesh.readings if r.key == key and r.wheel == self.wheel)

    # ------------------------------------------------------------ proof by the outlines

    @property
    def proof(self) -> dict[str, str]:
        """Overlap, mm², clearance, mm, and contact ratio of the drawn outlines over a pitch, printed."""
        found = self.mesh.proof
        return {
            "overlap": self.page.num(1e6 * found.overlap, 3, scale=1e3),
            "clearance": self.page.num(1e3 * found.clearance, 2, scale=1e6),
            "ratio": self.num(found.ratio),
        }

    @property
    def apart(self) -> bool:
        """Whether the outlines share no area but that of rounding."""
        return self.mesh.proof.overlap < 1e-6 * self.found.pair.m**2

    # ------------------------------------------------------------ the blocking contour

    @cached_property
    def contour_found(self) -> blocking.Found:
        return blocking.solve(self.found)

    def contour(self) -> Drawing:
        return contour(self.contour_found, self.names, self.num, str(self.t("Blocking contour")))

    def lacks(self) -> list[Markup]:
        return [self._lack(lack) for lack in self.contour_found.lacks]

    def _lack(self, lack: Lack) -> Markup:
        if math.isnan(lack.lack):
            return self.t(NONE)
        if math.isinf(lack.lack) and lack.limit.kind == "fouling":
            return self.t(STUCK)
        number: Callable[[float], str] = lambda x: self.page.num(x, places=4)  # noqa: E731
        return self.t(
            LACKS[lack.limit.kind],
            wheel=self.names[lack.limit.wheel - 1],
            value=number(lack.value),
            bound=number(lack.limit.bound),
            lack=number(lack.lack),
            degrees=number(math.degrees(lack.lack)),
        )

    def point(self, x: complex) -> Markup:
        """The shifts of a point of the contour."""
        shifts = zip(self.names, (x.real, x.imag), strict=True)
        return self.page.listed(self.page.value(Symbol("x", name), value) for name, value in shifts)

    def margin(self, x: complex) -> str:
        """How far the shifts would be changed."""
        return self.page.num(abs(x - self.contour_found.chosen), places=4)

"""View of the forces in the teeth of wheels and racks within the mechanism."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.quantities import wheels as own
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.structure.quantities import pitch_radius
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.quantity.formula import Formula, cos
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table
from tmm_report.report.part import Part


def parts(found: Kinetostatics, position: int, page: Page) -> Iterator[Part]:
    if own.toothed(found):
        yield Part("lever/kinetostatics/wheels", WheelsView(found, position, page), concludes=False)
    if own.rolling(found):
        yield Part("lever/kinetostatics/rolling", RollingView(found, position, page), concludes=False)


class WheelsView(BookView):
    def __init__(self, found: Kinetostatics, position: int, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.position = found, position
        self.wheels = own.toothed(found)

    def conclusions(self) -> Sequence[Markup]:
        return []

    def formulas(self, wheel: Coupled) -> list[Formula]:
        """Tangential force by the moment about the axis (not of a rack that is driven), and that along the line of
        action, at the sample position."""
        mesh, table, k = wheel.mesh, self.table("mesh_table"), self.position
        tangential = own.force_of(mesh, "t").key
        made = []
        if not wheel.slides:
            made.append(self._tangential(wheel, "mesh_table"))
        angle = self.value(own.engagement_of(mesh).key).var()
        made.append(table.formula(own.force_of(mesh, "n").key, k, table.var(tangential, k) / cos(angle)))
        return made

    def _tangential(self, wheel: Coupled, name: str) -> Formula:
        """|M| / r."""
        mesh, table, k = wheel.mesh, self.table(name), self.position
        radius = pitch_radius(self.found.kinematics.linkage, mesh, wheel.link)
        arm = radius.value(mesh.radius(wheel.link)).var()
        moment = table.var(own.moment_of(mesh, wheel.link).key, k)
        return table.formula(own.force_of(mesh, "t").key, k, abs(moment) / arm)

    def said(self, wheel: Coupled) -> list[dict[str, Any]]:
        return self.page.where(*self.formulas(wheel))

    def forces(self, caption: Any) -> Table:
        """Sizes of the forces and their moments about the axes."""
        keys: list[str] = []
        for wheel in self.wheels:
            mesh = wheel.mesh
            keys += [own.force_of(mesh, part).key for part in "tn"]
            keys += [own.moment_of(mesh, link).key for link in mesh.links if mesh.radius(link)]
        return self.by_positions(caption, "mesh_table", keys)


class RollingView(WheelsView):
    """Of the wheels that roll on rails."""

    def __init__(self, found: Kinetostatics, position: int, page: Page):
        super().__init__(found, position, page)
        self.wheels = own.rolling(found)

    def formulas(self, wheel: Coupled) -> list[Formula]:
        """Friction by the moment about the axis, and the coefficient that it needs, at the sample position."""
        mesh, table, k = wheel.mesh, self.table("rolling_table"), self.position
        made = [self._tangential(wheel, "rolling_table")]
        if self._normal(wheel)[k] > 0:
            friction, normal = (
                table.var(of.key, k) for of in (own.force_of(mesh, "t"), own.pressing_of(mesh))
            )
            made.append(table.formula(own.needed_of(mesh).key, k, friction / normal))
        return made

    def _normal(self, wheel: Coupled) -> Any:
        return own.normal_of(wheel, self.found.table)

    def lifted(self, wheel: Coupled) -> list[int]:
        """The positions at which the rail would have to pull the wheel."""
        normal = self._normal(wheel)[: self.found.positions]
        return [k for k, one in enumerate(normal) if one < 0]

    def most(self, wheel: Coupled) -> Markup | None:
        """The greatest coefficient of friction that it needs; None where it is pressed on the rail nowhere."""
        key = own.most_needed_of(wheel.mesh).key
        return self.sized(key) if self.knows(key) else None

    def forces(self, caption: Any) -> Table:
        keys: list[str] = []
        for wheel in self.wheels:
            of = wheel.mesh
            keys += [one.key for one in (own.force_of(of, "t"), own.pressing_of(of), own.needed_of(of))]
            keys.append(own.moment_of(of, wheel.link).key)
        return self.by_positions(caption, "rolling_table", keys)

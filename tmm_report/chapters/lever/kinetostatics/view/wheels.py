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
    if own.coupled_of(found):
        yield Part("lever/kinetostatics/wheels", WheelsView(found, position, page), concludes=False)


class WheelsView(BookView):
    def __init__(self, found: Kinetostatics, position: int, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.position = found, position
        self.wheels = own.coupled_of(found)

    def conclusions(self) -> Sequence[Markup]:
        return []

    def formulas(self, wheel: Coupled) -> list[Formula]:
        """Tangential force by the moment about the axis (not of a rack that is driven), and that along the line of
        action, at the sample position."""
        mesh, table, k = wheel.mesh, self.table("mesh_table"), self.position
        tangential = own.force_of(mesh, "t").key
        made = []
        if not wheel.slides:
            radius = pitch_radius(self.found.kinematics.linkage, mesh, wheel.link)
            arm = radius.value(mesh.radius(wheel.link)).var()
            moment = table.var(own.moment_of(mesh, wheel.link).key, k)
            made.append(table.formula(tangential, k, abs(moment) / arm))
        angle = self.value(own.engagement_of(mesh).key).var()
        made.append(table.formula(own.force_of(mesh, "n").key, k, table.var(tangential, k) / cos(angle)))
        return made

    def said(self, wheel: Coupled) -> list[dict[str, Any]]:
        return self.page.where(*self.formulas(wheel))

    def at_axis(self, wheel: Coupled) -> bool:
        """Whether the force in the teeth acts along the common tangent of the circles."""
        return wheel.mesh.pressure == 0

    def forces(self, caption: Any) -> Table:
        """Sizes of the forces and their moments about the axes."""
        keys: list[str] = []
        for wheel in self.wheels:
            mesh = wheel.mesh
            keys += [own.force_of(mesh, part).key for part in "tn"]
            keys += [own.moment_of(mesh, link).key for link in mesh.links if mesh.radius(link)]
        return self.by_positions(caption, "mesh_table", keys)

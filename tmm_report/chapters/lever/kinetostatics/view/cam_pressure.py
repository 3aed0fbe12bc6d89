"""View of how hard the cams press their followers, and where a closure has to hold them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.kinetostatics.quantities import cam_pressure as own
from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.quantities.cycle import ranges
from tmm_report.chapters.lever.kinetostatics.solve.cam_pressure import Pressing
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.problems import N_
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table
from tmm_report.report.part import Failed, Part


def parts(found: Kinetostatics, page: Page) -> Iterator[Part]:
    if found.pressings:
        yield Part("lever/kinetostatics/cams", PressingsView(found, page))


class PressingsView(BookView):
    def __init__(self, found: Kinetostatics, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.cams = found, found.pressings

    def conclusions(self) -> Sequence[Markup]:
        """Of cams that their followers would leave."""
        text = N_(
            "Cam %(cam)s does not hold follower %(follower)s everywhere: a closure by a spring or by a groove is "
            "needed, which holds at least %(force)s N along the normal."
        )
        return [
            Failed(self.t(text, cam=one.cam.cam, follower=one.cam.follower, force=self.closure(one)))
            for one in self.cams
            if one.parts
        ]

    def along_normals(self, caption: Any) -> Table:
        """The reactions along the normals by positions."""
        return self.by_positions(caption, "cam_press_table", [own.along(one).key for one in self.cams])

    def parting(self, one: Pressing) -> str:
        """Positions in which the follower would leave the cam: "1–4, 9"."""
        return ranges(one.parting)

    def zones(self, one: Pressing) -> Markup:
        """From and to which angles it would: "36.1–90°; 140–152.3"."""
        table = self.table(f"cam_parting_{one.cam.name}")
        ends = [
            [self.page.said(self.page.cell(table, key, row, places=1)) for key in ("from", "to")]
            for row in range(len(one.zones))
        ]
        return self.page.listed([self.page.listed(two, "–") for two in ends], "°; ")

    def closure(self, one: Pressing) -> Markup:
        return self.number(f"cam_closure_{one.cam.name}")

    def extreme(self, one: Pressing, end: str) -> Markup:
        """ "min" or "max"."""
        return self.number(f"cam_press_{end}_{one.cam.name}")

    def extreme_at(self, one: Pressing, end: str) -> Markup:
        """The angle of turn of an extreme, degrees."""
        return self.turned(f"cam_press_{end}_{one.cam.name}")

"""Singular positions in the note: a table of how near the groups come to them, and sentences about those there are."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.kinematics.limits import Closest
from tmm_report.chapters.kinematics.solve import digits_left
from tmm_report.problems import N_, Message
from tmm_report.report.columns import Columns
from tmm_report.report.layout import Table, worded


class SpecialTables(Columns):
    def drivers(self, caption: Any) -> Table:
        """What the groups become when another link drives."""
        rows = []
        for other in self.r.structure.alternatives:
            if other.structure is None:
                rows.append([other.link, self._sentence(other.reason), "—"])
            else:
                formula = self.words.formula(other.structure)
                rows.append([other.link, formula, self.words.roman(other.structure.mechanism_class)])
        heads = [self.t("Driving link"), self.t("Structural formula"), self.t("Class")]
        return worded(caption, heads, rows, (2, 8, 2))

    def closeness(self, caption: Any) -> Table:
        """Of every group the least closeness over the cycle, where it is reached and what it costs."""
        rows = [
            [
                self.words.label(c.group),
                self.t("sine of the transmission angle")
                if c.is_dyad
                else self.t("least singular value of the scaled Jacobian"),
                self.page.num(c.closeness.value, 4, scale=1.0),
                self.words.degrees(c.closeness.turned),
                str(int(digits_left(c.closeness.value))),
            ]
            for c in self.r.kinematics.closest
        ]
        heads = [
            self.t("Group"),
            self.t("Measure"),
            self.t("Least value"),
            self.t("At the angle of turn, °"),
            self.t("Digits that remain"),
        ]
        return worded(caption, heads, rows, (3, 6, 2, 2, 2))

    def dead(self, caption: Any) -> Table:
        """Dead points of the output links."""
        rows = []
        for dead in self.r.kinematics.dead:
            lines = dict(zip(dead.turned, dead.in_line, strict=True))
            for turned, pair in lines.items():
                words = (
                    self.t("links %(one)s and %(other)s in one line", one=pair[0], other=pair[1])
                    if pair
                    else "—"
                )
                rows.append([dead.output, self._exact(turned), words])
        heads = [self.t("Output link"), self.t("Angle of turn, °"), self.t("Position of the links")]
        return worded(caption, heads, rows, (2, 2, 6))

    def sentences(self) -> list[Markup]:
        """What is to be said of limits, change points and parallel guides."""
        found = [self._sentence(gap.text) for gap in self.r.kinematics.gaps]
        return found + [text for c in self.r.kinematics.closest for text in self._singular(c)]

    def _singular(self, c: Closest) -> Iterator[Markup]:
        group = self.words.label(c.group)
        links = ", ".join(c.links)
        passed = tuple(x for x in c.changes if x not in c.corners)
        if passed:
            text = N_(
                "at the angle of turn φ = %(angles)s group %(group)s (links %(links)s) passes a change point: "
                "its two assemblies meet and two continuations exist; the stated assembly is kept and the motion "
                "goes on smoothly. Velocities and accelerations there are the limits of those beside it; reactions "
                "grow without bound and are left out"
            )
            yield self.t(text, group=group, links=links, angles=self._angles(passed))
        if c.corners:
            text = N_(
                "at the angle of turn φ = %(angles)s group %(group)s (links %(links)s) is in a change point in which "
                "its two assemblies meet, and is kept in the stated one: gone through smoothly, it would begin the "
                "next turn in the other. Velocities there have no limit"
            )
            yield self.t(text, group=group, links=links, angles=self._angles(c.corners))
        if c.parallel:
            text = N_(
                "at the angle of turn φ = %(angles)s the guides of group %(group)s (links %(links)s) are parallel "
                "and its links run away"
            )
            yield self.t(text, group=group, links=links, angles=self._angles(c.parallel))
        if c.limits:
            text = N_(
                "at the angle of turn φ = %(angles)s group %(group)s (links %(links)s) is at the limit of its "
                "assembly; velocities there are not bounded"
            )
            yield self.t(text, group=group, links=links, angles=self._angles(c.limits))

    def _angles(self, turned: tuple[float, ...]) -> str:
        return ", ".join(f"{self._exact(x)}°" for x in turned)

    def _exact(self, turned: float) -> str:
        """An angle found by root finding, rad, in degrees to a thousandth."""
        return self.words.page.num(float(turned) * 57.29577951308232, places=3)

    def _sentence(self, message: Message) -> Markup:
        """A message with its numbers in the note's decimal sign."""
        text = message.render(self.page.tr.gettext)
        return self.page.text(re.sub(r"(?<=\d)\.(?=\d)", self.page.tr.decimal, text))

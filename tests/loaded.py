"""Loads that have a law and nothing else, for tests of laws."""

from __future__ import annotations

from tmm_report.chapters.lever.kinetostatics.given import Force, Moment
from tmm_report.mechanics.calculus.laws import Law


def loaded(law: Law, at: str | None = "B", on: str = "1") -> Force | Moment:
    """A force at a point, or a moment on a link."""
    load: Force | Moment = Moment(on=on, direction=1, constant=0.0)
    if at is not None:
        load = Force(at=at, direction=1 + 0j, constant=0.0)
    vars(load)["law"] = law  # in the place of the one that its keys state
    return load

"""The title page: what is written on it."""

from __future__ import annotations

from tmm_report.records import dataclass


@dataclass(frozen=True)
class Title:
    """The title page; empty fields are left out of it."""

    institution: str = ""
    department: str = ""
    course: str = ""
    topic: str = ""
    student: str = ""
    group: str = ""
    variant: str = ""
    teacher: str = ""
    city: str = ""
    year: str = ""

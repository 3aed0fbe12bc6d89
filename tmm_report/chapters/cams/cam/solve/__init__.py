"""A cam that stands alone, and what it shares with the cam pairs of a lever mechanism."""

from tmm_report.chapters.cams.cam.given import Given
from tmm_report.chapters.cams.cam.solve.alone import Found, solve

__all__ = ["Found", "Given", "solve"]

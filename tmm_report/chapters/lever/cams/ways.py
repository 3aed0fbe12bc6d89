"""How the numbers of the cam pairs are found that no formula of the note defines."""

from tmm_report.chapters.cams.cam.ways import PAIRS as WAYS

__all__ = ["WAYS"]

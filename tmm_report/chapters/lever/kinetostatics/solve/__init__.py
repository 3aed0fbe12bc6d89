"""How the chapter is solved; the course asks for `solve`."""

from tmm_report.chapters.lever.kinetostatics.solve.positions import solve

__all__ = ["solve"]

"""How the chapter is solved; the course asks for `solve`."""

from tmm_report.chapters.gears.planetary.solve.stage import solve

__all__ = ["solve"]

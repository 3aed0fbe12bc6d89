"""How the chapter is solved; the course asks for `solve`."""

from tmm_report.chapters.gears.spur.solve.pair import solve

__all__ = ["solve"]

"""How the chapter is solved; the course asks for `solve`."""

from tmm_report.chapters.gears.eccentric.solve.mechanism import solve

__all__ = ["solve"]

"""How the chapter is solved; the course asks for `solve`."""

from tmm_report.chapters.machine.governor.solve.whole import solve

__all__ = ["solve"]

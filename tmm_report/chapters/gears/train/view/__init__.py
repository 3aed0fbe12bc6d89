"""How a compound gear train is printed."""

from tmm_report.chapters.gears.train.view.train import parts, picture

__all__ = ["parts", "picture"]

"""What the note prints of the chapter; it asks for the parts."""

from tmm_report.chapters.gears.planetary.view.stage import parts

__all__ = ["parts"]

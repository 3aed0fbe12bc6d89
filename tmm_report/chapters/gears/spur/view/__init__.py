"""What the note prints of the chapter; it asks for the parts."""

from tmm_report.chapters.gears.spur.view.pair import parts

__all__ = ["parts"]

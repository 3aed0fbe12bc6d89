"""What the note prints of the chapter; it asks for the parts."""

from tmm_report.chapters.gears.eccentric.view.mechanism import parts, picture

__all__ = ["parts", "picture"]

"""What the note prints of the chapter; it asks for the parts."""

from tmm_report.chapters.machine.balancing.view.whole import parts

__all__ = ["parts"]

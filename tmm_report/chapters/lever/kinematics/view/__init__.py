"""What the note prints of the chapter; it asks for the parts."""

from tmm_report.chapters.lever.kinematics.view.positions import parts

__all__ = ["parts"]

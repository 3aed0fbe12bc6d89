"""What the note prints of the chapter; it asks for the parts."""

from tmm_report.chapters.lever.kinetostatics.view.positions import given_parts, parts

__all__ = ["given_parts", "parts"]

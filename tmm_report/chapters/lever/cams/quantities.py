"""The numbers of the cam pairs of a lever mechanism: those of any cam, by the names of the pairs."""

from tmm_report.chapters.cams.cam.quantities import cad_outlines, tables, values

__all__ = ["cad_outlines", "tables", "values"]

"""Every number of the chapter; results, grading and checks ask for `tables` and `values`."""

from tmm_report.chapters.lever.kinetostatics.quantities.positions import headline, tables, values

__all__ = ["headline", "tables", "values"]

"""Every number of the chapter; results, grading and checks ask for `tables` and `values`."""

from tmm_report.chapters.gears.eccentric.quantities.mechanism import SOUGHT, tables, values

__all__ = ["SOUGHT", "tables", "values"]

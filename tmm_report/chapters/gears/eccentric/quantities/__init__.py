"""Every number of the chapter; results, grading and checks ask for `tables` and `values`."""

from tmm_report.chapters.gears.eccentric.quantities.mechanism import HEADLINE, tables, values

__all__ = ["HEADLINE", "tables", "values"]

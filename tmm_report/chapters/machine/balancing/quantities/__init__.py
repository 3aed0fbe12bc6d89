"""Every number of the chapter; results, grading and checks ask for `tables` and `values`."""

from tmm_report.chapters.machine.balancing.quantities.whole import tables, values

__all__ = ["tables", "values"]

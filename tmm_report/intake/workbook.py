"""XLSX workbooks from outside -> rows of text. Read as streams of XML events under budgets, not by a library.

Libraries build what the file asks for: a row of five million cells, a million strings, a rectangle up to a far
cell. Here a part is walked once, and what lies beyond the limits is passed over.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from tmm_report.intake.parts import Parts
from tmm_report.intake.readers import Grid, Limits, Strings, Styles, clean
from tmm_report.problems import N_, Problem, ProblemError, shown

__all__ = ["Limits", "Worksheet", "worksheets"]

Worksheet = tuple[str, str, list[tuple[int, list[str]]], list[Problem]]


def worksheets(label: str, content: bytes, limits: Limits) -> Iterator[Worksheet]:
    """Title, label for messages, (row number, cells) of the rows that are not blank, and notes, of each worksheet
    with a cell.

    A formula stands for the value stored with it. Raises ProblemError for what is no workbook, too large, or has a
    document type.
    """
    parts = Parts(label, content)
    book = parts.main()
    targets = parts.relations(book)
    styles, strings = Styles(), Strings(limits.characters)
    parts.walk(_of_kind(targets, "/styles"), styles)
    parts.walk(_of_kind(targets, "/sharedStrings"), strings)
    sheets = parts.attributes(book, "sheet")
    if len(sheets) > limits.sheets:
        raise parts.refused(N_("the workbook has more than %(limit)s sheets"), limit=limits.sheets)
    for sheet in sheets:
        kind, path = targets.get(sheet.get("r:id") or sheet.get("id", ""), ("", ""))
        if kind.endswith("/worksheet"):
            title = clean(sheet.get("name", ""))[: limits.characters]
            grid = Grid(f"{label}!{shown(title)}", strings.found, styles.dates, limits)
            parts.walk(path, grid)
            if grid.faults:
                raise ProblemError(grid.faults)
            if grid.cells:
                yield title, grid.label, grid.lines(), grid.notes


def _of_kind(relations: Mapping[str, tuple[str, str]], kind: str) -> str:
    return next((path for type_, path in relations.values() if type_.endswith(kind)), "")

"""The tables as Markdown, put between marks of a page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from benchmarks.failures.judge import NONE, Cell

Rows = Mapping[str, Mapping[str, Cell]]  # scene's title -> column -> cell


def table(rows: Rows, columns: Mapping[str, str], first: str = "scene") -> str:
    """`columns`: key -> head."""
    lines = [_row([first, *columns.values()]), _row(["---"] * (len(columns) + 1))]
    for title, cells in rows.items():
        lines.append(_row([title, *(cells[key].short if key in cells else NONE for key in columns)]))
    return "\n".join(lines)


def said(rows: Mapping[str, tuple[Cell, Sequence[str]]]) -> str:
    """What the program finds and says, scene by scene."""
    lines = [_row(["scene", "numbers", "the sentences of console and note"]), _row(["---"] * 3)]
    for title, (cell, sentences) in rows.items():
        lines.append(_row([title, cell.text, "; ".join(sentences) or NONE]))
    return "\n".join(lines)


def counts(rows: Rows, columns: Mapping[str, str]) -> dict[str, dict[str, int]]:
    """Column -> verdict -> in how many scenes."""
    found: dict[str, dict[str, int]] = {}
    for cells in rows.values():
        for key in columns:
            if key in cells:
                of = found.setdefault(key, {})
                of[cells[key].verdict] = of.get(cells[key].verdict, 0) + 1
    return found


def _row(cells: Sequence[str]) -> str:
    return "| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in cells) + " |"


def put(page: Path, tables: Mapping[str, str]) -> None:
    """Replace what stands between `<!-- name -->` and `<!-- end of name -->`."""
    text = page.read_text("utf-8")
    for name, new in tables.items():
        start, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
        before, rest = text.split(start, 1)
        text = before + start + "\n" + new + "\n" + end + rest.split(end, 1)[1]
    page.write_text(text, "utf-8")

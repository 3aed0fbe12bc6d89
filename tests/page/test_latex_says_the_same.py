"""The LaTeX note says what the HTML note says: every cell of every table, every formula, letter by letter."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest

import latex
import pytest
from note import Note
from reading import BOTH, html, tex, wrong


def other_cells(note: Note, text: str) -> Iterator[str]:
    for table, rows in zip_longest(note.tables, latex.tables(text)):
        if table is None or rows is None:
            yield f"one table too many: {table.where if table else rows[0]}"
            continue
        ours = [list(map(latex.alike, (head.text for head in table.heads)))]
        ours += [[latex.seen(cell.node) for cell in row] for row in table.rows]
        for k, (one, other) in enumerate(zip_longest(ours, rows)):
            if one != other:
                yield f"{table.where}, row {k}: {one}, in LaTeX {other}"


def other_formulas(note: Note, text: str) -> Iterator[str]:
    ours = [box for box in note.root.iter("div") if box.get("class") == "math"]
    for box, found in zip_longest(ours, latex.formulas(text)):
        said = None if box is None else latex.seen(box)
        if said != found:
            yield f"{said}, in LaTeX {found}"


@pytest.mark.parametrize(("name", "other"), BOTH)
def test_tables_are_the_same(name, other):
    wrong(list(other_cells(html(name, other), tex(name, other))))


@pytest.mark.parametrize(("name", "other"), BOTH)
def test_formulas_are_the_same(name, other):
    wrong(list(other_formulas(html(name, other), tex(name, other))))


def test_there_is_something_to_compare():
    name, other = BOTH[0]
    text = tex(name, other)
    assert len(latex.tables(text)) > 2 and len(latex.formulas(text)) > 5


def test_a_difference_is_told():
    name, other = BOTH[0]
    note, text = html(name, other), tex(name, other)
    cell = next(row[0] for row in reversed(note.tables[0].rows)).text
    assert cell
    head, table = text.split("\\begin{NoteTable}", 1)
    changed = head + "\\begin{NoteTable}" + table.replace(" \\\\ \\hline", "1 \\\\ \\hline", 2)
    assert list(other_cells(note, changed)) != list(other_cells(note, text))

"""docs/notebook.ipynb is run cell by cell, and gives what stands in it."""

from __future__ import annotations

import ast
import json
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
CELLS = json.loads((ROOT / "docs" / "notebook.ipynb").read_text("utf-8"))["cells"]
CODE = [cell for cell in CELLS if cell["cell_type"] == "code"]


def run(source: str, names: dict[str, Any]) -> Any:
    """A cell run as Jupyter does: the value of its last line, where that is an expression."""
    tree = ast.parse(source)
    *before, last = tree.body
    if not isinstance(last, ast.Expr):
        exec(compile(tree, "cell", "exec"), names)
        return None
    exec(compile(ast.Module(before, []), "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names)


def stored(cell: dict[str, Any], kind: str) -> str | None:
    return next(("".join(one["data"][kind]) for one in cell["outputs"] if kind in one["data"]), None)


@pytest.mark.parametrize("tables", [True, False], ids=["with pandas", "without"])
def test_the_notebook_runs_and_gives_what_stands_in_it(monkeypatch, tables):
    if tables:
        pytest.importorskip("pandas")
    else:
        monkeypatch.setitem(sys.modules, "pandas", None)
    monkeypatch.chdir(ROOT)
    names: dict[str, Any] = {}
    shown = 0
    for cell in CODE:
        source = "".join(cell["source"])
        if not tables and ".table(" in source:
            with pytest.raises(ImportError, match="pip install pandas"):
                run(source, names)
            continue
        value = run(source, names)
        assert value is not None and repr(value) == stored(cell, "text/plain"), source
        html = stored(cell, "text/html")
        if html is not None and not hasattr(value, "columns"):  # that of a DataFrame is pandas' own
            assert value._repr_html_() == html
            shown += 1
    assert shown and len(CODE) > 8


def test_the_notebook_has_one_of_everything():
    """What a first hour needs, each shown once at least."""
    text = "\n".join("".join(cell["source"]) for cell in CODE)
    assert all(
        one in text for one in ("load(", "solve(", "sweep(", ".unit", ".table(", ".figure(", ".failed")
    )

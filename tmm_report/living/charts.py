"""Diagrams over the cycle as the script goes along them: where the cursor is, and the values of the curves there."""

from __future__ import annotations

from collections.abc import Container, Mapping
from typing import Any

import numpy as np

from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Label, Parts, Symbol
from tmm_report.i18n import Translator
from tmm_report.living.cycle import Positions, numbers
from tmm_report.quantity.text import unit_text

Array = Any
DIGITS = 5
NEAR = 1e-6  # degrees
SAME = 1e-9  # of the largest value


def cursors(
    pictures: Mapping[str, Drawing | Graph], cycle: Positions, tr: Translator, shown: Container[str]
) -> dict[str, Any]:
    """`shown`: keys of the columns that are told anyway."""
    found, columns = {}, _Columns(cycle, shown)
    for anchor, picture in pictures.items():
        if isinstance(picture, Graph) and over_the_cycle(picture, cycle):
            found[anchor] = _cursor(picture, cycle, columns, tr)
    return found


class _Columns:
    """The columns of the positions, of which curves may be."""

    def __init__(self, cycle: Positions, shown: Container[str]):
        self.names, rows = list[str](), list[Array]()
        for name, one, other in cycle.told(shown):
            self.names.append(f"{name}.{one.key}")
            rows.append(cycle.values(one, other))
        self.rows = np.array(rows).reshape(len(rows), len(cycle.turned))

    def same(self, values: Array) -> str | None:
        """The name of the column that has these values."""
        near = SAME * np.nanmax(np.abs(values), initial=0.0)
        both = np.isnan(self.rows) & np.isnan(values)
        found = np.flatnonzero((both | (np.abs(self.rows - values) <= near)).all(axis=1))
        return self.names[found[0]] if len(found) else None


def over_the_cycle(graph: Graph, cycle: Positions) -> bool:
    """Whether a diagram's axis is the angle turned, from the first position to the last."""
    label = graph.xlabel
    along = isinstance(label, Label) and label.of.base == "phi" and label.unit == "deg"
    ends = np.degrees(cycle.turned[[0, -1]])
    return along and bool(np.all(np.abs(ends - (graph.x[0], graph.x[-1])) <= NEAR))


def _cursor(graph: Graph, cycle: Positions, columns: _Columns, tr: Translator) -> dict[str, Any]:
    first = graph.panels[0]
    panels = [
        {
            "box": [round(x, 3) for x in (panel.bottom, panel.top, *panel.y)],
            "sign": _plain(label),
            "unit": unit_text(label.unit, tr.language) if isinstance(label, Label) else "",
            "curves": [_curve(curve, graph.x, cycle, columns) for curve, _ in graph.of(k)],
        }
        for k, (panel, label) in enumerate(zip(graph.panels, graph.ylabels, strict=True))
    ]
    return {"left": round(first.left, 3), "right": round(first.right, 3), "panels": panels}


def _curve(curve: Curve, x: Array, cycle: Positions, columns: _Columns) -> dict[str, Any]:
    """A curve has the positions among its points; at a jump it has what stands for the position. `values`: or the name
    of the column that has them."""
    at = np.degrees(cycle.turned)
    order = np.argsort(x, kind="stable")
    values = np.interp(at, x[order], curve.values[order])
    return {"name": _plain(curve.name), "values": columns.same(values) or numbers(values, DIGITS)}


def _plain(label: Parts | str) -> str:
    """A label as text; of an axis without its unit."""
    parts = (label,) if isinstance(label, str) else tuple(label)
    if isinstance(label, Label) and label.unit and len(parts) > 1:
        parts = parts[:-1]
    return "".join(p if isinstance(p, str) else _sign(p) for p in parts)


def _sign(part: Symbol) -> str:
    return part.base + part.sub + part.sup

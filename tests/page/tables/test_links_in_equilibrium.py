"""Every link is in equilibrium under the printed forces, and these are what printed masses and the motion make them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from note import Note
from pages import columns, rows_of, table_of
from reading import LINKAGES, html, results, wrong
from statics import scheme, unbalanced, weights


@pytest.mark.parametrize("name", LINKAGES)
def test_every_link_is_in_equilibrium(name):
    wrong(unbalanced(html(name), results(name), name))


def masses(note: Note) -> dict[str, tuple[float, float, float, float]]:
    """Mass and moment of inertia of each link as printed, each with its half unit."""
    table = next(rows_of(note, "m", "J"))
    at = {head.symbol: j for j, head in enumerate(table.heads)}
    found = {}
    for row in table.rows:
        m, j = row[at["m"]].printed, row[at["J"]].printed
        assert m is not None and j is not None
        # decimals are those of the whole column, to which its small numbers are rounded too
        dm, dj = (x.half if x.places == table.places(at[s]) > 0 else x.off for x, s in ((m, "m"), (j, "J")))
        found[row[0].text] = (m.value, dm, 0.0 if np.isnan(j.value) else j.value, dj)
    return found


def wrong_inertia(note: Note, document: dict[str, Any], name: str) -> Iterator[str]:
    drawn, rates, printed = scheme(name), table_of(document, "rates_table"), columns(note)
    for link, (m, dm, j, dj) in masses(note).items():
        centre = drawn.mass_centres.get(link)
        a = np.hypot(rates[f"a_{centre}_x"], rates[f"a_{centre}_y"]) if f"a_{centre}_x" in rates else None
        if f"F_I{link}" in printed and a is not None:
            column = printed[f"F_I{link}"][0][1]
            for k in np.flatnonzero(
                np.abs(column.values - m * a) > column.half * 1.01 + dm * a + 1e-9 * m * a.max()
            ):
                yield f"F_I{link}[{k}] is {column.values[k]:.6g}, m a is {m * a[k]:.6g}"
        if f"M_I{link}" in printed:
            column, e = printed[f"M_I{link}"][0][1], rates[f"e_{link}"]
            for k in np.flatnonzero(
                np.abs(column.values + j * e) > column.half * 1.01 + dj * np.abs(e) + 1e-9
            ):
                yield f"M_I{link}[{k}] is {column.values[k]:.6g}, -J e is {-j * e[k]:.6g}"


def wrong_weights(note: Note, name: str) -> Iterator[str]:
    gravity, found = scheme(name).gravity, weights(note)
    for symbol, weight in found.items():
        m, dm, *_ = masses(note)[symbol[2:]]
        if abs(weight.value - m * gravity) > weight.half + dm * gravity:
            yield f"{symbol} is {weight.value}, m g is {m * gravity:.6g}"
    if gravity and not found:
        yield "no weights are printed"


@pytest.mark.parametrize("name", LINKAGES)
def test_inertia_and_weights_follow_from_masses(name):
    wrong([*wrong_inertia(html(name), results(name), name), *wrong_weights(html(name), name)])

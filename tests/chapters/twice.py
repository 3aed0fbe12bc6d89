"""The single numbers of a chapter, each by a second way: what a `test_<chapter>_twice` names for every printed formula.

A formula is evaluated where it is printed, so print and result agree even where both are wrong; the second way shares
no expression with it: mechanics' own numpy, or another law.
"""

from collections.abc import Mapping

import numpy as np

from tmm_report.quantity.sheet import Sheet
from tmm_report.quantity.units import factor


def disagreements(s: Sheet, ways: Mapping[str, float | None], tolerance: float = 1e-9) -> list[str]:
    """Of the formulas that a sheet prints: those that no second way is named for, and those that it contradicts; of a
    formula with a number of its own, found more exactly, both are held. The second ways are in the units of the
    results, angles in radians."""
    told = []
    for key in (key for key in s.DECLARED if s.has_formula(key)):
        if ways.get(key) is None:
            told.append(f"{key}: no second way")
            continue
        formula, size = s.formula(key), abs(ways[key]) or 1.0
        of = s.declared(key)
        formed = factor(of.unit, of.formed) if of.formed not in ("", "deg") else 1.0
        for number in (s.var(key).number / formed, float(formula.value) / formed):
            if not np.isclose(number, ways[key], rtol=tolerance, atol=tolerance * min(size, 1.0)):
                told.append(f"{key}: {number!r}, by the second way {ways[key]!r}")
    return told

"""What the dimensions of a toothed wheel are called: the rows of the note's tables and of the results."""

from __future__ import annotations

from dataclasses import replace

from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol, math_symbol

DIAMETERS = {
    "d": N_("reference diameter"),
    "d_b": N_("base diameter"),
    "d_w": N_("working pitch diameter"),
    "d_f": N_("root diameter"),
    "d_a": N_("tip diameter"),
}
TEETH = {
    "height": N_("tooth depth"),
    "s": N_("tooth thickness on the reference circle"),
    "s_b": N_("tooth thickness on the base circle"),
    "s_w": N_("tooth thickness on the working pitch circle"),
    "s_a": N_("tooth thickness on the tip circle"),
}
OWN_SYMBOLS = {"height": Symbol("h")}  # that are not the keys


def dimension(key: str) -> Quantity:
    """A diameter, height or thickness by its key; m."""
    symbol = OWN_SYMBOLS.get(key) or math_symbol(key)
    return Quantity(key, symbol, "m", Message((DIAMETERS | TEETH)[key]))


def of_wheel(symbol: Symbol, wheel: str) -> Symbol:
    """The symbol with the wheel's number in its index: d_a of wheel 4 is d_a4."""
    return replace(symbol, sub=symbol.sub + wheel)

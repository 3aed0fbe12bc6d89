"""Printed text -> number with its error, and printed units: read as a reader reads them, by nothing of the program."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_NUMBER = re.compile(r"([−-]?)(\d+)(?:[.,](\d+))?(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+|\^-?\d+))?")
LEAST = (
    4  # significant digits that a number has at least where it is rounded; zeros at the end are not printed
)


class Printed(NamedTuple):
    """A printed number; `half`: half a unit of its last printed place; `places`: decimals."""

    value: float
    half: float
    places: int = 0
    digits: int = 0  # significant ones

    @property
    def off(self) -> float:
        """By how much the number that was rounded may differ: half a unit of the last printed place, but not more
        than that of the fourth significant digit, for zeros at the end are not printed."""
        return self._of_digit(LEAST) if self.value and math.isfinite(self.value) else self.half

    @property
    def result_off(self) -> float:
        """The same of a result, which may have been rounded to two decimals or more."""
        if self.value == 0 or self.digits > 3 or self.places > 1:
            return self.half
        return min(self.half, max(3e-3 * abs(self.value), 0.005))

    def _of_digit(self, digit: int) -> float:
        return min(self.half, 0.5 * 10 ** (math.floor(math.log10(abs(self.value))) - digit + 1))


def number(text: str) -> Printed | None:
    """The number that a text is, or None; "—" is nan, a number that does not exist."""
    text = text.strip().replace("\N{NO-BREAK SPACE}", " ").removeprefix("≈ ").strip()
    if text in ("—", "---", "–"):
        return Printed(math.nan, 0.0)
    if text in ("∞", "−∞"):
        return Printed(math.inf if text == "∞" else -math.inf, 0.0)
    match = _NUMBER.fullmatch(text)
    if match is None:
        return None
    sign, whole, decimals, power = match.groups()
    exponent = int(power.removeprefix("^").translate(_RAISED)) if power else 0
    places = len(decimals or "")
    digits = (whole + (decimals or "")).lstrip("0")
    value = float(f"{whole}.{decimals or 0}e{exponent}")
    unit = 10.0 ** (exponent - places)
    if not decimals and not power:  # 20650: of four digits or of five
        unit *= 10.0 ** max(0, min(len(digits) - LEAST, len(digits) - len(digits.rstrip("0"))))
    return Printed(-value if sign else value, unit / 2, places, len(digits))


# --- units ---

Dimension = tuple[int, int, int, int]  # metre, kilogram, second, radian

_UNITS: dict[str, tuple[float, Dimension]] = {}
for names, size, dimension in (
    ("m м", 1.0, (1, 0, 0, 0)),
    ("mm мм", 1e-3, (1, 0, 0, 0)),
    ("s с", 1.0, (0, 0, 1, 0)),
    ("min мин хв", 60.0, (0, 0, 1, 0)),
    ("kg кг", 1.0, (0, 1, 0, 0)),
    ("N Н", 1.0, (1, 1, -2, 0)),
    ("kN кН", 1e3, (1, 1, -2, 0)),
    ("W Вт", 1.0, (2, 1, -3, 0)),
    ("kW кВт", 1e3, (2, 1, -3, 0)),
    ("J Дж", 1.0, (2, 1, -2, 0)),
    ("kJ кДж", 1e3, (2, 1, -2, 0)),
    ("µm мкм", 1e-6, (1, 0, 0, 0)),
    ("g г", 1e-3, (0, 1, 0, 0)),
    ("h ч", 3600.0, (0, 0, 1, 0)),
    ("ms мс", 1e-3, (0, 0, 1, 0)),
    ("Pa Па", 1.0, (-1, 1, -2, 0)),
    ("MPa МПа", 1e6, (-1, 1, -2, 0)),
    ("Hz Гц", 1.0, (0, 0, -1, 0)),
    ("rad рад", 1.0, (0, 0, 0, 1)),
    ("deg °", math.pi / 180, (0, 0, 0, 1)),
    ("об", 2 * math.pi, (0, 0, 0, 1)),
    ("rpm", 2 * math.pi / 60, (0, 0, -1, 1)),
    ("%", 0.01, (0, 0, 0, 0)),
):
    for name in names.split():
        _UNITS[name] = (size, dimension)
_POWERS = {"²": 2, "³": 3, "⁴": 4}
_UNITS["1"] = (1.0, (0, 0, 0, 0))  # of 1/mm
_TOKEN = re.compile(r"(1(?=/)|[^\W\d_²³⁴]+|°|%)([²³⁴]?)|([·/()])")


class Unit(NamedTuple):
    factor: float  # to SI
    dimension: Dimension


NONE = Unit(1.0, (0, 0, 0, 0))


def unit(text: str) -> Unit | None:
    """A printed unit, None where the text is none: "Н·м", "(рад/с)/мм", "°". "" is a pure number."""
    text = text.strip()
    tokens = _TOKEN.findall(text)
    if "".join(a + b + c for a, b, c in tokens) != text.replace(" ", ""):
        return None
    if any(name and name not in _UNITS for name, _, _ in tokens):
        return None
    return _product(tokens) if tokens else NONE


def _product(tokens: list[tuple[str, str, str]]) -> Unit:
    """Products and quotients from left to right; brackets after the sign before them."""
    found, sign, stack = NONE, 1, []
    for name, power, mark in tokens:
        if mark == "(":
            stack.append((found, sign))
            found, sign = NONE, 1
        elif mark == ")":
            before, outer = stack.pop()
            found, sign = _times(before, found, outer), 1
        elif mark:
            sign = 1 if mark == "·" else -1
        else:
            found = _times(found, Unit(*_UNITS[name]), sign * _POWERS.get(power, 1))
    return found


def _times(one: Unit, other: Unit, power: int) -> Unit:
    a, b = one.dimension, other.dimension
    total = (a[0] + power * b[0], a[1] + power * b[1], a[2] + power * b[2], a[3] + power * b[3])
    return Unit(one.factor * other.factor**power, total)

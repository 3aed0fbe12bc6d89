"""Number -> text in one place, in cells and in sentences, and the names of units.

Rounding is what a person does with the number in view: half up on its decimal digits. A float that stands for
2.675 is a little less than 2.675, so sizes are raised by a relative 1e-12 before they are rounded.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from tmm_report.i18n import NP_, Translator
from tmm_report.problems import N_, Message, Rendered, language_of
from tmm_report.records import dataclass

ZERO = 1e-9  # relative to the scale: anything smaller is the noise of a computation and prints as 0
NUDGE = 1 + 1e-12
EXACT_DIGITS = 12  # up to so many the error of a scaled number is below 1e-3, what CLEAR leaves to a half
CLEAR = 0.499
RAISED = 1e6  # from here on a power of ten is printed; what is less has no zeros in the place of its digits
MINUS = "\N{MINUS SIGN}"
_TENS = tuple(float(10**k) for k in range(23))  # the powers that a double holds exactly
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def roman(number: int) -> str:
    """Of a whole number from 0, which has none and gives "", to 39."""
    ones = ("", "I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX")
    return "X" * (number // 10) + ones[number % 10]


class Parts(NamedTuple):
    """A number ready to be typeset: sign, digits with a point, and the power of ten or None."""

    negative: bool
    digits: str
    power: int | None = None


def split(
    x: float, digits: int = 5, places: int | None = None, scale: float = 1.0, keep_zeros: bool = False
) -> Parts:
    """`x` to `digits` significant digits, but all that stand before its point, or to `places` decimals. |x| <= 1e-9
    scale is 0.

    The power of ten appears outside 1e-4 <= |x| < 1e6. nan is a dash. `keep_zeros` keeps trailing zeros.
    """
    size = abs(x)
    if not math.isfinite(size):
        return Parts(x < 0, "—" if size != size else "∞")
    size = 0.0 if size <= ZERO * scale else size * NUDGE
    if places is not None:
        text, power = f"{size:.{places}f}", None
    else:
        text, power = _significant(size, digits) if size else ("0", None)
    if not keep_zeros:
        text = _bare(text)
    return Parts(x < 0 and text.strip("0.") != "", text, power)


def _bare(text: str) -> str:
    """Digits without zeros at their end."""
    return text.rstrip("0").rstrip(".") if "." in text else text


def _significant(size: float, digits: int) -> tuple[str, int | None]:
    """Digits, trailing zeros kept, and power of a size that is already nudged."""
    whole = math.floor(size + 0.5) if size < RAISED else RAISED
    if 10 ** (digits - 1) <= size and whole < RAISED:
        return str(whole), None
    mantissa, _, power = f"{size:#.{digits}g}".partition("e")
    return mantissa.rstrip("."), int(power) if power else None


def number(
    x: float,
    digits: int = 5,
    decimal: str = ",",
    places: int | None = None,
    scale: float = 1.0,
    keep_zeros: bool = False,
) -> str:
    """`split` as running text: 4,444; −41,888; 1,35·10⁻⁵; a dash for nan."""
    return _running(split(x, digits, places, scale, keep_zeros), decimal)


def short_and_full(
    x: float, digits: int, decimal: str, places: int | None = None, scale: float = 1.0
) -> tuple[str, str]:
    """`number` without and with the zeros at its end."""
    full = split(x, digits, places, scale, keep_zeros=True)
    whole, bare = _running(full, decimal), _bare(full.digits)
    return whole if bare == full.digits else _running(Parts(full.negative, bare, full.power), decimal), whole


def _running(parts: Parts, decimal: str) -> str:
    text = (MINUS if parts.negative else "") + parts.digits.replace(".", decimal)
    return text if parts.power is None else f"{text}·10{str(parts.power).translate(_RAISED)}"


def round_significant(x: Any, digits: int) -> Any:
    """`x` (a number or an array) rounded half up to `digits` significant digits, as `number` prints it: below a million
    not to tens or more."""
    if isinstance(x, (int, float)):
        return _rounded(x, digits)
    x = np.asarray(x, dtype=float)
    size = np.abs(x) * NUDGE
    known = np.isfinite(size) & (size > 0)
    shift = digits - 1 - np.floor(np.log10(np.where(known, size, 1.0)))
    shift = np.where(size < RAISED, np.maximum(shift, 0), shift)
    up, down = 10.0 ** np.maximum(shift, 0), 10.0 ** np.maximum(-shift, 0)  # one of them is 1: both exact
    rounded = np.floor(size * up / down + 0.5) / up * down
    return np.where(known, np.copysign(rounded, x), x)


def _rounded(x: float, digits: int) -> float:
    """One number rounded as its text would be read.

    By whole numbers and powers of ten that a double holds exactly, so that the one division rounds as reading text
    does; where the scaled number is so near a half that its own rounding error could decide, by the text itself.
    """
    size = abs(x) * NUDGE
    if digits <= EXACT_DIGITS and 1e-9 < size < 1e9:
        shift = digits - 1 - math.floor(math.log10(size))
        if shift < 0 and size < RAISED:
            shift = 0
        up, down = (_TENS[shift], 1.0) if shift >= 0 else (1.0, _TENS[-shift])
        scaled = size * up / down
        whole = math.floor(scaled + 0.5)
        if abs(scaled - whole) < CLEAR:
            return math.copysign(whole / up * down, x)
    if 10 ** (digits - 1) <= size < RAISED:
        return math.copysign(math.floor(size + 0.5), x)
    return float(f"{x * NUDGE:.{digits - 1}e}") if math.isfinite(x) else x


def column(values: Iterable[float], digits: int = 5, decimal: str = ",") -> list[str]:
    """A table column with one number of decimals: the largest value has `digits` significant digits."""
    values = [float(value) for value in values]
    largest = max((abs(value) for value in values if math.isfinite(value)), default=0.0)
    scale = max(1.0, largest)
    if not 1e-4 <= largest < 1e6:
        return [number(value, digits, decimal, scale=scale) for value in values]
    places = max(0, digits - 1 - math.floor(math.log10(round_significant(largest, digits))))
    return [_cell(value, places, decimal, scale) for value in values]


def _cell(value: float, places: int, decimal: str, scale: float) -> str:
    text = number(value, decimal=decimal, places=places, scale=scale, keep_zeros=True)
    return text if text.strip("0" + decimal) else "0"


UNITS = (
    NP_("unit", "m"),
    NP_("unit", "mm"),
    NP_("unit", "s"),
    NP_("unit", "min"),
    NP_("unit", "kg"),
    NP_("unit", "N"),
    NP_("unit", "W"),
    NP_("unit", "kW"),
    NP_("unit", "J"),
    NP_("unit", "Pa"),
    NP_("unit", "MPa"),
    NP_("unit", "Hz"),
    NP_("unit", "rad"),
    NP_("unit", "rpm"),
    NP_("unit", "µm"),
    NP_("unit", "g"),
    NP_("unit", "kN"),
    NP_("unit", "kJ"),
    NP_("unit", "h"),
    NP_("unit", "ms"),
    NP_("unit", "V"),
    NP_("unit", "A"),
)
ANGLE = N_("20 deg")
_SIGNS = str.maketrans({"*": "·", "^": "", "2": "²", "3": "³", "4": "⁴"})


@lru_cache(maxsize=1024)
def unit_text(unit: str, language: str) -> str:
    """A unit as it is printed in the language: "kg*m^2" or "kg·m²" -> "кг·м²"; "deg" -> "°"."""
    translate = Translator(language).pgettext
    words = re.split(r"([A-Za-zµ]+)", unit)
    words[1::2] = ["°" if word == "deg" else translate("unit", word) for word in words[1::2]]
    words[::2] = [sign.translate(_SIGNS) for sign in words[::2]]
    return "".join(words)


# ---------------------------------------------------------------- numbers in sentences


@dataclass(frozen=True)
class Amount(Rendered):
    """A number of a sentence, to `digits` significant ones; as text it is English."""

    value: float
    digits: int = 4
    unit: str = ""

    def text(self, tr: Translator) -> str:
        shown = number(self.value, self.digits, tr.decimal, scale=0.0)
        unit = unit_text(self.unit, tr.language)
        return f"{shown} {unit}" if unit not in ("", "°") else f"{shown}{unit}"

    def __str__(self) -> str:
        return self.text(Translator("en"))

    def render(self, translate: Callable[[str], str]) -> str:
        return self.text(Translator(language_of(translate)))


_UNIT_TYPED = re.compile(r"(?<=[0-9⁶] )[A-Za-zµ]+(?:[*/^][A-Za-z0-9^]+)*")


@dataclass(frozen=True)
class Typed(Rendered):
    """A piece of a variant as one types it: in each language with its own units, always with a point."""

    written: str

    def __str__(self) -> str:
        return self.written

    def render(self, translate: Callable[[str], str]) -> str:
        tr = Translator(language_of(translate))
        degree = translate(ANGLE).rpartition(" ")[2]

        def unit(found: re.Match[str]) -> str:
            return re.sub(
                "[A-Za-zµ]+", lambda word: tr.pgettext("unit", word[0]), found[0].replace("deg", degree)
            )

        return _UNIT_TYPED.sub(unit, self.written)


def for_example(written: str) -> Message:
    """What would be right, by a piece of a variant."""
    return Message(N_("for example, %(example)s"), {"example": Typed(written)})


def amounts(values: Mapping[str, float], digits: int = 4) -> dict[str, Amount]:
    """Of a sentence whose units stand in its words."""
    return {key: Amount(value, digits) for key, value in values.items()}


def equalities(named: Mapping[str, Amount]) -> Message:
    """a = 142 mm, b = 1.5."""
    text = ", ".join(f"%(name{k})s = %(of{k})s" for k in range(len(named)))
    values: dict[str, object] = {f"name{k}": name for k, name in enumerate(named)}
    return Message(text, values | {f"of{k}": one for k, one in enumerate(named.values())})


def printed(message: Message, tr: Translator) -> Message:
    """The sentence with its amounts as the language writes them; other values are left as they are."""
    return Message(message.text, {key: _printed(value, tr) for key, value in message.values.items()})


def _printed(value: object, tr: Translator) -> object:
    if isinstance(value, Message):
        return printed(value, tr)
    return value.text(tr) if isinstance(value, Amount) else value

"""What stands in a cell of a student's table: a number as people write it, nothing, or a head with a unit."""

from __future__ import annotations

import math
import re
import unicodedata

LENGTH = 40  # the longest text of a number

_MINUS = "\u2010\u2011\u2012\u2013\u2014\u2212\ufe63\uff0d"
_SPACES = "\t\xa0\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u202f\u205f\u3000"
_UNSEEN = "\u200b\u200e\u200f\u2060\ufeff"  # marks that come along when text is copied
_TIMES = "\N{MULTIPLICATION SIGN}\N{DOT OPERATOR}\N{BULLET OPERATOR}*xXхХ"
_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+", strict=True))
_TABLE = str.maketrans(
    {
        **dict.fromkeys(_MINUS, "-"),
        **dict.fromkeys(_SPACES, " "),
        **dict.fromkeys(_UNSEEN, ""),
        **dict.fromkeys(_TIMES, "·"),
        **dict.fromkeys("eEеЕ", "e"),  # the Cyrillic letters look the same
        ",": ".",
    }
)
_BLANK = {word.translate(_TABLE) for word in ("", "-", "н/д", "n/a", "нет")}
_NUMBER = re.compile(r"([-+]?) ?([0-9]{1,3}(?: [0-9]{3})+|[0-9]*)(\.[0-9]*)?(?:e([-+]?[0-9]+))?")
_POWER = re.compile(r" ?· ?10(?:\^ ?\(?([-+]?[0-9]+)\)?|([⁺⁻]?[⁰¹²³⁴-⁹]+))$")
_LIST = re.compile(
    r".*[^\s()\[\]]\([^()\[\]]*,[^()\[\]]*\)"
)  # k12_II2(2,3): what belongs to the name, no unit
_BRACKETS = re.compile(r"([^()\[\]]*)[(\[]([^()\[\]]*)[)\]]")


def number(text: str) -> float:
    """The number that a person wrote, nan where there is none.

    Decimal comma or point, any dash for the minus, spaces between thousands, `1,5e3`, `1,5·10³`, `1.5*10^3`. What
    is longer than `LENGTH`, infinite or undefined is no number.
    """
    if len(text) > LENGTH:
        return math.nan
    plain = text.translate(_TABLE).strip().removeprefix("'")
    found = _NUMBER.fullmatch(plain)
    return _value(found, "") if found else _power(plain)


def _power(plain: str) -> float:
    """A mantissa times a power of ten."""
    power = _POWER.search(plain)
    found = _NUMBER.fullmatch(plain[: power.start()]) if power else None
    if power is None or found is None or found[4]:
        return math.nan
    return _value(found, power[1] or "".join(_RAISED[digit] for digit in power[2]))


def _value(found: re.Match[str], power: str) -> float:
    sign, whole, part, exponent = found.groups("")
    if not whole and len(part) < 2:
        return math.nan
    value = float(f"{sign}{whole.replace(' ', '')}{part}e{power or exponent or 0}")
    return value if math.isfinite(value) else math.nan


def is_blank(text: str) -> bool:
    """Whether a cell says that there is nothing: empty, a dash, or words for it."""
    return len(text) <= LENGTH and text.casefold().translate(_TABLE).strip() in _BLANK


def header(text: str) -> tuple[str, str]:
    """Name and unit of a column's head: `v_B, m/s`, `v_B (m/s)`, `v_B [m/s]`; without a unit "" stands for it."""
    plain = " ".join(unicodedata.normalize("NFC", text).replace("\ufeff", "").split()).removeprefix("'")
    if _LIST.fullmatch(plain):
        return plain, ""
    if found := _BRACKETS.fullmatch(plain):
        return found[1].strip(" ,"), found[2].strip()
    name, _, unit = plain.rpartition(",")
    return (name.strip(), unit.strip()) if name.strip() else (plain.strip(" ,"), "")

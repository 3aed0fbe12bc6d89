"""What a number with a unit was meant to be, where its writing is a usual slip: powers of ten, parted digits."""

from __future__ import annotations

import re
from collections.abc import Collection

from tmm_report.problems import N_, Message

_NUMBER = r"([-+−]?[0-9]+(?:[.,][0-9]*)?)"
_POWER = re.compile(_NUMBER + r"\s*[*·⋅×xх]\s*10\s*(?:\^|\*\*)?\s*\(?([-+−]?[0-9]+|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)\)?\s*(.*)")
_PARTED = re.compile(r"([-+−]?[0-9]{1,3})((?:[\s'’][0-9]{3})+)(?![0-9])(.*)")
_UNITS = re.compile(_NUMBER + r"(\s*[^\W\d_][^#;]{0,20})")
_COMMENT = re.compile(r".*?\S(?:\s*(?:#|//)|\s+\()\s*[^\W\d_]{2}.*")
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹−", "-0123456789-")


def corrected(text: str, units: Collection[str]) -> str | None:
    """What a text that begins with a number and goes on with no unit may have been meant to be, if a slip is seen.

    "1.2*10^-2 kg" -> "1.2e-2 kg", "1 200 mm" -> "1200 mm", "20 mm." -> "20 mm", "5 kn" -> "5 kN".
    """
    text = text.strip()
    if found := _POWER.fullmatch(text):
        return f"{found[1]}e{found[2].translate(_RAISED)} {found[3]}".strip()
    if found := _PARTED.fullmatch(text):
        return found[1] + re.sub(r"\D", "", found[2]) + found[3]
    return text[:-1] if text.endswith(".") else _cased(text, units)


def _cased(text: str, units: Collection[str]) -> str | None:
    """The text with capitals and small letters as units have them, where only one unit is meant."""
    if not (found := _UNITS.fullmatch(text)):
        return None
    names: dict[str, set[str]] = {}
    for unit in units:
        names.setdefault(unit.casefold(), set()).add(unit)

    def cased(word: re.Match[str]) -> str:
        meant = {word[0]} if word[0] in units else names.get(word[0].casefold(), set())
        return meant.copy().pop() if len(meant) == 1 else word[0]

    near = found[1] + re.sub(r"[^\W\d_]+", cased, found[2])
    return near if near != text else None


def sign(text: str) -> Message | None:
    """What would be right where another sign than a comma, or none before a comment, stands behind a number."""
    if ";" in text:
        return Message(N_("write a comma"))
    return Message(N_("a comment begins with a space and #")) if _COMMENT.fullmatch(text.strip()) else None

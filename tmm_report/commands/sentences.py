"""Numbers in the sentences of a result: with the decimal sign, the minus and the units of the language spoken."""

from __future__ import annotations

import re
from typing import Any

from tmm_report.i18n import Translator
from tmm_report.problems import Message
from tmm_report.quantity.text import MINUS, unit_text

_NUMBER = r"-?\d+(?:\.\d+)?(?:e[+-]\d+)?"
_WHOLE = re.compile(rf"{_NUMBER}\Z")
_AMOUNT = re.compile(rf"(?<= = )({_NUMBER})(?: ([A-Za-zµ][\w*/^·²]*))?(?=, |\Z)")  # "a = 142 mm, b = 1.5"


def printed(message: Message, tr: Translator) -> Message:
    """The sentence with its numbers as the language writes them. Other texts, such as names, are left as they are."""
    return Message(message.text, {key: _value(value, tr) for key, value in message.values.items()})


def _value(value: Any, tr: Translator) -> Any:
    if isinstance(value, Message):
        return printed(value, tr)
    if type(value) is not str:
        return value
    if _WHOLE.match(value):
        return _number(value, tr)
    return _AMOUNT.sub(lambda found: " ".join([_number(found[1], tr), *_unit(found[2], tr)]), value)


def _number(text: str, tr: Translator) -> str:
    mantissa, *power = text.split("e")
    mantissa = mantissa.replace("-", MINUS).replace(".", tr.decimal)
    return "e".join([mantissa, *power])


def _unit(unit: str | None, tr: Translator) -> list[str]:
    return [unit_text(unit, tr.language)] if unit else []

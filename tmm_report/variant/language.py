"""The key `language`: a code of the table of languages; names that may be given by languages, {ru: …, en: …}."""

from __future__ import annotations

from typing import Annotated

from tmm_report.languages import LANGUAGES, language
from tmm_report.problems import N_, Called, Message, ProblemError, shown
from tmm_report.quantity.typed.alike import difference, skeleton
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.values import Reads, free_text


def _code(value: object) -> str:
    """The code as it is written. Raises WrongValue with what --lang says of it."""
    try:
        return language(str(value) if isinstance(value, str | int | float) else "[…]").code
    except ProblemError as error:
        (problem,) = error.problems
        raise WrongValue(problem.wrong, problem.right) from None


CODE = Reads(_code, {"type": "string", "enum": [*LANGUAGES]})


def called(value: object) -> str:
    """A text, or one of each language: {ru: …, en: …}."""
    if not isinstance(value, dict):
        return free_text(value)
    for code in value:
        if code not in LANGUAGES:
            text = N_("a text by languages: %(code)s is none of them")
            alike = next((one for one in LANGUAGES if skeleton(one) == skeleton(str(code))), None)
            known = Message(N_("known: %(codes)s"), {"codes": ", ".join(LANGUAGES)})
            right = known if alike is None else difference(str(code), alike)
            raise WrongValue(Message(text, {"code": shown(code)}), right, str(code))
    if not value:
        raise WrongValue(Message(N_("a text is expected here")))
    return Called({code: free_text(text) for code, text in value.items()})


_EACH = ", or one of each language: {ru: …, en: …}"
_TEXT = {"type": ["string", "number"], "maxLength": 200}
_BY_LANGUAGE = {
    "type": "object",
    "properties": dict.fromkeys(LANGUAGES, _TEXT),
    "additionalProperties": False,
    "minProperties": 1,
}
CalledBy = Annotated[str, Reads(called, {"anyOf": [_TEXT, _BY_LANGUAGE], "description": f"a name{_EACH}"})]
_FIELD = {**_TEXT, "type": ["string", "number", "boolean", "null"]}
TitleLine = Annotated[
    str, Reads(called, {"anyOf": [_FIELD, _BY_LANGUAGE], "description": f"a line of text{_EACH}"})
]

"""The key `language`: a code of the table of languages."""

from __future__ import annotations

from tmm_report.languages import LANGUAGES, language
from tmm_report.problems import ProblemError
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.values import Reads


def _code(value: object) -> str:
    """The code as it is written. Raises WrongValue with what --lang says of it."""
    try:
        return language(str(value) if isinstance(value, str | int | float) else "[…]").code
    except ProblemError as error:
        (problem,) = error.problems
        raise WrongValue(problem.wrong, problem.right) from None


CODE = Reads(_code, {"type": "string", "enum": [*LANGUAGES]})

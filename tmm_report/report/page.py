"""The templates' environment: only here jinja2 is known, and what a chapter's template may call.

A template is written once for all formats; its markup comes from `macros.<format>.j2`. It is given the results,
the macros `m` and the functions of `Page`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template, pass_context
from jinja2.runtime import Context, Undefined
from markupsafe import Markup

from tmm_report.figures.drawing import Drawing
from tmm_report.figures.graphs import Graph
from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Inline
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.text import column, number, unit_text
from tmm_report.report.formats import Format, percent
from tmm_report.report.numbering import Numbering
from tmm_report.resources import data_root

_VALUE = re.compile(r"%(?:\((\w+)\)[sd]|%)")


@pass_context  # without it jinja2 folds string literals at compile time, html-escaping them before `finalize`
def _finalize(context: Context, value: Any) -> Any:
    if isinstance(value, Markup | Undefined):
        return value
    return context["page"].text(value)


@cache
def environment() -> Environment:
    return Environment(
        loader=FileSystemLoader(data_root() / "templates"),
        undefined=StrictUndefined,
        autoescape=True,
        finalize=_finalize,
        trim_blocks=True,
        lstrip_blocks=True,
    )


def template(name: str) -> Template:
    return environment().get_template(name)


class Page:
    """What templates call: text, mathematics and numbers in one format and one language."""

    def __init__(self, form: Format, tr: Translator, numbering: Numbering):
        self.form, self.tr, self.numbering = form, tr, numbering

    def text(self, value: Any) -> Markup:
        """Anything for output: Markup as it is, other text escaped for the format."""
        return value if isinstance(value, Markup) else self.form.escape(str(value))

    def t(self, message: str, **values: Any) -> Markup:
        """A message translated and escaped, with values put in for %(name)s; of these, too, only Markup is trusted."""
        return self._filled(self.tr.gettext(message), values)

    def _filled(self, text: str, values: dict[str, Any]) -> Markup:
        out, end = [], 0
        for match in _VALUE.finditer(text):
            out += [self.text(text[end : match.start()]), self.text(values[match[1]] if match[1] else "%")]
            end = match.end()
        return Markup("").join([*out, self.text(text[end:])])

    def percent(self, picture: Drawing | Graph) -> int:
        return percent(picture)

    def math(self, item: Any, display: bool = False) -> Markup:
        return self.form.math(item, self.tr, display)

    def sym(self, key: str | Symbol) -> Markup:
        """The symbol of a key, "v_BA"."""
        return self.math(math_symbol(key) if isinstance(key, str) else key)

    def value(self, key: str | Symbol, value: float, unit: str = "", digits: int = 5) -> Markup:
        """symbol = value unit; a value of unit "deg" is given in rad."""
        return self.math(Inline(key, float(value), unit, digits))

    def values(self, items: Iterable[tuple[str, float, str]], digits: int = 4) -> Markup:
        """Several `value`s: (symbol, value, unit), ..."""
        return self.listed(self.value(key, value, unit, digits) for key, value, unit in items)

    def num(self, x: float, digits: int = 5, places: int | None = None, scale: float = 1.0) -> str:
        return number(float(x), digits, self.tr.decimal, places, scale)

    def col(self, values: Iterable[float], digits: int = 5) -> list[str]:
        """A table column."""
        return column(values, digits, self.tr.decimal)

    def unit(self, unit: str) -> str:
        return unit_text(unit, self.tr.language)

    def listed(self, items: Iterable[Any], between: str = ", ") -> Markup:
        return self.text(between).join(self.text(item) for item in items)

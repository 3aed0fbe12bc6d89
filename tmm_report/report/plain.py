"""Formulas as plain text, for a terminal: v_BA = ω_2·l_AB = 36,791·0,3 = 11,037 м/с.

The tree of `quantity/formula` is printed with signs that every terminal has; fractions become a/b, with brackets where
the line needs them, so that the text is worked out from left to right as the formula is.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field

from tmm_report.i18n import Translator
from tmm_report.problems import Message
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula, Page, Term, Var, VectorEquation
from tmm_report.quantity.symbols import Latex, Symbol
from tmm_report.quantity.text import MINUS, Parts, unit_text
from tmm_report.quantity.written import Equation
from tmm_report.records import dataclass

Item = Formula | VectorEquation | Equation | Definition
_RAISED = str.maketrans("-−0123456789", "⁻⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_DIGITS = frozenset("-−0123456789")


def text(item: Item, tr: Translator, form: Plain | None = None) -> str:
    """A formula on one line: what is defined = in symbols = in numbers = value and unit."""
    form = form or Plain(tr)
    match item:
        case Formula():
            return " = ".join([form.symbol(_sign(item.result)), *_sides(item, form)]) + _unit(item, tr)
        case VectorEquation():
            return " = ".join(_vectors(side, form) for side in item.sides)
        case Equation():
            return "".join(item.expression.terms(Page(form, numbers=item.numbers))) + " = 0"
        case Definition():
            expression = "".join(item.expression.terms(Page(form, numbers=False)))
            return f"{form.symbol(_sign(item.result))} = {expression}"


def value(symbol: Symbol, number: str, unit: str, tr: Translator) -> str:
    """symbol = number unit, of a number that is already text."""
    return f"{Plain(tr).symbol(symbol)} = {number}{gap(unit, tr)}"


def gap(unit: str, tr: Translator) -> str:
    """A unit as it follows its number."""
    name = unit_text(unit, tr.language)
    return f"{'' if name == '°' else ' '}{name}" if name else ""


def said(message: Message, tr: Translator, form: Plain | None = None) -> str:
    """A message in words, symbols among its values as they are written in text."""
    form, values = form or Plain(tr), {}
    for name, value in message.values.items():
        value = said(value, tr, form) if isinstance(value, Message) else value
        values[name] = form.symbol(value) if isinstance(value, Symbol) else value
    return Message(message.text, values).render(tr.gettext)


def _sign(result: Symbol | str) -> Symbol:
    return Var(result, 0.0).sign


def _sides(item: Formula, form: Plain) -> Iterator[str]:
    """The expression in symbols and in numbers, and the value; what says the same as the side before is left out."""
    last = ""
    pages = [Page(form, numbers, item.index, item.digits) for numbers in (False, True)]
    number = pages[1].number(item.shown, item.digits, item.unit == "deg", item.scale)
    for side in (*("".join(item.expression.terms(page)) for page in pages), number.text):
        if side != last:
            yield side
        last = side


def _unit(item: Formula, tr: Translator) -> str:
    return "" if item.unit == "deg" else gap(item.unit, tr)  # degrees stand with the number itself


def _vectors(side: Sequence[Term], form: Plain) -> str:
    """A side of a vector equation: its terms with their directions."""
    texts = [(MINUS if term.negative else "+", term.text(form)) for term in side]
    if not texts:
        return "0"
    first = ("" if texts[0][0] == "+" else MINUS) + texts[0][1]
    return "".join([first, *(f" {sign} {term}" for sign, term in texts[1:])])


@dataclass(frozen=True, eq=False)
class Plain(Latex):
    """Plain text in place of LaTeX: every shape that `Latex` knows, written with ordinary signs. `written`: symbols,
    which formulas have many times."""

    written: dict[Symbol, str] = field(default_factory=dict)

    def parts(self, parts: Parts) -> str:
        number = (MINUS if parts.negative else "") + parts.digits.replace(".", self.tr.decimal)
        return number if parts.power is None else f"{number}·10{str(parts.power).translate(_RAISED)}"

    def symbol(self, symbol: Symbol) -> str:
        if symbol not in self.written:
            self.written[symbol] = self._symbol(symbol)
        return self.written[symbol]

    def _symbol(self, symbol: Symbol) -> str:
        if symbol.kind == "segment":
            return symbol.base
        return self.indexed(self.text(symbol.base, base=True), self.text(symbol.sub), self.text(symbol.sup))

    def indexed(self, base: str, sub: str, sup: str) -> str:
        below = f"_{sub}" if sub else ""
        return base + below + (self._raised(sup) if sup else "")

    def _raised(self, sup: str) -> str:
        if sup in ("'", "′", "″", "*"):
            return sup
        return sup.translate(_RAISED) if _DIGITS.issuperset(sup) else f"^{sup}"

    def run(self, run: str) -> str:
        if run[0] in "'′":
            return "′" * len(run)
        short = run.isascii() and (run.isupper() or run.isdigit() or len(run) == 1)
        return run if short else self.word(run)

    def unit(self, unit: str) -> str:
        return gap(unit, self.tr)

    def operator(self, sign: str) -> str:
        return sign if sign == "·" else f" {sign} "

    def negative(self, text: str) -> str:
        return MINUS + text

    def brackets(self, text: str, marks: str = "()") -> str:
        return f"{marks[0]}{text}{marks[1]}"

    def fraction(self, above: str, below: str) -> str:
        above = f"({above})" if _outside(above, "+−") or above.startswith(MINUS) else above
        return f"{above}/{f'({below})' if _outside(below, '+−·/') or below.startswith(MINUS) else below}"

    def root(self, text: str) -> str:
        return f"√({text})"

    def power(self, base: str, exponent: str) -> str:
        return base + self._raised(exponent) if _DIGITS.issuperset(exponent) else f"{base}^({exponent})"

    def function(self, name: str, argument: str) -> str:
        return f"{name}{argument}" if argument.startswith("(") else f"{name}({argument})"

    def integral(self, body: str, along: str, lower: str, upper: str) -> str:
        return f"∫_{lower}^{upper} {body} d{along}"

    def bar(self, text: str) -> str:
        return text

    def underlined(self, text: str, lines: int) -> str:
        return text

    def under(self, text: str, note: str) -> str:
        return f"{text} ({note})"

    def formula(self, pieces: list[str]) -> str:
        return "".join(pieces)


def _outside(text: str, signs: str) -> bool:
    """Whether one of the signs stands outside all brackets; of + and −, between two terms."""
    depth, inside = 0, False
    for place, sign in enumerate(text):
        inside = inside != (sign == "|")
        depth += (sign == "(") - (sign == ")")
        if not depth and not inside and sign in signs and (sign in "·/" or text[:place].endswith(" ")):
            return True
    return False

"""One expression tree: evaluated over arrays, printed as symbols = numbers = value in LaTeX and MathML.

    l = Var("l_AB", 0.3, "m"); omega = Var("omega_2", result.omega, "rad/s")    # omega: (P,)
    normal = Formula(math_symbol("a_BA^n"), omega**2 * l, "m/s²", index=7)
    normal.value                      # (P,), full precision
    normal.mathml(Translator("ru"))   # aⁿ = ω₂²·l = (−36,791)²·0,3 = 406,07 м/с²

What is printed and what is computed are the same tree, so they cannot disagree.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from tmm_report.i18n import NP_, Translator
from tmm_report.problems import Message
from tmm_report.quantity.ref import Ref, read_alike
from tmm_report.quantity.symbols import Notation, Symbol, math_symbol, notation, with_power
from tmm_report.quantity.text import ZERO, round_significant
from tmm_report.records import dataclass

Value = Any  # a number or an array (..., P)

# How tightly a printed expression holds together: a looser one is bracketed inside a tighter one.
SUM, NEGATIVE, PRODUCT, FRACTION, POWER, ATOM = range(6)


class Piece(NamedTuple):
    text: str
    level: int
    zero: bool = False  # prints as 0


@dataclass(eq=False)
class Page:
    """Where an expression is printed: the format, as symbols or numbers, which position, how many digits."""

    notation: Notation
    numbers: bool
    index: int | None = None
    digits: int = 5

    def bracket(self, piece: Piece, level: int) -> str:
        """The piece in brackets if it holds together no better than `level`."""
        return self.notation.brackets(piece.text) if piece.level <= level else piece.text

    def number(
        self,
        value: Value,
        digits: int,
        degrees: bool = False,
        scale: float | None = None,
        ref: Ref | None = None,
    ) -> Piece:
        """A value at the printed position; `scale` None: the largest value over the positions, at least 1."""
        x = at(value, self.index)
        if scale is None and abs(x) < 1e-3:
            scale = _largest(value)
        scale = 1.0 if scale is None else scale
        x = math.degrees(x) if degrees else x
        text = self.notation.number(x, digits, scale, ref)
        tail = self.notation.unit("deg") if degrees else ""
        if x < -ZERO * scale:
            return Piece(text + tail, NEGATIVE)
        zero = x <= ZERO * scale
        return Piece(text + tail, ATOM if 1e-4 <= x < 1e6 or zero else PRODUCT, zero)


def at(value: Value, index: int | None) -> float:
    """The number at position `index` of the last axis. Raises ValueError where that is not one number."""
    if isinstance(value, int | float):
        return float(value)
    array = np.asarray(value)
    if array.ndim and index is not None:
        array = array[..., index if array.shape[-1] > 1 else 0]
    if array.size != 1:
        raise ValueError(f"a printed value needs one position; the shape is {np.shape(value)}, index {index}")
    return float(array.reshape(()))


def _largest(value: Value) -> float:
    sizes = np.abs(np.asarray(value, dtype=float))
    return float(np.max(sizes, initial=1.0, where=np.isfinite(sizes)))


@dataclass(frozen=True, eq=False)
class Expr:
    """A node of the tree. Python's operators build it; plain numbers become `Number`."""

    def evaluate(self, digits: int | None = None) -> Value:
        """The value, broadcast over arrays; with `digits`, from every variable rounded as it is printed."""
        raise NotImplementedError

    def piece(self, page: Page) -> Piece:
        raise NotImplementedError

    def terms(self, page: Page) -> Iterator[str]:
        """The printed expression, cut before the signs of the outermost sum: a line may break there."""
        yield self.piece(page).text

    @property
    def value(self) -> Value:
        return self.evaluate()

    def __add__(self, other: Operand) -> Expr:
        return Sum(self, expr(other), "+")

    def __radd__(self, other: Operand) -> Expr:
        return Sum(expr(other), self, "+") if other != 0 else self  # sum() begins with 0

    def __sub__(self, other: Operand) -> Expr:
        return Sum(self, expr(other), "−")

    def __rsub__(self, other: Operand) -> Expr:
        return Sum(expr(other), self, "−")

    def __mul__(self, other: Operand) -> Expr:
        return Product(self, expr(other))

    def __rmul__(self, other: Operand) -> Expr:
        return Product(expr(other), self)

    def __truediv__(self, other: Operand) -> Expr:
        return Quotient(self, expr(other))

    def __rtruediv__(self, other: Operand) -> Expr:
        return Quotient(expr(other), self)

    def __pow__(self, exponent: int) -> Expr:
        return Power(self, exponent)

    def __neg__(self) -> Expr:
        return Negative(self)

    def __abs__(self) -> Expr:
        return Absolute(self)


Operand = Expr | float


def expr(operand: Operand) -> Expr:
    return operand if isinstance(operand, Expr) else Number(operand)


@dataclass(frozen=True, eq=False)
class Number(Expr):
    """An exact number of the formula itself, as the 2 of 2πr: never rounded in computing."""

    number: float

    def evaluate(self, digits: int | None = None) -> Value:
        return self.number

    def piece(self, page: Page) -> Piece:
        return page.number(float(self.number), 10, scale=0.0)


@dataclass(frozen=True, eq=False)
class Var(Expr):
    """A symbol with its value (number or array (..., P)) and unit.

    Unit "deg": the value is in rad and printed in degrees. `symbol` may be a key. `digits`: its own number of
    significant digits in place of the formula's. `ref`: where it stands in the results; `meaning`: for a list of
    symbols.
    """

    symbol: Symbol | str
    number: Value
    unit: str = ""
    digits: int | None = None
    ref: Ref | None = None
    meaning: Message | None = None

    def evaluate(self, digits: int | None = None) -> Value:
        if digits is None:
            return self.number
        if self.unit == "deg":
            return np.radians(round_significant(np.degrees(self.number), self.digits or digits))
        return round_significant(self.number, self.digits or digits)

    @property
    def sign(self) -> Symbol:
        return math_symbol(self.symbol) if isinstance(self.symbol, str) else self.symbol

    def piece(self, page: Page) -> Piece:
        if page.numbers:
            return page.number(self.number, self.digits or page.digits, self.unit == "deg", ref=self.ref)
        return Piece(page.notation.symbol(self.sign), POWER if self.sign.raised else ATOM)


PI = Var("pi", math.pi, ref=Ref("pi"))


@dataclass(frozen=True, eq=False)
class Sum(Expr):
    left: Expr
    right: Expr
    sign: str

    def evaluate(self, digits: int | None = None) -> Value:
        left, right = self.left.evaluate(digits), self.right.evaluate(digits)
        return left + right if self.sign == "+" else left - right

    def terms(self, page: Page) -> Iterator[str]:
        yield from self.left.terms(page)
        yield page.notation.operator(self.sign) + page.bracket(self.right.piece(page), NEGATIVE)

    def piece(self, page: Page) -> Piece:
        return Piece("".join(self.terms(page)), SUM)


@dataclass(frozen=True, eq=False)
class Product(Expr):
    left: Expr
    right: Expr

    def evaluate(self, digits: int | None = None) -> Value:
        return self.left.evaluate(digits) * self.right.evaluate(digits)

    def piece(self, page: Page) -> Piece:
        left, right = self.left.piece(page), self.right.piece(page)
        # 2π, 4r²: a number stands close to a symbol; everything else has a dot.
        close = isinstance(self.left, Number) and not page.numbers and _begins_with_letter(self.right)
        dot = "" if close else page.notation.operator("·")
        text = page.bracket(left, SUM) + dot + page.bracket(right, NEGATIVE)
        return Piece(text, NEGATIVE if left.level == NEGATIVE else PRODUCT)


def _begins_with_letter(node: Expr) -> bool:
    if isinstance(node, Product):
        return _begins_with_letter(node.left)
    return isinstance(node.base if isinstance(node, Power) else node, Var | Function)


@dataclass(frozen=True, eq=False)
class Quotient(Expr):
    above: Expr
    below: Expr

    def evaluate(self, digits: int | None = None) -> Value:
        return np.divide(self.above.evaluate(digits), self.below.evaluate(digits))

    def piece(self, page: Page) -> Piece:
        return Piece(
            page.notation.fraction(self.above.piece(page).text, self.below.piece(page).text), FRACTION
        )


@dataclass(frozen=True, eq=False)
class Power(Expr):
    base: Expr
    exponent: float

    def evaluate(self, digits: int | None = None) -> Value:
        return self.base.evaluate(digits) ** float(self.exponent)

    def piece(self, page: Page) -> Piece:
        if isinstance(self.base, Var) and not page.numbers and isinstance(self.exponent, int):
            raised = with_power(self.base.sign, str(self.exponent))
            if raised is not None:
                return Piece(page.notation.symbol(raised), POWER)
        base = page.bracket(self.base.piece(page), POWER)
        return Piece(page.notation.power(base, Number(self.exponent).piece(page).text), POWER)


@dataclass(frozen=True, eq=False)
class Negative(Expr):
    body: Expr

    def evaluate(self, digits: int | None = None) -> Value:
        return -self.body.evaluate(digits)

    def piece(self, page: Page) -> Piece:
        body = self.body.piece(page)
        if body.zero:
            return body  # never -0
        return Piece(page.notation.negative(page.bracket(body, NEGATIVE)), NEGATIVE)


@dataclass(frozen=True, eq=False)
class Absolute(Expr):
    body: Expr

    def evaluate(self, digits: int | None = None) -> Value:
        return abs(self.body.evaluate(digits))

    def piece(self, page: Page) -> Piece:
        return Piece(page.notation.brackets(self.body.piece(page).text, "||"), ATOM)


@dataclass(frozen=True, eq=False)
class Root(Expr):
    body: Expr

    def evaluate(self, digits: int | None = None) -> Value:
        return np.sqrt(self.body.evaluate(digits))

    def piece(self, page: Page) -> Piece:
        return Piece(page.notation.root(self.body.piece(page).text), ATOM)


@dataclass(frozen=True, eq=False)
class Function(Expr):
    """sin, cos, tan, arctan, arccos of an argument in rad; printed by the name the language uses."""

    name: str
    argument: Expr
    apply: Callable[[Value], Value]

    def evaluate(self, digits: int | None = None) -> Value:
        return self.apply(self.argument.evaluate(digits))

    def piece(self, page: Page) -> Piece:
        argument = page.bracket(self.argument.piece(page), FRACTION)
        name = page.notation.tr.pgettext("function", self.name)
        return Piece(page.notation.function(name, argument), PRODUCT)


def sqrt(body: Operand) -> Expr:
    return Root(expr(body))


def sin(argument: Operand) -> Expr:
    return Function("sin", expr(argument), np.sin)


def cos(argument: Operand) -> Expr:
    return Function("cos", expr(argument), np.cos)


def tan(argument: Operand) -> Expr:
    return Function(NP_("function", "tan"), expr(argument), np.tan)


def arccos(argument: Operand) -> Expr:
    return Function("arccos", expr(argument), np.arccos)


@dataclass(frozen=True, eq=False)
class Formula:
    """`result` = expression in symbols = in numbers = value, unit.
    `index`: the position printed where values are arrays (..., P). Unit "deg": the value is in rad, printed
    in degrees. `hand`: the printed value is computed from the numbers as printed, so that a reader's calculator
    agrees. `scale`: the size against which a value is noise (1e-9 of it prints 0); None: the largest, at least 1.
    `ref`: where the value stands in the results; `meaning`: of the result, for a list of symbols; `numbers`: put in.
    """

    result: Symbol | str
    expression: Expr
    unit: str = ""
    digits: int = 5
    index: int | None = None
    hand: bool = False
    scale: float | None = None
    ref: Ref | None = None
    meaning: Message | None = None
    numbers: bool = True

    @cached_property
    def value(self) -> Value:
        """Full precision, over all positions."""
        return self.expression.value

    @cached_property
    def shown(self) -> Value:
        """What is printed before rounding, over all positions; differs from `value` only by hand."""
        return self.expression.evaluate(self.digits) if self.hand else self.value

    @cached_property
    def written(self) -> float:
        """The printed result at the sample position, rounded to `digits`, in SI (rad for "deg")."""
        value = at(self.shown, self.index)
        if self.scale is not None and abs(value) <= ZERO * self.scale:  # printed as nothing beside its terms
            return 0.0
        if self.unit == "deg":
            return math.radians(round_significant(math.degrees(value), self.digits))
        return float(round_significant(value, self.digits))

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        result = Var(self.result, 0.0).sign
        pieces = [form.symbol(result)]
        last = ""
        for side in self._sides(form):
            joined = "".join(side)
            if read_alike(joined, last):  # a bare number is not repeated as its own value: it is the value
                del pieces[-len(side) :]
            pieces += [form.operator("=") + side[0], *side[1:]]
            last = joined
        pieces[-1] += form.unit(self.unit) if self.unit != "deg" else ""
        # the left side never stands alone at the end of a line
        return form.formula([pieces[0] + pieces[1], *pieces[2:]])

    def _sides(self, form: Notation) -> list[list[str]]:
        pages = [Page(form, numbers, self.index, self.digits) for numbers in (False, True)]
        value = pages[1].number(self.shown, self.digits, self.unit == "deg", self.scale, self.ref)
        if not self.numbers or (value.zero and self._nothing_divided()):
            pages = pages[:1]
        return [*(list(self.expression.terms(page)) for page in pages), [value.text]]

    def _nothing_divided(self) -> bool:
        """Whether a zero is divided by something: nobody writes 0/0,09 = 0."""
        body = self.expression.body if isinstance(self.expression, Negative) else self.expression
        return isinstance(body, Quotient) and at(body.above.evaluate(self.digits), self.index) == 0


def agrees(formula: Formula, solver_value: Value, tolerance: float = 1e-9) -> bool:
    """Whether the formula gives the solver's values at every position, relative to the largest of them.

    nan must stand at the same positions in both.
    """
    ours, theirs = np.broadcast_arrays(formula.value, solver_value)
    scale = np.max(np.abs(theirs), initial=0.0, where=np.isfinite(theirs))
    return bool(np.allclose(ours, theirs, rtol=0.0, atol=tolerance * (scale or 1.0), equal_nan=True))


@dataclass(frozen=True)
class Inline:
    """`symbol = value unit` in running text."""

    symbol: Symbol | str
    value: float
    unit: str = ""
    digits: int = 5
    ref: Ref | None = None

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        value = (
            Page(form, numbers=True).number(self.value, self.digits, self.unit == "deg", ref=self.ref).text
        )
        unit = "" if self.unit == "deg" else form.unit(self.unit)
        return form.formula([form.symbol(Var(self.symbol, 0.0).sign) + form.operator("=") + value + unit])


@dataclass(frozen=True, eq=False)
class Term:
    """A vector of a vector equation. `known`: 2 magnitude and direction, 1 direction only, 0 nothing.

    `note`: its direction, printed below: "∥ OA", "⟂ AB".
    """

    symbol: Symbol | str
    known: int = 0
    note: str = ""
    negative: bool = False

    def text(self, form: Notation) -> str:
        plain = math_symbol(self.symbol) if isinstance(self.symbol, str) else self.symbol
        vector = form.symbol(Symbol(plain.base, plain.sub, plain.sup, bar=True))
        lined = form.underlined(vector, self.known)
        return form.under(lined, form.text(self.note.replace(" ", ""))) if self.note else lined


@dataclass(frozen=True, eq=False)
class VectorEquation:
    """Sides joined by "=", each a sum of terms; a side without terms is zero."""

    sides: Sequence[Sequence[Term]]

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        pieces: list[str] = []
        for number, side in enumerate(self.sides):
            relation = form.operator("=") if number else ""
            pieces += [relation + text if not i else text for i, text in enumerate(_side(side, form))]
        return form.formula(pieces)


def _side(side: Sequence[Term], form: Notation) -> list[str]:
    if not side:
        return [form.number(0, 1)]
    first = form.negative(side[0].text(form)) if side[0].negative else side[0].text(form)
    return [first, *(form.operator("−" if term.negative else "+") + term.text(form) for term in side[1:])]

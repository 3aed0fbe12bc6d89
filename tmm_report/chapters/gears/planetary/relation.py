"""Two expressions set against each other, each in symbols, in numbers and with its value: a = b, a > b."""

from __future__ import annotations

from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Expr, Page
from tmm_report.quantity.ref import Ref, without_attributes
from tmm_report.quantity.symbols import Notation, notation
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Side:
    """One side of a relation; `ref`: where its value stands in the results."""

    expression: Expr
    ref: Ref

    @property
    def value(self) -> float:
        return float(self.expression.value)


@dataclass(frozen=True, eq=False)
class Relation:
    """left = numbers = value, unit, and how it stands to the right, written in the same way: a = b, a > b."""

    left: Side
    sign: str
    right: Side
    unit: str = ""

    @property
    def holds(self) -> bool:
        difference = self.left.value - self.right.value
        return abs(difference) < 1e-9 * abs(self.right.value) if self.sign == "=" else difference > 0

    def latex(self, tr: Translator) -> str:
        return self.printed(notation("latex", tr))

    def mathml(self, tr: Translator) -> str:
        return self.printed(notation("mathml", tr))

    def printed(self, form: Notation) -> str:
        left, right = self._side(self.left, form), self._side(self.right, form)
        return form.formula([left[0] + left[1], *left[2:], form.operator(self.sign) + right[0], *right[1:]])

    def _side(self, side: Side, form: Notation) -> list[str]:
        """In symbols, in numbers, the value: each with its sign of equality, what repeats left out."""
        pages = [Page(form, numbers) for numbers in (False, True)]
        texts = [side.expression.piece(page).text for page in pages]
        texts.append(pages[1].number(side.value, 5, ref=side.ref).text)
        bare = [without_attributes(text) for text in texts]
        new = [text for k, text in enumerate(texts) if k == 0 or bare[k] != bare[k - 1]]
        pieces = [new[0], *(form.operator("=") + text for text in new[1:])]
        pieces[-1] += form.unit(self.unit)
        return pieces

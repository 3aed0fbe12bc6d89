"""A reader's calculator: the numbers put into a formula give the number printed after them."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest
from arithmetic import Near, NotNumbers, evaluate
from note import Formula, Note, read, whole_number
from reading import BOTH, html, wrong


def worked(formula: Formula) -> Iterator[tuple[int, Near]]:
    """The sides that are numbers alone, but for the last one."""
    for k, side in enumerate(formula.sides[1:-1], 1):
        try:
            yield k, evaluate(side)
        except NotNumbers:
            continue


def wrong_results(note: Note) -> Iterator[str]:
    for formula in note.formulas:
        last = formula.numbers[-1]
        if len(last) != 1 or len(formula.sides[-1]) != 1 or whole_number(formula.sides[-1][0]) is None:
            continue
        printed = last[0].printed
        scale = math.pi / 180 if formula.unit_text == "°" else 1.0
        for _, found in worked(formula):
            half = printed.result_off if printed.value else 1e-9
            if abs(found.value - printed.value * scale) > found.error * 1.001 + half * scale * 1.001 + 1e-12:
                yield f"{formula.where} {formula.text}: gives {found.value / scale:.9g} ± {found.error / scale:.2g}"


@pytest.mark.parametrize(("name", "other"), BOTH)
def test_printed_formulas_give_what_they_print(name, other):
    wrong(list(wrong_results(html(name, other))))


@pytest.mark.parametrize(("name", "other"), BOTH)
def test_printed_comparisons_hold(name, other):
    wrong([f"{where}: {text}" for where, text, holds in html(name, other).comparisons if not holds])


@pytest.mark.parametrize(("name", "other"), BOTH[:1])
def test_formulas_are_worked_at_all(name, other):
    formulas = [
        formula for formula in html(name, other).formulas if formula.display and len(formula.sides) > 2
    ]
    assert sum(1 for formula in formulas for _ in worked(formula)) > 0.7 * len(formulas)


SUM = "<main><p><math><mi>W</mi><mo>=</mo><mn>3</mn><mo>·</mo><mn>3,5</mn></math><wbr/><math><mo>−</mo><msup><mrow><mn>2</mn></mrow><mrow><mn>2</mn></mrow></msup><mo>=</mo><mn>{}</mn></math></p></main>"  # noqa: E501


@pytest.mark.parametrize(("text", "count"), [("6,5", 0), ("6,51", 1), ("−6,5", 1), ("14,5", 1)])
def test_a_wrong_result_is_told(text, count):
    assert len(list(wrong_results(read(SUM.format(text))))) == count

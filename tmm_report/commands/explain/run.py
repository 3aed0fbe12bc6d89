"""`tmm-report explain`: how the program finds one number of a variant, with its formulas and the numbers in them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from tmm_report import load, solve
from tmm_report.commands.explain.derivation import Derivation, Walk, derive
from tmm_report.commands.explain.listen import listen
from tmm_report.commands.explain.stated import stated, written
from tmm_report.commands.explain.target import Target, find
from tmm_report.commands.explain.text import lines
from tmm_report.commands.explain.way import Ways
from tmm_report.commands.files import translator
from tmm_report.commands.talk import Talk
from tmm_report.course import Results, Variant
from tmm_report.i18n import Translator
from tmm_report.note import parts
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.text import number
from tmm_report.quantity.ways import STATED
from tmm_report.report.heard import Heard
from tmm_report.report.words import method_name

OTHER_METHOD = N_(
    "The task names another method of the motion for the results: %(method)s. It errs by %(worst)s of the largest "
    "value at most."
)


def run(variant: Path, quantity: str, position: int | None, language: str | None, talk: Talk) -> bool:
    """Tell the derivation; whether the quantity has a number there. Raises ProblemError."""
    loaded = load(variant)
    tr = translator(loaded, language)
    talk.speak(tr.language)
    results = solve(loaded)
    target = find(results, quantity, position)
    heard, derivation = _derived(results, target, tr)
    own = position is None or bool(derivation.spoken)
    if not own:
        results = solve(written_out(results.variant, position))
        target = find(results, quantity, position)
        heard, derivation = _derived(results, target, tr)
    told = Ways.of(results).told(target)
    given = (
        written(stated(variant), target.numbers, target.quantity.unit)
        if told and told.way.text == STATED
        else []
    )
    for line in lines(target, heard, derivation, told, own, tr, given):
        talk.tell(line)
    if results.lever is not None and (choice := results.lever.kinematics.choice) and not choice.own:
        values = {
            "method": method_name(choice.taken, tr),
            "worst": number(choice.worst, 1, tr.decimal, scale=0),
        }
        talk.tell(Message(OTHER_METHOD, values))
    return bool(target.texts) or bool(np.isfinite(target.numbers).any())


def written_out(variant: Variant, position: int | None) -> Variant:
    """The variant with one position written out in full, in place of those that it states."""
    if variant.lever is None or position is None:
        return variant
    positions = replace(variant.lever.positions, plans=(position,), force_plan=(position,))
    return replace(variant, lever=replace(variant.lever, positions=positions))


def _derived(results: Results, target: Target, tr: Translator) -> tuple[Heard, Derivation]:
    """What the note says, and what of it leads to the number."""
    heard = listen(lambda page: list(parts(results, page)), results.variant.title, tr)
    return heard, derive(Walk(heard), starts(target))


def starts(target: Target) -> Callable[[Formula], bool]:
    """Which formulas of the note define what is asked."""

    def defines(item: Formula) -> bool:
        ref = item.ref
        if ref is None:
            return False
        if target.table is None:
            return (ref.table, ref.key) == ("", target.quantity.key)
        if target.worked:
            return ref.table == target.table.name
        if target.position is None:
            return (ref.table, ref.key) == (target.table.name, target.quantity.key)
        return ref.row == target.position and _meant(ref.key, item, target)

    return defines


def _meant(key: str, item: Formula, target: Target) -> bool:
    """Whether a formula at the position asked is of the quantity, of the vector whose component it is, or of the motion
    of an output, which is that of its point."""
    asked, table = target.quantity.key, target.table
    assert table is not None
    vector = asked[:-2] if asked.endswith(("_x", "_y")) and asked[:-2] in table else asked
    if key == vector:
        return True
    sign = Var(item.result, 0.0).sign
    return table.name.startswith("outputs_") and sign in _of_point(target.quantity.symbol)


def _of_point(symbol: Symbol | None) -> tuple[Symbol, ...]:
    """What the motion of an output is called in the plans: V_B is v_B there."""
    return () if symbol is None else (symbol, replace(symbol, base=symbol.base.lower()))

"""A derivation in lines for a terminal: its formulas by sections of the note, what they begin with, the value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

import numpy as np

from tmm_report.commands.explain.derivation import Derivation
from tmm_report.commands.explain.stated import Written
from tmm_report.commands.explain.target import Target, is_text
from tmm_report.commands.explain.way import Told
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Page, Var
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.text import number
from tmm_report.quantity.ways import STATED, Input, Line
from tmm_report.report.heard import Heard
from tmm_report.report.plain import Plain, gap, said, text

DIGITS = 5
MOST_ROWS = 40  # of a table of things, wheels or solutions: more are not told
MOST_INPUTS = 24
MORE = N_("… and %(count)s more")


def lines(
    target: Target,
    heard: Heard,
    derivation: Derivation,
    told: Told | None,
    own: bool,
    tr: Translator,
    given: Sequence[Written] = (),
) -> Iterator[str]:
    """The derivation, a line each. `told`: the way that the chapter tells; `own`: these formulas stand in the note of
    the variant, with these numbers; `given`: where the numbers stand in its file."""
    yield _title(target, tr)
    if derivation.spoken and not own:
        yield ""
        yield tr.gettext(
            N_("The note of the variant writes other positions out; this one is found in the same way.")
        )
    yield from _derived(derivation, own, tr)
    yield from _beginning(derivation, tr)
    yield from _way(target, derivation, told, tr)
    if told is not None and told.way.text == STATED and not derivation.spoken:
        yield from _given(given, tr)
    yield from _found(target, tr)
    yield _where(target, heard, own, tr)


def _title(target: Target, tr: Translator) -> str:
    name = target.quantity.symbol
    symbol = Plain(tr).symbol(name) if name is not None else target.quantity.key
    title = f"{symbol} – {said(target.quantity.meaning, tr)}"
    if target.position is None:
        return title
    at = Message(N_("position %(k)s"), {"k": target.position})
    return f"{title}, {at.render(tr.gettext)}"


def _derived(derivation: Derivation, own: bool, tr: Translator) -> Iterator[str]:
    """The formulas by the sections of the note, each with its number there and its meaning."""
    section = None
    for spoken in derivation.spoken:
        if spoken.section != section:
            section = spoken.section
            yield ""
            yield f"{section.place.number} {section.title}" if own else section.title
        number = f"({spoken.number}) " if own and spoken.number else ""
        meaning = getattr(spoken.item, "meaning", None)
        yield f"  {number}{text(spoken.item, tr)}" + (f" – {said(meaning, tr)}" if meaning else "")


def _beginning(derivation: Derivation, tr: Translator) -> Iterator[str]:
    """The numbers with which the formulas begin."""
    if derivation.begins:
        yield ""
        yield tr.gettext(N_("It begins with:"))
    for var in derivation.begins:
        written = text_of(var, tr)
        yield f"  {written} – {said(var.meaning, tr)}" if var.meaning else f"  {written}"


def text_of(var: Var, tr: Translator) -> str:
    """A variable with its number: l_AB = 0,3 м."""
    form = Plain(tr)
    piece = Page(form, numbers=True).number(var.number, var.digits or DIGITS, var.unit == "deg")
    return f"{form.symbol(var.sign)} = {piece.text}{'' if var.unit == 'deg' else gap(var.unit, tr)}"


def _way(target: Target, derivation: Derivation, told: Told | None, tr: Translator) -> Iterator[str]:
    """How the number in the results is found, where that is not by the formulas above alone."""
    if told is None or (derivation.spoken and not told.way.beside):
        return
    yield ""
    if told.way.text:
        yield tr.gettext(told.way.text)
    said = [f"  {one}" for line in told.worked for one in _line(line, tr)]
    yield from (one for one, before in zip(said, ["", *said], strict=False) if one != before)
    yield from (f"  {text(one, tr)}" for one in told.formulas[:MOST_ROWS])
    yield from _inputs(target, told, tr)


def _line(line: Line, tr: Translator) -> Iterator[str]:
    """What a chapter works out with numbers."""
    match line:
        case Message():
            yield line.render(tr.gettext)
        case Input():
            yield _input(line, tr)
        case _:
            yield f"  {text(line, tr)}"


def _inputs(target: Target, told: Told, tr: Translator) -> Iterator[str]:
    """The numbers with which it starts; of a table of things what stands in the row beside its number."""
    given = dict.fromkeys(_meant(one, tr) for one in chain.from_iterable(told.inputs))
    if not given:
        return
    yield tr.gettext(N_("It starts with:"))
    if target.table is None or len(told.inputs) == 1:
        yield from _short([f"  {line}" for line in given], tr)
        return
    shared = [one for one in told.inputs[0] if all(one in row for row in told.inputs)]
    yield from (f"  {_meant(one, tr)}" for one in shared)
    rows = ([_input(one, tr) for one in row if one not in shared] for row in told.inputs)
    yield from _short([f"  {n}: {', '.join(row)}" for n, row in enumerate(rows, 1) if row], tr)


def _given(given: Sequence[Written], tr: Translator) -> Iterator[str]:
    """Where the numbers stand in the file."""
    line = N_("line %(line)s: %(key)s: %(text)s")
    yield from _short([f"  {Message(line, one._asdict()).render(tr.gettext)}" for one in given], tr)
    if not given:
        yield f"  {tr.gettext(N_('The file does not state this number: it is the usual value.'))}"


def _short(every: list[str], tr: Translator) -> Iterator[str]:
    yield from every[:MOST_INPUTS]
    if len(every) > MOST_INPUTS:
        yield f"  {tr.gettext(MORE) % {'count': len(every) - MOST_INPUTS}}"


def _meant(one: Input, tr: Translator) -> str:
    """With its meaning: m = 2 kg – mass of the link."""
    line = _input(one, tr)
    return line if isinstance(one.number, str) else f"{line} – {said(one.quantity.meaning, tr)}"


def _input(one: Input, tr: Translator) -> str:
    """A number or a text of the results: m = 2 kg; the member held: H."""
    if isinstance(one.number, str):
        return f"{said(one.quantity.meaning, tr)}: {one.number}"
    name = Plain(tr).symbol(one.symbol) if one.symbol is not None else one.quantity.key
    return f"{name} = {number(one.number, DIGITS, tr.decimal, scale=0.0)}{gap(one.unit, tr)}"


def _found(target: Target, tr: Translator) -> Iterator[str]:
    """The number as it stands in the results; of a table of things a line for each row."""
    if target.texts:
        yield from _texts(target, tr)
        return
    numbers, every = target.numbers, np.asarray(target.column.values, dtype=float)
    largest = float(np.max(np.abs(every), initial=0.0, where=np.isfinite(every)))
    scale = largest if target.table is not None else 0.0
    yield tr.gettext(N_("Value in the results:"))
    for row, x in enumerate(numbers[:MOST_ROWS]):
        yield f"  {_named(target, row, tr)} = {number(x, DIGITS, tr.decimal, scale=scale)}{_unit(target, row, tr)}"
    if len(numbers) > MOST_ROWS:
        yield f"  {tr.gettext(MORE) % {'count': len(numbers) - MOST_ROWS}}"
    if target.position is not None and not np.isfinite(numbers).any():
        yield tr.gettext(
            N_("It is not determined at this position: the mechanism is singular or cannot be assembled.")
        )


def _texts(target: Target, tr: Translator) -> Iterator[str]:
    """The texts as they stand in the results."""
    yield tr.gettext(N_("In the results:"))
    yield from _short([f"  {row}: {one}" for row, one in enumerate(target.texts, 1)], tr)


def _named(target: Target, row: int, tr: Translator) -> str:
    """Symbol or key; of a table of things with what the row is called."""
    of_things = target.table if target.position is None else None
    name = target.quantity.key
    if target.quantity.symbol is not None:
        name = Plain(tr).symbol(target.column.symbol(row if of_things is not None else None))
    if of_things is None:
        return name
    labels = next((column for column in of_things.columns if is_text(column)), None)
    return f"{labels.values[row] if labels is not None else row + 1}: {name}"


def _unit(target: Target, row: int, tr: Translator) -> str:
    return gap(target.column.unit_of(row if target.position is None else 0), tr)


def _where(target: Target, heard: Heard, own: bool, tr: Translator) -> str:
    """Where the number stands in the note and in results.json."""
    at = {"name": target.name}
    numbers = list(dict.fromkeys(f"{cell.table}" for cell in heard.cells if _stands(cell.ref, target)))
    if not numbers or not own:
        return tr.gettext(N_("In results.json: %(name)s.")) % at
    listed = ", ".join(numbers)
    return tr.gettext(N_("In the note: tables %(tables)s; in results.json: %(name)s.")) % {
        **at,
        "tables": listed,
    }


def _stands(ref: Ref, target: Target) -> bool:
    if ref.key != target.quantity.key or ref.by == "at_deg":
        return False
    if target.position is None:
        return ref.table == (target.table.name if target.table is not None else "")
    return ref.row == target.position

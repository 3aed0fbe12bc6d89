"""A derivation in lines for a terminal: its formulas by sections of the note, what they begin with, the value."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.commands.derivation import Derivation
from tmm_report.commands.explain_target import Target, is_text
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Page, Var
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.text import number
from tmm_report.report.heard import Heard
from tmm_report.report.plain import Plain, gap, said, text

DIGITS = 5
MOST_ROWS = 40  # of a table of things, wheels or solutions: more are not told


def lines(target: Target, heard: Heard, derivation: Derivation, own: bool, tr: Translator) -> Iterator[str]:
    """The derivation, a line each. `own`: these formulas stand in the note of the variant, with these numbers."""
    yield _title(target, tr)
    if derivation.spoken and not own:
        yield ""
        yield tr.gettext(
            N_("The note of the variant writes other positions out; this one is found in the same way.")
        )
    yield from _derived(derivation, own, tr)
    yield from _beginning(derivation, tr)
    yield from _way(target, derivation, tr)
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


WAYS = {
    "positions": N_(
        "Found from the closed vector contours of the groups, group by group in the order of assembly."
    ),
    "rates": N_(
        "Found analytically: the contours of the groups, differentiated with respect to time once for the velocities "
        "and twice for the accelerations, are linear equations that are solved together, group by group."
    ),
    "reactions": N_(
        "Found analytically: the equations of equilibrium of the links of a group, with their inertia forces and "
        "couples, are solved together; the groups go in the order opposite to that of assembly."
    ),
    "M_bal": N_("Found analytically from the moments about the pivot of the driving link."),
    "M_lever": N_(
        "Found from the balance of Zhukovsky's lever: the powers of all the forces at the position."
    ),
    "M_power": N_(
        "Found from the power balance: the rate of change of the kinetic energy less the power of the loads, divided "
        "by the angular velocity of the driving link."
    ),
    "powers": N_("Power of the loads: force times the velocity of its point along it, moment times rate."),
    "loads": N_("Found from the given masses and the accelerations: G = mg, F = ma, M = Jε."),
    "stated": N_("Stated by the variant: the law of the load at the position."),
    "friction": N_("Found from the reaction and from the relative motion of the two links."),
    "P_fr": N_("Sum of the powers of friction in all pairs."),
    "reduced": N_(
        "Found from the equality of kinetic energies and of powers with those of the driving link."
    ),
    "segments": N_("Measured in the plan."),
    "plan_values": N_("Found by the plan: the measured segment times the scale."),
    "H": N_(
        "The way from one extreme position of the output to the other; both are found exactly, not by the table."
    ),
    "K": N_(
        "The time of the one stroke to that of the other, between the exact extreme positions of the output."
    ),
    "min": N_("The least value over the whole cycle, found exactly between the positions of the table too."),
    "max": N_(
        "The greatest value over the whole cycle, found exactly between the positions of the table too."
    ),
}
"""How a number of the results is found that the formulas of the note only approach, by its name; see `_names`."""
WAYS["outputs"] = WAYS["rates"]
APPROACHED = ("rates", "outputs", "reactions", "M_bal")  # the note writes them out by plans, as by hand


def _way(target: Target, derivation: Derivation, tr: Translator) -> Iterator[str]:
    """How the number in the results is found, where that is not by the formulas above."""
    name = next((name for name in _names(target) if name in WAYS), "")
    if derivation.spoken and name not in APPROACHED:
        return
    way = WAYS.get(name)
    yield ""
    yield tr.gettext(
        way or N_("It has no formula of its own in the note: it is given, counted, searched or measured.")
    )


def _names(target: Target) -> tuple[str, ...]:
    """Under what the way to a number may be listed: its key, its table, the first or last word of its key."""
    key = target.quantity.key
    if target.table is not None:
        table = target.table.name
        return (key, table.rsplit("_", 1)[0], table.split("_")[0]) if target.by_position else ()
    return key.split("_")[-1], key.split("_")[0]


def _found(target: Target, tr: Translator) -> Iterator[str]:
    """The number as it stands in the results; of a table of things a line for each row."""
    numbers, every = target.numbers, np.asarray(target.column.values, dtype=float)
    largest = float(np.max(np.abs(every), initial=0.0, where=np.isfinite(every)))
    scale = largest if target.table is not None else 0.0
    yield tr.gettext(N_("Value in the results:"))
    for row, x in enumerate(numbers[:MOST_ROWS]):
        yield f"  {_named(target, row, tr)} = {number(x, DIGITS, tr.decimal, scale=scale)}{_unit(target, row, tr)}"
    if len(numbers) > MOST_ROWS:
        more = tr.gettext(N_("… and %(count)s more")) % {"count": len(numbers) - MOST_ROWS}
        yield f"  {more}"
    if target.position is not None and not np.isfinite(numbers).any():
        yield tr.gettext(
            N_("It is not determined at this position: the mechanism is singular or cannot be assembled.")
        )


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

"""Sentences of the ordinary stages, chosen by their kind."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from tmm_report.problems import N_

HEADINGS = {
    "belt": N_("Belt drive %(name)s"),
}
INTRODUCED = {
    "belt open": N_(
        "An open flat belt runs round pulleys %(one)s and %(two)s; pulley %(one)s drives, both turn in the same sense."
    ),
    "belt crossed": N_(
        "A crossed flat belt runs round pulleys %(one)s and %(two)s; pulley %(one)s drives, pulley %(two)s turns in "
        "the opposite sense."
    ),
    "belt V": N_(
        "V-belts run round pulleys %(one)s and %(two)s; pulley %(one)s drives, both turn in the same sense."
    ),
}


CHOSEN = {
    "row": N_("Taken of the row of preferred numbers R 20: %(value)s."),
    "by length": N_(
        "The distance of the centres, %(value)s, is that at which the strands and the arcs have this length."
    ),
    "by rule": N_("The distance of the centres is taken by the usual rule: %(value)s."),
}


class Group(NamedTuple):
    """Formulas that stand together under a sentence, of those keys that a stage has; `taken`: numbers of which it is
    said behind them how they are chosen, where they are (`chosen` of the record)."""

    text: str
    keys: Sequence[str]
    taken: Sequence[str] = ()


GROUPS: dict[str, tuple[Group, ...]] = {
    "belt": (
        Group(
            N_("The other diameter follows from the ratio and the slip:"),
            ("d_exact", "d1", "d2"),
            ("d2",),
        ),
        Group(N_("The ratio of the belt drive is"), ("u",)),
        Group(
            N_("The length of the belt is first found approximately, and the nearest of the row is taken:"),
            ("L_about",),
            ("L", "a"),
        ),
        Group(
            N_(
                "The angle of the strands with the line of centres, the angles of wrap and the length of the belt:"
            ),
            ("theta", "alpha1", "alpha2", "L"),
        ),
        Group(N_("The velocity of the belt and the number of its runs in a second:"), ("v", "runs")),
        Group(N_("The circumferential force is"), ("F_t",)),
        Group(
            N_(
                "By Euler's formula, on the pulley that is wrapped less, the tight strand may be tenser so many times:"
            ),
            ("f_red", "m"),
        ),
        Group(
            N_(
                "So that the belt does not slip its strands must be tensioned; at work one is tighter and the other "
                "slacker by half the circumferential force:"
            ),
            ("F_0", "F_tight", "F_slack"),
        ),
        Group(
            N_("The centrifugal tension presses on no pulley, so the belt is put on tighter by it:"),
            ("F_c", "F_put"),
        ),
        Group(N_("The force by which both strands pull a shaft:"), ("F_shaft",)),
    ),
}

"""Sentences of the ordinary stages, chosen by their kind."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from tmm_report.problems import N_

HEADINGS = {
    "belt": N_("Belt drive %(name)s"),
    "chain": N_("Chain drive %(name)s"),
    "friction": N_("Friction wheels %(name)s"),
    "train": N_("Train of wheels %(name)s"),
    "pair": N_("Pair of wheels %(name)s"),
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
    "chain": N_(
        "A chain runs round sprockets %(one)s and %(two)s; sprocket %(one)s drives, both turn in the same sense. The "
        "shape of the teeth is not found."
    ),
    "friction external": N_(
        "Friction wheels %(one)s and %(two)s are pressed together; wheel %(one)s drives, wheel %(two)s turns in the "
        "opposite sense."
    ),
    "friction internal": N_(
        "Friction wheels %(one)s and %(two)s are pressed together, one within the other; wheel %(one)s drives, both "
        "turn in the same sense."
    ),
    "train external": N_(
        "Between the driving wheel %(one)s and the driven wheel %(two)s there are idlers: each drives and is driven, "
        "so that its teeth cancel out of the ratio and only the sense depends on their number. The shape of the teeth "
        "is not found; the wheels are cut without shift."
    ),
    "pair external": N_(
        "Wheels %(one)s and %(two)s are in outer mesh; wheel %(one)s drives, wheel %(two)s turns in the opposite "
        "sense. No module is stated, so no size is found: the wheels are drawn with a module of 3 mm, and velocities "
        "of their points are right in their ratio alone."
    ),
    "pair internal": N_(
        "Wheels %(one)s and %(two)s are in inner mesh; wheel %(one)s drives, both turn in the same sense. No module is "
        "stated, so no size is found: the wheels are drawn with a module of 3 mm, and velocities of their points are "
        "right in their ratio alone."
    ),
    "train internal": N_(
        "Between the driving wheel %(one)s and the ring %(two)s there are idlers: each drives and is driven, so that "
        "its teeth cancel out of the ratio and only the sense depends on their number. The shape of the teeth is not "
        "found; the wheels are cut without shift."
    ),
}


CHOSEN = {
    "row": N_("Taken of the row of preferred numbers R 20: %(value)s."),
    "by length": N_(
        "The distance of the centres, %(value)s, is that at which the strands and the arcs have this length."
    ),
    "whole": N_("Taken, a whole number: %(value)s."),
    "even": N_("Taken, an even whole number, so that no bent link is needed: %(value)s."),
    "forty pitches": N_("The distance of the centres is wished for at forty pitches: %(value)s."),
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
    "chain": (
        Group(
            N_("The number of teeth of the driven sprocket that the ratio asks for:"), ("z_exact",), ("z2",)
        ),
        Group(N_("The ratio of the chain drive is"), ("u",)),
        Group(
            N_(
                "The pitch diameters of the sprockets, whose pitch circles go through the joints of the chain:"
            ),
            ("d1", "d2"),
        ),
        Group("", (), ("a_about",)),
        Group(
            N_("The number of links is first found at the distance that is wished for:"),
            ("links_about",),
            ("links",),
        ),
        Group(N_("The distance of the centres that belongs to this number of links:"), ("a",)),
        Group(N_("It is made a little shorter, so that the slack strand sags:"), ("a_put",)),
        Group(N_("The length of the chain is"), ("L",)),
        Group(N_("The mean velocity of the chain is"), ("v",)),
        Group(
            N_(
                "The chain lies on the sprocket as on a polygon, so that its velocity along itself goes up and down "
                "with every tooth, between"
            ),
            ("v_max", "v_min"),
        ),
        Group(N_("and its unevenness is"), ("delta",)),
        Group(N_("The circumferential force by the power and the mean velocity is"), ("F_t",)),
        Group(N_("With the centrifugal tension the driving strand bears"), ("F_c", "F_tight")),
    ),
    "friction": (
        Group(N_("The other diameter follows from the ratio and the slip:"), ("d1", "d2")),
        Group(N_("The ratio of the friction wheels and the distance of the centres:"), ("u", "a")),
        Group(N_("The velocity at the circumference, and that of slipping:"), ("v", "v_slip")),
        Group(N_("The circumferential force is"), ("F_t",)),
        Group(
            N_(
                "So that friction carries it with the reserve, the wheels must be pressed together by the force"
            ),
            ("F_n",),
        ),
        Group(N_("which is on a metre of the line of contact"), ("q_n",)),
    ),
    "pair": (Group(N_("The ratio of the pair of wheels is"), ("u",)),),
    "train": (
        Group(N_("The number of teeth of the driven wheel that the ratio asks for:"), ("z_exact",)),
        Group(N_("The ratio of the train, in which the teeth of every idler cancel:"), ("u",)),
        Group(N_("From the driving to the driven axis, all of them in one plane, it is"), ("a",)),
    ),
}

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
    "bevel": N_("Bevel gear pair %(name)s"),
    "worm": N_("Worm gear pair %(name)s"),
}
INTRODUCED = {
    "belt open": N_(
        "An open flat belt runs round pulleys %(one)s and %(two)s; pulley %(one)s drives, and both turn "
        "in the same sense."
    ),
    "belt crossed": N_(
        "A crossed flat belt runs round pulleys %(one)s and %(two)s; pulley %(one)s drives, and pulley %(two)s "
        "turns in the opposite sense."
    ),
    "belt V": N_(
        "V-belts run round pulleys %(one)s and %(two)s; pulley %(one)s drives, and both turn in the same sense."
    ),
    "chain": N_(
        "A chain runs round sprockets %(one)s and %(two)s; sprocket %(one)s drives, and both turn in the same "
        "sense. The shape of the teeth is not found."
    ),
    "friction external": N_(
        "Friction wheels %(one)s and %(two)s are pressed together; wheel %(one)s drives, and wheel %(two)s turns "
        "in the opposite sense."
    ),
    "friction internal": N_(
        "Friction wheels %(one)s and %(two)s are pressed together, one within the other; wheel %(one)s drives, "
        "and both turn in the same sense."
    ),
    "friction bevel": N_(
        "Cones %(one)s and %(two)s are pressed together; cone %(one)s drives. Their axes intersect; in the "
        "scheme and in the diagrams the driven axis is turned about the common tangent until both are parallel: "
        "the cones then turn in opposite senses, and this is the minus of the ratio. The diameters are those of "
        "the mean sections."
    ),
    "bevel": N_(
        "The axes of bevel gears %(one)s and %(two)s intersect; wheel %(one)s drives. In the scheme and in the "
        "diagrams the driven axis is turned about the common tangent of the mean pitch circles until both are "
        "parallel: the wheels then turn in opposite senses, and this is the minus of the ratio. The shape of the "
        "teeth is not found."
    ),
    "worm": N_(
        "Worm %(one)s drives wheel %(two)s; their axes cross at a right angle. The shape of thread and "
        "teeth is not found."
    ),
    "train external": N_(
        "Between the driving wheel %(one)s and the driven wheel %(two)s there are idlers: each drives and is driven, "
        "so that its teeth cancel out of the ratio and only the sense depends on their number. The shape of the teeth "
        "is not found; the wheels are cut without shift."
    ),
    "pair external": N_(
        "Wheels %(one)s and %(two)s are in outer mesh; wheel %(one)s drives, and wheel %(two)s turns in the "
        "opposite sense. No module is stated, so no size is found: the wheels are drawn with a module of 3 mm, "
        "and velocities of their points are right in their ratio alone."
    ),
    "pair internal": N_(
        "Wheels %(one)s and %(two)s are in inner mesh; wheel %(one)s drives, and both turn in the same sense. No "
        "module is stated, so no size is found: the wheels are drawn with a module of 3 mm, and velocities of "
        "their points are right in their ratio alone."
    ),
    "train internal": N_(
        "Between the driving wheel %(one)s and the ring %(two)s there are idlers: each drives and is driven, so that "
        "its teeth cancel out of the ratio and only the sense depends on their number. The shape of the teeth is not "
        "found; the wheels are cut without shift."
    ),
}


CHOSEN = {
    "row": N_("Taken from the R 20 series of preferred numbers: %(value)s."),
    "by length": N_(
        "The centre distance, %(value)s, is that at which the strands and the arcs have this length."
    ),
    "usual width": N_(
        "The facewidth is taken by the usual rule as a fraction of the outer cone distance: %(value)s."
    ),
    "whole": N_("Taken, a whole number: %(value)s."),
    "even": N_("Taken, an even whole number, so that no bent link is needed: %(value)s."),
    "forty pitches": N_("A centre distance of forty pitches is aimed at: %(value)s."),
    "by rule": N_("The centre distance is taken by the usual rule: %(value)s."),
}


HANDED = {
    "right above": N_("The thread is right-handed, the worm lies above the wheel."),
    "right below": N_("The thread is right-handed, the worm lies below the wheel."),
    "left above": N_("The thread is left-handed, the worm lies above the wheel."),
    "left below": N_("The thread is left-handed, the worm lies below the wheel."),
}
WAY = {
    1: N_(
        "Seen with the driving end of the worm's shaft on the left, from which end the worm turns "
        "counter-clockwise, the wheel turns clockwise. In the diagrams the axis of the wheel is turned about the "
        "line of centres until both are parallel: both then turn in the same sense."
    ),
    -1: N_(
        "Seen with the driving end of the worm's shaft on the left, from which end the worm turns "
        "counter-clockwise, the wheel turns counter-clockwise, too. In the diagrams the axis of the wheel is "
        "turned about the line of centres until both are parallel: they then turn in opposite senses, and this "
        "is the minus of the ratio."
    ),
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
        Group("", (), ("a_about",)),
        Group(
            N_(
                "The length of the belt is first found approximately, and then the nearest of the series is taken:"
            ),
            ("L_about",),
            ("L", "a"),
        ),
        Group(
            N_(
                "The angle between the strands and the line of centres, the angles of wrap and the length of the belt:"
            ),
            ("theta", "alpha1", "alpha2", "L"),
        ),
        Group(N_("The velocity of the belt and the number of its passes per second:"), ("v", "runs")),
        Group(N_("The circumferential force is"), ("F_t",)),
        Group(
            N_(
                "By Euler's formula the greatest ratio of the tensions of the strands, on the pulley "
                "with the smaller angle of wrap, is"
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
        Group(N_("The force with which the two strands pull a shaft:"), ("F_shaft",)),
    ),
    "chain": (
        Group(N_("The number of teeth of the driven sprocket required by the ratio:"), ("z_exact",), ("z2",)),
        Group(N_("The ratio of the chain drive is"), ("u",)),
        Group(
            N_(
                "The pitch diameters of the sprockets, whose pitch circles pass through the joints of the chain:"
            ),
            ("d1", "d2"),
        ),
        Group("", (), ("a_about",)),
        Group(
            N_("The number of links is first found at the distance aimed at:"),
            ("links_about",),
            ("links",),
        ),
        Group(N_("The centre distance that belongs to this number of links:"), ("a",)),
        Group(N_("It is made a little shorter, so that the slack strand sags:"), ("a_put",)),
        Group(N_("The length of the chain is"), ("L",)),
        Group(N_("The mean velocity of the chain is"), ("v",)),
        Group(
            N_(
                "The chain lies on the sprocket as on a polygon, so that its velocity rises and falls with every "
                "tooth, between"
            ),
            ("v_max", "v_min"),
        ),
        Group(N_("and its unevenness is"), ("delta",)),
        Group(N_("The circumferential force by the power and the mean velocity is"), ("F_t",)),
        Group(N_("With the centrifugal tension the driving strand carries"), ("F_c", "F_tight")),
    ),
    "friction": (
        Group(N_("The other diameter follows from the ratio and the slip:"), ("d1", "d2")),
        Group(N_("The ratio of the friction wheels, and of cylinders the centre distance:"), ("u", "a")),
        Group(N_("The angles of the cones by the ratio of their diameters:"), ("delta1", "delta2")),
        Group(N_("The circumferential velocity and that of slipping:"), ("v", "v_slip")),
        Group(N_("The circumferential force is"), ("F_t",)),
        Group(
            N_(
                "So that friction carries it with the reserve, the wheels must be pressed together by the force"
            ),
            ("F_n",),
        ),
        Group(N_("For it the cones are pressed along their axes by"), ("F_a1", "F_a2")),
        Group(N_("On a metre of the line of contact the pressing force is"), ("q_n",)),
    ),
    "pair": (Group(N_("The ratio of the pair of wheels is"), ("u",)),),
    "train": (
        Group(N_("The number of teeth of the driven wheel required by the ratio:"), ("z_exact",), ("z2",)),
        Group(N_("The ratio of the train, in which the teeth of every idler cancel:"), ("u",)),
        Group(N_("From the driving to the driven axis, all of them in one plane, it is"), ("a",)),
    ),
    "bevel": (
        Group(N_("The number of teeth of the driven wheel required by the ratio:"), ("z_exact",), ("z2",)),
        Group(N_("The ratio of the bevel gear pair is"), ("u",)),
        Group(N_("The pitch cone angles:"), ("delta1", "delta2")),
        Group("", (), ("psi",)),
        Group(
            N_("The cone distances, outer and mean, the facewidth and the modules:"),
            ("R_e", "b", "R_m", "m_e", "m_m"),
        ),
        Group(N_("The outer and the mean pitch diameters:"), ("d_e1", "d_e2", "d_m1", "d_m2")),
        Group(N_("The numbers of teeth of the equivalent spur gears:"), ("z_v1", "z_v2")),
        Group(N_("The velocity at the mean pitch circles:"), ("v",)),
        Group(
            N_(
                "The forces are calculated at the mean diameter for straight teeth; where the axes are at a "
                "right angle, the radial force on one wheel is the axial one on the other:"
            ),
            ("F_t", "F_r1", "F_a1", "F_r2", "F_a2"),
        ),
    ),
    "worm": (
        Group(N_("The number of teeth of the driven wheel required by the ratio:"), ("z_exact",), ("z2",)),
        Group(N_("The ratio is that of the teeth of the wheel to the starts of the worm:"), ("u",)),
        Group(
            N_("The lead angle of the thread, the pitch diameters and the centre distance:"),
            ("gamma", "d1", "d2", "a"),
        ),
        Group(
            N_("The efficiency from the lead angle and the reduced angle of friction:"),
            ("phi", "eta_mesh", "eta"),
        ),
        Group(N_("Where the wheel drives, the efficiency of the mesh is"), ("eta_back",)),
        Group(
            N_(
                "The velocities at both pitch circles are at right angles, and their difference is that of sliding:"
            ),
            ("omega2", "v1", "v2", "v_slip"),
        ),
        Group(N_("The torque on the wheel and the forces in the mesh:"), ("T2", "F_t2", "F_t1", "F_r")),
    ),
}

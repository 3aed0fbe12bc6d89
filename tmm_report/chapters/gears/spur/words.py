"""Sentences of the spur chapter that are chosen by a key."""

from __future__ import annotations

from tmm_report.problems import N_

CONDITIONS = {
    "undercut": N_("no undercut of the teeth of wheel %(wheel)s"),
    "pointing": N_("no pointing of the teeth of wheel %(wheel)s"),
    "contact": N_("smoothness of the engagement"),
    "interference": N_("no interference at the root of wheel %(wheel)s"),
    "fouling": N_("no overlap of the tips of the ring and the pinion"),
    "space": N_("open spaces at the root circle of ring %(wheel)s"),
    "radial": N_("room to put the pinion into the ring radially"),
    "trimming": N_("tips of ring %(wheel)s left whole by the root of the pinion cutter"),
    "cutter fouling": N_("no overlap of the tips of ring %(wheel)s and the pinion cutter"),
    "feed": N_("room to feed the pinion cutter into ring %(wheel)s radially"),
    "sliding": N_("specific sliding at the root of wheel %(wheel)s"),
}
RULES = {
    "rule": N_(
        "The shift of the smaller wheel is taken by the rule of the course, which excludes undercut approximately:"
    ),
    "limit": N_("The shift of the smaller wheel is the least without undercut by the exact formula:"),
    "equal sliding": N_(
        "The sum of the shifts is divided so that the specific sliding at the roots of both wheels is equal."
    ),
}
UNDERCUT = N_("The shift of wheel %(wheel)s is")
UNDERCUT_BY_RULE = N_("The shift of wheel %(wheel)s satisfies the rule (%(least)s − z)/%(least)s but is")
UNDERCUT_HOW = N_(
    "%(short)s less than the exact limit %(limit)s, so the tooth is undercut: its involute begins at "
    "the radius of curvature %(start)s mm, its active profile at %(lower)s mm;"
)
UNDERCUT_DEEP = N_(
    "%(short)s less than the exact limit %(limit)s, so the tooth is undercut: its involute begins at the radius of "
    "curvature %(start)s mm, where the tip of the other wheel would meet the line of action at %(lower)s mm;"
)
# why the contact is shorter than between the tip circles; rho_m of an undercut wheel may be under the base circle
LATE = N_(
    "the involute of wheel %(wheel)s begins at the radius of curvature %(start)s mm, and the tip circle of the other "
    "wheel would meet the line of action at %(lower)s mm: contact begins where the involute does"
)
EARLY = N_(
    "the involute of ring %(wheel)s ends at the radius of curvature %(start)s mm, and the tip circle of the pinion "
    "would meet the line of action at %(lower)s mm: contact ends where the involute does"
)
POINTED = N_(
    "the teeth of wheel %(other)s come to a point before their tip circle: at the root of wheel %(wheel)s contact ends "
    "at the radius of curvature %(real)s mm, not at %(lower)s mm"
)
HARD = N_("with such shifts the teeth of wheel %(wheel)s cannot be cut, or nothing is left of their profiles")
NO_SPAN = {
    "": N_("No span over teeth of wheel %(wheel)s touches their active profiles."),
    "narrow": N_(
        "The face of wheel %(wheel)s is too narrow for a span across its helical teeth; they are measured by chords "
        "or over balls."
    ),
    "helical ring": N_("Inside helical ring %(wheel)s there is no span; it is measured between balls."),
}
SPAN_MOVED = N_(
    "The rule gives no number of teeth in the span of wheel %(wheel)s that fits; the nearest one that does is taken."
)
NO_CONSTANT = N_("The constant chord of wheel %(wheel)s does not end on its involutes.")
NO_CHORD = N_("No usual circle cuts the involutes of wheel %(wheel)s, so there is no chordal thickness.")
OFF_PITCH = N_(
    "The reference circle does not cut the involutes of wheel %(wheel)s; the chordal thickness is taken halfway up."
)
NO_PINS = N_("No pin lies between the teeth of wheel %(wheel)s so that it touches involutes and stands out.")
PAIRS = (N_("no pair"), N_("one pair"), N_("two pairs"), N_("three pairs"), N_("four pairs"))
NONE = N_("wheels with such shifts cannot be put in mesh")
LACKS = {
    "undercut": N_(
        "undercut of wheel %(wheel)s: the shift %(value)s is less than the least one %(bound)s by %(lack)s"
    ),
    "pointing": N_(
        "pointing of wheel %(wheel)s: the thickness of the tip is %(value)s·%(m)s and must be at least "
        "%(bound)s·%(m)s; it is short by %(lack)s·%(m)s"
    ),
    "contact": N_("smoothness: the contact ratio %(value)s is less than %(bound)s by %(lack)s"),
    "interference": N_(
        "interference at the root of wheel %(wheel)s: the active profile reaches %(lack)s·%(m)s along the line of "
        "action beyond the end of the involute"
    ),
    "fouling": N_("the tips of the ring and the pinion overlap by %(degrees)s°"),
    "space": N_(
        "closed spaces of ring %(wheel)s: at the root circle the width of a space is short by %(lack)s·%(m)s"
    ),
    "tips": N_(
        "tips of ring %(wheel)s inside its base circle: the diameter of the tip circle is short by %(lack)s·%(m)s"
    ),
    "trimming": N_(
        "tips of ring %(wheel)s taken away by the root of the pinion cutter: short by %(lack)s·%(m)s along the "
        "line of action"
    ),
    "cutter fouling": N_("the tips of ring %(wheel)s and the pinion cutter overlap by %(degrees)s°"),
    "root sliding": N_("specific sliding at the root of wheel %(wheel)s greater than allowed"),
    "reach": N_("the involutes of the wheels do not meet at all"),
    "mesh": NONE,
}
STUCK = N_("the tips of the ring and the pinion cannot pass each other")  # their overlap has no measure
SIDES = {"from": N_("no less than"), "to": N_("no greater than")}
COUNTED = {
    "own": N_(
        "Specific sliding is counted by the velocity of the wheel itself along the profile, 1 − v′/v with "
        "v′ of its mate; at the roots it is below zero."
    ),
    "mate": N_(
        "Specific sliding is counted by the velocity of the mate along the profile, v/v′ − 1 with v of the "
        "wheel itself; at the roots it lies between −1 and 0."
    ),
    "size": N_(
        "Specific sliding is given by its size, |1 − v′/v|, with v of the wheel itself along the profile and "
        "v′ of its mate."
    ),
}
BY_WHAT = {
    "rack": N_("It is stated as the additional shift of the rack; the teeth lose"),
    "span": N_("It is stated as the change of the span; the teeth lose"),
}
MEASURED = {
    "s": N_("tooth thickness on the reference circle"),
    "W": N_("span"),
    "s_c": N_("constant chord"),
    "s_y": N_("chordal thickness"),
    "M": N_("measurement over pins or balls"),
}

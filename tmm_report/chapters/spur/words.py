"""Sentences of the spur chapter that are chosen by a key."""

from __future__ import annotations

from tmm_report.problems import N_

CONDITIONS = {
    "undercut": N_("no undercut of the teeth of wheel %(wheel)s"),
    "pointing": N_("no pointing of the teeth of wheel %(wheel)s"),
    "contact": N_("smoothness of the engagement"),
    "interference": N_("no interference at the root of wheel %(wheel)s"),
    "fouling": N_("no overlap of the tips of the ring and the pinion"),
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
PAIRS = (N_("no pair"), N_("one pair"), N_("two pairs"), N_("three pairs"), N_("four pairs"))
LACKS = {
    "undercut": N_(
        "undercut of wheel %(wheel)s: the shift %(value)s is less than the least one %(bound)s by %(lack)s"
    ),
    "pointing": N_(
        "pointing of wheel %(wheel)s: the thickness of the tip is %(value)s %(m)s and must be at least "
        "%(bound)s %(m)s, %(lack)s %(m)s is wanting"
    ),
    "ratio": N_("smoothness: the contact ratio %(value)s is less than %(bound)s by %(lack)s"),
    "interference": N_(
        "interference at the root of wheel %(wheel)s: the active profile reaches %(lack)s %(m)s along the line of "
        "action beyond the end of the involute"
    ),
    "fouling": N_("the tips of the ring and the pinion overlap by %(degrees)s°"),
}
NONE = N_("wheels with such shifts cannot be put in mesh")
STUCK = N_("the tips of the ring and the pinion cannot pass each other")  # their overlap has no measure

"""How the numbers of structure are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

PAIR = N_("One for a pivot or a guide, two for a higher pair: the kinds of motion that the pair leaves.")
LINKS = N_("Counted: the moving links that the variant states.")
PAIRS = N_(
    "Counted in the table of kinematic pairs: revolute and prismatic ones are lower, cams' are higher."
)
REPLACED = N_("Counted in the mechanism whose higher pairs are each replaced by a link with two lower pairs.")
HIGHEST = N_("The highest class of the groups that are detached.")
OF_GROUP = N_("By Assur: II for a dyad; III and more by the most pairs of a closed contour of its links.")
ORDER = N_("Counted: the pairs by which the group hangs on the links found before it.")
RADIUS = N_(
    "By the stated teeth and module, radii or ratio, so that the working pitch circles of both wheels "
    "touch between their axes."
)
RATIO = N_("By the radii of the working pitch circles, which roll on one another.")
COUNT = N_("Counted in the group.")
OTHER = N_(
    "The groups are sought again with this link driving; the highest class of them, 0 where it cannot drive."
)

WAYS = (
    Way("pairs.number", COUNTED),
    Way("pairs.mobility", PAIR, of="kind"),
    Way("pairs.* groups.group groups.links drivers.link", NAME),
    Way("groups.class", OF_GROUP, of="links lower"),
    Way("groups.order", ORDER, of="links links_count lower"),
    Way("groups.equations", by=lambda q: 3 * q("links_count")),
    Way("groups.unknowns", by=lambda q: 2 * q("lower") + q("higher")),
    Way("groups.*", COUNT, of="links"),
    Way("drivers.class drivers.formula", OTHER, of="link"),
    Way("n", LINKS, enough=True),
    Way("p5 p4", PAIRS, enough=True),
    Way("n_repl", by=lambda q: q("n") + q("p4")),
    Way("p5_repl", by=lambda q: q("p5") + 2 * q("p4")),
    Way("*_repl", REPLACED, of="n p4"),
    Way("z_*_* m_* phase_*", STATED),
    Way("r_*_*", RADIUS, of="i_*"),
    Way("i_*", RATIO, of="r_*"),
    Way("class", HIGHEST, of="n p5"),
)

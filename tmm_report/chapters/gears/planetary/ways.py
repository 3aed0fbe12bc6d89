"""How the numbers of a planetary stage are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Way

MOTION = N_("From Willis' equation with the member of the row held, the input at speed 1.")
SEARCH = N_(
    "All combinations of teeth within the bounds are judged by the conditions of assembly, "
    "coaxiality, neighbourhood and undercut; those that meet all are ranked."
)
REJECTED = N_("Counted: the combinations whose first condition that fails is this one.")
ROW = N_("By the geometry of the wheels of the mesh: their teeth, module and shifts.")
SCHEME = N_(
    "The search for teeth, repeated for each scheme of the stage; the best solution of each is compared."
)
ETA = N_(
    "By the flow of the power with the carrier stopped: the efficiency of the meshes to the "
    "power of its direction."
)
APART = N_("Twice the centre distance by the sine of half the angle between neighbouring planet gears.")
GAP = N_("The distance of neighbouring axes less the tip diameter of the planet gear.")
TURNS = N_("By the condition of assembly: the turns of the carrier after which the teeth fit whole.")
RULE = N_(
    "By the rule of the course: the least teeth of a wheel cut by a rack, or of a ring, without undercut."
)
U = N_("By Willis' formula from the teeth of the stage.")
DIVISOR = N_("By the algorithm of Euclid from the teeth of both crowns.")

WAYS = (
    Way(
        "stage*_motions.held stage*_motions.input stage*_motions.output stage*_*.mesh "
        "stage*_rejected.reason stage*_schemes.scheme",
        NAME,
    ),
    Way("stage*_motions.*", MOTION, of="held input output u stage{0}_u_carrier"),
    Way("stage*_solutions.place", COUNTED),
    Way("stage*_solutions.*", SEARCH, of="place z_* z1 z2 z3 delta_u D stage{0}_u_wanted"),
    Way("stage*_rejected.combinations", REJECTED, of="reason stage{0}_combinations"),
    Way("stage*_rows.*", ROW, of="mesh stage{0}_m z_sum"),
    Way("stage*_schemes.*", SCHEME, of="scheme teeth u eta"),
    Way("stage*_eta", ETA, of="stage{0}_eta_stopped stage{0}_u_carrier"),
    Way("stage*_apart", APART, of="stage{0}_a_w stage{0}_k stage{0}_m"),
    Way("stage*_gap", GAP, of="stage{0}_apart stage{0}_m"),
    Way("stage*_turns", TURNS, of="stage{0}_k stage{0}_u_carrier"),
    Way("stage*_divisor", DIVISOR, of="stage{0}_k"),
    Way("stage*_u_carrier", U, of="stage{0}_ratio stage{0}_u_wanted"),
    Way(
        "stage*_u_wanted",
        N_("Stated of the stage, or what the other stages leave of the ratio of the drive."),
        of="drive_u_required stage{0}_tolerance",
    ),
    Way("stage*_least_teeth_rounded stage*_ring_rule", RULE, of="stage{0}_ha stage{0}_alpha"),
    Way(
        "stage*_combinations stage*_solutions stage*_k",
        SEARCH,
        of="stage{0}_u_wanted stage{0}_rings_least stage{0}_rings_most stage{0}_external_least "
        "stage{0}_external_most",
    ),
    Way("stage*_*", STATED),
)

"""The pieces of the note that not every department wants, and where each stands at each depth.

A template puts such a piece into `{% call m.piece("chapter.name") %} … {% endcall %}`; all else of it is always in the
note. At `full` every piece stands in the text. The numbers of a piece left out stand in the results.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from tmm_report.problems import N_

Depth = Literal["short", "course", "full"]
Stand = Literal["body", "appendix", "omit"]
DEPTHS: tuple[Depth, ...] = ("short", "course", "full")


class Piece(NamedTuple):
    """What a piece is, and where it stands in a short note and in one of the usual depth."""

    meaning: str
    short: Stand = "omit"
    course: Stand = "body"


PIECES: dict[str, Piece] = {
    "structure.driving_links": Piece(N_("groups and classes with other driving links")),
    "kinematics.contours": Piece(N_("vector loops of the groups, worked out at a position")),
    "kinematics.singular": Piece(N_("how near the groups come to singular positions"), course="appendix"),
    "kinematics.dead_points": Piece(N_("dead points")),
    "kinematics.extremes": Piece(N_("extreme values of the motion of the links")),
    "kinematics.diagrams": Piece(N_("diagrams of the motion of the outputs after the first one")),
    "kinematics.angles": Piece(N_("motion of the links that are no outputs"), course="appendix"),
    "kinematics.analogues": Piece(N_("analogues of velocities and accelerations"), course="appendix"),
    "plans.others": Piece(N_("polygons of the positions after the first one, worked out"), course="omit"),
    "plans.sheets": Piece(
        N_("velocity and acceleration polygons as large as they are drawn; else two share the page")
    ),
    "plans.senses": Piece(N_("senses of angular velocities and accelerations, by the polygons")),
    "plans.compared": Piece(
        N_("comparison of the methods at the positions whose polygons are not worked out")
    ),
    "kinetostatics.loads": Piece(N_("loads over the cycle, drawn")),
    "kinetostatics.directions": Piece(N_("directions of the reactions"), course="appendix"),
    "kinetostatics.curves": Piece(N_("diagrams and hodographs of the reactions"), course="appendix"),
    "kinetostatics.extremes": Piece(N_("extremes of the reactions over the cycle"), course="appendix"),
    "kinetostatics.projections": Piece(
        N_("extremes of the projections of the reactions over the cycle"), course="omit"
    ),
    "kinetostatics.methods": Piece(
        N_("the balancing moment by three methods, position by position"), course="omit"
    ),
    "kinetostatics.works": Piece(
        N_("driving and resisting loads, their works and senses of the moment"), course="appendix"
    ),
    "kinetostatics.powers": Piece(N_("powers of the loads at a position, where no lever is drawn")),
    "force_plans.others": Piece(
        N_("force polygons of the positions after the first one, worked out"), course="omit"
    ),
    "force_plans.groups": Piece(N_("force polygons of the groups after the first one, worked out")),
    "force_plans.sheets": Piece(
        N_("force polygons and loading schemes as large as they are drawn; else several share a page")
    ),
    "force_plans.formulas": Piece(
        N_("inertia forces and readings of the force polygons after the first of a kind, worked out"),
        course="omit",
    ),
    "force_plans.lever": Piece(N_("Zhukovsky's lever, drawn")),
    "friction.formulas": Piece(
        N_("power of friction in every pair, worked out; efficiency by moments"), course="omit"
    ),
    "friction.pairs": Piece(N_("power of friction in each pair, position by position"), course="appendix"),
    "friction.diagram": Piece(N_("power of friction and efficiency over the cycle, drawn")),
    "friction.corrected": Piece(N_("reactions corrected for friction"), course="appendix"),
    "cam.zone": Piece(N_("where the axis of a cam may stand, drawn")),
    "cam.free": Piece(
        N_("the smallest cam with a free offset or distance between the pivots, where one is stated"),
        course="appendix",
    ),
    "cam.laws": Piece(N_("laws of a cam after the first one, worked out")),
    "cam.shocks": Piece(N_("table of the shocks of a law"), course="appendix"),
    "cam.coordinates": Piece(
        N_("coordinates of a cam's profile in a table of their own, velocities and accelerations")
    ),
    "cam.extremes": Piece(N_("extremes of a cam's pressure angle with its sign; the jerk")),
    "cam.profile": Piece(
        N_("profile of a cam that stands alone, drawn beside its construction"), course="omit"
    ),
    "cam.rules": Piece(N_("rules for the roller, worked out")),
    "cam.sheet": Piece(
        N_("construction of a cam by kinematic inversion as large as a sheet holds it; else it is reduced"),
        course="omit",
    ),
    "cam.divisions": Piece(N_("motion of a follower at equal parts of the phases"), course="appendix"),
    "cam_forces.springs": Piece(N_("springs that just keep a follower on its cam"), course="appendix"),
    "cam_forces.spring_line": Piece(
        N_("force of a spring over the displacement against what the inertia requires")
    ),
    "cam_forces.parts": Piece(
        N_("what the forces of a cam are made of, position by position"), course="appendix"
    ),
    "cam_forces.ends": Piece(N_("least and greatest forces of a cam by its phases"), course="appendix"),
    "methods.charts": Piece(
        N_("errors of methods and tables, drawn over their costs and numbers of positions")
    ),
    "flywheel.derivation": Piece(
        N_("masses, loads and energies worked out at a position, the integrals of the work")
    ),
    "flywheel.check": Piece(N_("the exact moment of inertia worked out, the motion with the flywheel")),
    "flywheel.sketch": Piece(N_("drawing of the flywheel")),
    "flywheel.methods": Piece(
        N_("the flywheel by the other methods; comparison of the methods"), course="appendix"
    ),
    "flywheel.speeds": Piece(
        N_("speeds over the cycle with and without the flywheel, the motion in two ways"), course="omit"
    ),
    "balancing.substituted": Piece(
        N_("masses of the links substituted into their joints, worked out"), course="appendix"
    ),
    "balancing.positions": Piece(N_("shaking force and moment before balancing, position by position")),
    "balancing.check": Piece(N_("the shaking force as the sum of the reactions of the frame")),
    "balancing.means": Piece(N_("what the ways of balancing after the first one do")),
    "balancing.ways": Piece(N_("counterweights after the first one, worked out"), course="omit"),
    "balancing.hodographs": Piece(N_("hodographs of the shaking force by the ways of balancing")),
    "balancing.diagrams": Piece(
        N_("shaking force and moment over the cycle by the ways of balancing, drawn"), course="appendix"
    ),
    "balancing.left": Piece(
        N_("shaking force and moment after balancing, position by position"), course="omit"
    ),
    "balancing.moment": Piece(N_("what becomes of the shaking moment"), course="appendix"),
    "balancing.harmonics": Piece(
        N_("harmonics of the shaking force and counter-rotating weights"), course="appendix"
    ),
    "balancing.sliders": Piece(N_("harmonics of a slider and Lanchester's balancer"), course="appendix"),
    "spur.contour": Piece(N_("blocking contour of a pair"), course="appendix"),
    "spur.motion": Piece(
        N_("velocities of the point of contact along the line of action"), course="appendix"
    ),
    "spur.quality": Piece(N_("quality of the mesh over the shifts")),
    "spur.phase": Piece(N_("the mesh with two pairs of teeth in contact"), course="appendix"),
    "spur.inspection": Piece(N_("sizes by which the teeth are measured"), course="appendix"),
    "spur.formulas": Piece(N_("formulas of the dimensions of the wheels of a pair")),
    "spur.worked": Piece(N_("dimensions of the wheels of a pair, worked out in numbers"), course="omit"),
    "spur.further": Piece(
        N_(
            "exact least shift, depth, base thickness, curvature and sliding at the ends of the profiles of a pair"
        )
    ),
    "spur.conditions": Piece(N_("conditions of a pair with their margins")),
    "spur.graph": Piece(N_("contact ratio of a pair by the drawing of its mesh")),
    "spur.sliding": Piece(N_("graph of the specific sliding along the line of action"), course="appendix"),
    "spur.details": Piece(
        N_("least shift, shift of the centres, check of thicknesses and time of two-pair contact of a pair")
    ),
    "spur.points": Piece(N_("specific sliding at the points of the line of action"), course="appendix"),
    "spur.zones": Piece(N_("zones of contact of one and two pairs of teeth"), course="appendix"),
    "spur.readings": Piece(N_("values read off the drawing of a mesh"), course="appendix"),
    "drive.worked": Piece(N_("angular velocities of a drive, one of each kind worked out")),
    "drive.speeds": Piece(N_("angular velocities of a drive that are found as others are"), course="omit"),
    "drive.stages": Piece(N_("table of the stages of a drive, which a sentence lists else")),
    "drive.diagrams": Piece(N_("how the diagrams of velocities of a drive are drawn")),
    "drive.comparison": Piece(
        N_("velocities by the diagrams of a drive against calculation"), course="appendix"
    ),
    "drive.meshes": Piece(N_("flow of the power through the meshes of a drive"), course="appendix"),
    "eccentric.proof": Piece(
        N_("drawn teeth of an eccentric mechanism turned over a pitch"), course="appendix"
    ),
    "eccentric.paths": Piece(
        N_("paths of points of the output wheel of an eccentric mechanism"), course="appendix"
    ),
    "eccentric.masses": Piece(N_("masses of the planet gears of an eccentric mechanism"), course="appendix"),
    "train.solutions": Piece(N_("solutions for the teeth of a train beyond the best few"), course="appendix"),
    "train.speeds": Piece(N_("angular velocities of a train that are found as others are"), course="omit"),
    "train.diagrams": Piece(N_("how the diagrams of velocities of a train are drawn")),
    "train.flow": Piece(
        N_("torques and powers that the meshes of a train give its members, and their forces"),
        course="appendix",
    ),
    "planetary.search": Piece(N_("search for the numbers of teeth of a planetary stage")),
    "planetary.worked": Piece(N_("undercut and interference of a planetary stage, worked out")),
    "planetary.solutions": Piece(
        N_("solutions for the teeth of a stage beyond the best few"), course="appendix"
    ),
    "planetary.ring": Piece(N_("interference with a ring in numbers of teeth"), course="omit"),
    "planetary.conditions": Piece(N_("conditions of a planetary stage with their margins")),
    "planetary.front": Piece(N_("a planetary stage drawn from the front"), course="appendix"),
    "planetary.motions": Piece(
        N_("motions of a planetary stage with each of its members held, and the load of a planet gear"),
        course="appendix",
    ),
}

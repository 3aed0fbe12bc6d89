"""All methods by which the motion of a mechanism can be found, the program's own first.

What is rivalled is the way to places, velocities and accelerations; position 0 and its assembly are stated alike for
all of them.
"""

from __future__ import annotations

from functools import partial

from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.model import MotionMethod
from tmm_report.mechanics.rivals.motion import constraints, drawing, newton, parallelogram
from tmm_report.mechanics.rivals.paper import ACCURACIES
from tmm_report.mechanics.rivals.tables import TABLES
from tmm_report.problems import N_, Message


def _groups(cycle: Cycle, count: int) -> Motion:
    """The program's own way: dyads in closed form, groups above class II followed round."""
    return cycle.motion(cycle.once(count))


def _root_finder(cycle: Cycle, count: int) -> Motion:
    from tmm_report.mechanics.rivals.motion.library import root_finder

    return root_finder(cycle, count)


def no_cams(cycle: Cycle) -> Message | None:
    """Why equations of lower pairs are not enough."""
    if cycle.linkage.mechanism.cams:
        return Message(N_("a cam moves its follower by a law, which no equation of a pair states"))
    return None


MOTIONS: tuple[MotionMethod, ...] = (
    MotionMethod("groups", N_("closed form by groups"), _groups),
    MotionMethod("newton", N_("Newton on the constraint equations"), newton.newton, no_cams),
    MotionMethod("root_finder", N_("general root finder"), _root_finder, no_cams),
    MotionMethod(
        "constraints",
        N_("integration of the constraint equations"),
        constraints.runge_kutta,
        no_cams,
        "RK4",
    ),
    MotionMethod(
        "constraints_corrected",
        N_("integration of the constraint equations, each position corrected"),
        constraints.corrected,
        no_cams,
        "RK4",
    ),
    MotionMethod(
        "constraints_dop853",
        N_("integration of the constraint equations"),
        constraints.dormand_prince,
        no_cams,
        "DOP853, 1e-10",
    ),
    MotionMethod(
        "parallelogram",
        N_("closed form of the parallelogram"),
        parallelogram.parallelogram,
        parallelogram.refuses,
    ),
    *(
        MotionMethod(
            f"drawing_{accuracy:g}",
            N_("drawing"),
            partial(drawing.drawing, accuracy=accuracy),
            no_cams,
            f"{accuracy:g} mm",
        )
        for accuracy in ACCURACIES
    ),
    *TABLES,
)

PLAIN_NEWTON = MotionMethod(
    "plain_newton", N_("Newton without step control"), newton.plain_newton, no_cams
)  # no rival: what failures are shown by


def motion_method(key: str) -> MotionMethod:
    """The method of a key. Raises KeyError."""
    return {method.key: method for method in MOTIONS}[key]

"""How the numbers of ordinary stages are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import STATED, Way

BY_LENGTH = N_(
    "Stated, or by the usual rule; of a stated length of the belt the distance at which the strands and the arcs "
    "together are as long."
)
ROW = N_("Stated, or of the row of preferred numbers R 20 the nearest to what the ratio asks for.")
TURNED = N_("By the speed of the input shaft and the ratios of the stages before.")
TORQUE = N_("From the equilibrium of the members of the drive, with the losses before this stage.")

WAYS = (
    Way("stage*_a stage*_a_about", BY_LENGTH, of="stage{0}_d1 stage{0}_d2 stage{0}_L"),
    Way("stage*_d1 stage*_d2", ROW, of="stage{0}_u"),
    Way("stage*_omega1", TURNED, of="drive_u"),
    Way("stage*_T1", TORQUE, of="stage{0}_u stage{0}_F_t"),
    Way("stage*_epsilon stage*_u_required stage*_f stage*_phi stage*_k stage*_q", STATED),
)

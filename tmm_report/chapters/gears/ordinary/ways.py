"""How the numbers of ordinary stages are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import NAME, Way

BY_LENGTH = N_(
    "Stated, or by the usual rule; of a stated length of the belt the distance at which the strands and the arcs "
    "together are as long."
)
ROW = N_("Stated, or of the row of preferred numbers R 20 the nearest to what the ratio asks for.")
TURNED = N_("By the speed of the input shaft and the ratios of the stages before.")
TORQUE = N_("From the equilibrium of the members of the drive, with the losses before this stage.")

LINKS = N_("Stated, or the even whole number that is nearest to that at the distance wished for.")
WHOLE = N_("Stated, or the whole number that is nearest to what the ratio asks for.")
WISHED = N_(
    "Stated, or by the usual rule: of a chain forty pitches, of a belt by the diameters of both pulleys."
)

WAYS = (
    Way("stage*_a", BY_LENGTH, of="stage{0}_d1 stage{0}_d2 stage{0}_L"),
    Way("stage*_a_about", WISHED, of="stage{0}_p stage{0}_d1 stage{0}_d2"),
    Way("stage*_links", LINKS, of="stage{0}_links_about"),
    Way("stage*_z1 stage*_z2", WHOLE, of="stage{0}_u"),
    Way("stage*_d1 stage*_d2", ROW, of="stage{0}_u"),
    Way("stage*_omega1", TURNED, of="drive_u"),
    Way("stage*_T1", TORQUE, of="stage{0}_u stage{0}_F_t"),
    Way("stage*_train.wheel", NAME),
    Way("stage*_train.z", WHOLE, of="wheel stage{0}_u"),
    Way("stage*_train.d", N_("The teeth by the module."), of="wheel z stage{0}_m"),
    Way("stage*_train.*", N_("Wheel by wheel, as the formulas of the note do."), of="wheel z d stage{0}_m"),
    Way("stage*_psi", N_("The usual 0.285.")),
)

"""How the numbers of a drive from the machine back to the motor are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Known, Way

JUDGED = N_("The rated rotational speed of the motor by the wanted one of the machine.")
LOAD = N_("The power needed from the motor by its rated power.")
PARTS = N_("Stated; of a stage as it is found by its teeth, or stated.")
MESH = N_(
    "The torque that the shaft transmits to the driving wheel, by the radius of its rolling circle; the radial "
    "force by the angle of pressure."
)
DIVIDED = N_("The ratio that is left, divided by the rule among the stages without a stated one.")

RANGE = N_(
    "Stated; else the usual range of the stages without a ratio times the ratios of the others, or that of the drive "
    "within its tolerance."
)


def _divided(q: Known) -> Expr:
    """What the drive leaves a stage whose teeth it finds. Raises KeyError for another stage."""
    row, stages = int(q.parts[0]) - 1, q.book.tables["drive_stages"]
    driving = str(stages["members"].values[row]).partition("–")[0]
    if driving not in list(q.book.tables["drive_sought"]["wheel"].values):
        raise KeyError("its ratio is stated")
    return stages.var("u_required", row)


MOMENTS = N_(
    "Of the balancing moment of the driving link over the cycle: its mean, its greatest size, and where that is."
)

WAYS = (
    Way("drive_M_mean drive_M_greatest drive_M_angle drive_M_fr", MOMENTS, of="drive_P_out drive_omega_out"),
    Way("drive_u_low drive_u_high", RANGE, of="drive_tolerance drive_u_teeth"),
    Way("stage*_u_required", by=_divided),
    Way(
        "drive_motors.motor drive_motors.verdict drive_losses.part drive_losses.wheels drive_sought.wheel "
        "drive_shafts.by drive_mesh_loads.mesh",
        NAME,
    ),
    Way("drive_shafts.shaft drive_losses.count", COUNTED),
    Way("drive_motors.P drive_motors.n", STATED),
    Way("drive_motors.u", JUDGED, by=lambda q: q("n") / q("drive_n_out")),
    Way("drive_motors.load", LOAD, by=lambda q: q("drive_P_req") / q("P")),
    Way("drive_losses.eta", PARTS, of="part"),
    Way(
        "drive_sought.z",
        N_("Stated of one wheel; of the other one rounded to a whole number."),
        of="wheel z_exact",
    ),
    Way("drive_mesh_loads.*", MESH, of="mesh F_t"),
    Way("drive_stages.u_required", DIVIDED, of="drive_u_rest drive_factor"),
)

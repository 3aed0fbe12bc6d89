"""How the numbers of a gear drive are found that no formula of the note defines; then those of its stages."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import add, mul

from tmm_report.chapters.gears.drive.power.ways import WAYS as POWER
from tmm_report.chapters.gears.ordinary.ways import WAYS as ORDINARY
from tmm_report.chapters.gears.planetary.ways import WAYS as PLANETARY
from tmm_report.chapters.gears.spur.ways import WAYS as SPUR
from tmm_report.problems import N_
from tmm_report.quantity.formula import PI, Expr
from tmm_report.quantity.ways import COUNTED, NAME, STATED, Known, Way

WILLIS = N_("From Willis' equations of all meshes, solved together with the stated speeds.")
ETA = N_(
    "The useful power by the supplied: torques and powers of all members, with the losses of the meshes."
)
LOSSES = N_("Of each mesh what its power in the motion about the carrier loses; summed.")
TORQUES = N_(
    "From the equilibrium of every member and the power that each mesh transmits, by its driving wheel."
)
READ = N_("Read off the drawing to its accuracy, and multiplied by the scale.")
SCALE = N_("Chosen so that the drawing fits the paper, from the usual scales.")
DIFFER = N_("The difference of both by their mean, in per cent.")
STAGE = N_("By the teeth of the stage, its second input at rest.")
MESH = N_(
    "Stated for pairs of the kind, or the usual value: the power that is handed on with the carrier stopped."
)


def _over_stages(q: Known, key: str) -> Expr:
    """The product over the stages."""
    table = q.book.tables["drive_stages"]
    factors: list[Expr] = [table.var(key, k) for k in range(len(table))]
    return reduce(mul, factors)


def _eta(q: Known) -> Expr:
    """The product of the stages' where they stand in series, else the powers of the members."""
    if not q.found.differential:
        total = _over_stages(q, "eta")
        if abs(float(total.value) - q.found.efficiency) <= 1e-12:
            return total
    loads = q.book.tables["drive_loads"]
    powers = [loads.var("N", k) for k in range(len(loads))]
    supplied = [one for one in powers if float(one.number) > 0]
    useful = [one for one in powers if float(one.number) < 0]
    if not supplied or not useful or not q.found.efficiency:
        raise KeyError("it locks")
    return -_sum(useful) / _sum(supplied)


def _sum(terms: Sequence[Expr]) -> Expr:
    return reduce(add, terms)


def _losses(q: Known) -> Expr:
    table = q.book.tables["drive_meshes"]
    return _sum([table.var("N_fr", k) for k in range(len(table))])


WAYS = (
    *POWER,
    Way(
        "drive_*.key drive_*.unit drive_*.member drive_*.members drive_*.mesh drive_*.carrier "
        "drive_*.driving",
        NAME,
    ),
    Way("drive_stages.stage", COUNTED),
    Way("drive_stages.u", STAGE, of="members"),
    Way(
        "drive_stages.u_required",
        N_("Stated, or what the other stages leave of the ratio of the whole drive."),
        of="members u drive_u_required",
    ),
    Way("drive_stages.eta", ETA, of="members u"),
    Way("drive_speeds.z", N_("The teeth of the stage that the member is of."), of="member"),
    Way("drive_speeds.n", by=lambda q: 30 * q("omega") / PI),
    Way("drive_speeds.*", WILLIS, of="member omega z"),
    Way("drive_segments.s", READ, of="member drive_mu_omega drive_step"),
    Way("drive_comparison.delta", DIFFER, of="key graph analytic"),
    Way("drive_comparison.graph", READ, of="key drive_mu_omega drive_mu_v drive_step"),
    Way("drive_comparison.analytic", WILLIS, of="key"),
    Way("drive_loads.*", TORQUES, of="member T N"),
    Way("drive_meshes.eta", MESH, of="mesh"),
    Way("drive_meshes.*", LOSSES, of="mesh eta N"),
    Way("drive_eta", ETA, by=_eta),
    Way("drive_eta", ETA, of="stage*_eta"),
    Way("drive_losses", LOSSES, by=_losses),
    Way("drive_u", WILLIS, of="drive_u_teeth stage*_ratio"),
    Way("drive_u_teeth", by=lambda q: _over_stages(q, "u")),
    Way(
        "drive_u_required",
        N_("Stated of the drive, or by the stated speeds of its ends."),
        of="drive_u drive_tolerance",
    ),
    Way("drive_mu_l drive_mu_omega drive_mu_v drive_h", SCALE, of="drive_v drive_step"),
    Way(
        "drive_arm",
        N_("Chosen on the drawing: the pitch radius of the first wheel, or of the carrier."),
        of="drive_v",
    ),
    Way("drive_teeth.mesh", NAME),
    Way("drive_*", STATED),
    *ORDINARY,
    *SPUR,
    *PLANETARY,
)

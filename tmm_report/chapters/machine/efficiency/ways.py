"""How the numbers of machines joined are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.ways import NAME, STATED, Known, Way

OF_PARTS = N_(
    "Of a module as stated; in series the product of its parts', in parallel by the shares of their powers."
)
SHARE = N_(
    "Stated of one side; the share of the other side follows by the efficiencies of the parallel parts."
)
POWER = N_(
    "From the whole's power along the tree: in series the output of the part before, in parallel its share."
)
CHECK = N_("The input less the output less what all modules lose, by the input.")


def _supplied(q: Known) -> Expr:
    """Where the power at the output is the stated one."""
    if q.found.given.output is None:
        raise KeyError("stated")
    return q("P_out_whole") / q("eta_whole")


def _useful(q: Known) -> Expr:
    if q.found.given.output is not None:
        raise KeyError("stated")
    return q("P_in_whole") * q("eta_whole")


WAYS = (
    Way("efficiency_parts.index efficiency_parts.name efficiency_parts.kind", NAME),
    Way("efficiency_parts.eta", OF_PARTS, of="kind"),
    Way("efficiency_parts.psi", by=lambda q: 1 - q("eta")),
    Way("efficiency_parts.P_lost", by=lambda q: q("P_in") - q("P_out")),
    Way("efficiency_parts.P_out", POWER, by=lambda q: q("P_in") * q("eta")),
    Way("efficiency_parts.P_in", POWER, of="kind share"),
    Way("efficiency_parts.share efficiency_parts.output_share", SHARE, of="name kind eta"),
    Way(
        "efficiency_parts.kappa",
        N_(
            "The derivative of the whole's efficiency with respect to the part's, by the chain rule along the tree."
        ),
        of="eta",
    ),
    Way("P_in_whole", by=_supplied),
    Way("P_out_whole", by=_useful),
    Way("P_in_whole P_out_whole", STATED),
    Way("efficiency_imbalance", CHECK, of="P_in_whole P_out_whole"),
)

"""How the numbers of an engine's balance are found that no formula of the note defines."""

from __future__ import annotations

from tmm_report.problems import N_
from tmm_report.quantity.ways import AXIS, COUNTED, NAME, STATED, Way

CRANK = N_(
    "The angle of the crank from the cylinder's axis by the order: the direct crank turns with "
    "the shaft, the reverse against it."
)
ORDER = N_(
    "The sums of the direct and of the reverse cranks of the order over all cylinders: the "
    "greatest is the sum of their sizes, the least the difference."
)
SERIES = N_(
    "The coefficient of the slider's acceleration: by Fourier's sums of the exact motion, and "
    "by the series in λ."
)
FORCE = N_(
    "The inertia forces of all cylinders at the angle, by the exact motion; their moments by "
    "the places along the shaft."
)
GREATEST = N_("The greatest over a cycle of the shaft.")
REMEDY = N_("A weight against the sum of the direct, or of the reverse, cranks of the order.")
FIRING = N_("By the stated order of firing and the angles of the cranks.")
POLYGON = N_("By the polygon of the cranks at its scale.")
DIFFER = N_("The difference of both by their mean, in per cent.")
LAYOUT = N_(
    "By the layout that the variant states: the angles of the cranks, of the rows and the "
    "places of the cylinders."
)
SCALE = N_("Chosen so that the polygons fit the paper, from the usual scales.")

WAYS = (
    Way("engine_*.cylinder engine_*.of engine_*.unit engine_*.kind engine_*.stage engine_*.key", NAME),
    Way("engine_orders.order engine_remedies.order", COUNTED),
    Way("engine_diagram.phi", AXIS),
    Way("engine_cylinders.direct_* engine_cylinders.reverse_*", CRANK, of="cylinder psi beta"),
    Way("engine_cylinders.*", LAYOUT, of="cylinder psi engine_count"),
    Way("engine_firing.*", FIRING, of="cylinder angle"),
    Way("engine_orders.c engine_orders.c_exact", SERIES, of="order engine_lambda engine_r engine_l"),
    Way("engine_orders.* engine_primary.*", ORDER, of="order stage F_forward F_backward"),
    Way("engine_diagram.*", FORCE, of="phi engine_omega"),
    Way("engine_greatest.*", GREATEST, of="of before orders after"),
    Way("engine_remedies.*", REMEDY, of="order of kind"),
    Way("engine_polygons.graph engine_polygons.d_*", POLYGON, of="key engine_mu_F engine_mu_M"),
    Way("engine_polygons.analytic", ORDER, of="key graph"),
    Way("engine_polygons.delta", DIFFER, of="key graph analytic"),
    Way("engine_mu_F engine_mu_M", SCALE, of="engine_omega"),
    Way("engine_count", N_("Counted: the cylinders that the variant states."), of="engine_omega"),
    Way("engine_*", STATED),
)

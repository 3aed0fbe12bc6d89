"""Why the contact of a pair is shorter than between the tip circles, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.gears.spur.words import EARLY, LATE, POINTED

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.view.pair import SpurView


def reasons(view: SpurView) -> list[Markup]:
    """A sentence for each wheel at whose root the contact ends early."""
    return [_reason(view, i) for i in (0, 1) if view.found.late(i)]


def _reason(view: SpurView, i: int) -> Markup:
    start, lower, real = (view.page.shown(view.sizes, key, i) for key in ("rho_l", "rho_m", "rho_p"))
    names = {"wheel": view.names[i], "other": view.names[1 - i]}
    if not np.isclose(view.found.starts[i], float(view.pair.rho_p[i]), rtol=1e-9):
        return view.t(POINTED, **names, real=real, lower=lower)
    return view.t(EARLY if view.found.pair.signs[i] < 0 else LATE, **names, start=start, lower=lower)

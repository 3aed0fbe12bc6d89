"""The spring over the displacement against what the inertia asks of it: the line of the spring lies above the loop
where the follower stays on its cam, and touches it where a spring just holds."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.cams.cam.quantities import displacement
from tmm_report.chapters.cams.cam_forces import quantities as q
from tmm_report.chapters.cams.cam_forces.solve import Found
from tmm_report.figures.charts.plane import Trace, framed, plane
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.quantity.paper import round_scale
from tmm_report.quantity.units import factor
from tmm_report.report.diagrams import CycleGraphs
from tmm_report.report.page import Page

FINE = 1441
FIELD = (110.0, 70.0)  # mm: largest width and height between the axes


def loop(found: Found, page: Page) -> Drawing:
    """Abscissa the displacement, mm or degrees; ordinate what the spring has to hold, and its own force."""
    loaded = found.loaded
    reserve = found.given.spring.reserve if found.given.spring else 1.0
    edges = loaded.panels.edges
    turned = np.unique(
        np.concatenate([np.linspace(0, FULL_TURN, FINE), edges, np.clip(edges - 1e-7, 0, None)])
    )
    parts, S = loaded.parts(turned), loaded.lifted(turned)[0]
    own, shown = displacement(found.cam), "mm" if found.slides else "deg"
    x = S * factor(own.unit, shown)
    asked = -(reserve * parts.inertia + parts.load + parts.weight)
    ends = np.array([0.0, loaded.lift])
    held = ends * factor(own.unit, shown) + 1j * (loaded.spring.preload + loaded.spring.rate * ends)
    graphs = CycleGraphs(np.zeros(2), 0, page.tr)
    curve = x + 1j * asked
    traces = [Trace(curve), Trace(held, graphs.letter(q.spring(found).sign))]
    force = q.spring(found)
    along = graphs.letter(own.sign, shown)
    up = graphs.letter(force.sign, force.unit)
    spans = [(ends.max() - min(0.0, ends.min())) or 1.0 for ends in (x, np.append(asked, held.imag))]
    mu = [round_scale(span, room) for span, room in zip(spans, FIELD, strict=True)]
    return plane(framed([curve, held], scales=(mu[0], mu[1])), traces, along, up, page.num)

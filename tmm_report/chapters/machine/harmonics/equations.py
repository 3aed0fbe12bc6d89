"""Place of a point of a rod in the axes of its guide, of the numbers of the mechanism."""

from __future__ import annotations

from tmm_report.chapters.machine.harmonics.solve import Found, Wave
from tmm_report.chapters.machine.harmonics.values import Rod
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Var, cos, sin, sqrt
from tmm_report.quantity.model import variable


def rod(found: Found, wave: Wave) -> list[Definition]:
    """x along the guide from the pivot of the crank, y across it in the sense of rotation; their values are those at
    the parts of the way and the angles of the samples, (M, N), m."""
    crank = wave.crank
    assert crank is not None
    r, length = variable(Rod.r.quantity, crank.r), variable(Rod.l.quantity, crank.l)
    phi = variable(Rod.phi.quantity, crank.angle(found.turned))
    xi, e = variable(Rod.xi.quantity, wave.xi[:, None]), Var("e", crank.offset)
    across = r * sin(phi) if crank.central else r * sin(phi) - e
    y = (1 - xi) * r * sin(phi)
    x = r * cos(phi) + xi * sqrt(length**2 - across**2)
    return [Definition("x", x), Definition("y", y if crank.central else y + xi * e)]

"""Integration of equations of motion where no integral in closed form exists: scipy's LSODA and DOP853.

LSODA (Petzold, SIAM J. Sci. Stat. Comput. 4, 1983) changes by itself between Adams' formulas and, in a stiff start-up,
backward differences; it is compiled, so that a step costs little more than the forces.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import Any

from tmm_report.records import dataclass

Array = Any
Rate = Callable[[float, Array], Array]  # dy/dx of x and y (N,)
Event = Callable[[float, Array], float]  # passes through zero
RELATIVE = 1e-10  # tolerance of a step, of each unknown's size
ABSOLUTE = 1e-12


CLOSER = (
    1.0,
    0.5,
    0.25,
)  # of the relative error: where the steps of one do not do, those of the next are others


@dataclass(frozen=True, eq=False)
class Trajectory:
    """`x` (P,) and the unknowns `y` (N, P); `ended`: the number of the event that ended it, None where the span did;
    `at`: (N, Q) of any x (Q,) within it; `steps`: evaluations of the rates."""

    x: Array
    y: Array
    ended: int | None
    at: Callable[[Array], Array]
    steps: int


def integrate(
    rate: Rate,
    start: Array,
    span: tuple[float, float],
    *,
    events: Sequence[Event] = (),
    method: str = "LSODA",
    relative: float = RELATIVE,
    absolute: float | Array = ABSOLUTE,
    longest: float = float("inf"),
) -> Trajectory:
    """The solution of y' = rate(x, y) from `start` (N,) over the span, ended by the first event that reaches zero.

    `longest`: step that may be taken at most: where the rates have breaks. Raises ArithmeticError where the solution
    cannot be continued (it grows beyond every bound).
    """
    from scipy.integrate import solve_ivp

    for event in events:
        event.terminal = True  # type: ignore[attr-defined]
    for closer in CLOSER:
        try:
            with warnings.catch_warnings():  # what scipy warns of is told by its status, too
                warnings.filterwarnings("ignore", message="lsoda:")
                found = solve_ivp(
                    rate, span, start, method=method, rtol=closer * relative, atol=absolute,
                    events=list(events) or None, dense_output=True, max_step=longest,
                )  # fmt: skip
            if found.status >= 0:
                break
        except ValueError as error:
            # an event at the very end of a step: scipy sees it in the unknowns there and not in their interpolant
            if "different signs" not in str(error) or closer == CLOSER[-1]:
                raise
    if found.status < 0:
        raise ArithmeticError(found.message)
    hit = next((k for k, places in enumerate(found.t_events or ()) if len(places)), None)
    return Trajectory(found.t, found.y, hit if found.status == 1 else None, found.sol, int(found.nfev))

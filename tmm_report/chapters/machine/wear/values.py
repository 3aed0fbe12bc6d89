"""Single values of the wear, by the prefix of a guide or a pivot."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.wear.guide import GuideFound
from tmm_report.chapters.machine.wear.pivot import PivotFound
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import math_symbol

WORDS = (NP_("index", "bound"), NP_("index", "unif"), NP_("index", "rep"), NP_("index", "begin"))

HOUR = 3600.0  # s

# key -> symbol, unit, meaning
GUIDE = {
    "stroke": ("S_max", "m", N_("stroke of the slider")),
    "slider": ("l_s", "m", N_("length of the slider")),
    "length": ("L", "m", N_("length of the guide that wears")),
    "width": ("b", "m", N_("width of the faces")),
    "parts": ("N", "", N_("number of equal parts of the guide")),
    "step": ("Delta_L", "m", N_("length of a part")),
    "ratio": ("n_s", "", N_("parts of the guide on the length of the slider")),
    "covered": ("N_s", "", N_("points of the guide under the slider")),
    "positions": ("P", "", N_("positions of the cycle over which it is summed")),
    "cycles": ("N_c", "", N_("number of cycles")),
    "period": ("T", "s", N_("time of a cycle")),
    "time": ("t_c", "h", N_("time of all the cycles")),
    "greatest": ("u_max", "m", N_("greatest wear")),
    "repair": ("x_rep", "m", N_("place of the guide worn most, from its beginning")),
    "even": ("u_unif", "m", N_("wear of that face of the guide if it wore evenly")),
    "uneven": ("kappa", "", N_("unevenness: greatest wear of that face by the even one")),
    "shift": ("delta_max", "m", N_("greatest displacement of the slider across the guide")),
    "tilt": ("theta_max", "rad", N_("greatest tilt of the slider")),
    "rate": ("gamma", "µm/h", N_("rate of steady wear where it is greatest")),
    "limit": ("u_bound", "m", N_("limit of the wear")),
    "run_in": ("u_0", "m", N_("wear of running in")),
    "constant": ("tau", "h", N_("time constant of running in")),
    "life": ("t_bound", "h", N_("time until the limit of the wear")),
    "life_cycles": ("N_bound", "", N_("cycles until the limit of the wear")),
    "volume": ("V", "m³", N_("volume worn off slider and guide")),
    "density": ("rho", "kg/m³", N_("density of the material")),
    "mass": ("m", "kg", N_("mass worn off slider and guide")),
}
PIVOT = {
    "diameter": ("d", "m", N_("diameter of the journal")),
    "width": ("b", "m", N_("width of the bushing")),
    "arc": ("alpha", "rad", N_("half the angle of contact")),
    "sectors": ("N", "", N_("number of sectors of the circumference")),
    "positions": ("P", "", N_("positions of the cycle over which it is summed")),
    "cycles": ("N_c", "", N_("number of cycles")),
    "pressure": ("p", "Pa", N_("mean pressure on the projection of the journal")),
    "rubbed": ("W", "N·m", N_("sum of reaction by path over a cycle")),
    "spread": ("lambda", "", N_("sum of the pressures by the reaction")),
    "greatest": ("u_max", "m", N_("greatest wear")),
    "limit": ("u_bound", "m", N_("limit of the wear")),
    "life_cycles": ("N_bound", "", N_("cycles until the limit of the wear")),
}


def guide_values(found: GuideFound, prefix: str) -> Iterator[Value]:
    given, grid = found.given, found.grid
    worst, run = found.worst_guide, given.running_in
    shift, tilt = found.settled
    volume = sum(found.volume(one) for one in found.surfaces)
    numbers = {
        "stroke": found.stroke,
        "slider": given.length,
        "length": found.length,
        "width": given.width,
        "parts": given.parts,
        "step": grid.step,
        "ratio": given.length / grid.step,
        "covered": grid.covered,
        "positions": len(found.force),
        "cycles": given.cycles,
        "period": found.period,
        "time": found.time / HOUR,
        "greatest": found.worst.greatest,
        "repair": grid.x[worst.worst],
        "even": found.even,
        "uneven": worst.greatest / found.even if found.even else math.nan,
        "shift": _largest(shift),
        "tilt": _largest(tilt),
        "rate": 1e6 * HOUR * found.rate,
        "limit": given.limit,
        "run_in": run.wear if run else None,
        "constant": run.time / HOUR if run else None,
        "life": None if found.life is None else found.life / HOUR,
        "life_cycles": None if found.life is None else found.life / found.period,
        "volume": volume,
        "density": given.density,
        "mass": None if given.density is None else given.density * volume,
    }
    yield from _values(GUIDE, prefix, numbers)


def _largest(values: np.ndarray) -> float:
    """The size of the largest, of none 0."""
    return float(np.nanmax(np.abs(values), initial=0.0))


def pivot_values(found: PivotFound, prefix: str) -> Iterator[Value]:
    given = found.given
    numbers = {
        "diameter": given.diameter,
        "width": given.width,
        "arc": given.arc,
        "sectors": given.sectors,
        "positions": len(found.force),
        "cycles": given.cycles,
        "pressure": found.pressure,
        "rubbed": found.rubbed,
        "spread": found.spread,
        "greatest": found.worst.greatest,
        "limit": given.limit,
        "life_cycles": found.life,
    }
    yield from _values(PIVOT, prefix, numbers)


def _values(
    of: dict[str, tuple[str, str, str]], prefix: str, numbers: dict[str, float | None]
) -> Iterator[Value]:
    for key, number in numbers.items():
        if number is not None and not math.isnan(number):
            symbol, unit, text = of[key]
            yield Quantity(f"{prefix}_{key}", math_symbol(symbol), unit, Message(text)).value(float(number))

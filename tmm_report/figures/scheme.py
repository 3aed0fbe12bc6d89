"""Schemes of a mechanism: one position, all positions together, and its groups taken apart.

`places` maps each point to its world places, complex (P,), m; `turns` maps each link to the unit direction of its
x axis, complex (P,); `mu_l` is m of the mechanism per mm of paper, None: a standard scale that fits the page.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import product

import numpy as np

from tmm_report.figures.apart import in_rows, taken_off
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.superposed import labelled, position_tags, superposed, with_numbers
from tmm_report.figures.view import Arrays, view_of
from tmm_report.mechanics.mechanism import Mechanism

PAGE = (168.0, 228.0)  # what a drawing may fill of a sheet, mm
GROUPS_PAGE = (168.0, 130.0)  # what the groups taken apart may fill

Group = tuple[str, Sequence[str]]  # its name as it is printed, its links ("0" with the driving link)


def scheme(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    mu_l: float | None = None,
    position: int = 0,
    zero: complex = 1.0,
    title: str = "",
) -> Drawing:
    """One position. `zero`: unit direction from which the driver's angle is counted in its sense of rotation."""

    def draw(mu: float) -> Drawing:
        view = view_of(mechanism, places, turns, mu, position)
        items = (*view.plates(), *view.frame(), *view.links(), *view.rotation(), *view.angle(zero))
        tags = view.point_tags() + view.number_tags() + view.rotation_tags() + view.angle_tags(zero)
        return Drawing(items, title).labelled(tags)

    return draw(mu_l) if mu_l else draw(standard_scale(mechanism, places, turns))


def positions_scheme(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    mu_l: float | None = None,
    position: int = 0,
    paths: Arrays | None = None,
    traced: Sequence[str] = (),
    title: str = "",
) -> Drawing:
    """All positions, `position` drawn thick, the places of cranks, rockers and sliders numbered.

    `paths`: denser places of the points, complex (Q,), m, for their trajectories; `traced` names points to trace
    beside the coupler points, mass centres for example.
    """
    mu = mu_l or standard_scale(mechanism, places, turns)
    view = view_of(mechanism, places, turns, mu, position)
    items = (*superposed(view, paths or {}, traced), *view.rotation())
    drawing = Drawing(items, title).labelled(view.point_tags())
    for point in labelled(view):
        drawing = with_numbers(drawing, position_tags(view, point))
    return drawing.labelled(view.number_tags() + view.rotation_tags())


def groups_apart(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    groups: Sequence[Group],
    position: int = 0,
    mu_l: float | None = None,
    title: str = "",
) -> Drawing:
    """The driving link and the Assur groups side by side, each over its name, outer joints as free halves."""

    def draw(mu: float) -> Drawing:
        view = view_of(mechanism, places, turns, mu, position)
        return Drawing(in_rows([taken_off(view, name, links) for name, links in groups], PAGE[0] - 2), title)

    return draw(mu_l) if mu_l else draw(_fitting(_span(places) / PAGE[0], draw, GROUPS_PAGE))


# --- scales ---


def standard_scale(mechanism: Mechanism, places: Arrays, turns: Arrays) -> float:
    """The finest of the scales 1, 2, 2.5, 4, 5 x 10^n m/mm at which all positions fit the page."""
    page = (PAGE[0] - 2, PAGE[1] - 8)  # the rest is for lettering, left out here for speed

    def draw(mu: float) -> Drawing:
        view = view_of(mechanism, places, turns, mu, 0)
        return Drawing(tuple(superposed(view, places, ())))

    return _fitting(_span(places) / PAGE[1], draw, page)


def _fitting(least: float, draw: Callable[[float], Drawing], page: tuple[float, float]) -> float:
    """The least standard scale, m/mm, not under `least`, whose drawing fits the page."""
    power = math.floor(math.log10(least)) if least > 0 else -3
    scales = [digit * 10.0 ** (power + more) for more, digit in product(range(4), (1, 2, 2.5, 4, 5))]
    for mu in scales:
        if mu >= least and all(size <= room for size, room in zip(draw(mu).size, page, strict=True)):
            return float(f"{mu:.3g}")
    return float(f"{scales[-1]:.3g}")


def _span(places: Arrays) -> float:
    """The greater side of the box that holds all places, m."""
    every = np.concatenate([np.ravel(place) for place in places.values()])
    every = every[np.isfinite(every)]
    return float(max(np.ptp(every.real), np.ptp(every.imag))) if len(every) else 0.0

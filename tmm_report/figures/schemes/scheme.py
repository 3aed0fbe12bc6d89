"""Schemes of a mechanism: one position, all positions together, and its groups taken apart.

`places` maps each point to its world places, complex (P,), m; `turns` maps each link to the unit direction of its
x axis, complex (P,); `mu_l` is m of the mechanism per mm of paper, None: a standard scale that fits the page.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from tmm_report.figures.drawing import Drawing, Item, Tag
from tmm_report.figures.schemes.apart import in_rows, taken_off
from tmm_report.figures.schemes.detail import Place, ring_reach, with_detail
from tmm_report.figures.schemes.strokes import CLEAR, OUTSIDE, Stroke, stroke_bands, stroke_tags
from tmm_report.figures.schemes.superposed import labelled, position_tags, superposed
from tmm_report.figures.schemes.ties import Tie
from tmm_report.figures.schemes.view import Arrays, View, view_of
from tmm_report.mechanics.lever.mechanism import Mechanism

PAGE = (165.0, 228.0)  # what a drawing may fill of a sheet, mm
GROUPS_PAGE = (165.0, 130.0)  # what the groups taken apart, or one position, may fill
SMALL, FEWER = (165.0, 75.0), 2.5  # the same in a shorter note, and how much smaller it is made for that

Group = tuple[str, Sequence[str]]  # its name as it is printed, its links ("0" with the driving link)


class Drawn(NamedTuple):
    """A drawing and its scale, m of the mechanism per mm of paper."""

    mu: float
    drawing: Drawing


def scheme(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    mu_l: float | None = None,
    position: int = 0,
    zero: complex = 1.0,
    title: str = "",
    detailed: bool = True,
    ties: Sequence[Tie] = (),
) -> Drawing:
    """One position. `zero`: unit direction from which the driver's angle is counted in its sense of rotation.
    `detailed`: with a larger detail where the crank is short; `ties`: springs and dampers."""

    def draw(view: View, place: Place) -> tuple[Sequence[Item], Sequence[Tag]]:
        items, tags = (
            [*view.plates(), *view.frame(), *view.links()],
            [*view.point_tags(), *view.number_tags(), *view.tied.tags()],
        )
        if place == "beside":
            return items, tags
        turning = view.driving_tags() + view.angle_tags(zero)
        return [*items, *view.driving(), *view.angle(zero)], [*tags, *turning]

    mu = mu_l or standard_scale(mechanism, places, turns)
    return with_detail(
        lambda scale: view_of(mechanism, places, turns, scale, position, ties), mu, draw, title, detailed
    )


def positions_scheme(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    mu_l: float | None = None,
    position: int = 0,
    paths: Arrays | None = None,
    traced: Sequence[str] = (),
    strokes: Sequence[Stroke] = (),
    title: str = "",
    ties: Sequence[Tie] = (),
) -> Drawing:
    """All positions, `position` drawn thick, the places of cranks, rockers and sliders numbered.

    `paths`: denser places of the points, complex (Q,), m, for their trajectories; `traced` names points to trace
    beside the coupler points, mass centres for example; `strokes`: working strokes, marked round the driver's circle;
    `ties`: springs and dampers.
    """

    def draw(view: View, place: Place) -> tuple[Sequence[Item], Sequence[Tag]]:
        numbers = [tag for point in _numbered(view, place) for tag in position_tags(view, point)]
        tags = [*view.point_tags(), *numbers, *view.number_tags(), *view.tied.tags()]
        tags += [] if place == "beside" else view.driving_tags()
        turning = [] if place == "beside" else view.driving()
        shown = () if place == "detail" else strokes
        outside = OUTSIDE if place == "alone" else ring_reach(view) - view.crank[0] + CLEAR
        items = superposed(view, paths or {}, traced, stroke_bands(view, shown, outside))
        return [*items, *turning], [*tags, *stroke_tags(view, shown, outside)]

    mu = mu_l or standard_scale(mechanism, places, turns)
    return with_detail(
        lambda scale: view_of(mechanism, places, turns, scale, position, ties), mu, draw, title
    )


def _numbered(view: View, place: Place) -> list[str]:
    """Joints whose positions are numbered: those of the driver where it is drawn large enough for that."""
    crank = {point for point in labelled(view) if view.driver in view.joints[point]}
    return [p for p in labelled(view) if place == "alone" or (p in crank) == (place == "detail")]


def groups_apart(
    mechanism: Mechanism,
    places: Arrays,
    turns: Arrays,
    groups: Sequence[Group],
    position: int = 0,
    least: float = 0.0,
    small: bool = False,
) -> Drawn:
    """The driving link and the Assur groups side by side, each over its name, outer joints as free halves: at `least`,
    m/mm, where they fit a page at it; else at the finest standard scale at which they fit the part of a page that is
    theirs."""

    def draw(mu: float) -> Drawing:
        return Drawing(_apart(view_of(mechanism, places, turns, mu, position), groups))

    return in_text(draw, least, places, PAGE, small)


def in_text(
    draw: Callable[[float], Drawing],
    least: float,
    places: Arrays,
    page: tuple[float, float],
    small: bool = False,
) -> Drawn:
    """A drawing at the scale `least`, m/mm, if it fits the `page` at it, else at the finest standard scale at which it
    fits a part of one. `small`: made as much smaller, by FEWER at most, as lets it take a third of a page."""
    drawn = draw(least) if least else None
    if drawn is not None and _fits(drawn, page):
        found = Drawn(least, drawn)
    else:
        found = _fitting(max(least, _span(places) / PAGE[0]), draw, GROUPS_PAGE)
    return _smaller(found, draw) if small else found


def _smaller(drawn: Drawn, draw: Callable[[float], Drawing]) -> Drawn:
    tried = [drawn]
    for mu in _standard(drawn.mu):
        if not _fits(tried[-1].drawing, SMALL) and drawn.mu < mu <= FEWER * drawn.mu:
            tried.append(Drawn(mu, draw(mu)))
    return tried[-1]


def _apart(view: View, groups: Sequence[Group]) -> tuple[Item, ...]:
    return in_rows([taken_off(view, name, links) for name, links in groups], PAGE[0] - 2)


# --- scales ---


def standard_scale(mechanism: Mechanism, places: Arrays, turns: Arrays) -> float:
    """The finest of the scales 1, 2, 2.5, 4, 5 x 10^n m/mm at which all positions fit the page."""
    page = (PAGE[0], PAGE[1] - 8)  # the rest is for lettering, left out here for speed

    def draw(mu: float) -> Drawing:
        view = view_of(mechanism, places, turns, mu, 0)
        return Drawing(tuple(superposed(view, places, ())))

    return _fitting(_span(places) / PAGE[1], draw, page).mu


def reduced(own: float, draw: Callable[[float], Iterable[Drawing]], page: tuple[float, float]) -> float:
    """The scale `own` of drawings that all fit the page at it, else the finest standard one at which they do."""
    scales = [own, *_standard(own)]
    return next((mu for mu in scales if all(_fits(one, page) for one in draw(mu))), scales[-1])


def _fitting(least: float, draw: Callable[[float], Drawing], page: tuple[float, float]) -> Drawn:
    """The least standard scale, m/mm, not under `least`, whose drawing fits the page, else the greatest."""
    scales = _standard(least)
    tried = (Drawn(mu, draw(mu)) for mu in scales)
    return next((one for one in tried if _fits(one.drawing, page)), None) or Drawn(
        scales[-1], draw(scales[-1])
    )


def _standard(least: float) -> list[float]:
    """Standard scales not under `least`, from the finest on."""
    power = math.floor(math.log10(least)) if least > 0 else -3
    digits = product(range(4), (1, 2, 2.5, 4, 5))
    scales = [float(f"{digit * 10.0 ** (power + more):.3g}") for more, digit in digits]
    return [mu for mu in scales if mu >= least]


def _fits(drawing: Drawing, page: tuple[float, float]) -> bool:
    return all(size <= room for size, room in zip(drawing.size, page, strict=True))


def _span(places: Arrays) -> float:
    """The greater side of the box that holds all places, m."""
    every = np.concatenate([np.ravel(place) for place in places.values()])
    every = every[np.isfinite(every)]
    return float(max(np.ptp(every.real), np.ptp(every.imag))) if len(every) else 0.0

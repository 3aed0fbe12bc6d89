"""The numbers of a synthesis: single ones, the points it goes through, lengths as they are taken, the demand met."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.lever.synthesis import body_steps, points_steps, positions_steps, rocker_steps, steps
from tmm_report.chapters.lever.synthesis.given import (
    AnglePairs,
    Body,
    CrankRocker,
    Generator,
    RockerPositions,
    SliderCrank,
    SliderPositions,
)
from tmm_report.chapters.lever.synthesis.solve import Found
from tmm_report.chapters.lever.synthesis.values import Pairs, Values
from tmm_report.i18n import NP_
from tmm_report.mechanics.lever import synthesis
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

POINTS = 91  # of a chart of a family or of a function
FAMILY = Message(N_("linkages that meet the demand"))
SOLUTIONS = Message(N_("linkages that lead the body from one position to the other, the best first"))
SLIDERS = Message(N_("slider-cranks that meet the demand, the one that is taken the first"))
ROCKERS = Message(N_("crank-rockers that meet the demand, the one that is taken the first"))
WAY = Message(N_("the linkage between the pairs of angles"))
COURSE = Message(N_("what the linkage makes of the function"))
PSI_WANTED = Quantity(
    "psi_wanted", Symbol("psi", NP_("index", "want")), "rad", Message(N_("wanted angle of the rocker")), "deg"
)
ERROR = Quantity(
    "error", Symbol("Delta"), "rad", Message(N_("angle of the rocker less the wanted one")), "deg"
)
TRANSMISSION = Quantity("transmission", Symbol("mu"), "rad", Message(N_("transmission angle")), "deg")
X = Quantity("x", Symbol("x"), "", Message(N_("variable of the function")))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    design = found.design
    if design.table is not None:
        yield design.table
    if found.given.round is not None:
        yield _rounded(found)
    match found.given.asked:
        case SliderCrank() as asked if asked.K > 1 and asked.offset is None and asked.ratio is None:
            yield _slider_cranks(found)
        case SliderCrank() as asked if asked.K == 1 and asked.offset and asked.ratio is not None:
            yield from _two_cranks(found, asked.ratio, asked.offset)
        case CrankRocker() as asked:
            if asked.crank is None and asked.rod is None:
                yield _crank_rockers(found, asked)
            if found.s.number("theta"):
                keys = ("crank", "rod", "frame", "transmission")
                yield _solved(ROCKERS, keys, rocker_steps.solutions(found.s, asked))
        case Generator() as asked:
            yield _course(found, asked)
        case AnglePairs() as asked:
            yield _way(found, asked)
        case RockerPositions() as asked if asked.crank_angles is None and asked.frame is None:
            yield _positioned(found, "frame")
        case RockerPositions() as asked if asked.crank_angles is not None and asked.rocker is None:
            yield _positioned(found, "rocker")
        case SliderPositions() as asked if asked.crank_angles is not None and asked.offset is None:
            yield _positioned(found, "offset")
        case Body() as asked if design.solutions:
            if asked.rocker is None:
                yield _led(found, asked)
            yield _solutions(found)


@tabulated
def values(found: Found) -> Iterator[Value]:
    return found.s.values()


def headline(found: Found) -> Iterator[Value]:
    """What is looked for first: the lengths, the greatest pressure angle or the least transmission angle."""
    return (found.s[key] for key in (*found.design.lengths, "pressure", "transmission") if key in found.s)


def offered(key: str) -> Quantity:
    """What the mechanism takes as `synthesis.KEY`."""
    return Values.DECLARED[key].named(Values.PREFIX)


def _rounded(found: Found) -> Table:
    keys = found.design.lengths
    numbers = {
        "found": [found.s.number(key) for key in keys],
        "taken": [found.design.taken(key) for key in keys],
    }
    names = {"found": N_("length as it is found"), "taken": N_("length as the mechanism takes it")}
    signs = [found.s.named(key).sign for key in keys]
    columns = [
        Column(Quantity(key, Symbol("l"), "m", Message(names[key]), "mm"), numbers[key], signs)
        for key in ("found", "taken")
    ]
    of = text_column("key", Message(N_("number of the synthesis")), keys)
    return Table("synthesis_lengths", Message(N_("lengths as found and as taken")), (of, *columns))


def _slider_cranks(found: Found) -> Table:
    """Over the ratio of rod to crank."""
    ratio = np.linspace(1.05, max(8.0, 1.5 * found.s.number("ratio")), POINTS)
    of = synthesis.slider_cranks(found.s.number("stroke"), found.s.number("theta"), ratio)
    columns = {"ratio": ratio, "pressure": of.pressure, "crank": of.a, "rod": of.b, "offset": of.e}
    return _family(columns)


def _crank_rockers(found: Found, asked: CrankRocker) -> Table:
    """Over the crank; of equal strokes over the distance of the pivots."""
    s = found.s
    if s.number("theta") == 0:
        frame = asked.rocker * np.linspace(1.01, rocker_steps.MOST_FRAME, POINTS)
        of = synthesis.in_step(asked.swing, asked.rocker, s.number("half_chord"), frame)
        return _family({"frame": frame, "transmission": of.transmission, "rod": of.b})
    crank = s.number("half_chord") * np.linspace(0.01, 0.999, POINTS)
    of = rocker_steps.family(s, asked, crank)
    return _family({"crank": crank, "transmission": of.transmission, "rod": of.b, "frame": of.d})


def _led(found: Found, asked: Body) -> Table:
    """Over the place of the rocker's pivot on the perpendicular bisector."""
    pins = body_steps.pinned(asked)
    most = 1.5 * abs(found.s.number("off_B")) + found.s.number("way_B")
    off = np.linspace(-most, most, POINTS)
    of = body_steps.family(pins, found.s.number("off_A"), off)
    sound = np.isfinite(of.transmission)
    rocker, frame = np.abs(pins[1][0] - of.rocker_pivot), np.abs(of.rocker_pivot - of.crank_pivot)
    return _family({
        "off_B": off, "transmission": of.transmission, "rocker": np.where(sound, rocker, np.nan), "frame": frame,
    })  # fmt: skip


def _positioned(found: Found, key: str) -> Table:
    """Of two positions of a rocker or a slider, over what is free."""
    s = found.s
    if key == "offset":
        x = positions_steps.span(s) * np.linspace(-1, 1, POINTS)
        of, angle = positions_steps.places(s, x), "pressure"
    else:
        stated = s.number("rocker" if key == "frame" else "frame")
        x = stated * np.linspace(positions_steps.LEAST, positions_steps.MOST, POINTS)
        family = positions_steps.extremes if key == "frame" else positions_steps.pairs
        of, angle = family(s, x), "transmission"
    return _family({key: x, angle: of.angle, "crank": of.a, "rod": of.b})


def _solutions(found: Found) -> Table:
    """Of each side on which the pivots may stand, the best first."""
    keys = ("off_A", "off_B", "frame", "transmission")
    return _solved(SOLUTIONS, keys, np.array(found.design.solutions).T)


def _two_cranks(found: Found, ratio: float, e: float) -> Iterator[Table]:
    """Where two cranks have the stroke, both."""
    cranks = steps.cranks_of(found.s.number("stroke"), ratio, e)[::-1]
    if len(cranks) > 1:
        rods = ratio * cranks
        yield _solved(
            SLIDERS, ("crank", "rod", "pressure"), np.array([cranks, rods, np.arcsin((cranks + e) / rods)])
        )


def _solved(caption: Message, keys: Sequence[str], columns: np.ndarray) -> Table:
    named = (Values.DECLARED[key].column(of) for key, of in zip(keys, columns, strict=True))
    return Table("synthesis_solutions", caption, tuple(named))


def _family(columns: dict[str, np.ndarray]) -> Table:
    first, *others = columns
    sound = np.isfinite(columns[others[0]])
    chosen = (Values.DECLARED[key].column(np.where(sound, columns[key], np.nan)) for key in others)
    return Table("synthesis_family", FAMILY, (Values.DECLARED[first].column(columns[first]), *chosen))


def _course(found: Found, asked: Generator) -> Table:
    """Over the range of the function."""
    bar = found.design.bar
    assert bar is not None
    x = np.linspace(*asked.x, POINTS)
    phi, psi = points_steps.angles(asked, x)
    columns = (
        X.column(x), PSI_WANTED.column(psi), ERROR.column(points_steps.differences(asked, bar, x)),
        TRANSMISSION.column(bar.transmission(phi)),
    )  # fmt: skip
    return Table("synthesis_course", COURSE, columns)


def _way(found: Found, asked: AnglePairs) -> Table:
    """Over the way of the crank from the first pair of angles to the last."""
    bar = found.design.bar
    assert bar is not None
    first, psi = asked.pairs[0]
    phi = np.linspace(first, asked.pairs[-1][0], POINTS)
    turned = np.unwrap(np.angle(bar.rocker(phi) * np.exp(-1j * psi)))
    columns = (
        Pairs.phi.column(phi), Pairs.psi.column(psi + turned),
        TRANSMISSION.column(bar.transmission(phi)),
    )  # fmt: skip
    return Table("synthesis_course", WAY, columns)

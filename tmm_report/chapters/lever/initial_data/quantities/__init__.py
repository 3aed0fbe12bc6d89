"""What is given of a lever mechanism: its dimensions, fixed points and masses."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.i18n import NP_
from tmm_report.mechanics.lever.mechanism import FRAME, Link, Mechanism
from tmm_report.mechanics.lever.stated_masses import (
    Letter,
    MassOf,
    PerLength,
    Segment,
    Statement,
    Synthesised,
    letters,
    worked,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Formula, Var, expr
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column, variable
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol, segment
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.directions import X_OF, Y_OF
from tmm_report.quantity.written import SEGMENT

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

LENGTH = N_("length of segment %(of)s")
CYCLE = NP_("index", "cyc")  # of a cycle
DIMENSIONS = Message(N_("dimensions of the links"))
STATED_LENGTHS = Message(N_("other lengths by which lengths and masses are stated"))
FIXED = Message(N_("coordinates of the fixed points"))
MASSES = Message(N_("masses of the links, their mass centres and moments of inertia"))
LINK = Message(N_("link"))

X = Quantity("x", Symbol("x"), "m", Message(N_("x coordinate of the point")))
Y = Quantity("y", Symbol("y"), "m", Message(N_("y coordinate of the point")))
MASS = Quantity("m", Symbol("m"), "kg", Message(N_("mass of the link")))
INERTIA = Quantity(
    "J", Symbol("J"), "kg·m²", Message(N_("moment of inertia of the link about its mass centre"))
)
AWAY = Quantity("l_about", Symbol("l"), "m", Message(N_("distance of that point from the mass centre")))
PER_LENGTH = Quantity("q", Symbol("q"), "kg/m", Message(N_("mass of a metre of the link's length")))
STATED_INERTIA = Quantity(
    "J_about", Symbol("J"), "kg·m²", Message(N_("moment of inertia of the link about that point"))
)


def point_coordinate(axis: str, text: str, point: str) -> Quantity:
    return Quantity(f"{axis}_{point}", Symbol(axis, point), "m", Message(text, {"name": point}))


def length(ends: str) -> Quantity:
    """Of the segment between two points, named by both."""
    return Quantity(f"l_{ends}", Symbol("l", ends), "m", Message(LENGTH, {"of": ends}))


def segment_between(mechanism: Mechanism, one: str, other: str) -> Quantity:
    """The length of the segment between two points under one name in every chapter: in the order in which its link
    lists them; of points of two links a fixed one leads, else the first of the alphabet."""
    for link in sized_links(mechanism):
        if one in link.points and other in link.points:
            order = list(link.points).index
            return length(one + other if order(one) < order(other) else other + one)
    fixed = mechanism.links[FRAME].points
    return length("".join(sorted((one, other), key=lambda point: (point not in fixed, point))))


def mass(link: str) -> Quantity:
    return Quantity(f"m_{link}", Symbol("m", link), "kg", Message(N_("mass of link %(of)s"), {"of": link}))


def per_length(link: str) -> Quantity:
    text = N_("mass of a metre of the length of link %(of)s")
    return Quantity(f"q_{link}", Symbol("q", link), "kg/m", Message(text, {"of": link}))


def inertia(link: str) -> Quantity:
    text = N_("moment of inertia of link %(of)s about its mass centre")
    return Quantity(f"J_{link}", Symbol("J", link), "kg·m²", Message(text, {"of": link}))


@tabulated
def tables(lever: LeverFound) -> Iterator[Table]:
    return given_tables(lever.given.mechanism)


@tabulated
def values(lever: LeverFound) -> Iterator[Value]:
    return given_values(lever.given.mechanism, lever.plans.length_scale)


def given_tables(mechanism: Mechanism) -> Iterator[Table]:
    mechanism = mechanism.real  # links that replace cam pairs have no length of their own
    sized = _dimensions(mechanism)
    yield sized
    yield from _stated_lengths(mechanism, [str(key) for key in sized["key"].values])
    fixed = mechanism.links[FRAME].points
    places = np.array(list(fixed.values()), dtype=complex)
    point = text_column("point", Message(N_("point")), list(fixed))
    x, y = (
        Column.of_each(of, list(numbers), [point_coordinate(of.key, text, name) for name in fixed])
        for of, text, numbers in ((X, X_OF, places.real), (Y, Y_OF, places.imag))
    )
    yield Table("fixed_points", FIXED, (point, x, y))
    if heavy := heavy_links(mechanism):
        yield _masses(heavy)


def sizes(points: Mapping[str, complex]) -> list[tuple[Quantity, float]]:
    """Distances of a link's points from its first; where they are not in one line, also from each other, m. Of two
    points at one place there is none."""
    (first, start), *others = points.items()
    found = [(length(first + name), abs(z - start)) for name, z in others]
    if not _in_line(list(points.values())):
        pairs = [(a, b) for i, a in enumerate(others) for b in others[i + 1 :]]
        found += [(length(a + b), abs(z - w)) for (a, z), (b, w) in pairs]
    return [(segment, size) for segment, size in found if size > 0]


def together(points: Mapping[str, complex]) -> list[tuple[str, str]]:
    """Points of a link at the place of another that is named before them, and that other."""
    places: dict[complex, str] = {}
    named = [(name, places.setdefault(complex(place), name)) for name, place in points.items()]
    return [(name, first) for name, first in named if name != first]


def _in_line(points: list[complex]) -> bool:
    arms = np.array(points[1:]) - points[0]
    along = arms[np.argmax(np.abs(arms))]
    return bool(np.all(np.abs((arms * np.conj(along)).imag) <= 1e-9 * np.abs(along) ** 2))


def sized_links(mechanism: Mechanism) -> list[Link]:
    """Moving links of two points or more."""
    return [link for name, link in mechanism.links.items() if name != FRAME and len(link.points) > 1]


def heavy_links(mechanism: Mechanism) -> list[Link]:
    """Moving links with a mass or a moment of inertia."""
    links = (link for name, link in mechanism.links.items() if name != FRAME)
    return [link for link in links if link.mass or link.inertia]


def _dimensions(mechanism: Mechanism) -> Table:
    """One row a segment; its name finds it."""
    rows = [(link.name, *size) for link in sized_links(mechanism) for size in sizes(link.points)]
    return _lengths("dimensions", DIMENSIONS, rows)


def _stated_lengths(mechanism: Mechanism, known: Sequence[str]) -> Iterator[Table]:
    """Segments by which something is stated and that are no dimensions of one link: along it, or of the frame."""
    rows: dict[str, tuple[str, Quantity, float]] = {}
    for one in _segments_said(mechanism):
        either = (length(one.first + one.second), length(one.second + one.first))
        if not {ends.key for ends in either} & {*known, *rows}:
            points = mechanism.links[one.link].points
            rows[either[0].key] = (one.link, either[0], abs(points[one.second] - points[one.first]))
    if rows:
        yield _lengths("stated_lengths", STATED_LENGTHS, [*rows.values()])


def _lengths(name: str, meaning: Message, rows: Sequence[tuple[str, Quantity, float]]) -> Table:
    return Table(
        name,
        meaning,
        (
            text_column("key", Message(N_("segment")), [quantity.key for _, quantity, _ in rows]),
            text_column("link", LINK, [link for link, _, _ in rows]),
            Quantity("length", None, "m", Message(N_("its length"))).column([size for _, _, size in rows]),
        ),
    )


def stated_inertia(link: Link) -> Quantity:
    """About the point of the link that the variant names."""
    about = link.stated[0] if link.stated else ""
    text = N_("moment of inertia of link %(of)s about point %(about)s")
    meaning = Message(text, {"of": link.name, "about": about})
    return Quantity(f"J_{link.name},{about}", Symbol("J", f"{link.name},{about}"), "kg·m²", meaning)


def _stated(links: list[Link]) -> Iterator[Column]:
    """Where a moment of inertia is about another point than the mass centre: the point, how far it is, the moment."""
    if not any(link.stated for link in links):
        return
    about = [link.stated[0] if link.stated else "" for link in links]
    away = [
        abs(link.points[x] - link.points[str(link.mass_centre)]) if x else math.nan
        for x, link in zip(about, links, strict=True)
    ]
    ends = [length(f"{x}{link.mass_centre}") for x, link in zip(about, links, strict=True)]
    yield text_column("about", Message(N_("point about which the moment of inertia is stated")), about)
    yield Column.of_each(AWAY, away, ends)
    stated = [link.stated[1] if link.stated else math.nan for link in links]
    yield Column.of_each(STATED_INERTIA, stated, [*map(stated_inertia, links)])


def _statements(link: Link) -> list[tuple[str, Statement]]:
    """Columns of the masses in which the assignment states the link's by lengths and other masses, and how."""
    if link.said is None:
        return []
    found = [("m", link.said.mass), ("J_about" if link.stated else "J", link.said.inertia)]
    return [(key, one) for key, one in found if one is not None]


def _segments_said(mechanism: Mechanism) -> Iterator[Segment]:
    """Segments in statements of masses, moments of inertia and lengths."""
    for link in mechanism.links.values():
        stated = [one for _, one in _statements(link)] + [*(link.said.places.values() if link.said else ())]
        for one in stated:
            yield from (letter for letter in letters(one) if isinstance(letter, Segment))


def _of_length(one: Segment | Synthesised, lengths: Sequence[Table]) -> Var:
    return _of_synthesis(one) if isinstance(one, Synthesised) else _of_segment(one, lengths)


def _of_synthesis(one: Synthesised) -> Var:
    """A length as the mechanism takes it, where it is rounded by its row of the table of rounded lengths."""
    from tmm_report.chapters.lever.synthesis.quantities import offered  # only such a variant needs it

    of = offered(one.key)
    ref = Ref(of.key) if one.row is None else Ref("taken", one.row, "synthesis_lengths")
    return variable(of, one.number, ref=ref)


def _of_segment(one: Segment, lengths: Sequence[Table]) -> Var:
    """The length of a segment, found in the tables of lengths."""
    for table in lengths:
        rows = list(table["key"].values)
        for ends in (length(one.first + one.second), length(one.second + one.first)):
            if ends.key in rows:
                size = table["length"].number(rows.index(ends.key), "")
                return variable(ends, size, ref=table.by_key(ends.key, "length"))
    raise KeyError(one)


def lengths_said(mechanism: Mechanism, lengths: Sequence[Table]) -> Iterator[Formula]:
    """Lengths that the assignment states by others, of points on the axes of their links."""
    for link in sized_links(mechanism):
        origin, place = next(iter(link.points.items()))
        for point, one in (link.said.places if link.said and place == 0 else {}).items():
            if point != origin and link.points[point]:
                size = _of_segment(Segment(link.name, origin, point), lengths)
                expression = expr(worked(one, partial(_of_length, lengths=lengths)))
                yield Formula(size.sign, expression, "m", ref=size.ref, meaning=size.meaning)


def coordinates_said(mechanism: Mechanism, fixed: Table) -> Iterator[Formula]:
    """Coordinates of fixed points that follow from the synthesis."""
    frame, points = mechanism.links[FRAME], [str(one) for one in fixed["point"].values]
    for (point, axis), one in (frame.said.coordinates if frame.said else {}).items():
        expression = expr(worked(one, partial(_of_length, lengths=())))
        yield fixed.formula(axis, points.index(point), expression)


def said(
    mechanism: Mechanism, masses: Table, lengths: Sequence[Table]
) -> Iterator[tuple[str, int, Quantity, Expr]]:
    """Key, row, quantity and expression of what is stated by lengths and other masses: masses, moments of inertia."""
    links = heavy_links(mechanism)
    rows = {link.name: row for row, link in enumerate(links)}

    def variable_of(letter: Letter, own: int) -> Expr:
        if isinstance(letter, Segment):
            return _of_segment(letter, lengths)
        if isinstance(letter, Synthesised):
            return _of_synthesis(letter)
        one, key, row = per_length(links[own].name), "q", own
        if isinstance(letter, MassOf):
            one, key, row = mass(letter.link), "m", rows[letter.link]
        return variable(one, masses[key].number(row, ""), ref=masses.ref(key, row))

    for own, link in enumerate(links):
        for key, one in _statements(link):
            of = {"m": mass(link.name), "J": inertia(link.name), "J_about": stated_inertia(link)}[key]
            yield key, own, of, expr(worked(one, partial(variable_of, own=own)))


def _per_length(links: list[Link]) -> Iterator[Column]:
    """Of links whose mass is stated by a metre of their length."""
    found = [
        next(
            (one.value for _, s in _statements(link) for one in letters(s) if isinstance(one, PerLength)),
            math.nan,
        )
        for link in links
    ]
    if not all(map(math.isnan, found)):
        yield Column.of_each(PER_LENGTH, found, [per_length(link.name) for link in links])


def _masses(links: list[Link]) -> Table:
    return Table(
        "masses",
        MASSES,
        (
            text_column("link", LINK, [link.name for link in links]),
            Column.of_each(MASS, [float(link.mass) for link in links], [mass(link.name) for link in links]),
            text_column(
                "mass_centre", Message(N_("mass centre")), [link.mass_centre or "" for link in links]
            ),
            Column.of_each(
                INERTIA,
                [float(link.inertia) or math.nan for link in links],
                [inertia(link.name) for link in links],
            ),
            *_stated(links),
            *_per_length(links),
        ),
    )


# ---------------------------------------------------------------- the driving link


def given_values(mechanism: Mechanism, length_scale: float) -> Iterator[Value]:
    if mechanism.driver.law is None:
        yield speed(mechanism)
        yield revolutions(mechanism)
    elif mechanism.driver.stroke is not None:
        from tmm_report.chapters.lever.initial_data.quantities import driving_stroke

        yield from driving_stroke.values(mechanism.driver.stroke.law)
    else:
        from tmm_report.chapters.lever.initial_data.quantities import driving_law

        yield from driving_law.values(mechanism.driver)
    if mechanism.driver.period is not None:
        yield PERIOD.value(float(mechanism.driver.period))
    yield from cycle(mechanism)
    yield from scale(mechanism, length_scale)


def speed(mechanism: Mechanism) -> Value:
    """Angular velocity of the driving link, + counter-clockwise."""
    driver = mechanism.driver
    meaning = Message(N_("angular velocity of link %(name)s"), {"name": driver.link})
    return Quantity("omega", Symbol("omega", driver.link), "rad/s", meaning).value(float(driver.omega))


PERIOD = Quantity("T_turn", Symbol("T"), "s", Message(N_("time of one turn of the driving link")))


def revolutions(mechanism: Mechanism) -> Value:
    """Rotational speed of the driving link, without its sense."""
    meaning = Message(N_("rotational speed of the driving link"))
    rpm = 30 * abs(float(mechanism.driver.omega)) / math.pi
    return Quantity("n_1", Symbol("n"), "rpm", meaning).value(rpm)


def cycle(mechanism: Mechanism) -> Iterator[Value]:
    """Of a cycle of several turns: how many they are, and how far and how long the driving link turns in it."""
    driver = mechanism.driver
    if driver.turns > 1:
        angle = driver.turns * driver.sweep
        turns = Message(N_("number of turns of the driving link in a cycle"))
        yield Quantity("turns", Symbol("z"), "", turns).value(driver.turns)
        meaning = Message(N_("angle of rotation of the driving link in a cycle"))
        yield Quantity("phi_cycle", Symbol("phi", CYCLE), "deg", meaning).value(math.degrees(angle))
        meaning = Message(N_("duration of a cycle"))
        yield Quantity("T_cycle", Symbol("T", CYCLE), "s", meaning).value(angle / abs(float(driver.omega)))


# ---------------------------------------------------------------- the scale of the scheme

MU_L = Quantity("mu_l", Symbol("mu", "l"), "m/mm", Message(N_("scale of lengths")))


def scale(mechanism: Mechanism, length_scale: float) -> Iterator[Value]:
    """m/mm, and the lengths at which the segments of the links are drawn."""
    yield MU_L.value(length_scale)
    for ends, metres in segments(mechanism):
        yield drawn(ends).value(metres / length_scale)


def drawn(ends: str) -> Quantity:
    """The length at which the segment between two points of a link is drawn."""
    return Quantity(f"drawn_{ends}", segment(ends), "mm", SEGMENT)


def segments(mechanism: Mechanism) -> list[tuple[str, float]]:
    """Both ends and the length, m, of every segment of the links; of the driving link its arm, if no other."""
    links = sized_links(mechanism.real)
    found = {quantity.key.removeprefix("l_"): size for link in links for quantity, size in sizes(link.points)}
    if arm := driving_arm(mechanism):
        found.setdefault(*arm)
    return list(found.items())


def driving_arm(mechanism: Mechanism) -> tuple[str, float] | None:
    """Both ends and the length, m, of the driving link from its pivot to its first other point; None without one."""
    points = mechanism.real.links[mechanism.driver.link].points
    pivot = driving_pivot(mechanism)
    pin = next((p for p in points if abs(points[p] - points[pivot]) > 0), None)
    return None if pin is None else (pivot + pin, abs(points[pin] - points[pivot]))


def driving_pivot(mechanism: Mechanism) -> str:
    """The fixed point about which the driving link turns."""
    own = mechanism.links[mechanism.driver.link].points
    return next(point for point in own if point in mechanism.links[FRAME].points)

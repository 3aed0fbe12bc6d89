"""Forces on the links as a note prints them: reactions by size and direction, weights, inertia, loads.

Directions that a note does not print in numbers (of inertia forces and stated loads) and places of points are those of
results.json.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
import yaml
from conftest import path_of
from note import Note
from pages import BALANCING, columns, table_of
from printed import Printed


class Force(NamedTuple):
    """On a link, at a point (P,) of complex numbers, with its error; a couple beside it."""

    name: str
    link: str
    at: np.ndarray | complex
    value: np.ndarray
    error: np.ndarray
    moment: np.ndarray | float = 0.0
    moment_error: np.ndarray | float = 0.0


@dataclass(frozen=True)
class Scheme:
    """What a variant's file says of its links."""

    points: dict[str, list[str]]
    sliding: dict[str, str]  # link with a slider -> the slider's point
    mass_centres: dict[str, str]
    driver: str
    gravity: float
    loads: list[tuple[str, list[str]]]  # point of each stated force, in order, and the links it may act on
    pitch: complex | None = (
        None  # from the pivot O to the pitch point of the gear that turns the driving link, m
    )
    pivot: str = ""
    drive: list[tuple[str, str, str]] = field(default_factory=list)
    # links in mesh -> their axes and the share of the way between them at which they touch; a place from one axis, m
    meshes: dict[frozenset[str], tuple[str, str, float]] = field(default_factory=dict)
    rolling: dict[frozenset[str], tuple[str, complex]] = field(default_factory=dict)


def scheme(name: str) -> Scheme:
    data = yaml.safe_load(path_of(name).read_text("utf-8"))
    links = {str(key): link for key, link in data["mechanism"]["links"].items()}
    points = {key: [str(p) for p in link["points"]] for key, link in links.items()}
    sliding = {}
    for key, link in links.items():
        if "slides" in link:
            stated = link["slides"]
            sliding[key] = (
                str(stated.get("at", points[key][0])) if isinstance(stated, dict) else points[key][0]
            )
    centres = {
        key: str(link.get("mass_centre", points[key][0])) for key, link in links.items() if "mass" in link
    }
    loads = data.get("loads") or {}
    forces = [
        (
            str(f["at"]),
            [str(f["on"])] if "on" in f else [k for k, own in points.items() if str(f["at"]) in own],
        )
        for f in loads.get("forces") or []
    ]
    gravity = loads.get("gravity", 0)
    gravity = float(str(gravity["value"] if isinstance(gravity, dict) else gravity).split()[0])
    driver = data["mechanism"]["driver"]
    frame, cylinder = data["mechanism"]["frame"], [str(p) for p in driver.get("cylinder", ())]
    link = str(driver.get("link") or turning(points, frame, cylinder))
    pivot = next((p for p in points[link] if p in frame), "")
    drive = driving(driver, points, frame, cylinder, link)
    return Scheme(
        points, sliding, centres, link, gravity, forces, pitch_point(driver.get("gear")), pivot, drive,
        meshed(data["mechanism"], {"0": [*frame], **points}), rolled(data["mechanism"], points),
    )  # fmt: skip


def meshed(
    mechanism: dict[str, Any], points: dict[str, list[str]]
) -> dict[frozenset[str], tuple[str, str, float]]:
    """Of wheels on a carrier: outside one another they touch between the axes, else beyond that of the smaller one."""
    found = {}
    for one in mechanism.get("wheels", ()):
        links, carrier = [str(link) for link in one["links"]], points[str(one["carrier"])]
        axes = [next(p for p in points[link] if p in carrier) for link in links]
        first, second = [float(r.split()[0]) for r in one["radii"]] if "radii" in one else (1.0, one["ratio"])
        share = first / (first - second if one.get("mesh") == "internal" else first + second)
        found[frozenset(links)] = (*axes, share)
    return found


def rolled(
    mechanism: dict[str, Any], points: dict[str, list[str]]
) -> dict[frozenset[str], tuple[str, complex]]:
    """Of wheels on level rails: the axis, and the way to the rail."""
    found = {}
    for one in mechanism.get("rolling", ()):
        axis = next(p for p in points[str(one["carrier"])] if p in points[str(one["wheel"])])
        down = {"above": -1j, "below": 1j}[one["side"]] * float(one["radius"].split()[0]) / 1000
        found[frozenset(("0", str(one["wheel"])))] = axis, down
    return found


def turning(points: dict[str, list[str]], frame: dict[str, Any], cylinder: list[str]) -> str:
    """The link about a fixed point that a slider or a cylinder drives, which is no part of the cylinder."""
    own = {p for p in frame if p not in cylinder}
    return next(link for link, of in points.items() if own & {*of})


def driving(
    driver: dict[str, Any], points: dict[str, list[str]], frame: dict[str, Any], cylinder: list[str], led: str
) -> list[tuple[str, str, str]]:
    """Of a driving slider (whose guide is horizontal) or cylinder: the links that take its force, the point of each and
    the point towards which it is pressed apart; of a slider none."""
    if "slider" in driver:
        return [(str(driver["slider"]), points[str(driver["slider"])][0], "")]
    if not cylinder:
        return []
    far, pin = sorted(cylinder, key=lambda p: p not in frame)
    found = []
    for end, other in ((pin, far), (far, pin)):
        there = [link for link in points if end in points[link]]
        own = [link for link in there if link != led]  # the cylinder's, where it is stated as links
        found += [(link, end, other) for link in own or there]
    return found


def pitch_point(gear: dict[str, str] | None) -> complex | None:
    """Of a gear as the file states it, in mm and degrees."""
    if gear is None:
        return None
    radius, at = (float(gear[key].removesuffix(unit)) for key, unit in (("radius", "mm"), ("at", "deg")))
    return complex(radius / 1000 * np.exp(1j * np.radians(at)))


def ends(symbol: str) -> tuple[str, str]:
    """The two links of R_12 or R_10,11."""
    sub = symbol.split("_", 1)[1]
    one, other = sub.split(",") if "," in sub else (sub[: len(sub) // 2], sub[len(sub) // 2 :])
    return one, other


class Places:
    """Points of the mechanism at the printed positions."""

    def __init__(self, note: Note, document: dict[str, Any]):
        self.found = table_of(document, "positions_table")
        parts: dict[str, dict[str, float]] = {}
        for formula in note.formulas:
            last = formula.numbers[-1][-1:]
            if last and last[0].mark and last[0].mark.table == "fixed_points":
                axis, _, point = formula.symbol.partition("_")
                parts.setdefault(point, {})[axis] = last[0].printed.value
        self.fixed = {point: complex(part["x"], part["y"]) for point, part in parts.items()}

    def __getitem__(self, point: str) -> np.ndarray | complex:
        if f"x_{point}" in self.found:
            return self.found[f"x_{point}"] + 1j * self.found[f"y_{point}"]
        return self.fixed.get(point, 0j)


def pair_points(note: Note, drawn: Scheme) -> dict[frozenset[str], str]:
    """Links of a pair -> the point where its reaction acts: the pivot, or the slider's own point."""
    table = next(
        t
        for t in note.tables
        if len(t.heads) > 4 and t.heads[4].text in ("Class", "Класс") and "–" in t.rows[0][1].text
    )
    found = {}
    for row in table.rows:
        links = frozenset(row[1].text.split("–"))
        sliders = [link for link in links if link in drawn.sliding]
        if row[3].text in ("higher", "высшая"):
            continue
        revolute = row[3].text in ("revolute", "вращательная")
        found[links] = row[2].text if revolute else drawn.sliding[slider_of(links, sliders)]
    return found


def slider_of(links: frozenset[str], sliders: list[str]) -> str:
    """The link that slides: the one whose stated slide this is; beside the frame the other one."""
    moving = [link for link in sorted(links) if link != "0"]
    return moving[0] if len(moving) == 1 else (sliders[0] if len(sliders) == 1 else moving[0])


def reactions(note: Note, drawn: Scheme, places: Places) -> Iterator[Force]:
    """Each reaction on both of its links."""
    found, at = columns(note), pair_points(note, drawn)
    for symbol, entries in found.items():
        if not re.fullmatch(r"R_[\d,]+", symbol):
            continue
        size = entries[0][1]
        turned = found["α_" + symbol[2:]][0][1]
        zero = size.values <= size.half
        value = np.where(zero, 0, size.values * np.exp(1j * np.where(zero, 0, turned.values)))
        error = size.half + np.where(zero, size.half, np.abs(size.values) * turned.half)
        one, other = ends(symbol)
        moment, off = 0.0 * size.values, 0.0 * size.values
        if "M_" + symbol[2:] in found:
            couple = found["M_" + symbol[2:]][-1][1]
            moment, off = couple.values, couple.half
        point = (
            touching(drawn, places, both) if (both := frozenset((one, other))) not in at else places[at[both]]
        )
        yield Force(symbol, other, point, value, error, moment, off)
        yield Force(symbol, one, point, -value, error, -moment, off)


def touching(drawn: Scheme, places: Places, links: frozenset[str]) -> np.ndarray | complex:
    """Where two wheels, or a wheel and its rail, touch."""
    if links in drawn.rolling:
        axis, down = drawn.rolling[links]
        return places[axis] + down
    one, other, share = drawn.meshes[links]
    return places[one] + share * (places[other] - places[one])


def weights(note: Note) -> dict[str, Printed]:
    """Those that the text says, by their symbols."""
    said = (one for one in note.formulas if not one.display and re.fullmatch(r"G_\d+", one.symbol))
    return {one.symbol: one.result for one in said if one.result is not None and one.unit_text in ("N", "Н")}


def loads(note: Note, document: dict[str, Any], drawn: Scheme, places: Places) -> Iterator[Force]:
    """Weights, inertia forces and couples, stated moments, the balancing moment."""
    found, rates = columns(note), table_of(document, "rates_table")
    acting = table_of(document, "loads_table")
    count = len(rates["position"])
    zeros = np.zeros(count)
    for symbol, weight in weights(note).items():
        at = places[drawn.mass_centres[symbol[2:]]]
        yield Force(symbol, symbol[2:], at, zeros - 1j * weight.value, zeros + weight.half)
    for symbol, entries in found.items():
        column = entries[0][1]
        inertia = re.fullmatch(r"([FM])_I([\d]+)", symbol)
        stated = re.fullmatch(r"M_(?:k\d+,)?(\d+)(?:,\d+)?", symbol)  # also of a torsion spring k1
        if inertia and inertia[1] == "F":
            point = drawn.mass_centres[inertia[2]]
            a = rates[f"a_{point}_x"] + 1j * rates[f"a_{point}_y"] if f"a_{point}_x" in rates else zeros + 0j
            way = np.divide(-a, np.abs(a), out=np.zeros_like(a), where=np.abs(a) > 0)
            yield Force(symbol, inertia[2], places[point], column.values * way, column.half)
        elif inertia:
            yield Force(symbol, inertia[2], 0j, zeros + 0j, zeros, column.values, column.half)
        elif stated and not {symbol, f"{symbol},1"} & {*acting}:
            continue  # of the teeth
        elif stated and len(stated[1]) == 1 and "R_" + stated[1] not in found:
            for k, (_, one) in enumerate(entries, 1):  # sizes are printed, their signs stand in the results
                key, rows = symbol if "," in symbol else f"{symbol},{k}", len(one.values)
                couple = np.abs(one.values) * np.sign(acting[key][:rows])
                yield Force(key, stated[1], 0j, zeros[:rows] + 0j, zeros[:rows], couple, one.half)
        elif symbol in ("F_bal", "F_ур") and drawn.drive:
            for link, point, other in drawn.drive:
                line = places[point] - places[other] if other else zeros + 1.0
                yield Force(symbol, link, places[point], column.values * line / np.abs(line), column.half)
        elif symbol in ("F_bal", "F_ур") and drawn.pitch is not None:  # a force in place of the moment
            line = found["α_F"][0][1]
            way, size = np.exp(1j * line.values), np.abs(column.values)
            at = places[drawn.pivot] + drawn.pitch
            yield Force(symbol, drawn.driver, at, column.values * way, column.half + size * line.half)
        elif symbol in BALANCING and drawn.pitch is None and not drawn.drive:
            yield Force(symbol, drawn.driver, 0j, zeros + 0j, zeros, column.values, column.half)


def stated(note: Note, document: dict[str, Any], drawn: Scheme, places: Places) -> Iterator[list[Force]]:
    """Each stated force on the link that takes it, by the results."""
    found, table = columns(note), table_of(document, "loads_table")
    given = {c["key"]: c["values"] for c in document["tables"].get("loads_given", {"columns": []})["columns"]}
    ways = dict(zip(given.get("key", ()), given.get("direction", ()), strict=True))
    taken = dict(zip(given.get("key", ()), given.get("link", ()), strict=True))
    seen: dict[str, int] = {}
    for point, links in drawn.loads:
        several = [at for at, _ in drawn.loads].count(point) > 1
        seen[point] = seen.get(point, 0) + 1
        key = f"P_{point},{seen[point]}" if several else f"P_{point}"
        column = found[key][0][1]
        vector = table[f"{key}_x"] + 1j * table[f"{key}_y"]
        way = _way(ways[key], vector, column.values)
        count = min(len(way), len(column.values))  # the last row, the first again, may be left out
        value, half = column.values[:count] * way[:count], column.half[:count]
        yield [Force(key, link, places[point], value, half) for link in links if link == taken[key]]


def tied(note: Note, document: dict[str, Any], places: Places) -> Iterator[Force]:
    """The printed forces of springs and dampers, each on the links at both its ends along the line of the points."""
    found = columns(note)
    for name in ("springs", "dampers"):
        for row in _rows_told(document, name):
            column, (one, other) = (
                found[f"F_{row['key']}"][0][1],
                (places[row[end]] for end in ("one", "other")),
            )
            way = np.atleast_1d((other - one) / np.abs(other - one))[: len(column.values)]
            for end, at, sign in (("link_one", one, 1), ("link_other", other, -1)):
                yield Force(f"F_{row['key']}", row[end], at, sign * column.values * way, column.half)


def _rows_told(document: dict[str, Any], name: str) -> list[dict[str, str]]:
    """The texts of a table of the results, row by row."""
    table = {c["key"]: c["values"] for c in document["tables"].get(name, {"columns": []})["columns"]}
    return [dict(zip(table, row, strict=True)) for row in zip(*table.values(), strict=True)]


def _way(stated_: str, vector: np.ndarray, printed: np.ndarray) -> np.ndarray:
    """Unit direction that a load states: fixed, or that of its point's motion, in which a printed plus acts."""
    if stated_ not in ("along", "against"):
        return np.full_like(vector, np.exp(1j * np.radians(float(stated_))))
    unit = np.divide(vector, np.abs(vector), out=np.zeros_like(vector), where=np.abs(vector) > 0)
    count = min(len(unit), len(printed))
    return unit[:count] * np.where(printed[:count] < 0, -1, 1)


def unbalanced(note: Note, document: dict[str, Any], name: str) -> list[str]:
    """Links and positions at which the printed forces or moments do not add up to nothing."""
    drawn = scheme(name)
    places = Places(note, document)
    sure = [
        *reactions(note, drawn, places),
        *loads(note, document, drawn, places),
        *tied(note, document, places),
    ]
    choices = list(stated(note, document, drawn, places))
    tried = [list(_off([*sure, *chosen], drawn)) for chosen in itertools.product(*choices)]
    return min(tried, key=len)


def _off(forces: list[Force], drawn: Scheme) -> Iterator[str]:
    for link in drawn.points:
        mine = [force for force in forces if force.link == link]
        count = min(len(np.atleast_1d(force.value)) for force in mine)
        total = sum(force.value[:count] for force in mine)
        error = sum(force.error[:count] for force in mine)
        moment, off = np.zeros(count), np.zeros(count)
        for force in mine:
            at, couple, beside = (_rows(x, count) for x in (force.at, force.moment, force.moment_error))
            moment = moment + np.imag(np.conj(at) * force.value[:count]) + couple
            off = off + np.abs(at) * force.error[:count] + beside
        for k in np.flatnonzero(np.abs(total) > error * 1.01 + 1e-9):
            yield f"link {link}, position {k}: forces add up to {np.abs(total[k]):.5g} N, printed to {error[k]:.2g} N"
        for k in np.flatnonzero(np.abs(moment) > off * 1.01 + 1e-9):
            yield f"link {link}, position {k}: moments add up to {moment[k]:.5g} N·m, printed to {off[k]:.2g} N·m"


def _rows(values: np.ndarray | complex, count: int) -> np.ndarray:
    """The first rows; one value for all of them."""
    return np.asarray(values)[:count] if np.ndim(values) else np.full(count, values)

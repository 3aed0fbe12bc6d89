"""Mechanisms with closed-form places, to draw: each function gives (mechanism, places, turns) at `count` positions."""

from __future__ import annotations

import numpy as np

from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide

Case = tuple[Mechanism, dict[str, np.ndarray], dict[str, np.ndarray]]


def turn(count: int, sense: int = 1, start: float = 0.4) -> np.ndarray:
    return np.exp(1j * (start + sense * 2 * np.pi * np.arange(count) / count))


def fixed(place: complex, count: int) -> np.ndarray:
    return np.full(count, place, complex)


def unit(z: np.ndarray) -> np.ndarray:
    return z / abs(z)


def circles(a: np.ndarray, ra: float, b: complex, rb: float, side: int) -> np.ndarray:
    """Where two circles meet, on the left (+1) or right of the line from a to b."""
    d = b - a
    x = (ra**2 - rb**2 + abs(d) ** 2) / (2 * abs(d))
    return a + unit(d) * (x + side * 1j * np.sqrt(ra**2 - x**2))


def on_line(a: np.ndarray, length: float, height: float, side: int) -> np.ndarray:
    """The point of the line y = height at `length` from a, to its right (+1) or left."""
    return a.real + side * np.sqrt(length**2 - (height - a.imag) ** 2) + 1j * height


def compressor(count: int = 12) -> Case:
    t1 = turn(count, -1, 0.0)
    a = 0.1 * t1
    b = on_line(a, 0.3, 0.0, 1)
    t2 = unit(b - a)
    c, s2 = a + 0.075 * t2, a + 0.15 * t2
    d = on_line(c, 0.31, 0.0, -1)
    t4 = unit(d - c)
    links = {
        "0": Link("0", {"O": 0}),
        "1": Link("1", {"O": 0, "A": 0.1}),
        "2": Link("2", {"A": 0, "B": 0.3, "C": 0.075, "S2": 0.15}, 1.5, "S2"),
        "3": Link("3", {"B": 0}, 0.6, "B"),
        "4": Link("4", {"C": 0, "D": 0.31, "S4": 0.155}, 1.5, "S4"),
        "5": Link("5", {"D": 0}, 0.6, "D"),
    }
    guides = {"x": Guide("x", "0", 0, 1)}
    mechanism = Mechanism(links, Driver("1", -125.0), guides, (Slide("3", "x"), Slide("5", "x")))
    places = {"O": fixed(0, count), "A": a, "B": b, "C": c, "D": d, "S2": s2, "S4": c + 0.155 * t4}
    return mechanism, places, {"1": t1, "2": t2, "4": t4, "3": fixed(1, count), "5": fixed(1, count)}


def offset_slider(count: int = 12) -> Case:
    t1 = turn(count)
    a = 0.05 * t1
    b = on_line(a, 0.16, -0.03, 1)
    links = {
        "0": Link("0", {"O": 0}),
        "1": Link("1", {"O": 0, "A": 0.05, "S1": -0.01}, 1.0, "S1"),
        "2": Link("2", {"A": 0, "B": 0.16, "S2": 0.07 + 0.01j}, 1.0, "S2"),
        "3": Link("3", {"B": 0}, 0.6, "B"),
    }
    t2 = unit(b - a)
    mechanism = Mechanism(links, Driver("1", 10.0), {"x": Guide("x", "0", -0.03j, 1)}, (Slide("3", "x"),))
    places = {"O": fixed(0, count), "A": a, "B": b, "S1": -0.01 * t1, "S2": a + (0.07 + 0.01j) * t2}
    return mechanism, places, {"1": t1, "2": t2, "3": fixed(1, count)}


def four_bar(count: int = 12) -> Case:
    """A crank-rocker with a ternary coupler (coupler point E off the line AB)."""
    t1 = turn(count)
    a = 0.04 * t1
    b = circles(a, 0.11, 0.12 + 0.02j, 0.08, 1)
    t2, t3 = unit(b - a), unit(b - (0.12 + 0.02j))
    links = {
        "0": Link("0", {"O": 0, "C": 0.12 + 0.02j}),
        "1": Link("1", {"O": 0, "A": 0.04}),
        "2": Link("2", {"A": 0, "B": 0.11, "E": 0.06 + 0.05j, "S2": 0.055 + 0.02j}, 1.0, "S2"),
        "3": Link("3", {"C": 0, "B": 0.08, "S3": 0.04}, 1.0, "S3"),
    }
    places = {"O": fixed(0, count), "C": fixed(0.12 + 0.02j, count), "A": a, "B": b}
    places |= {"E": a + (0.06 + 0.05j) * t2, "S2": a + (0.055 + 0.02j) * t2, "S3": 0.12 + 0.02j + 0.04 * t3}
    return Mechanism(links, Driver("1", 10.0)), places, {"1": t1, "2": t2, "3": t3}


def shaper(count: int = 12) -> Case:
    """A crank with a stone on a rocking slotted link; a rod from the link to the ram."""
    t1 = turn(count)
    a = 0.3j + 0.1 * t1
    t3 = unit(a)
    b = 0.55 * t3
    c = on_line(b, 0.2, 0.56, 1)
    t4 = unit(c - b)
    links = {
        "0": Link("0", {"O": 0.3j, "C": 0}),
        "1": Link("1", {"O": 0, "A": 0.1}),
        "2": Link("2", {"A": 0}),
        "3": Link("3", {"C": 0, "B": 0.55, "S3": 0.3}, 1.0, "S3"),
        "4": Link("4", {"B": 0, "D": 0.2}),
        "5": Link("5", {"D": 0, "S5": 0.08}, 1.0, "S5"),
    }
    guides = {"slot": Guide("slot", "3", 0, 1), "ram": Guide("ram", "0", 0.56j, 1)}
    slides = (Slide("2", "slot"), Slide("5", "ram"))
    places = {
        "O": fixed(0.3j, count),
        "C": fixed(0, count),
        "A": a,
        "B": b,
        "D": c,
        "S3": 0.3 * t3,
        "S5": c + 0.08,
    }
    turns = {"1": t1, "2": t3, "3": t3, "4": t4, "5": fixed(1, count)}
    return Mechanism(links, Driver("1", -8.0), guides, slides), places, turns


def scotch_yoke(count: int = 12, named: bool = True) -> Case:
    """A stone on the crank in the upright slot of a yoke that slides along x; the yoke may have no named point."""
    t1 = turn(count)
    a = 0.06 * t1
    links = {
        "0": Link("0", {"O": 0}),
        "1": Link("1", {"O": 0, "A": 0.06}),
        "2": Link("2", {"A": 0}),
        "3": Link("3", {"B": 0.05} if named else {}),
    }
    guides = {"slot": Guide("slot", "3", 0, 1j), "x": Guide("x", "0", 0, 1)}
    slides = (Slide("2", "slot", direction=1j), Slide("3", "x"))
    places = {"O": fixed(0, count), "A": a} | ({"B": a.real + 0.05 + 0j} if named else {})
    turns = {"1": t1, "2": fixed(1, count), "3": fixed(1, count)}
    return Mechanism(links, Driver("1", 5.0), guides, slides), places, turns


def tangent(count: int = 12) -> Case:
    """A rocking slotted driver turns between -50 and 50 degrees; its stone drives a bar along an upright guide."""
    t1 = np.exp(1j * np.radians(np.linspace(-50, 50, count)))
    b = 0.08 * t1 / t1.real
    links = {
        "0": Link("0", {"O": 0}),
        "1": Link("1", {"O": 0}),
        "2": Link("2", {"B": 0}),
        "3": Link("3", {"B": 0}),
    }
    guides = {"slot": Guide("slot", "1", 0, 1), "y": Guide("y", "0", 0.08, 1j)}
    slides = (Slide("2", "slot"), Slide("3", "y", direction=1j))
    mechanism = Mechanism(links, Driver("1", 5.0, sweep=np.radians(100)), guides, slides)
    return mechanism, {"O": fixed(0, count), "B": b}, {"1": t1, "2": t1, "3": fixed(1, count)}


def trammel(count: int = 12) -> Case:
    """An elliptic mechanism: a crank OC of half the bar AB, whose ends slide along x and y; E draws an ellipse."""
    t1 = turn(count, start=0.5)
    t2 = t1.conj()
    c = 0.05 * t1
    links = {
        "0": Link("0", {"O": 0}),
        "1": Link("1", {"O": 0, "C": 0.05}),
        "2": Link("2", {"C": 0, "A": 0.05, "E": 0.09}),
        "3": Link("3", {"A": 0}),
    }
    mechanism = Mechanism(links, Driver("1", 5.0), {"x": Guide("x", "0", 0, 1)}, (Slide("3", "x"),))
    places = {"O": fixed(0, count), "C": c, "A": c + 0.05 * t2, "E": c + 0.09 * t2}
    return mechanism, places, {"1": t1, "2": t2, "3": fixed(1, count)}


def swinging_cylinder(count: int = 12) -> Case:
    """A rod from the crank slides through a stone pivoted on the frame (the guide is carried by the rod)."""
    t1 = turn(count)
    a = 0.04 * t1
    t2 = unit(0.1 - a)
    links = {
        "0": Link("0", {"O": 0, "C": 0.1}),
        "1": Link("1", {"O": 0, "A": 0.04}),
        "2": Link("2", {"A": 0}),
        "3": Link("3", {"C": 0}),
    }
    mechanism = Mechanism(links, Driver("1", 5.0), {"rod": Guide("rod", "2", 0, 1)}, (Slide("3", "rod"),))
    places = {"O": fixed(0, count), "C": fixed(0.1, count), "A": a}
    return mechanism, places, {"1": t1, "2": t2, "3": t2}


def rotated(case: Case, angle: float) -> Case:
    """The same drawing turned about the origin."""
    mechanism, places, turns = case
    u = np.exp(1j * angle)
    frame = Link("0", {p: z * u for p, z in mechanism.links["0"].points.items()})
    guides = {
        name: Guide(name, g.link, g.through * u, g.direction * u) if g.link == "0" else g
        for name, g in mechanism.guides.items()
    }
    turned = Mechanism(mechanism.links | {"0": frame}, mechanism.driver, guides, mechanism.slides)
    return turned, {p: z * u for p, z in places.items()}, {name: t * u for name, t in turns.items()}


CASES = {
    "compressor": compressor,
    "offset_slider": offset_slider,
    "four_bar": four_bar,
    "shaper": shaper,
    "scotch_yoke": scotch_yoke,
    "yoke_unnamed": lambda count=12: scotch_yoke(count, named=False),
    "tangent": tangent,
    "trammel": trammel,
    "swinging_cylinder": swinging_cylinder,
    "rotated_slider": lambda count=12: rotated(offset_slider(count), 2.2),
    "rotated_yoke": lambda count=12: rotated(scotch_yoke(count), -0.6),
}

"""Mechanisms with one Assur group above class II, drawn at random in one position, so that it certainly exists.

In that position the axes of all links are those of the drawing: a joint has one place in all of them. A pivot is a
point, a sliding pair a line. The crank is short beside the rest, so that most drawn mechanisms go all round.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide

# group -> pairs as links that they join; links 0 and 1 are the frame and the crank
TOPOLOGIES: dict[str, Sequence[tuple[str, str]]] = {
    "III3": (("1", "3"), ("0", "4"), ("0", "5"), ("2", "3"), ("2", "4"), ("2", "5")),
    "IV2": (("1", "2"), ("0", "5"), ("2", "3"), ("2", "4"), ("3", "5"), ("4", "5")),
    "III4": (
        ("1", "4"), ("0", "5"), ("0", "6"), ("0", "7"), ("2", "4"), ("2", "5"), ("2", "3"), ("3", "6"), ("3", "7"),
    ),
}  # fmt: skip
LABELS = {"III3": "III3(2,3,4,5)", "IV2": "IV2(2,3,4,5)", "III4": "III4(2,3,4,5,6,7)"}
OMEGA = 7.0


@dataclass(frozen=True)
class Drawn:
    """A drawn mechanism: places of the joints, one a pair, and direction of its line, 0 for a pivot."""

    name: str
    places: Sequence[complex]
    lines: Sequence[complex]
    crank: complex = 0.05 + 0.02j

    def mechanism(
        self, turn: complex = 1.0, scale: float = 1.0, names: Mapping[str, str] | None = None
    ) -> Mechanism:
        """The mechanism turned, scaled and with its links and points named otherwise."""
        called = names or {}
        pairs = TOPOLOGIES[self.name]
        links = sorted({link for pair in pairs for link in pair})
        points: dict[str, dict[str, complex]] = {link: {} for link in links}
        guides, slides = {}, []
        pin = self.places[0]  # of the crank: the first pair
        points["0"]["O"] = points["1"]["O"] = pin - self.crank
        for n, ((one, other), at, along) in enumerate(zip(pairs, self.places, self.lines, strict=True)):
            if along == 0:
                points[one][f"P{n}"] = points[other][f"P{n}"] = at
            else:
                name = called.get(f"g{n}", f"g{n}")
                guides[name] = Guide(name, called.get(one, one), at * scale * turn, along * turn)
                slides.append(Slide(called.get(other, other), name, at * scale * turn, along * turn))
        for k, link in enumerate(links[1:], 1):
            points[link][f"S{link}"] = self.places[k % len(self.places)] + 0.1 * k
        body = {
            called.get(link, link): Link(
                called.get(link, link),
                {called.get(p, p): at * scale * turn for p, at in places.items()},
                0.5 + 0.1 * int(link),
                called.get(f"S{link}", f"S{link}") if link != "0" else None,
                0.01 * int(link) * scale**2,
            )
            for link, places in points.items()
        }
        sketch = {p: at for link in body.values() for p, at in link.points.items()}
        driver = Driver(called.get("1", "1"), OMEGA)
        return Mechanism(body, driver, guides, tuple(slides), sketch=sketch)


def drawn(name: str, seed: int, sliding: Sequence[int] = ()) -> Drawn:
    """Joints at random in a square of 2 m, those numbered in `sliding` as lines of random direction."""
    random = np.random.default_rng(seed)
    count = len(TOPOLOGIES[name])
    places = random.uniform(-1, 1, count) + 1j * random.uniform(-1, 1, count)
    angles = random.uniform(-np.pi, np.pi, count)
    lines = [complex(np.exp(1j * angle)) if n in sliding else 0j for n, angle in enumerate(angles)]
    return Drawn(name, [complex(p) for p in places], lines)

"""The block scheme of the loop: the machine, the governor, the throttle, the servomotor with its feedback; the
brake."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from tmm_report.chapters.machine.governor.solve.in_loop import LoopFound
from tmm_report.figures.drawing import (
    NORMAL,
    Arrow,
    Circle,
    Drawing,
    Item,
    Text,
    line,
    polygon,
)
from tmm_report.figures.lettering import Parts, Symbol, width
from tmm_report.problems import N_

Say = Callable[[str], str]
TALL, GAP, SIZE = 12.0, 12.0, 3.0  # height of a box, an arrow between two, height of the letters, mm
SPARE = 5.0  # beside the letters of a box
BACK, AHEAD = 8.0, 7.0  # of the line that goes back, from the first and the last box

MACHINE, BEVEL, GOVERNOR = N_("machine"), N_("bevel gear pair"), N_("governor")
THROTTLE, SERVO, ISODROME = N_("throttle"), N_("servomotor"), N_("isodrome")


def blocks(found: LoopFound, say: Say, title: str = "") -> Drawing:
    """From the speed of the machine through the governor back to its drive."""
    names = [BEVEL, GOVERNOR] + ([SERVO] if found.servo else []) + [THROTTLE]
    signals: list[Parts] = [(Symbol("ω", "g"),), (Symbol("z"),)]
    signals += [(Symbol("s"),)] if found.servo else []
    wide = [width((say(name),), SIZE) + SPARE for name in names]
    items: list[Item] = []
    lefts = _lefts(wide)
    for name, left, long in zip(names, lefts, wide, strict=True):
        items += _box(left, 0.0, long, say(name))
    for k, signal in enumerate(signals):
        start, end = lefts[k] + wide[k], lefts[k + 1]
        fed = (
            GAP / 3 if k == 1 and found.servo and found.servo.beta else 0.0
        )  # there is a node before the box
        said = complex((start + end) / 2 - fed, 0)
        items += [Arrow(complex(start, 0), complex(end, 0)), _over(signal, said)]
    items += _machine(say(MACHINE), lefts[0], lefts[-1] + wide[-1])
    if found.servo and found.servo.beta:
        items += _feedback(say(ISODROME), lefts[1:4], wide[1:4])
    return Drawing(tuple(items), title)


def _lefts(wide: Sequence[float]) -> list[float]:
    lefts = [0.0]
    for one in wide[:-1]:
        lefts.append(lefts[-1] + one + GAP)
    return lefts


def _box(left: float, middle: float, long: float, text: str) -> list[Item]:
    low, high = middle - TALL / 2, middle + TALL / 2
    corners = (complex(left, low), complex(left + long, low), complex(left + long, high), complex(left, high))
    return [polygon(corners, NORMAL), Text(complex(left + long / 2, middle), (text,), SIZE, 0)]


def _over(signal: Parts, at: complex) -> Text:
    return Text(at + 3.2j, signal, SIZE, 0)


def _machine(name: str, left: float, right: float) -> Iterator[Item]:
    """Above the others: the signals go back through it, from the right to the left."""
    up, long = 26.0, width((name,), SIZE) + 10
    middle = (left + right) / 2
    yield from _box(middle - long / 2, up, long, name)
    node = complex(middle + long / 2 + 18, up)
    yield line(complex(right, 0), complex(right + AHEAD, 0))
    yield line(complex(right + AHEAD, 0), complex(right + AHEAD, up))
    yield Arrow(complex(right + AHEAD, up), node + 2.5)
    yield Text(
        complex((right + AHEAD + node.real + 2.5) / 2, up + 3.4),
        (Symbol("M", "d"), " ", Symbol("s")),
        SIZE,
        0,
    )
    yield Circle(node, 2.5, NORMAL, "white")
    yield Arrow(node + 14j, node + 2.5j)
    yield Text(node + 10j + 2, (Symbol("M", "c"),), SIZE)
    yield Text(node + 4.6j - 3.4, ("−",), SIZE, 0)
    yield Arrow(node - 2.5, complex(middle + long / 2, up))
    yield line(complex(middle - long / 2, up), complex(left - BACK, up))
    yield line(complex(left - BACK, up), complex(left - BACK, 0))
    yield Arrow(complex(left - BACK, 0), complex(left, 0))
    yield Text(complex((middle - long / 2 + left - BACK) / 2, up + 3.2), (Symbol("ω"),), SIZE, 0)


def _feedback(name: str, lefts: Sequence[float], wide: Sequence[float]) -> Iterator[Item]:
    """From the piston below the servomotor back to its valve."""
    low, long = -20.0, width((name,), SIZE) + SPARE
    taken = lefts[2] - GAP / 3
    node = complex(lefts[1] - GAP / 3, 0)
    middle = (taken + node.real) / 2
    yield line(complex(taken, 0), complex(taken, low))
    yield Arrow(complex(taken, low), complex(middle + long / 2, low))
    yield from _box(middle - long / 2, low, long, name)
    yield line(complex(middle - long / 2, low), complex(node.real, low))
    yield Arrow(complex(node.real, low), node - 2j)
    yield Circle(node, 2.0, NORMAL, "white")
    yield Text(complex(node.real - 2.6, low / 2), (Symbol("x"),), SIZE, 0)

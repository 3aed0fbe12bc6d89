"""A thousand random demands of each kind: what was asked comes out of the solver's motion to 1e-9, of the others is
told what is wrong.

The lengths that are found go as arrays into one mechanism, whose positions the solver gives; its dead points are roots
of the velocity, found by halving, no closed form of the synthesis takes part in them. What is refused is held against
the triangles of the demand laid out with numbers.
"""

import random
from collections import Counter

import numpy as np
import pytest
from random_demands import CANNOT, DRAWN, FUNCTIONS, SIZES, read

from tmm_report import loading
from tmm_report.chapters.lever.synthesis.solve import design
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.assur_groups import decompose
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide
from tmm_report.problems import ProblemError

QUICK, MANY = 30, 1000


def demands(kind, count):
    """Random demands of a kind, and what is found of each: a Design, or the problems that are told."""
    draw = random.Random(f"{kind} {count}")
    texts = [DRAWN[kind](draw) for _ in range(count)]
    found = []
    for text in texts:
        try:
            variant = loading.loads(f"language: en\nsynthesis: {{{kind.split()[0]}: {{{text}}}}}\n")
            found.append(design(variant.synthesis))
        except ProblemError as error:
            found.append(error.problems)
    return list(zip(texts, found, strict=True))


def told(kind, made):
    """How many demands are refused, by what is said: each once, of this synthesis, with what would be right."""
    said = Counter()
    for text, problems in made:
        if isinstance(problems, list):
            assert problems[0].path[:2] == ("synthesis", kind.split()[0]) and len(problems) == 1, text
            assert problems[0].right is not None, problems[0].text()
            said[problems[0].wrong.text] += 1
    return said


# ---------------------------------------------------------------- the motion


def moved(links, phi, sign, guides=(), slides=()):
    """The solver's motion at angles (V, P) of link 1, at 1 rad/s. `links`: name -> point -> place, number or (V, 1)."""
    made = {name: Link(name, points) for name, points in links.items()}
    mechanism = Mechanism(made, Driver("1", 1.0), {one.name: one for one in guides}, slides)
    structure = decompose(mechanism)
    signs = sign if isinstance(sign, tuple) else (sign,) * len(structure.groups)
    return motion.solve(motion.linkage_of(structure, signs), phi)


def dead_points(rate, count):
    """Both angles of each of `count` mechanisms at which a rate, of angles (V, P), passes zero, (V, 2)."""
    grid = np.linspace(0, 2 * np.pi, 1441)[None] + np.zeros((count, 1)) + 1e-3
    rates = rate(grid)
    turns = rates[:, :-1] * rates[:, 1:] < 0
    assert (turns.sum(axis=1) == 2).all(), turns.sum(axis=1)
    k = np.nonzero(turns)[1].reshape(count, 2)
    low, high = np.take_along_axis(grid, k, 1), np.take_along_axis(grid, k + 1, 1)
    before = np.sign(np.take_along_axis(rates, k, 1))
    for _ in range(56):
        middle = (low + high) / 2
        same = np.sign(rate(middle)) == before
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return (low + high) / 2


def time_ratio(phi):
    one = np.abs(phi[:, 1] - phi[:, 0])
    return np.maximum(one, 2 * np.pi - one) / np.minimum(one, 2 * np.pi - one)


def least(value, count):
    """The least of a value over the turn, (V,): by ever finer grids about its lowest place."""
    low, wide = np.zeros((count, 1)), 2 * np.pi
    for steps in (720, *[40] * 6):  # at last 1e-8 rad apart, and it is flat there
        grid = low + np.linspace(0, wide, steps + 1)[None]
        values = value(grid)
        at = np.argmin(values, axis=1)[:, None]
        low, wide = np.take_along_axis(grid, at, 1) - 2 * wide / steps, 4 * wide / steps
    return values.min(axis=1)


def numbers(found, *keys):
    """Of all that is found, (V, 1) each."""
    return [np.array([one.s.number(key) for one in found])[:, None] for key in keys]


def asked(found, key, default=np.nan):
    return np.array([getattr(one.given.asked, key) or default for one in found], float)


def close(one, other, scale=1.0, of=1e-9):
    one, other = np.ravel(one), np.ravel(other)
    off = np.abs(one - other) / np.maximum(np.abs(other), 1e-300) / np.ravel(scale)
    assert (off <= of).all(), (np.nanargmax(off), np.nanmax(off))


def slider_crank(found):
    a, b, e = numbers(found, "crank", "rod", "offset")
    links = {"0": {"O": 0j}, "1": {"O": 0j, "A": a}, "2": {"A": 0j, "B": b}, "3": {"B": 0j}}
    guide, slide = Guide("x", "0", 1j * e, 1 + 0j), Slide("3", "x")

    def at(phi):
        return moved(links, phi, 1, [guide], [slide])

    count = len(found)
    assert (at(np.zeros((count, 1))).place("B").real > 0).all()
    ends = dead_points(lambda phi: at(phi).velocity("B").real, count)
    places = at(ends).place("B").real
    steep = least(lambda phi: -np.abs((at(phi).place("B") - at(phi).place("A")).imag) / b, count)
    pressure = np.arcsin(np.minimum(-steep, 1.0))
    # where rod and slide line are nearly square, the stroke has as many digits less
    keen = 1 / np.cos(pressure)
    stroke = np.abs(places[:, 0] - places[:, 1])
    speed, omega = asked(found, "mean_speed"), asked(found, "speed")
    wanted = np.where(np.isnan(speed), asked(found, "stroke"), np.pi * speed / omega)
    close(stroke, wanted, keen)
    by_ratios = np.isfinite(asked(found, "offset_ratio")) | (asked(found, "offset", 0.0) > 0)
    K = asked(found, "K")
    close(np.where((K > 1) | ~by_ratios, time_ratio(ends), 1), K, keen**2)
    for key, size in (("ratio", b / a), ("offset", e), ("offset_ratio", e / a)):
        stated = asked(found, key)
        given = np.isfinite(stated)
        close(size[given, 0], stated[given])
    permitted = asked(found, "pressure_angle")
    assert (
        np.sin(pressure) <= np.sin(np.where(np.isnan(permitted), np.pi / 2, permitted)) * (1 + 1e-9)
    ).all()
    close(np.sin(pressure), np.sin(numbers(found, "pressure")[0]))


def crank_rocker(found):
    a, b, c, x, y, d = numbers(found, "crank", "rod", "rocker", "frame_x", "frame_y", "frame")
    links = {
        "0": {"O": 0j, "C": x + 1j * y},
        "1": {"O": 0j, "A": a},
        "2": {"A": 0j, "B": b},
        "3": {"C": 0j, "B": c},
    }
    count = len(found)
    both = [
        moved(links, np.linspace(0, 2 * np.pi, 73)[None] + np.zeros((count, 1)), sign) for sign in (1, -1)
    ]
    # the assembly in which the rocker is on the side of its middle position, which is asked to be up
    up = [np.mean(one.place("B").imag - y, axis=1) for one in both]
    sign = np.where(up[0] > up[1], 1, -1)[:, None]

    def at(phi):
        return moved(links, phi, sign)

    def swung(phi):
        return np.angle((at(phi).place("B") - (x + 1j * y)) / 1j)

    def between(phi):
        m = at(phi)
        rod, rocker = m.place("B") - m.place("A"), m.place("B") - (x + 1j * y)
        return np.arcsin(np.minimum(np.abs(np.imag(np.conj(rod) * rocker)) / (b * c), 1.0))

    def rate(phi):
        m = at(phi)
        return np.imag(np.conj(m.place("B") - (x + 1j * y)) * m.velocity("B"))

    close(np.hypot(x, y), d)
    angle = least(between, count)
    keen = 1 / np.sin(angle)
    ends = dead_points(rate, count)
    swings = swung(ends)
    close(np.abs(swings[:, 0] - swings[:, 1]), asked(found, "swing"), keen)
    assert (np.abs(swings.sum(axis=1)) <= 2e-9 * keen).all()  # about the direction that is asked
    close(time_ratio(ends), asked(found, "K"), keen)
    close(angle, numbers(found, "transmission")[0], keen)
    for key, size in (("crank", a), ("rod", b), ("frame", d), ("rocker", c)):
        stated = asked(found, key)
        given = np.isfinite(stated)
        close(size[given, 0], stated[given])


def slotted(found, moves, pivot, line, arm):
    """Crank and slotted link, rod and slider; `pivot` of the link, the slide line at height `line`, `moves`: the
    crank's pivot."""
    a, r, b = numbers(found, "crank", arm, "rod")
    count = len(found)
    links = {
        "0": {"O": moves, "C": pivot}, "1": {"O": 0j, "A": a}, "2": {"A": 0j}, "3": {"C": 0j, "B": r},
        "4": {"B": 0j, "D": b}, "5": {"D": 0j},
    }  # fmt: skip
    guides = [Guide("x", "0", 1j * line, 1 + 0j), Guide("k", "3", 0j, 1 + 0j)]
    slides = [Slide("2", "k"), Slide("5", "x")]
    signs = {}
    for one in (1, -1):  # the slide block on the link's own side, the slider to the right
        for other in (1, -1):
            m = moved(links, np.full((count, 1), 0.7), (one, other), guides, slides)
            signs[one, other] = (
                (m.place("D") - m.place("B")).real.min(),
                np.real(np.conj(m.place("B") - pivot) * (m.place("A") - pivot)).min(),
            )
    own = 1 if arm == "link" else -1
    (sign,) = [key for key, (right, along) in signs.items() if right > 0 and own * along > 0]

    def at(phi):
        return moved(links, phi, sign, guides, slides)

    ends = dead_points(lambda phi: at(phi).velocity("D").real, count)
    places = at(ends).place("D").real
    close(np.abs(places[:, 0] - places[:, 1]), asked(found, "stroke"))
    close(time_ratio(ends), asked(found, "K"))
    steep = least(lambda phi: -np.abs((at(phi).place("D") - at(phi).place("B")).imag) / b, count)
    close(-steep, np.sin(numbers(found, "pressure")[0]))
    permitted = asked(found, "pressure_angle")
    free = np.isfinite(permitted) & np.isnan(asked(found, "rod")) & np.isnan(asked(found, "rod_ratio"))
    close(-steep[free], np.sin(permitted[free]))


def slotted_link(found):
    d, h = numbers(found, "frame", "slide_line")
    slotted(found, 1j * d, 0j, h, "link")


def turning_guide(found):
    (d,) = numbers(found, "frame")
    slotted(found, 0j, 1j * d, d, "arm")


def function(found, texts):
    a, b, c, d = numbers(found, "crank", "rod", "rocker", "frame")
    links = {"0": {"O": 0j, "C": d}, "1": {"O": 0j, "A": a}, "2": {"A": 0j, "B": b}, "3": {"C": 0j, "B": c}}
    first, turn, start, swing = (
        asked(found, key, 0.0)[:, None] for key in ("crank_from", "crank_turn", "rocker_from", "rocker_turn")
    )

    def off(share, sign):
        """How far the rocker is from the angle of the function, and sine of the transmission angle, each (V, P)."""
        m = moved(links, first + turn * share, sign)
        rod, rocker = m.place("B") - m.place("A"), m.place("B") - d
        wanted = start + swing * np.array([values_of(*one) for one in zip(found, texts, share, strict=True)])
        sine = np.abs(np.imag(np.conj(rod) * rocker)) / np.abs(b * c)
        return np.abs(np.angle(rocker / np.sign(c) * np.exp(-1j * wanted))), np.minimum(sine, 1.0)

    accurate = np.array([points_of_accuracy(one.given.asked.spacing) for one in found])
    offs = np.array([off(accurate, sign)[0].max(axis=1) for sign in (1, -1)])
    sign = np.where(offs[0] < offs[1], 1, -1)[:, None]
    error, sine = off(np.linspace(0, 1, 721)[None] + np.zeros((len(found), 1)), sign)
    error, angle = error.max(axis=1), np.arcsin(sine.min(axis=1))
    # near a position in which rod and rocker lie on one line the angle has as many digits less
    size = np.max([np.ones_like(d), np.abs(a) / d, np.abs(c) / d, b / d], axis=0)[:, 0] / angle
    assert (offs.min(axis=0) <= 1e-9 * size).all()
    stated, transmission = (np.ravel(one) for one in numbers(found, "error", "transmission"))
    assert (error <= stated * (1 + 1e-9) + 1e-9).all() and (error >= stated * 0.99 - 1e-9).all()
    assert (angle >= transmission - 1e-9).all()
    assert (np.abs(angle - transmission) <= np.maximum(0.02 * transmission, 1e-12)).all()


def points_of_accuracy(spacing):
    """Where the three of them lie, as shares of the interval."""
    ends, middle = np.array([0.0, 0.5, 1.0]), (1 - np.cos(np.pi * np.array([1, 3, 5]) / 6)) / 2
    return ends if spacing == "ends" else middle


def values_of(one, text, share):
    """The function's value at shares of the interval, from 0 at its beginning to 1 at its end."""
    f = next(f for name, f in FUNCTIONS.items() if f"y: {name}," in text)
    low, high = one.given.asked.x
    return (f(low + share * (high - low)) - f(low)) / (f(high) - f(low))


def dwell(found):
    a, b, c, d, x, y = numbers(found, "crank", "rod", "rocker", "frame", "point_x", "point_y")
    qx, qy, radius, line = numbers(found, "centre_x", "centre_y", "radius", "guide_angle")
    centre = qx + 1j * qy
    links = {
        "0": {"O": 0j, "C": d}, "1": {"O": 0j, "A": a}, "2": {"A": 0j, "B": b, "P": x + 1j * y}, "3": {"C": 0j, "B": c},
        "4": {"P": 0j, "D": radius}, "5": {"D": 0j},
    }  # fmt: skip
    guide, slide = Guide("x", "0", centre, np.exp(1j * line)), Slide("5", "x")
    phi = np.array([one.given.asked.angles for one in found])
    left = np.array([one.given.asked.rocker_joint == "left" for one in found])[:, None]
    each = [moved(links, phi, sign, [guide], [slide]) for sign in (1, -1)]
    is_left = np.imag(np.conj(d - each[0].place("A")) * (each[0].place("B") - each[0].place("A"))) > 0
    first = np.where(is_left[:, :1] == left, 1, -1)
    # the slider on the side to which the guide points
    for second in (1, -1):
        m = moved(links, phi, (first, np.full_like(first, second)), [guide], [slide])
        if (np.real((m.place("D") - m.place("P"))[:, 1:2] * np.exp(-1j * line)) > 0).all():
            break
    rod = m.place("D") - m.place("P")
    inclined = np.cos(np.angle(rod) - line)
    close(np.abs(m.place("P") - centre), radius + 0 * phi)
    # a rod that is nearly square to the guide carries the slider by as much more
    assert (inclined > 0).all() and (np.abs(m.place("D") - centre) * inclined / radius).max() < 1e-9
    order = np.angle((m.place("P") - centre) / (m.place("P") - centre)[:, 1:2])
    assert (order[:, 0] * order[:, 2] < 0).all()


def body(found):
    """The coupler is where the body should be in each position, and comes there in their order without a break."""
    for one in found:
        number, stated = one.s.number, one.given.asked
        crank = complex(number("crank_pivot_x"), number("crank_pivot_y"))
        rocker = complex(number("rocker_pivot_x"), number("rocker_pivot_y"))
        x, y, turned = np.array(stated.positions).T
        pins = x + 1j * y + np.exp(1j * turned) * complex(*stated.points[0])
        links = {
            "0": {"O": crank, "C": rocker}, "1": {"O": 0j, "A": number("crank")},
            "2": {"W": 0j, "A": complex(*stated.points[0]), "B": complex(*stated.points[1])},
            "3": {"C": 0j, "B": number("rocker")},
        }  # fmt: skip
        phi = np.angle(pins - crank)
        best = min(
            (moved(links, phi, sign) for sign in (1, -1)),
            key=lambda m: np.abs(m.place("W") - x - 1j * y).max(),
        )
        rod, arm = best.place("B") - best.place("A"), best.place("B") - rocker
        size = np.abs(best.places).max() / np.abs(rod).min()
        keen = size / np.abs(np.imag(np.conj(rod) * arm) / np.abs(rod * arm)).min()
        assert np.abs(best.place("W") - x - 1j * y).max() <= 1e-9 * keen * size
        side = np.sign(np.imag(np.conj(best.place("A") - rocker) * arm))
        assert np.abs(side.sum()) == len(side)
        ways = []
        for sense in (1, -1):
            steps = (sense * np.diff(phi)) % (2 * np.pi)
            if steps.sum() < 2 * np.pi:
                way = phi[0] + sense * np.linspace(0, steps.sum(), 2001)
                ways.append(np.abs(np.abs(number("crank") * np.exp(1j * way) + crank - rocker)))
        shortest, longest = abs(number("rod") - number("rocker")), number("rod") + number("rocker")
        slack = 1e-9 * longest
        assert any(shortest - slack <= way.min() and way.max() <= longest + slack for way in ways)
        for key in ("crank", "rocker"):
            if getattr(stated, key) is not None:
                assert number(key) == getattr(stated, key)


def positions(found):
    """Of two positions of a rocker or a slider: by the solver, at the extremes or at the angles of the crank."""
    for sliding in (True, False):
        own = [one for one in found if ("x_1" in one.s) == sliding]
        for extreme in (True, False):
            chosen = [one for one in own if (one.given.asked.crank_angles is None) == extreme]
            if chosen:
                (_extreme if extreme else _with_crank)(chosen, sliding)


def _linkage(found, sliding):
    """The solver's motion at angles (V, P), in the assembly that each is in; where the joint of rod and output is, and
    the output's coordinate."""
    a, b = numbers(found, "crank", "rod")
    count = len(found)
    if sliding:
        (e,) = numbers(found, "offset")
        links = {"0": {"O": 0j}, "1": {"O": 0j, "A": a}, "2": {"A": 0j, "B": b}, "3": {"B": 0j}}
        more = [Guide("x", "0", -1j * e, 1 + 0j)], [Slide("3", "x")]
        sign = np.array([np.sign(one.given.asked.places[0] - _pin(one)) for one in found])[:, None]
    else:
        c, d = numbers(found, "rocker", "frame")
        links = {
            "0": {"O": 0j, "C": d + 0j},
            "1": {"O": 0j, "A": a},
            "2": {"A": 0j, "B": b},
            "3": {"C": 0j, "B": c},
        }
        more, sign = ((), ()), None

    def at(phi, sign=sign):
        return moved(links, phi, sign.astype(int), *more)

    if sliding:
        return at, lambda m: m.place("B").real
    psi = np.array([one.given.asked.angles[0] for one in found])[:, None]
    first = np.array([_first_angle(one) for one in found])[:, None]
    miss = []
    for one in (1, -1):
        m = at(first, np.full((count, 1), one))
        miss.append(np.abs(m.place("B") - d - c * np.exp(1j * psi)))
    sign = np.where(miss[0] < miss[1], 1, -1)
    return (lambda phi: at(phi, sign)), (lambda m: np.angle(m.place("B") - d))


def _first_angle(one):
    """Of the crank in the first stated position: stated, or on the line of the rod there."""
    asked_ = one.given.asked
    if asked_.crank_angles is not None:
        return asked_.crank_angles[0]
    end = one.s.number("frame") + one.s.number("rocker") * np.exp(1j * asked_.angles[0])
    outstretched = abs(asked_.angles[0]) < abs(asked_.angles[1])
    return np.angle(end if outstretched else -end) + 1e-7


def _pin(one):
    """How far to the right the crank's pin is in the first stated place of the slider."""
    angles = one.given.asked.crank_angles
    return one.s.number("crank") * np.cos(angles[0]) if angles else 0.0


def _extreme(found, sliding):
    at, coordinate = _linkage(found, sliding)
    count = len(found)
    (b,) = numbers(found, "rod")

    def rate(phi):
        m = at(phi)
        return m.velocity("B").real if sliding else m.angular_velocity("3")

    reached = coordinate(at(dead_points(rate, count)))
    stated = np.array([one.given.asked.places if sliding else one.given.asked.angles for one in found])
    off = np.abs(np.sort(reached, axis=1) - np.sort(stated, axis=1))
    assert (off <= 1e-9 * np.abs(stated).max(axis=1, keepdims=True)).all(), off.max()
    close(
        time_ratio(dead_points(rate, count)),
        [one.s.number("K") if "K" in one.s else 1.0 for one in found],
        of=1e-7,
    )
    steep = numbers(found, "pressure" if sliding else "transmission")[0]

    def angle(phi):
        m = at(phi)
        rod = m.place("B") - m.place("A")
        if sliding:
            return -np.arcsin(np.minimum(np.abs(rod.imag) / b, 1.0))
        rocker = m.place("B") - m.place("C")
        return np.arcsin(np.minimum(np.abs(np.imag(np.conj(rod) * rocker)) / np.abs(rod * rocker), 1.0))

    close(np.abs(least(angle, count)), steep, of=1e-7)


def _with_crank(found, sliding):
    """Both stated positions are those of the solver, which closes all the way between them."""
    at, coordinate = _linkage(found, sliding)
    phi = np.array([one.given.asked.crank_angles for one in found])
    stated = np.array([one.given.asked.places if sliding else one.given.asked.angles for one in found])
    m = at(phi)
    off = coordinate(m) - stated
    off = off if sliding else np.angle(np.exp(1j * off))
    tilt = np.cos(numbers(found, "pressure")[0]) if sliding else np.sin(numbers(found, "transmission")[0])
    assert (np.abs(off) * tilt <= 1e-9).all(), np.abs(off * tilt).max()
    way = phi[:, :1] + (phi[:, 1:] - phi[:, :1]) * np.linspace(0, 1, 361)
    assert np.isfinite(at(way).place("B")).all()


MEETS = {
    "slider_crank": slider_crank, "crank_rocker": crank_rocker, "slotted_link": slotted_link,
    "turning_guide": turning_guide, "dwell": dwell, "body": body, "body of two positions": body,
    "rocker_positions": positions, "slider_positions": positions,
}  # fmt: skip


def check(kind, count):
    made = demands(kind, count)
    said = told(kind, made)
    found = [(text, one) for text, one in made if not isinstance(one, list)]
    if kind in CANNOT:
        for text, one in made:
            stated = read(text)
            if (
                stated.get("K", 1) > 1
                and any(key in stated for key in SIZES[kind])
                and "pressure_angle" not in stated
            ):
                assert isinstance(one, list) == CANNOT[kind](stated), text
    assert len(found) + sum(said.values()) == count and len(found) > count / 25, (len(found), said)
    if kind == "function":
        function([one for _, one in found], [text for text, _ in found])
    else:
        MEETS[kind]([one for _, one in found])
    return len(found), said


@pytest.mark.parametrize("kind", DRAWN)
def test_what_is_asked_comes_out_and_what_cannot_be_is_told(kind):
    check(kind, QUICK)


@pytest.mark.exhaustive
@pytest.mark.parametrize("kind", DRAWN)
def test_what_is_asked_comes_out_of_a_thousand_demands(kind):
    met, said = check(kind, MANY)
    print(kind, met, "met,", dict(said))

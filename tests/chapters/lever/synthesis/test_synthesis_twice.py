"""Every formula of a synthesis by a second way: the triangles of the extreme positions solved in coordinates."""

import math
import re

import numpy as np
import pytest
from notes import render
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.lever.synthesis.given import AnglePairs
from tmm_report.mechanics.lever import synthesis

TEXTS = {
    "slider-crank by ratio": "slider_crank: {stroke: 120 mm, K: 1.2, ratio: 3.1}",
    "slider-crank, free": "slider_crank: {stroke: 120 mm, K: 1.2}",
    "slider-crank by angle": "slider_crank: {stroke: 120 mm, K: 1.1, pressure_angle: 45 deg}",
    "slider-crank by offset": "slider_crank: {stroke: 120 mm, K: 1.2, offset: 40 mm}",
    "slider-crank by ratios": "slider_crank: {stroke: 120 mm, ratio: 3, offset_ratio: 0.7}",
    "slider-crank by ratio and offset": "slider_crank: {stroke: 120 mm, ratio: 3, offset: 25 mm}",
    "slider-crank in line": "slider_crank: {mean_speed: 0.8 m/s, speed: 120 rpm, pressure_angle: 12 deg}",
    "slider-crank in line by ratio": "slider_crank: {stroke: 90 mm, ratio: 4}",
    "slider-crank of a mean speed": "slider_crank: {stroke: 90 mm, mean_speed: 0.6 m/s, transmission: 75 deg}",
    "crank-rocker by crank": "crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m, crank: 0.15 m}",
    "crank-rocker beyond": "crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m, crank: 0.15 m, beyond: true}",
    "crank-rocker by rod": "crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m, rod: 0.9 m}",
    "crank-rocker by frame": "crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m, frame: 0.85 m}",
    "crank-rocker, free": "crank_rocker: {K: 1.25, swing: 60 deg, rocker: 300 mm, middle: 90 deg}",
    "crank-rocker in step by rod": "crank_rocker: {swing: 60 deg, rocker: 300 mm, rod: 500 mm}",
    "crank-rocker in step by frame": "crank_rocker: {swing: 60 deg, rocker: 300 mm, frame: 500 mm}",
    "shaper": "slotted_link: {stroke: 400 mm, K: 1.5, frame: 420 mm, rod_ratio: 0.25}",
    "shaper by crank": "slotted_link: {stroke: 400 mm, K: 1.5, crank: 130 mm, pressure_angle: 7 deg}",
    "shaper by swing": "slotted_link: {stroke: 400 mm, swing: 40 deg, frame: 420 mm, rod_ratio: 0.25}",
    "shaper by crank and frame": "slotted_link: {stroke: 400 mm, crank: 130 mm, frame: 420 mm, pressure_angle: 7 deg}",
    "shaper by transmission angle": "slotted_link: {stroke: 400 mm, K: 1.5, crank: 130 mm, transmission: 80 deg, "
    "working_speed: 0.4 m/s}",
    "Whitworth of a working speed": "turning_guide: {stroke: 300 mm, K: 1.8, crank: 150 mm, transmission: 70 deg, "
    "working_speed: 0.5 m/s}",
    "Whitworth": "turning_guide: {stroke: 300 mm, K: 1.8, crank: 150 mm, rod_ratio: 4}",
    "Whitworth by frame": "turning_guide: {stroke: 300 mm, K: 1.8, frame: 60 mm, pressure_angle: 20 deg}",
    "function": "function: {y: x^1.5, x: [1, 4], crank_from: 30 deg, crank_turn: 90 deg, rocker_from: 60 deg, "
    "rocker_turn: 90 deg, frame: 100 mm}",
    "pairs of angles": "function: {pairs: [[20 deg, 35 deg], [35 deg, 45 deg], [50 deg, 60 deg]], frame: 100 mm}",
    "body from one position to another": "body: {positions: [[0, 0, 0], [90 mm, 40 mm, 50 deg]], "
    "points: [[0, 0], [80 mm, 20 mm]], crank: 70 mm}",
    "body whose crank passes the frame": "body: {positions: [[0, 0, 0], [90 mm, 40 mm, 50 deg]], "
    "points: [[0, 0], [80 mm, 20 mm]], crank: 55 mm, crank_pivot: right, rocker: 70 mm, rocker_pivot: left}",
    "rocker between extremes": "rocker_positions: {rocker: 300 mm, angles: [100 deg, 60 deg], frame: 400 mm}",
    "rocker between extremes below": "rocker_positions: {rocker: 300 mm, angles: [-60 deg, -85 deg]}",
    "rocker and crank": "rocker_positions: {frame: 400 mm, rocker: 250 mm, angles: [60 deg, 100 deg], "
    "crank_angles: [30 deg, 110 deg]}",
    "rocker and crank, free": "rocker_positions: {frame: 400 mm, angles: [60 deg, 100 deg], "
    "crank_angles: [30 deg, 110 deg]}",
    "slider between extremes": "slider_positions: {places: [150 mm, 270 mm], offset: 30 mm}",
    "slider between extremes to the left": "slider_positions: {places: [-150 mm, -270 mm]}",
    "slider and crank": "slider_positions: {places: [270 mm, 190 mm], offset: -20 mm, crank_angles: [20 deg, 90 deg]}",
    "slider and crank, free": "slider_positions: {places: [270 mm, 190 mm], crank_angles: [20 deg, 90 deg]}",
    "body by a rocker on the other side": "body: {positions: [[10 mm, 0, 20 deg], [90 mm, 40 mm, 50 deg]], "
    "points: [[0, 0], [80 mm, 20 mm]], crank: 70 mm, crank_pivot: right, rocker: 90 mm}",
}


def found_of(text):
    return course.solve(loading.loads(f"language: en\nsynthesis: {{{text}}}\n")).synthesis


@pytest.mark.parametrize("name", TEXTS, ids=lambda name: name.replace(" ", "_"))
def test_every_formula_agrees_with_the_second_way(name):
    found = found_of(TEXTS[name])
    assert disagreements(found.s, WAYS[found.given.kind](found.s, found.given.asked), 1e-8) == []


def met(one: complex, r: float, other: complex, R: float, left: bool) -> complex:
    """Where two circles meet, to the left or right of the line from one centre to the other."""
    line = other - one
    far = abs(line)
    along = (r**2 - R**2 + far**2) / (2 * far)
    return one + line / far * complex(along, math.sqrt(r**2 - along**2) * (1 if left else -1))


def transmits(pressure, asked):
    """The angles that are stated or asked in place of those of pressure; the speed by the time of the slow stroke."""
    ways = {}
    if asked.transmission is not None:
        ways |= {
            "permitted": math.radians(90) - asked.transmission,
            "transmission": math.radians(90) - pressure,
        }
    if getattr(asked, "working_speed", None) is not None:
        slow = asked.stroke / asked.working_speed
        ways["speed"] = 2 * math.pi / (slow + slow / asked.K)
    elif getattr(asked, "stroke", None) and getattr(asked, "mean_speed", None):
        ways["speed"] = 2 * math.pi / (2 * asked.stroke / asked.mean_speed)
    return ways


def slider_crank(s, asked):
    """The slider's extreme places off a line at distance e from the crank's pivot."""
    a, b, e = (s.number(key) for key in ("crank", "rod", "offset"))
    far, near = complex(math.sqrt((b + a) ** 2 - e**2), e), complex(math.sqrt((b - a) ** 2 - e**2), e)
    stroke = abs(far - near)
    theta = np.angle(near / far)
    phi = np.linspace(0, 2 * np.pi, 3601)
    pressure = np.arcsin(np.max(np.abs(a * np.sin(phi) - e)) / b)
    both = met(0j, 0.0 + b - a, stroke + 0j, b + a, True) if e else None
    turned = asked.K if asked.K > 1 else 1.0
    wanted = asked.stroke or asked.mean_speed * math.pi / asked.speed
    ways = {"stroke": wanted, "theta": math.pi * (turned - 1) / (turned + 1), "pressure": pressure}
    ways["difference"] = b * b - a * a
    # the two dead positions give the same crank, rod and offset again
    ways |= {"crank": (abs(far) - abs(near)) / 2, "rod": (abs(far) + abs(near)) / 2}
    ways["offset"] = abs(both.imag) if both is not None else e
    ways |= transmits(pressure, asked)
    assert stroke == pytest.approx(wanted, rel=1e-9)
    assert asked.K == 1 or theta == pytest.approx(ways["theta"], rel=1e-8)
    return ways


def crank_rocker(s, asked):
    a, b, c, d = (s.number(key) for key in ("crank", "rod", "rocker", "frame"))
    ends = [c * np.exp(1j * (math.pi / 2 + turn * asked.swing / 2)) for turn in (-1, 1)]
    half, rise = abs(ends[0] - ends[1]) / 2, (ends[0] + ends[1]).imag / 2
    theta = math.pi * (asked.K - 1) / (asked.K + 1)
    # the pivot of the crank sees the chord's ends at its distances from them
    pivots = [met(ends[0], b - a, ends[1], b + a, left) for left in (True, False)] if theta else []
    inside = min(pivots, key=abs) if pivots else complex(s.number("along"), rise)
    pivot = max(pivots, key=abs) if asked.beyond else inside
    if theta:
        assert abs(np.angle((ends[0] - pivot) / (ends[1] - pivot))) == pytest.approx(theta, rel=1e-8)
    angles = []
    for pin in (a + 0j, -a + 0j):
        joint = met(pin, b, d + 0j, c, True)
        angles.append(abs(np.angle((joint - pin) / (joint - d))))
    family = synthesis.crank_rockers(theta, asked.swing, c, np.array([a]), asked.beyond) if theta else None
    distances = abs(ends[0] - pivot), abs(ends[1] - pivot)
    return {
        "theta": theta, "half_chord": half, "rise": rise, "along": abs(pivot.real), "away": abs(pivot.imag - rise),
        "frame": abs(pivot), "mu_inner": angles[0], "mu_outer": angles[1],
        "rod": float(family.b[0]) if family else b, "crank": abs(distances[0] - distances[1]) / 2 if theta else half,
    }  # fmt: skip


def slotted_link(s, asked):
    """The crank's circle is touched by the slotted link in its extreme positions."""
    if asked.K is None:
        theta = asked.swing or 2 * math.atan2(asked.crank, math.sqrt(asked.frame**2 - asked.crank**2))
    else:
        theta = math.pi * (asked.K - 1) / (asked.K + 1)
    d = asked.frame or asked.crank / abs(np.sin(theta / 2))
    end = asked.stroke / 2 / math.tan(theta / 2) * 1j + asked.stroke / 2
    top, low = abs(end), end.imag
    line = (top + low) / 2
    off = top - line
    rod = abs(end) * asked.rod_ratio if asked.rod_ratio else off / math.sin(asked.permitted)
    reach = np.linspace(-theta / 2, theta / 2, 4001)
    pressure = np.max(np.abs(np.arcsin((top * np.cos(reach) - line) / rod)))
    # over the arc outside of its tangents the pin goes forth, over the one inside back
    ratio = (2 * math.pi - 2 * math.acos(math.sin(theta / 2))) / (2 * math.acos(math.sin(theta / 2)))
    return {
        "K": ratio, "theta": theta, "crank": abs((np.conj(end) * 1j * d).imag) / top, "frame": d, "link": top,
        "sagitta": top - low, "slide_line": line, "rod": rod, "pressure": pressure, **transmits(pressure, asked),
    }  # fmt: skip


def turning_guide(s, asked):
    """The crank's pin passes the line through the link's pivot at angles whose turns have the ratio K."""
    a, d = s.number("crank"), s.number("frame")
    slow = 2 * math.pi - 2 * math.acos(d / a)
    assert slow / (2 * math.pi - slow) == pytest.approx(asked.K, rel=1e-9)
    frame, crank = a * math.sin(slow / 2 - math.pi / 2), d / math.sin(slow / 2 - math.pi / 2)
    r = asked.stroke / 2
    rod = r * asked.rod_ratio if asked.rod_ratio else r / math.sin(asked.permitted)
    pressure = math.atan(r / math.sqrt(rod**2 - r**2))
    return {
        "frame": frame,
        "crank": crank,
        "arm": r,
        "rod": rod,
        "pressure": pressure,
        **transmits(pressure, asked),
    }


def function(s, asked):
    """The rod is as long as the joints are apart in each of the three positions."""
    if isinstance(asked, AnglePairs):
        phi, psi = np.array(asked.pairs).T
    else:
        x = 2.5 + 1.5 * np.cos(np.pi * np.array([5, 3, 1]) / 6)
        phi = asked.crank_from + asked.crank_turn * (x - 1) / 3
        psi = asked.rocker_from + asked.rocker_turn * (x**1.5 - 1) / 7
    a, c, d = s.number("crank"), s.number("rocker"), asked.frame
    rods = np.abs(a * np.exp(1j * phi) - d - c * np.exp(1j * psi))
    assert rods == pytest.approx(rods[0], rel=1e-9)
    return {"crank": d / s.number("k2"), "rocker": d / s.number("k3"), "rod": rods[1]}


def body(s, asked):
    """Each pivot is where circles of the link about both places of its pin meet; the links turn about it."""
    ways, pivots, places = {}, {}, []
    for name, key, point in (("A", "crank", asked.points[0]), ("B", "rocker", asked.points[1])):
        one, other = (
            complex(x, y) + np.exp(1j * turned) * complex(*point) for x, y, turned in asked.positions
        )
        pivot = complex(s.number(f"{key}_pivot_x"), s.number(f"{key}_pivot_y"))
        off = ((pivot - one) / (other - one)).imag * abs(other - one)
        found = met(one, s.number(key), other, s.number(key), left=off > 0)
        assert found == pytest.approx(pivot, abs=1e-9)
        turn = abs(np.angle((other - found) / (one - found)))
        ways |= {
            f"way_{name}": abs(other - one),
            f"off_{name}": off,
            f"turn_{name}": turn,
            key: abs(other - found),
        }
        pivots[key] = pivot
        places.append((one, other))
    ways["frame"] = abs(pivots["rocker"] - pivots["crank"])
    assert 0 <= least_on_the_way(s, pivots, places) - s.number("transmission") + 1e-9 <= 1e-4
    return ways


def least_on_the_way(s, pivots, places):
    """The crank turned by small steps from one position to the other."""
    pins, ends = places
    turn = np.angle((pins[1] - pivots["crank"]) / (pins[0] - pivots["crank"]))
    side = ((ends[0] - pins[0]) / (pivots["rocker"] - pins[0])).imag > 0
    angles = []
    for part in np.linspace(0, 1, 4001):
        pin = pivots["crank"] + (pins[0] - pivots["crank"]) * np.exp(1j * turn * part)
        joint = met(pin, s.number("rod"), pivots["rocker"], s.number("rocker"), left=side)
        angle = abs(np.angle((joint - pin) / (joint - pivots["rocker"])))
        angles.append(min(angle, math.pi - angle))
    assert joint == pytest.approx(ends[1], abs=1e-9)
    return min(angles)


def rocker_positions(s, asked):
    """By the places of the joints in both positions."""
    c, d = s.number("rocker"), s.number("frame")
    ends = [d + c * np.exp(1j * one) for one in asked.angles]
    if asked.crank_angles is None:
        far, near = sorted(map(abs, ends), reverse=True)
        a, b = s.number("crank"), s.number("rod")
        theta = abs(np.angle(ends[1] / ends[0]))
        inner, outer = (
            abs(np.angle((joint - pin) / (joint - d)))
            for pin in (a + 0j, -a + 0j)
            for joint in (met(pin, b, d + 0j, c, True),)
        )
        return {
            "far": far, "near": near, "crank": (far - near) / 2, "rod": (far + near) / 2, "theta": theta,
            "K": (math.pi + theta) / (math.pi - theta), "swing": abs(np.angle((ends[1] - d) / (ends[0] - d))),
            "mu_inner": inner, "mu_outer": outer,
        }  # fmt: skip
    return _led_by(s, ends, asked.crank_angles)


def _led_by(s, ends, angles):
    """The crank's pin is as far from both ends: its length by halving, not by the linear equation."""
    turns = np.exp(1j * np.array(angles))

    def differ(a):
        return abs(ends[0] - a * turns[0]) - abs(ends[1] - a * turns[1])

    low, high = 0.0, 3 * s.number("crank")
    assert differ(low) * differ(high) < 0
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if differ(middle) * differ(low) > 0 else (low, middle)
    return {"crank": low, "rod": abs(ends[1] - low * turns[1])}


def slider_positions(s, asked):
    ends = [x - 1j * s.number("offset") for x in asked.places]
    if asked.crank_angles is not None:
        return _led_by(s, ends, asked.crank_angles)
    far, near = sorted(ends, key=abs, reverse=True)
    a, b = (abs(far) - abs(near)) / 2, (abs(far) + abs(near)) / 2
    theta = abs(np.angle(near / far))
    found = {"crank": a, "rod": b, "stroke": abs(far - near), "far": abs(far), "near": abs(near)}
    found |= {"pressure": math.asin((a + abs(far.imag)) / b)}
    return found | ({"theta": theta, "K": (math.pi + theta) / (math.pi - theta)} if asked.offset else {})


WAYS = {
    "rocker_positions": rocker_positions,
    "slider_positions": slider_positions,
    "body": body,
    "slider_crank": slider_crank,
    "crank_rocker": crank_rocker,
    "slotted_link": slotted_link,
    "turning_guide": turning_guide,
    "function": function,
}


def test_the_conclusion_has_the_lengths_as_they_are_taken():
    """Rounded to whole centimetres, and only so."""
    text = "language: en\nsynthesis: {slider_crank: {stroke: 118 mm, K: 1.2, ratio: 3}, round: 1 cm}\n"
    note = render(course.solve(loading.loads(text)), "html")["note.html"].decode()
    said = plain(note.rsplit("The synthesis gives the linkage", 1)[1].split("</p>")[0])
    s = course.solve(loading.loads(text)).synthesis.s
    for key, letter in (("crank", "a"), ("rod", "b"), ("offset", "e")):
        assert f"{letter}={10 * round(s.number(key) * 100)}mm" in said


def plain(html):
    return re.sub(r"<[^>]*>|\s|\N{NO-BREAK SPACE}", "", html)

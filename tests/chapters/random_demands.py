"""Random demands of a synthesis by its kinds, as they are stated, and which of them no linkage meets."""

import cmath
import math

import numpy as np

FUNCTIONS = {
    "log10 x": np.log10, "ln x": np.log, "exp x": np.exp, "sqrt x": np.sqrt, "x^2": np.square, "1/x": np.reciprocal,
    "sin x": np.sin, "tan x": np.tan, "x^1.5": lambda x: x**1.5,
}  # fmt: skip


def _slider_crank(draw):
    u, K = draw.uniform, f"K: {draw.uniform(1.01, 1.8)}"
    size = draw.choice([f"stroke: {u(0.02, 1)} m", f"mean_speed: {u(0.1, 3)} m/s, speed: {u(20, 400)} rpm"])
    own = draw.choice([
        K, f"{K}, ratio: {u(1.05, 8)}", f"{K}, offset: {u(1, 400)} mm", f"{K}, pressure_angle: {u(10, 70)} deg",
        f"{K}, ratio: {u(1.05, 8)}, pressure_angle: {u(10, 70)} deg",
        f"ratio: {u(1.5, 8)}, offset_ratio: {u(0.02, 3)}", f"ratio: {u(1.5, 8)}, offset: {u(1, 400)} mm",
        f"ratio: {u(1.05, 8)}", f"pressure_angle: {u(5, 60)} deg",
        f"ratio: {u(1.05, 8)}, pressure_angle: {u(5, 60)} deg",
    ])  # fmt: skip
    return f"{size}, {own}"


def _crank_rocker(draw):
    u = draw.uniform
    K = draw.choice([1.0, u(1.01, 1.8), u(1.01, 1.3)])
    rocker, swing = u(0.1, 1.0), u(5, 110)
    key = draw.choice(["", "crank", "rod", "frame"])
    chord = rocker * math.sin(math.radians(swing / 2))
    size = {"crank": u(0.1, 1.1) * chord, "rod": u(0.5, 4) * rocker, "frame": u(0.3, 3) * rocker, "": 0.0}[
        key
    ]
    own = f", {key}: {size}" if key and (K > 1 or key != "crank") else ""
    side = "true" if draw.random() < 0.5 else "false"
    return f"K: {K}, swing: {swing} deg, rocker: {rocker}{own}, beyond: {side}, middle: 90 deg"


def _slotted(draw, longest, rods):
    u = draw.uniform
    size, stroke = f"{draw.choice(['frame', 'crank'])}: {u(0.05, 1)}", u(0.1, 1)
    rod = draw.choice([f"rod: {u(*rods)}", f"rod_ratio: {u(*longest)}"])
    own = draw.choice([rod, f"pressure_angle: {u(2, 50)} deg", f"{rod}, pressure_angle: {u(2, 50)} deg"])
    return f"stroke: {stroke}, K: {u(1.02, 3)}, {size}, {own}"


def _function(draw):
    u = draw.uniform
    name, spacing = draw.choice(list(FUNCTIONS)), draw.choice(["chebyshev", "ends"])
    low = u(0.1, 0.6) if name in ("tan x", "sin x") else u(0.5, 2)
    high = low + (u(0.2, 0.8) if name in ("tan x", "sin x") else u(0.5, 3))
    return (
        f"y: {name}, x: [{low}, {high}], crank_from: {u(0, 360)} deg, "
        f"crank_turn: {draw.choice([1, -1]) * u(30, 120)} deg, "
        f"rocker_from: {u(0, 360)} deg, rocker_turn: {draw.choice([1, -1]) * u(20, 100)} deg, frame: {u(0.1, 1)}, "
        f"spacing: {spacing}"
    )


def _dwell(draw):
    u = draw.uniform
    a, first, wide = u(0.03, 0.1), u(0, 360), u(10, 60)
    return (
        f"crank: {a}, coupler: {a * u(1.5, 4)}, rocker: {a * u(1.5, 4)}, frame: {a * u(1.2, 4)}, "
        f"point: [{u(-0.3, 0.3)}, {u(-0.3, 0.3)}], angles: [{first} deg, {first + wide} deg, {first + 2 * wide} deg], "
        f"rocker_joint: {draw.choice(['left', 'right'])}"
    )


def _poses(draw, count):
    u = draw.uniform
    poses = [[u(-0.1, 0.1), u(-0.1, 0.1), u(-0.8, 0.8)] for _ in range(count)]
    return f"positions: {poses}, points: {[[u(-0.1, 0.1), u(-0.1, 0.1)] for _ in range(2)]}"


def _two(draw):
    u = draw.uniform
    sides = [
        f", {key}: {draw.choice(['left', 'right'])}"
        for key in ("crank_pivot", "rocker_pivot")
        if u(0, 1) < 0.4
    ]
    rocker = draw.choice(["", f", rocker: {u(0.02, 0.3)}"])
    return f"{_poses(draw, 2)}, crank: {u(0.03, 0.3)}{rocker}{''.join(sides)}"


def _angles(draw, low, high, least):
    """Two angles of a range, some of them below nought, at least so far apart, deg."""
    first = draw.uniform(low, high - least)
    both = [first, draw.uniform(first + least, high)]
    draw.shuffle(both)
    sign = draw.choice([1, -1])
    return f"[{sign * both[0]} deg, {sign * both[1]} deg]"


def _rocker_positions(draw):
    u = draw.uniform
    transmission = draw.choice(["", f", transmission: {u(10, 50)} deg"])
    if draw.random() < 0.5:
        frame = draw.choice(["", f", frame: {u(0.1, 1)}"])
        return f"rocker: {u(0.1, 1)}, angles: {_angles(draw, 5, 175, 3)}{frame}{transmission}"
    rocker = draw.choice(["", f", rocker: {u(0.1, 1)}"])
    return (
        f"frame: {u(0.1, 1)}, angles: {_angles(draw, 5, 175, 3)}, crank_angles: {_angles(draw, -90, 150, 10)}"
        f"{rocker}{transmission}"
    )


def _slider_positions(draw):
    u, sign = draw.uniform, draw.choice([1, -1])
    places = f"places: [{sign * u(0.1, 0.5)}, {sign * u(0.1, 0.5)}]"
    permitted = draw.choice(["", f", pressure_angle: {u(20, 60)} deg"])
    if draw.random() < 0.5:
        return f"{places}{draw.choice(['', f', offset: {u(0.005, 0.2)}'])}{permitted}"
    offset = draw.choice(["", f", offset: {u(-0.2, 0.2)}"])
    return f"{places}, crank_angles: {_angles(draw, -90, 180, 10)}{offset}{permitted}"


DRAWN = {
    "slider_crank": _slider_crank,
    "crank_rocker": _crank_rocker,
    "slotted_link": lambda draw: _slotted(draw, (0.02, 3), (0.01, 1)),
    "turning_guide": lambda draw: _slotted(draw, (1.01, 6), (0.05, 2)),
    "function": _function,
    "dwell": _dwell,
    "body": lambda draw: _poses(draw, 3),
    "body of two positions": _two,
    "rocker_positions": _rocker_positions,
    "slider_positions": _slider_positions,
}


# ---------------------------------------------------------------- what is refused cannot be


def read(text):
    """Keys of a demand and their numbers, SI."""
    scales = {"": 1.0, "deg": math.pi / 180, "mm": 1e-3, "m": 1.0, "m/s": 1.0, "rpm": math.pi / 30}
    words = {"true": 1.0, "false": 0.0}
    found = {}
    for part in text.split(", "):
        key, value = part.split(": ")
        number, _, unit = value.partition(" ")
        found[key] = words[number] if number in words else float(number) * scales[unit]
    return found


def impossible_slider(stated):
    """Whether no slider-crank of a stated ratio or offset has so great a time ratio: among many of each offset, or with
    the near end of each place."""
    H = stated.get("stroke") or math.pi * stated["mean_speed"] / stated["speed"]
    if "ratio" in stated:
        e = np.linspace(0, stated["ratio"] - 1, 2001)
        near, far = (np.sqrt(np.maximum((stated["ratio"] + one) ** 2 - e**2, 0)) for one in (-1, 1))
    else:
        e = stated["offset"]
        near = H * np.linspace(0, 30, 30001)
        far = near + H
    theta = np.max(np.arctan2(e, near) - np.arctan2(e, far))
    return (np.pi + theta) / (np.pi - theta) < stated["K"]


def impossible_rocker(stated):
    """Whether a crank-rocker of a stated crank or rod, laid out with numbers, cannot go round in one assembly."""
    c, swing = stated["rocker"], stated["swing"]
    theta = math.pi * (stated["K"] - 1) / (stated["K"] + 1)
    ends = [c * cmath.exp(1j * turn * swing / 2) for turn in (-1, 1)]
    chord = abs(ends[1] - ends[0])
    b, a = stated.get("rod"), stated.get("crank")
    # law of cosines at the crank's pivot: chord² = (b+a)² + (b−a)² − 2 (b+a)(b−a) cos θ
    if b is None:
        rest = chord**2 - 2 * a * a * (1 + math.cos(theta))
        if rest <= 0:
            return True
        b = math.sqrt(rest / (2 * (1 - math.cos(theta))))
    else:
        rest = chord**2 - 2 * b * b * (1 - math.cos(theta))
        if rest <= 0:
            return True
        a = math.sqrt(rest / (2 * (1 + math.cos(theta))))
    if a >= b:
        return True
    line = ends[1] - ends[0]
    along = ((b - a) ** 2 - (b + a) ** 2 + chord**2) / (2 * chord)
    off = math.sqrt(max((b - a) ** 2 - along**2, 0))
    pivots = [ends[0] + line / chord * complex(along, side * off) for side in (1, -1)]
    pivot = (max if stated["beyond"] else min)(pivots, key=lambda z: z.real)
    d = abs(pivot)
    short, middle, long = sorted((b, c, d))
    if a >= short or a + long > short + middle:
        return True
    sides = [(end - pivot).conjugate() * -pivot for end in ends]
    return sides[0].imag * sides[1].imag <= 0


CANNOT = {"slider_crank": impossible_slider, "crank_rocker": impossible_rocker}
SIZES = {"slider_crank": ("ratio", "offset"), "crank_rocker": ("crank", "rod")}

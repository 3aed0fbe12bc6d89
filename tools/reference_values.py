"""Exact single numbers of a variant's results beside those at its positions: strokes, gears, planetary trains."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from reference_machines import machines

from tmm_report.chapters.gears.eccentric.solve.mechanism import Found as Eccentric
from tmm_report.chapters.gears.ordinary.solve import Found as Ordinary
from tmm_report.chapters.gears.planetary.solve.stage import Found as Planetary
from tmm_report.chapters.gears.spur.solve.pair import Found as Spur
from tmm_report.chapters.lever.kinematics.solve.strokes import Travel
from tmm_report.course import LeverFound, Results
from tmm_report.mechanics.rivals import exact
from tmm_report.mechanics.rivals.exact import gears
from tmm_report.mechanics.rivals.exact.numbers import Number, context, dot, point
from tmm_report.mechanics.rivals.exact.numbers import exact as number
from tmm_report.mechanics.rivals.exact.scheme import Body

Named = Iterator[tuple[str, Number]]


def values(results: Results) -> Named:
    """Key of a single value of results.json, or "table/column/row", and its exact number in its unit there."""
    if results.lever is not None:
        yield from _strokes(results.lever)
    if results.drive is not None:
        yield from _drive(results.drive)
    if results.eccentric is not None:
        yield from _eccentric(results.eccentric)
    yield from machines(results)


def judged_by(key: str) -> str:
    """Key of the number by which an error is judged: of a difference, of what it is the difference of."""
    for ending in ("_y", "_shortening"):
        if key.endswith(ending):
            return key.removesuffix(ending) + "_x_sum"
    for column in ("/x/", "/y/", "/gap/"):
        if key.startswith("eccentric_") and column in key:
            return key.replace(column, "/l/")
    return key


def _degrees(angle: Number) -> Number:
    return angle * 180 / context().pi


# ---------------------------------------------------------------- strokes


STEP = 1e-9  # rad, of the difference that stands for the derivative of an acceleration


def _strokes(lever: LeverFound) -> Named:
    """Of every output that turns back within a full turn: stroke, ratio of both strokes' times, extreme velocities."""
    for travel in lever.kinematics.travels if lever.kinematics.cycle.closed else ():
        name, ends = (
            travel.output.name,
            [_end(lever, travel, end.turned) for end in (travel.near, travel.far)],
        )
        if any(end is None for end in ends):
            continue
        (low, first), (high, last) = ends  # type: ignore[misc]
        around = 2 * context().pi if travel.output.kind == "rocker" else context().mpf(0)
        stroke = high - low  # of angles, to whole turns
        yield (
            f"H_{name}",
            stroke + around * context().nint((travel.stroke - stroke) / around) if around else stroke,
        )
        if travel.time_ratio is not None:
            turn = 2 * context().pi
            way = abs(last - first)
            yield f"K_{name}", max(way, turn - way) / min(way, turn - way)
        for end, found in zip(("min", "max"), travel.V_extremes, strict=True):
            yield f"V_{name}_{end}", _fastest(lever, travel, found.turned)


def _end(lever: LeverFound, travel: Travel, turned: float) -> tuple[Number, Number] | None:
    """The output's coordinate and the exact angle turned where it turns back; None where it does not move there."""
    cycle = lever.kinematics.cycle
    place, rate, second = _rates(lever, travel, turned)
    if abs(second) < 1e-6 * number(lever.kinematics.omega) ** 2 * abs(number(travel.stroke)):
        return None
    angle = number(turned) - cycle.sense * rate / second * number(lever.kinematics.omega)
    return place - rate * rate / (2 * second), angle


def _fastest(lever: LeverFound, travel: Travel, turned: float) -> Number:
    """The extreme velocity near an angle turned: by the parabola through it."""
    _, v, a = _rates(lever, travel, turned)
    _, _, beside = _rates(lever, travel, turned + STEP)
    jerk = (beside - a) / number(float(turned + STEP) - float(turned)) * abs(number(lever.kinematics.omega))
    return v - a * a / (2 * jerk)


def _rates(lever: LeverFound, travel: Travel, turned: float) -> tuple[Number, Number, Number]:
    """Coordinate, velocity and acceleration of an output at an angle turned, rad."""
    cycle, output = lever.kinematics.cycle, travel.output
    found = exact.at(cycle, float(cycle.phi(np.array(float(turned)))))
    pose = found.poses[0]
    assert pose is not None
    if output.kind == "slider":
        way = point(output.direction)
        x, v, a = (
            dot(found.row(output.name, of)[0], way) for of in (Body.place, Body.velocity, Body.acceleration)
        )
        return x, v, a
    body, sign = pose[output.link], 1 if complex(output.direction).real > 0 else -1
    angle = sign * context().arg(body.u)
    return angle, sign * body.w, sign * body.e


# ---------------------------------------------------------------- gears


def _drive(found: Any) -> Named:
    for k, stage in enumerate(found.stages, 1):
        made = _pair if isinstance(stage, Spur) else _planetary if isinstance(stage, Planetary) else _ordinary
        yield from made(stage, f"stage{k}")
    train, own = found.train, context()
    fixed = {name: 0 for stage in found.stages for name in stage.fixed}
    if not any(stage.second for stage in found.stages):
        speed = gears.speeds(train.members, train.meshes, {found.output: own.mpf(1), **fixed})
        yield "drive_u_teeth", speed[found.input]
        yield "drive_u", speed[found.input]


def _ordinary(found: Ordinary, prefix: str) -> Named:
    n, made = found.s.number, {}
    if found.kind == "belt":
        made = gears.belt(n("d1"), n("d2"), n("a"), found.given.sense < 0)
    elif found.kind == "chain":
        made = gears.chain((round(n("z1")), round(n("z2"))), n("p"), round(n("links")))
    for key, value in made.items():
        yield f"{prefix}_{key}", value


ANGLES = ("alpha_w", "alpha_t", "alpha_a")


def _pair(found: Spur, prefix: str) -> Named:
    given, pair = found.given, found.pair
    if given.internal or given.cutter is not None or found.cut_short or found.loose:
        return
    stated = gears.External(
        found.teeth.z, given.module, given.rack.alpha, given.rack.ha, given.rack.c, given.helix,
        float(pair.a_w), float(pair.x1), given.tip_shortening,
    )  # fmt: skip
    for key, value in gears.pair(stated).items():
        if key in ("m_t", "alpha_t") and not given.helix:
            continue
        if isinstance(value, tuple):
            for wheel, one in enumerate(value):
                yield f"{prefix}_wheels/{key}/{wheel}", _degrees(one) if key in ANGLES else one
        elif key != "two_length" or found.two_zones:
            yield f"{prefix}_{key}", _degrees(value) if key in ANGLES else value
    if given.helix and given.width is not None:
        own = context()
        overlap = number(given.width) * own.sin(number(given.helix)) / (own.pi * number(given.module))
        yield f"{prefix}_eps_beta", overlap


def _planetary(found: Planetary, prefix: str) -> Named:
    own = context()
    first, carrier, last = found.members[0].name, found.members[-1].name, found.members[-2].name
    stopped = gears.speeds(found.members, found.meshes, {carrier: 0, last: own.mpf(1)})
    yield f"{prefix}_u_basic", stopped[first]
    driven = gears.speeds(found.members, found.meshes, {last: 0, carrier: own.mpf(1)})
    yield f"{prefix}_u_carrier", driven[first]
    task = found.given.task
    if not found.meshes[0].internal and not np.any(found.sizes.shifts) and not found.given.helix:
        z, rack, m = (found.members[0].teeth, found.members[1].teeth), task.rack, task.modules[0]
        whole = gears.External(z, m, rack.alpha, rack.ha, rack.c, 0.0, m * sum(z) / 2, 0.0)
        yield f"{prefix}_rows/eps_alpha/0", gears.pair(whole)["eps"]
    sun, satellite = (member.teeth for member in found.members[:2])
    if found.meshes[0].internal or task.distance is not None:
        return
    a_w = number(found.given.task.modules[0]) * (sun + satellite) / 2
    yield f"{prefix}_a_w", a_w
    yield f"{prefix}_apart", 2 * a_w * own.sin(own.pi / found.satellites)


def _eccentric(found: Eccentric) -> Named:
    own, (sun, ring) = context(), (found.sun, found.ring)
    u = own.mpf(ring) / sun
    yield "eccentric_u", -u
    yield "eccentric_u_1H", 1 + u
    yield "eccentric_u_3H", 1 + 1 / u
    m = number(found.given.module)
    yield "eccentric_r_1", m * sun / 2
    yield "eccentric_r_3", m * ring / 2
    e = m * found.E / 2
    yield "eccentric_gap_1_3", m * (ring - sun) / 2 - e - 2 * number(found.given.rack.ha) * m
    centres = [
        _centre(m * (sun + s.teeth) / 2, m * (ring - s.teeth) / 2, e, s.below) for s in found.satellites
    ]
    for k, z in enumerate(centres):
        for key, value in (("x", z.real), ("y", z.imag), ("l", abs(z))):
            yield f"eccentric_satellites/{key}/{k}", value
        for key, arm in (("phi1", z), ("phi3", z - e)):
            yield f"eccentric_satellites/{key}/{k}", _degrees(own.arg(arm)) % 360
    yield from _neighbours(found, centres)
    yield from _speeds(found, u)


def _centre(from_sun: Number, from_ring: Number, e: Number, below: bool) -> Number:
    """Where two circles about the axes cross: a satellite's axis from that of the sun; the ring's lies at x = e."""
    own = context()
    x = (from_sun**2 - from_ring**2 + e**2) / (2 * e)
    square = from_sun**2 - x**2
    y = own.mpf(0) if abs(square) < from_sun**2 * own.eps * 100 else own.sqrt(square)
    return own.mpc(x, -y if below else y)


def _neighbours(found: Eccentric, centres: list[Number]) -> Named:
    """Between the axes and between the tip circles of the satellites side by side."""
    m, ha = number(found.given.module), number(found.given.rack.ha)
    order = [s.wheel for s in found.satellites]
    for k, pair in enumerate(found.near):
        apart = abs(centres[order.index(pair.one.wheel)] - centres[order.index(pair.other.wheel)])
        yield f"eccentric_neighbours/l/{k}", apart
        yield (
            f"eccentric_neighbours/gap/{k}",
            apart - m * (pair.one.teeth + pair.other.teeth) / 2 - 2 * ha * m,
        )


def _speeds(found: Eccentric, u: Number) -> Named:
    """Willis: (ω1 − ω_H)/(ω3 − ω_H) = −u, the satellites against the sun."""
    for k, motion in enumerate(found.motions):
        speed = number(motion.speed[motion.driven])
        of_sun, of_ring, of_axes = {
            "H": (speed, -speed / u, 0 * u),
            "3": (speed, 0 * u, speed / (1 + u)),
            "1": (0 * u, speed, speed * u / (1 + u)),
        }[motion.stopped]
        yield f"eccentric_speeds/omega_1/{k}", of_sun
        yield f"eccentric_speeds/omega_3/{k}", of_ring
        yield f"eccentric_speeds/omega_H/{k}", of_axes
        for s in found.satellites:
            turning = of_axes - (of_sun - of_axes) * found.sun / s.teeth
            yield f"eccentric_speeds/omega_{s.wheel}/{k}", turning

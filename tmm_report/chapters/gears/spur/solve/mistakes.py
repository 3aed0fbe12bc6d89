"""What may be wrong with what a spur stage states: each mistake in a sentence, with what would work."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.gears.spur.solve.conditions import limits
from tmm_report.chapters.gears.spur.solve.motion import WIDEST
from tmm_report.mechanics.gears import meshing, shift_sharing
from tmm_report.mechanics.gears.cutting import tip_half_angle
from tmm_report.mechanics.gears.limits.pair import broken, unknown
from tmm_report.mechanics.gears.rack_mistakes import of_rack
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.given import Given
    from tmm_report.chapters.gears.spur.solve.sizes import Teeth

Array = Any
LEAST_TEETH = 6  # fewer cannot be cut with a usable tooth


def check(given: Given) -> None:
    """Raises ProblemError where the stage contradicts itself before anything is computed."""
    if problems := list(_stated(given)):
        raise ProblemError(problems)


def check_teeth(given: Given, chosen: Teeth) -> None:
    """Raises ProblemError where the distance leaves a wheel too few teeth, or the teeth are against the ratio."""
    if problems := list(_teeth(given, chosen)):
        raise ProblemError(problems)


def check_pair(given: Given, pair: meshing.Pair) -> None:
    """Raises ProblemError where there is no such pair: no such angle, teeth out of reach or overlapping."""
    if problems := list(_pair(given, pair)):
        raise ProblemError(problems)


def _stated(given: Given) -> Iterator[Problem]:
    yield from of_rack(given.rack, ("rack",))
    if given.internal and given.by_teeth and given.ratio == 1:
        right = Message(N_("give the ring more teeth than the pinion"))
        yield mistake(N_("a ring cannot have as many teeth as its pinion"), ("teeth",), right)
    elif given.internal and math.isclose(given.ratio, 1.0):
        right = Message(
            N_("the ratio of an internal pair must differ from 1: 2, or 0.5; −1 makes the pair external")
        )
        yield mistake(N_("a ring cannot have as many teeth as its pinion"), ("ratio",), right)
    if given.centre_distance is None and given.teeth is None:
        right = Message(N_("state centre_distance: 130 mm or teeth: [14, 28]"))
        yield mistake(N_("neither the centre distance nor the teeth are stated"), (), right)
    if given.rests and given.centre_distance is None:
        right = Message(N_("state centre_distance: 130 mm, or both shifts"))
        yield mistake(N_("without a centre distance no shift is left over"), ("shift", given.rests[0]), right)
    elif len(given.rests) == 2:
        right = Message(N_("one of both, for example [0.42, rest], or shift: rule"))
        yield mistake(N_("only one shift can be the rest"), ("shift",), right)
    if given.cutter:
        yield from _of_cutter(given, given.cutter)


def _of_cutter(given: Given, cutter: meshing.Cutter) -> Iterator[Problem]:
    """A shift of the cutter itself with which its teeth come to a point, or its tips lie inside its base circle."""
    rack, turn = given.rack.transverse(given.helix), math.cos(given.helix)
    if tip_half_angle(cutter.z, cutter.x * turn, rack) > 0:
        return
    wrong = N_("a cutter of %(z0)s teeth made with the shift %(x0)s has no sound teeth")
    trial = np.arange(-500, 501) / 100
    sound = trial[tip_half_angle(cutter.z, trial * turn, rack) > 0]
    right = Message(N_("a cutter of more teeth"))
    if sound.size:
        limits = {"low": _text(sound[0]), "high": _text(sound[-1])}
        right = Message(N_("with so many teeth, a shift of the cutter from %(low)s to %(high)s"), limits)
    yield mistake(wrong, ("cutter", "x0"), right, z0=cutter.z, x0=_text(cutter.x))


def _teeth(given: Given, chosen: Teeth) -> Iterator[Problem]:
    small = min(chosen.z)
    if small < LEAST_TEETH:
        yield _too_few(given, small)
    if given.teeth is not None:
        yield from _against_ratio(given)
    if given.internal and given.cutter and given.cutter.z >= max(chosen.z):
        right = Message(N_("fewer than %(ring)s teeth"), {"ring": max(chosen.z)})
        wrong = N_("a cutter of %(z0)s teeth does not fit into a ring of %(ring)s")
        yield mistake(wrong, ("cutter", "z0"), right, z0=given.cutter.z, ring=max(chosen.z))


def _too_few(given: Given, small: int) -> Problem:
    if given.teeth is not None:
        right = Message(N_("a wheel has %(least)s teeth or more"), {"least": LEAST_TEETH})
        return mistake(N_("a wheel of %(z)s teeth cannot be cut"), ("teeth",), right, z=small)
    large = max(abs(given.ratio), 1 / abs(given.ratio))
    sum_ = LEAST_TEETH * (large - 1 if given.internal else large + 1)
    assert given.centre_distance is not None  # the teeth were found from it
    values = {
        "distance": _mm(sum_ * given.module / (2 * math.cos(given.helix)), up=True),
        "module": _mm(2 * given.centre_distance * math.cos(given.helix) / sum_, up=False),
    }
    right = Message(N_("a centre distance from %(distance)s mm or a module up to %(module)s mm"), values)
    wrong = N_(
        "the centre distance of %(distance)s mm leaves the smaller wheel %(z)s teeth, and 6 are the least"
    )
    return mistake(wrong, ("centre_distance",), right, distance=_mm(given.centre_distance), z=max(small, 0))


def _against_ratio(given: Given) -> Iterator[Problem]:
    z1, z2 = given.teeth or (0, 0)
    if given.internal and z1 == z2:
        right = Message(N_("give the ring more teeth than the pinion"))
        yield mistake(N_("a ring cannot have as many teeth as its pinion"), ("teeth",), right)
    elif abs(z2 / z1 / abs(given.ratio) - 1) > 0.5:
        values = {"ratio": _text(math.copysign(z2 / z1, given.ratio))}
        right = Message(N_("write ratio: %(ratio)s, or other teeth"), values)
        wrong = N_("%(z1)s and %(z2)s teeth do not give the ratio %(wanted)s")
        yield mistake(wrong, ("teeth",), right, z1=z1, z2=z2, wanted=_text(given.ratio))


def _pair(given: Given, pair: meshing.Pair) -> Iterator[Problem]:
    if not np.isfinite(pair.alpha_w):
        yield _apart(given, pair)
    elif not np.isfinite(pair.x1):
        right = Message(N_("shift: rule, shift: limit, or two shifts"))
        yield mistake(N_("no division of the shifts makes the sliding equal"), ("shift",), right)
    elif pair.backlash < -1e-6 * pair.m:
        yield _overlapping(given, pair)
    elif problems := list(_stated_tips(given, pair)):
        yield from problems
    else:
        yield from _beyond(given, pair)


def _stated_tips(given: Given, pair: meshing.Pair) -> Iterator[Problem]:
    """Stated tip diameters that leave no teeth, or no clearance at the roots of the other wheel."""
    for i, d in enumerate(given.tip_diameters or ()):
        root, mate = float(pair.d_f[i]), float(pair.d_f[1 - i])
        if pair.signs[i] < 0:
            low, high = max(float(pair.d_b[i]), 2 * float(pair.a_w) + mate), root
        else:
            low, high = root, mate - 2 * float(pair.a_w) if pair.internal else 2 * float(pair.a_w) - mate
        if low < d <= high * (1 + 1e-9):
            continue
        wrong = N_(
            "tips of wheel %(wheel)s of %(diameter)s mm leave no teeth, or no clearance at the roots of its mate"
        )
        right = Message(
            N_("a diameter from %(low)s to %(high)s mm"),
            {"low": _mm(low, up=True), "high": _mm(high, up=False)},
        )
        yield mistake(wrong, ("tip_diameters", i), right, wheel=given.wheels[i], diameter=_mm(d))


def _beyond(given: Given, pair: meshing.Pair) -> Iterator[Problem]:
    """The limits of the list beyond which there are no such wheels; what was not asked for is not complained of."""
    hard = tuple(limit for limit in limits(pair, WIDEST) if limit.hard)
    over = [(limit.kind, limit.wheel) for limit in broken(hard, pair)]
    told = [kind for kind in TOLD if kind in {kind for kind, _ in over}]
    apart = not pair.eps_tips > 0 or {kind for kind, _ in over} & {"height", "root", "thickness"}
    if over and (not told or (apart and told[0] not in ("cut", "tips"))):
        yield _no_contact(given, pair)
    elif told:
        yield from (TOLD[kind](given, pair, wheel - 1) for kind, wheel in over if kind == told[0])


def _ring_uncut(given: Given, pair: meshing.Pair, i: int) -> Problem:
    """A stated cutter and a ring that leave no distance of the axes in cutting."""
    wrong = N_(
        "with the shift %(x)s ring %(wheel)s cannot be cut by a cutter of %(z0)s teeth with the shift %(x0)s"
    )
    right = Message(N_("a greater shift of the ring, a lesser one of the cutter, or a cutter of fewer teeth"))
    cutter = pair.cutter
    assert cutter is not None
    values = {"x": _shift(pair, i), "wheel": given.wheels[i], "z0": cutter.z, "x0": _text(cutter.x)}
    return mistake(wrong, ("cutter",), right, **values)


def _closed(given: Given, pair: meshing.Pair, i: int) -> Problem:
    right = Message(N_("a lesser shift of the ring, or of both wheels"))
    wrong = N_("with the shift %(x)s the spaces of ring %(wheel)s come to a point above their root circle")
    return mistake(wrong, ("shift",), right, x=_shift(pair, i), wheel=given.wheels[i])


def _uncut(given: Given, pair: meshing.Pair, i: int) -> Problem:
    """A wheel of which cutting leaves no involute."""
    values = {"x": _shift(pair, i), "wheel": given.wheels[i]}
    if math.isinf(pair.starts[i]) or (pair.signs[i] > 0 and pair.rho_l[i] < 0):
        least = {"least": f"{math.ceil(1e3 * pair.x_min[i]) / 1e3:g}"}
        wrong = N_("with the shift %(x)s wheel %(wheel)s is undercut up to its tip circle")
        return mistake(wrong, ("shift",), Message(N_("a shift of %(least)s or more"), least), **values)
    right = Message(N_("shifts between −0.5 and 1.5, or shift: rule"))
    wrong = N_("with the shift %(x)s no involute is left on the teeth of wheel %(wheel)s")
    return mistake(wrong, ("shift",), right, **values)


def _shift(pair: meshing.Pair, i: int) -> str:
    return _text(float((pair.x1, pair.x2)[i]))


def _apart(given: Given, pair: meshing.Pair) -> Problem:
    if given.centre_distance is None:
        return mistake(
            N_("with these shifts the wheels cannot be brought into mesh"),
            ("shift",),
            Message(N_("a greater sum of the shifts, for example shift: [0, 0]")),
        )
    values = {"least": _mm(pair.a * math.cos(pair.t.alpha), up=True), "plain": _mm(pair.a)}
    right = Message(N_("more than %(least)s mm; without shifts it is %(plain)s mm"), values)
    wrong = N_("at a centre distance of %(distance)s mm the base circles of the wheels overlap")
    if pair.internal:
        wrong = N_("at a centre distance of %(distance)s mm the pinion does not reach the ring's involutes")
    return mistake(wrong, ("centre_distance",), right, distance=_mm(given.centre_distance))


def _overlapping(given: Given, pair: meshing.Pair) -> Problem:
    settings = (pair.z1, pair.z2, pair.m, pair.rack, pair.beta)
    needed = float(meshing.shift_sum(*settings, pair.a_w, pair.internal))
    free = float(meshing.meshed(*settings, pair.x1, pair.x2, pair.internal).a_w)
    text = (
        N_("a difference of the shifts of %(sum)s, or a centre distance of %(distance)s mm")
        if pair.internal
        else N_("x1 + x2 = %(sum)s, or a centre distance of %(distance)s mm")
    )
    if not math.isfinite(free):  # no distance is free of backlash with such shifts
        text, free = N_("the shifts must make up %(sum)s: shift: rule does it"), 0.0
    right = Message(text, {"sum": _text(needed), "distance": _mm(free, up=not pair.internal)})
    wrong = N_(
        "with the shifts %(x1)s and %(x2)s the teeth overlap by %(overlap)s mm on the working pitch circles"
    )
    overlap = {
        "overlap": _mm(-float(pair.backlash)),
        "x1": _text(float(pair.x1)),
        "x2": _text(float(pair.x2)),
    }
    return mistake(wrong, ("shift",), right, **overlap)


def _tips_inside(given: Given, pair: meshing.Pair, i: int) -> Problem:
    """A ring whose tips lie under its base circle, where it has no involute."""
    least = pair.t.ha - (pair.z1, pair.z2)[i] * (1 - math.cos(pair.t.alpha)) / 2
    values = {"least": f"{math.ceil(1e3 * least / math.cos(pair.beta)) / 1e3:g}"}
    right = Message(N_("a shift of the ring of %(least)s or more, or more teeth"), values)
    wrong = N_("the tips of ring %(wheel)s lie inside its base circle")
    return mistake(wrong, ("shift",), right, wheel=given.wheels[i])


def _no_contact(given: Given, pair: meshing.Pair) -> Problem:
    """The pair exists only on paper; what distances would do is tried out."""
    wrong = N_("with the shifts %(x1)s and %(x2)s the teeth do not reach each other")
    if pair.eps_tips > 0:  # by the tip circles they would
        wrong = N_("with the shifts %(x1)s and %(x2)s cutting leaves no involutes that meet each other")
    if given.tip_diameters is not None:
        wrong = N_("with these tip diameters the teeth do not reach each other")
        right = Message(N_("leave out tip_diameters: those that follow from the shifts are then told"))
        return mistake(wrong, ("tip_diameters",), right)
    shown = {"x1": _text(float(pair.x1)), "x2": _text(float(pair.x2))}
    if given.centre_distance is None:
        return mistake(wrong, ("shift",), Message(N_("shifts between −0.5 and 1.5, or shift: rule")), **shown)
    trial = np.linspace(0.97, 1.15, 721) * float(pair.a)
    needed = meshing.shift_sum(pair.z1, pair.z2, pair.m, pair.rack, pair.beta, trial, pair.internal)
    blank = meshing.Pair(
        pair.z1, pair.z2, pair.m, pair.rack, pair.beta, 0.0, 0.0, trial, pair.internal, pair.shortened,
        pair.trimmed, pair.cutter,
    )  # fmt: skip
    small = int(pair.z2 < pair.z1)
    x = float(shift_sharing.rule_shift((pair.z1, pair.z2)[small], pair.rack, pair.beta))
    filled = shift_sharing.filling(blank, small, x, needed)
    with unknown():
        made = np.all(
            [limit.margin(filled) + 0 * trial >= 0 for limit in limits(filled, WIDEST) if limit.hard], axis=0
        )
    good = trial[made & (filled.eps >= 1) & (filled.s_a[0] >= 0) & (filled.s_a[1] >= 0)]
    if not good.size:
        return mistake(wrong, ("centre_distance",), Message(N_("other numbers of teeth")), **shown)
    values = {"low": _mm(good[0], up=True), "high": _mm(good[-1], up=False)}
    right = Message(N_("with these teeth, a centre distance from %(low)s to %(high)s mm"), values)
    return mistake(wrong, ("centre_distance",), right, **shown)


# What is said of a limit beyond which there are no wheels, the first that applies; of others that they do not meet.
TOLD: dict[str, Callable[[Given, meshing.Pair, int], Problem]] = {
    "cut": _ring_uncut, "tips": _tips_inside, "space": _closed, "involute": _uncut,
}  # fmt: skip


def _mm(length: float | None, up: bool | None = None) -> str:
    """A length in mm for a sentence; `up`: rounded away from what does not work."""
    mm = 1e3 * float(length or 0.0)
    if up is not None:
        mm = (math.ceil if up else math.floor)(mm * 100) / 100
    return _text(mm)


def _text(number: float) -> str:
    """Five digits; what is rounding beside a shift or a millimetre is 0."""
    return f"{number if abs(number) > 1e-9 else 0.0:.5g}"

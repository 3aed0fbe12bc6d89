"""Kinematics and forces of the compressor: the general solver against numpy written by hand for it alone.

    python -m benchmarks.speed.compressor_36 [--store]

The general solver is run as it is, as straight lines of numpy compiled once from it, and by these lines in blocks.

Both find the same things from the same numbers, asserted equal to 1e-12 of the largest value: places, velocities
and accelerations of all joints and mass centres, angular rates, inertia forces, reactions in all pairs, balancing
moment. Times are medians of interleaved runs; they are printed, never asserted.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from benchmarks.measuring import stored
from benchmarks.measuring.timing import interleaved
from tmm_report.mechanics.lever import assur_groups, motion
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.many.blocks import BLOCK, blocks
from tmm_report.mechanics.lever.many.compiled import straight
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide

Array = Any
POINTS = ("A", "B", "C", "D", "S2", "S4")
POSITIONS = 36
VARIANTS = 1000


@dataclass(frozen=True)
class Compressor:
    """The coursework's compressor, SI. A length may be an array (V, 1): V variants at once."""

    r: Array = 0.1  # OA
    l2: Array = 0.3  # AB
    c: Array = 0.075  # AC
    s2: Array = 0.15  # AS2
    l4: Array = 0.31  # CD
    s4: Array = 0.155  # CS4
    m2: float = 1.5
    m3: float = 0.6
    m4: float = 1.55
    m5: float = 0.6
    J2: float = 0.0135
    J4: float = 0.015
    omega: float = -2 * np.pi / 0.05
    gravity: complex = -9.81j


def moved_by_hand(k: Compressor, phi: Array) -> dict[str, Array]:
    """Kinematics: B and D slide on the x axis through O, B to the right of A, D to the left of C; (..., P), SI."""
    iw1 = 1j * k.omega
    A = k.r * np.exp(1j * phi)
    v_A, a_A = iw1 * A, (iw1 * iw1) * A

    y = A.imag  # AB = x − iy, v_B and a_B are along x; the other points of AB follow by similarity
    x = np.sqrt(k.l2 * k.l2 - y * y)
    w2 = -v_A.imag / x
    ww2 = w2 * w2
    e2 = -(a_A.imag + ww2 * y) / x
    B, v_B, a_B = A.real + x, v_A.real + w2 * y, a_A.real + e2 * y - ww2 * x
    AB, v_AB, a_AB = B - A, v_B - v_A, a_B - a_A
    to_C, to_S2 = k.c / k.l2, k.s2 / k.l2
    AC, AS2 = AB * to_C, AB * to_S2
    C, v_C, a_C = A + AC, v_A + v_AB * to_C, a_A + a_AB * to_C
    S2, v_S2, a_S2 = A + AS2, v_A + v_AB * to_S2, a_A + a_AB * to_S2

    y = C.imag
    x = -np.sqrt(k.l4 * k.l4 - y * y)
    w4 = -v_C.imag / x
    ww4 = w4 * w4
    e4 = -(a_C.imag + ww4 * y) / x
    D, v_D, a_D = C.real + x, v_C.real + w4 * y, a_C.real + e4 * y - ww4 * x
    CD, to_S4 = D - C, k.s4 / k.l4
    CS4 = CD * to_S4
    S4, v_S4, a_S4 = C + CS4, v_C + (v_D - v_C) * to_S4, a_C + (a_D - a_C) * to_S4

    return {
        "A": A, "B": B, "C": C, "D": D, "S2": S2, "S4": S4, "AB": AB, "AC": AC, "AS2": AS2, "CD": CD, "CS4": CS4,
        "v_A": v_A, "v_B": v_B, "v_C": v_C, "v_D": v_D, "v_S2": v_S2, "v_S4": v_S4,
        "a_A": a_A, "a_B": a_B, "a_C": a_C, "a_D": a_D, "a_S2": a_S2, "a_S4": a_S4,
        "w_2": w2, "e_2": e2, "w_4": w4, "e_4": e4,
    }  # fmt: skip


def by_hand(k: Compressor, phi: Array, gas_b: Array, gas_d: Array) -> dict[str, Array]:
    """Kinematics and forces; (..., P), SI."""
    found = moved_by_hand(k, phi)
    A, AB, AC, AS2, CD, CS4 = (found[name] for name in ("A", "AB", "AC", "AS2", "CD", "CS4"))
    a_S2, a_B, a_S4, a_D, e2, e4 = (found[name] for name in ("a_S2", "a_B", "a_S4", "a_D", "e_2", "e_4"))

    F2, F3 = k.m2 * (k.gravity - a_S2), k.m3 * (k.gravity - a_B) - gas_b
    F4, F5 = k.m4 * (k.gravity - a_S4), k.m5 * (k.gravity - a_D) + gas_d
    M2, M4 = -k.J2 * e2, -k.J4 * e4

    total = F4 + F5  # moments about C: links 4 and 5 with the guide's force i·y at D
    y = -(M4 + (CS4.conj() * F4 + CD.conj() * F5).imag) / CD.real
    R05 = 1j * y
    R24, R45 = -total - R05, -F5 - R05

    total = F2 + F3 - R24
    moment = M2 + (AS2.conj() * F2 - AC.conj() * R24 + AB.conj() * F3).imag
    R03 = -1j * (moment / AB.real)
    R12, R23 = -total - R03, -F3 - R03
    balancing = (A.conj() * R12).imag
    return found | {
        "0-1": R12, "1-2": R12, "2-3": R23, "0-3": R03, "2-4": R24, "4-5": R45, "0-5": R05,
        "balancing": balancing,
    }  # fmt: skip


def by_hand_in_blocks(k: Compressor, phi: Array, gas_b: Array, gas_d: Array) -> float:
    """The greatest balancing moment of a stack, found a block of variants at a time."""
    lengths = [item.name for item in fields(k) if np.ndim(getattr(k, item.name))]
    size = BLOCK // phi.size
    found = (
        by_hand(
            replace(k, **{name: getattr(k, name)[first : first + size] for name in lengths}),
            phi,
            gas_b,
            gas_d,
        )
        for first in range(0, len(k.r), size)
    )
    return max(float(np.max(np.abs(values["balancing"]))) for values in found)


def linkage(k: Compressor) -> motion.Linkage:
    """The same compressor as the general solver takes it."""
    links = [
        Link("0", {"O": 0j}),
        Link("1", {"O": 0j, "A": k.r + 0j}),
        Link("2", {"A": 0j, "B": k.l2 + 0j, "C": k.c + 0j, "S2": k.s2 + 0j}, k.m2, "S2", k.J2),
        Link("3", {"B": 0j}, k.m3, "B"),
        Link("4", {"C": 0j, "D": k.l4 + 0j, "S4": k.s4 + 0j}, k.m4, "S4", k.J4),
        Link("5", {"D": 0j}, k.m5, "D"),
    ]
    slides = [Slide("3", "x", 0j, 1 + 0j), Slide("5", "x", 0j, 1 + 0j)]
    guides = {"x": Guide("x", "0", 0j, 1 + 0j)}
    mechanism = Mechanism({link.name: link for link in links}, Driver("1", k.omega), guides, slides)
    return motion.linkage_of(assur_groups.decompose(mechanism), [1, -1])


def by_groups(scheme: motion.Linkage, gravity: complex, phi: Array, gas_b: Array, gas_d: Array) -> tuple:
    """Motion and forces by the general solver, every named point asked for."""
    return with_forces(motion.solve(scheme, phi), gravity, gas_b, gas_d)


def in_blocks(scheme: motion.Linkage, gravity: complex, phi: Array, gas_b: Array, gas_d: Array) -> float:
    """The greatest balancing moment, found a block of variants at a time."""
    found = (with_forces(part, gravity, gas_b, gas_d)[1] for _, part in blocks(scheme, phi))
    return max(float(np.max(np.abs(forces.balancing))) for forces in found)


def with_forces(found: motion.Motion, gravity: complex, gas_b: Array, gas_d: Array) -> tuple:
    loads = statics.inertia_and_gravity(found, gravity)
    loads["3"] = statics.Load(loads["3"].force - gas_b, loads["3"].moment)
    loads["5"] = statics.Load(loads["5"].force + gas_d, loads["5"].moment)
    forces = statics.solve(found, loads)
    at_all_points(found)
    return found, forces


def at_all_points(found: motion.Motion) -> None:
    for point in POINTS:
        found.place(point), found.velocity(point), found.acceleration(point)


def named(found: motion.Motion, forces: statics.Statics) -> dict[str, Array]:
    """The general solver's results under the keys of `by_hand`."""
    values: dict[str, Array] = {"balancing": forces.balancing}
    for point in POINTS:
        values[point] = found.place(point)
        values[f"v_{point}"], values[f"a_{point}"] = found.velocity(point), found.acceleration(point)
    for link in ("2", "4"):
        values[f"w_{link}"] = found.angular_velocity(link)
        values[f"e_{link}"] = found.angular_acceleration(link)
    return values | {key: reaction.force for key, reaction in forces.reactions.items()}


def disagreement(one: dict[str, Array], other: dict[str, Array]) -> float:
    """Largest difference of any result, relative to that result's largest value."""
    assert one.keys() >= other.keys()
    return max(float(np.max(np.abs(one[key] - other[key])) / np.max(np.abs(other[key]))) for key in other)


def gas() -> tuple[Array, Array]:
    """Gas forces on B (to the left) and D (to the right) at the 36 positions, N, from the 12 of the assignment."""
    on_b = [2000, 1000, 0, 0, 0, 0, 0, 500, 1000, 1500, 2000, 2000]
    on_d = [0, 500, 1000, 1500, 2000, 2000, 2000, 1000, 0, 0, 0, 0]
    at = np.arange(POSITIONS) * 12 / POSITIONS
    return np.interp(at, np.arange(12), on_b, period=12), np.interp(at, np.arange(12), on_d, period=12)


def compare(title: str, k: Compressor, rounds: int) -> dict[str, float]:
    """Ratios of the general solver's ways to the hand-written one, printed."""
    phi, scheme = -np.arange(POSITIONS) * (2 * np.pi / POSITIONS), linkage(k)
    lines, arguments = straight(scheme), (phi, *gas())
    worst = disagreement(by_hand(k, *arguments), named(*by_groups(scheme, k.gravity, *arguments)))
    assert worst < 1e-12, worst
    rivals: dict[tuple[str, str], Callable[[], object]] = {
        ("kinematics alone", "by hand"): lambda: moved_by_hand(k, phi),
        ("kinematics alone", "general"): lambda: at_all_points(motion.solve(scheme, phi)),
        ("kinematics alone", "compiled"): lambda: at_all_points(motion.solve(lines, phi)),
        ("all", "by hand"): lambda: by_hand(k, *arguments),
        ("all", "general"): lambda: by_groups(scheme, k.gravity, *arguments),
        ("all", "compiled"): lambda: by_groups(lines, k.gravity, *arguments),
    }
    if np.ndim(k.r):
        rivals["all, in blocks", "by hand"] = lambda: by_hand_in_blocks(k, *arguments)
        rivals["all, in blocks", "compiled"] = lambda: in_blocks(lines, k.gravity, *arguments)
    taken = interleaved(rivals, rounds)
    print(f"{title}: {1e3 * taken['all', 'by hand']:.3f} ms by hand; difference {worst:.1e}")
    return {
        f"{title}, {what}, {way} : by hand": seconds / taken[what, "by hand"]
        for (what, way), seconds in taken.items()
        if way != "by hand"
    }


def stack(size: int) -> Compressor:
    """Variants with lengths within ±10 % of the compressor's."""
    vary = np.random.default_rng(1).uniform(0.9, 1.1, (6, size, 1))
    base = Compressor()
    lengths = ("r", "l2", "c", "s2", "l4", "s4")
    return Compressor(**{name: getattr(base, name) * by for name, by in zip(lengths, vary, strict=True)})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    stored.add_option(parser)
    options = parser.parse_args()
    figures = compare("36 positions", Compressor(), rounds=3000)
    figures |= compare(f"{VARIANTS} variants", stack(VARIANTS), rounds=30)
    stored.report("compressor_36", figures, options.store)


if __name__ == "__main__":
    main()

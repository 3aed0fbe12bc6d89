"""Speed against accuracy: a slider-crank's motion by several methods, against 40 digits of mpmath.

    python benchmarks/methods.py -o DIR      writes methods.png and methods.svg, prints the tables

The first slider-crank of the compressor, r = 100 mm, l = 300 mm; x, v and a of the slider per radian of the crank.
The error of a method is the largest over the positions, relative to the reference's largest value.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq
from timing import interleaved

from tmm_report.mechanics import motion, structure
from tmm_report.mechanics.mechanism import Driver, Guide, Link, Mechanism, Slide

Array = Any
Method = Callable[[Array, float, float], Array]  # phi, r, l -> rows x, x', x''

TABLES = (12, 36, 100)
ROUNDS = 100


# ---------------------------------------------------------------- methods


def groups(phi: Array, r: float, l: float) -> Array:
    """The program's own way: the dyad in closed form."""
    found = motion.solve(linkage(r, l), phi)
    return np.array([found.place("B").real, found.velocity("B").real, found.acceleration("B").real])


@cache
def linkage(r: float, l: float) -> motion.Linkage:
    """Described once a mechanism, outside the timed calls."""
    points = {"0": {"O": 0j}, "1": {"O": 0j, "A": r + 0j}, "2": {"A": 0j, "B": l + 0j}, "3": {"B": 0j}}
    slides, guides = [Slide("3", "x", 0j, 1 + 0j)], {"x": Guide("x", "0", 0j, 1 + 0j)}
    links = {name: Link(name, places) for name, places in points.items()}
    mechanism = Mechanism(links, Driver("1", 1.0), guides, slides)
    return motion.linkage_of(structure.decompose(mechanism), [1])


def by_hand(phi: Array, r: float, l: float) -> Array:
    """The textbook's formulas for this one mechanism."""
    s, c = r * np.sin(phi), r * np.cos(phi)
    root = np.sqrt(l * l - s * s)
    w = -c / root
    e = (s - s * w * w) / root  # −s = l·sin β, differentiated twice
    return np.array([c + root, -s + s * w, -c + s * e - root * w * w])


def newton(phi: Array, r: float, l: float) -> Array:
    """Newton on the loop r·e^iφ + l·e^iβ = x for β and x, every position at once from β = 0; rates by its Jacobian."""
    A, beta, x = r * np.exp(1j * phi), np.zeros(phi.shape), np.full(phi.shape, l)
    for _ in range(50):
        step_beta, step_x = _loop_step(A + l * np.exp(1j * beta) - x, beta, l)
        beta, x = beta + step_beta, x + step_x
        if np.max(np.abs(step_beta)) < 1e-14:
            break
    return _rates(A, beta, x, l)


def root_finder(phi: Array, r: float, l: float) -> Array:
    """scipy's brentq on l·sin β = −r·sin φ, one position after another; rates by the Jacobian."""
    sines = r * np.sin(phi)
    beta = np.array(
        [brentq(lambda b, s=s: l * np.sin(b) + s, -np.pi / 2, np.pi / 2, xtol=1e-15) for s in sines]
    )
    A = r * np.exp(1j * phi)
    return _rates(A, beta, A.real + l * np.cos(beta), l)


def _loop_step(miss: Array, beta: Array, l: float) -> tuple[Array, Array]:
    """Solve miss + i·l·e^iβ·dβ − dx = 0."""
    turned = 1j * l * np.exp(1j * beta)
    d_beta = -miss.imag / turned.imag
    return d_beta, miss.real + turned.real * d_beta


def _rates(A: Array, beta: Array, x: Array, l: float) -> Array:
    """x, x', x'' by φ, from the loop's own linear equations."""
    w, v = _loop_step(1j * A, beta, l)
    _, a = _loop_step(-A - l * w * w * np.exp(1j * beta), beta, l)
    return np.array([x, v, a])


def differences(phi: Array, r: float, l: float) -> Array:
    """Central differences, second order, of the table of positions."""
    x, step = _table(phi, r, l), 2 * np.pi / phi.size
    ahead, behind = np.roll(x, -1), np.roll(x, 1)
    return np.array([x, (ahead - behind) / (2 * step), (ahead - 2 * x + behind) / step**2])


def spline(phi: Array, r: float, l: float) -> Array:
    """A periodic cubic spline through the table of positions."""
    x = _table(phi, r, l)
    smooth = CubicSpline(np.append(phi, phi[0] + 2 * np.pi), np.append(x, x[0]), bc_type="periodic")
    return np.array([x, smooth(phi, 1), smooth(phi, 2)])


def _table(phi: Array, r: float, l: float) -> Array:
    return r * np.cos(phi) + np.sqrt(l * l - (r * np.sin(phi)) ** 2)


EXACT: dict[str, Method] = {"groups": groups, "by hand": by_hand, "Newton": newton, "brentq": root_finder}
NUMERICAL: dict[str, Method] = {"differences": differences, "spline": spline}


# ---------------------------------------------------------------- reference and errors


def reference(phi: Array, r: float, l: float) -> Array:
    """x, x', x'' at the same binary angles and lengths in 40 digits, then rounded."""
    try:
        from mpmath import cos, mp, mpf, sin, sqrt
    except ImportError:
        raise SystemExit("this benchmark needs mpmath: python -m pip install mpmath") from None
    mp.dps = 40
    rows = []
    for angle in phi:
        s, c = sin(mpf(float(angle))), cos(mpf(float(angle)))
        root = sqrt(mpf(l) ** 2 - (mpf(r) * s) ** 2)
        v = -mpf(r) * s - mpf(r) ** 2 * s * c / root
        a = -mpf(r) * c - mpf(r) ** 2 * (c * c - s * s) / root - mpf(r) ** 4 * (s * c) ** 2 / root**3
        rows.append([mpf(r) * c + root, v, a])
    return np.array(rows, dtype=float).T


def errors(method: Method, count: int, r: float, l: float) -> Array:
    """Largest relative errors of x, v, a over `count` positions of a turn."""
    phi = np.arange(count) * (2 * np.pi / count)
    exact = reference(phi, r, l)
    with np.errstate(all="ignore"):
        return np.max(np.abs(method(phi, r, l) - exact), axis=1) / np.max(np.abs(exact), axis=1)


# ---------------------------------------------------------------- tables and chart


def measure(r: float, l: float) -> list[tuple[str, int, float, Array]]:
    """Method, positions, seconds, errors of x, v, a."""
    found = []
    for count in TABLES:
        phi = np.arange(count) * (2 * np.pi / count)
        methods = EXACT | NUMERICAL
        taken = interleaved({name: lambda m=m: m(phi, r, l) for name, m in methods.items()}, ROUNDS)  # noqa: B023
        found += [(name, count, taken[name], errors(m, count, r, l)) for name, m in methods.items()]
    return found


def draw(found: list[tuple[str, int, float, Array]], folder: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams |= {"svg.hashsalt": "methods", "font.size": 9}
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 4.6), layout="constrained")
    for name, marker in zip(EXACT | NUMERICAL, "opsD^v", strict=True):
        rows = [(seconds, max(error[1:])) for other, _, seconds, error in found if other == name]
        times, worst = np.array(rows).T
        axes.loglog(1e6 * times, worst, marker + "-", label=name)
        lift = -11 if name == "groups" else 5  # its points lie among Newton's
        for k in (0, -1):
            place = {"textcoords": "offset points", "fontsize": 7, "ha": "center"}
            axes.annotate(str(TABLES[k]), (1e6 * times[k], worst[k]), (0, lift), **place)
    axes.set_xlabel("time for the whole table, µs")
    axes.set_ylabel("largest relative error of v and a")
    axes.set_title(
        "Slider-crank, r/l = 1/3: speed against accuracy (12 to 100 positions in a turn)", fontsize=9
    )
    axes.grid(True, which="major", linewidth=0.4)
    axes.legend(loc="center right")
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / "methods.png", dpi=150)
    figure.savefig(folder / "methods.svg", metadata={"Date": None})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument(
        "-o", dest="folder", type=Path, required=True, help="folder for methods.png and methods.svg"
    )
    folder = parser.parse_args().folder
    found = measure(0.1, 0.3)
    print("r/l = 1/3      positions   time, us   error of x        v         a")
    for name, count, seconds, (x, v, a) in found:
        print(f"{name:<16}{count:8}{1e6 * seconds:11.1f}{x:13.1e}{v:10.1e}{a:10.1e}")
    print("\nnear-singular, 100 positions: largest error of x, v, a")
    for ratio in (0.95, 0.999):
        for name, method in (EXACT | NUMERICAL).items():
            x, v, a = errors(method, 100, ratio * 0.3, 0.3)
            print(f"r/l = {ratio:<8}{name:<14}{x:10.1e}{v:10.1e}{a:10.1e}")
    draw(found, folder)


if __name__ == "__main__":
    main()

"""Schemes of the drawn mechanisms: the numbers that a variant's file states, as constraints and as the file itself.

    RRR   class III: ternary link 3 (B, C, D) on rods to the crank and to two fixed points
    SRR   link 3 slides on a block pinned to the crank
    SGR   the block holds the pin beside the guide, and C is on a block of a fixed guide
    IV    class IV: ternary links 2 (A, B, C) and 5 (F, D, E) joined by two rods
    IVS   one of the rods is a block on a guide of link 2
    DRRR  a dyad (rods AP, GP) first; the first leg of RRR hangs on a point H of its rocker
    RRRD  a dyad (rods TR, KR) behind RRR, T a point of link 3

Places are complex numbers, m; keys that begin with "angle" are radians. Unknowns: φ first.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from benchmarks.random_groups.equations import Equations

Array = Any
Numbers = Mapping[str, Array]
RODS = {  # lengths of which one is altered to come near a tangency
    "RRR": ("AB", "EC", "FD"), "SRR": ("EC", "FD"), "SGR": ("FD",), "IV": ("BD", "CE"), "IVS": ("CE",),
    "DRRR": ("HB", "EC", "FD"), "RRRD": ("AB", "EC", "FD"),
}  # fmt: skip
DYAD_ROOTS = ("left", "right")


def size_of(numbers: Numbers) -> Array:
    """A power of two near the greatest length or place, (L,): parts of it are exact."""
    places = [np.abs(v) for k, v in numbers.items() if not k.startswith("angle")]
    return 2.0 ** np.round(np.log2(np.max(places, axis=0)))


def equations(scheme: str, numbers: Numbers, size: Array) -> Equations:
    """The constraints, lengths as parts of `size`."""
    v = {k: x if k.startswith("angle") else x / size for k, x in numbers.items()}
    if scheme in ("IV", "IVS"):
        return _class_four(scheme, v)
    return _class_three(scheme, v)


def _build(
    rows: list[tuple[tuple[Any, ...], Any, Any, Any]], turns: tuple[int, ...], body: tuple[int, ...], count: int
) -> Equations:  # fmt: skip
    """Rows of (arms, at, length, along)."""
    full = np.ones(count, dtype=complex)
    arms = np.stack([np.stack([a * full for a in arm], axis=1) for arm, _, _, _ in rows], axis=1)
    at, length, along = (np.stack([row[k] * full for row in rows], axis=1) for k in (1, 2, 3))
    return Equations(arms, at, length.real, along, np.array(body, dtype=float), turns, any(body))


def _class_three(scheme: str, v: Numbers) -> Equations:
    """Unknowns φ, (direction of the dyad's rod,) direction of link 3, place of B on it."""
    count, dyad = len(v["crank"]), scheme == "DRRR"
    none = (0.0,) * (2 if dyad else 1)
    if dyad:
        kappa = v["H"] / v["GP"]
        first: tuple[Any, Any] = (
            (-kappa * v["crank"], -kappa * v["AP"], 0.0),
            -v["G"] - kappa * (v["O"] - v["G"]),
        )
    else:
        first = ((-v["crank"], 0.0), -v["O"])
    rod = {"RRR": "AB", "RRRD": "AB", "DRRR": "HB"}.get(scheme)
    turns, body = [-2, -2, -2], [1, 1, 1]
    if rod:
        rows = [(*first, v[rod], 1.0)]
    else:
        turns[0] = 1
        offset = v["N2"].imag if scheme == "SGR" else 0.0
        rows = [(*first, offset, np.exp(1j * v["angle_k2"]))]
    if scheme == "SGR":
        turns[1] = -1
        rows.append(((*none, v["C"]), -v["Q"], v["C4"].imag, np.exp(1j * v["angle_g4"])))
    else:
        rows.append(((*none, v["C"]), -v["E"], v["EC"], 1.0))
    rows.append(((*none, v["D"]), -v["F"], v["FD"], 1.0))
    if dyad:
        rows.insert(0, ((v["crank"], v["AP"], 0.0), v["O"] - v["G"], v["GP"], 1.0))
        turns, body = [-2, *turns], [0, *body]
    return _build(rows, tuple(turns), tuple(body), count)


def _class_four(scheme: str, v: Numbers) -> Equations:
    """Unknowns φ, directions of links 2 and 5."""
    at = v["F"] - v["O"]
    rows = [
        ((-v["crank"], -v["B"], v["D"]), at, v["BD"] if scheme == "IV" else 0.0, 1.0),
        ((-v["crank"], -v["C"], v["E"]), at, v["CE"], 1.0),
    ]
    turns = (-2, -2)
    if scheme == "IVS":
        rows[0] = (*rows[0][:3], np.exp(1j * v["angle_k3"]))
        turns = (1, -2)
    return _build(rows, turns, (0, 0), len(v["crank"]))


def places(scheme: str, v: Numbers, size: Array, x: Array) -> dict[str, Array]:
    """World places of the joints at x (L, ..., n), m."""
    shape = (-1, *(1,) * (x.ndim - 2))
    v = {k: np.reshape(value, shape) for k, value in v.items()}
    a = v["O"] + v["crank"] * np.exp(1j * x[..., 0])
    if scheme in ("IV", "IVS"):
        u, w = np.exp(1j * x[..., 1]), np.exp(1j * x[..., 2])
        found = {"A": a, "C": a + v["C"] * u, "D": v["F"] + v["D"] * w, "E": v["F"] + v["E"] * w}
        return found | ({"B": a + v["B"] * u} if scheme == "IV" else {})
    p = (x[..., -2] + 1j * x[..., -1]) * size.reshape(shape)
    u = np.exp(1j * x[..., -3])
    found = {"A": a, "B": p, "C": p + v["C"] * u, "D": p + v["D"] * u}
    if scheme == "DRRR":
        P = a + v["AP"] * np.exp(1j * x[..., 1])
        found |= {"P": P, "H": v["G"] + v["H"] / v["GP"] * (P - v["G"])}
    if scheme == "RRRD":
        T = p + v["T"] * u
        found |= {"T": T, "R": rod_joint(T, v)}
    return found


def rod_joint(T: Array, v: Numbers) -> Array:
    """Joint R of the dyad behind, on its stated side of the line T-K; nan where the rods do not meet."""
    gap = v["K"] - T
    r = np.abs(gap)
    along = (r * r + v["TR"] ** 2 - v["KR"] ** 2) / (2 * r)
    with np.errstate(invalid="ignore"):
        aside = np.sqrt(v["TR"] ** 2 - along**2)
        return T + gap / r * (along + 1j * v["angle_side"] * aside)


# ---------------------------------------------------------------- the variant's file


def variant(scheme: str, v: Mapping[str, Any], sense: float, sketch: Mapping[str, complex]) -> dict[str, Any]:
    """The file of one mechanism: plain numbers, `v` of one lane."""
    frame = {name: v[name] for name in "OEFGK" if name in v and not (name == "E" and scheme in ("IV", "IVS"))}
    links: dict[str, Any] = {"1": {"points": {"O": 0, "A": v["crank"]}}}
    guides: dict[str, Any] = {}
    assembly: dict[str, str] = {}
    if scheme in ("IV", "IVS"):
        links["2"] = _points(A=0, B=v["B"], C=v["C"]) if scheme == "IV" else _points(A=0, K=v["B"], C=v["C"])
        links["3"] = _points(B=0, D=v["BD"]) if scheme == "IV" else {"points": ["D"], "slides": "k3"}
        links["4"] = _points(C=0, E=v["CE"])
        links["5"] = _points(F=0, D=v["D"], E=v["E"])
        if scheme == "IVS":
            guides["k3"] = {"through": "K", "link": "2", "angle": v["angle_k3"]}
    else:
        n = 2 if scheme == "DRRR" else 0  # numbers of links taken by the dyad in front
        name = [str(k + n) for k in range(6)]
        if n:
            links["2"], links["3"] = _points(A=0, P=v["AP"]), _points(G=0, P=v["GP"], H=v["H"])
            sketched = (sketch["A"], sketch["G"], sketch["P"])
            side = ((sketched[1] - sketched[0]).conjugate() * (sketched[2] - sketched[0])).imag
            assembly["P"] = ("left" if side > 0 else "right") + " of A-G"
        links[name[2]] = _first_leg(scheme, v)
        body = {"B": 0, "C": v["C"], "D": v["D"]} | ({"T": v["T"]} if scheme == "RRRD" else {})
        links[name[3]] = _points(**body)
        links[name[4]] = _points(N4=0, C=v["C4"]) if scheme == "SGR" else _points(E=0, C=v["EC"])
        links[name[5]] = _points(F=0, D=v["FD"])
        if scheme in ("SRR", "SGR"):
            guides["k2"] = {"through": "B", "link": "3", "angle": v["angle_k2"]}
        if scheme == "SGR":
            frame["Q4"] = v["Q"]
            guides["g4"] = {"through": "Q4", "angle": v["angle_g4"]}
            links["4"]["slides"] = "g4"
        if scheme == "RRRD":
            links["6"], links["7"] = _points(T=0, R=v["TR"]), _points(K=0, R=v["KR"])
            assembly["R"] = DYAD_ROOTS[int(v["angle_side"] < 0)] + " of T-K"
    mechanism: dict[str, Any] = {"frame": {k: _pair(p) for k, p in frame.items()}}
    if guides:
        mechanism["guides"] = guides
    mechanism["links"] = links
    mechanism["driver"] = {
        "link": "1", "speed": 5.0, "rotation": "counter-clockwise" if sense > 0 else "clockwise",
        "zero": {"angle": v["angle_zero"]},
    }  # fmt: skip
    if assembly:
        mechanism["assembly"] = assembly
    moving = [p for p in sketch if p not in frame and p not in assembly]
    mechanism["sketch"] = {p: _pair(sketch[p]) for p in moving}
    return {"mechanism": mechanism, "positions": {"table": 12, "diagram": 36}, "language": "en"}


def _first_leg(scheme: str, v: Mapping[str, Any]) -> dict[str, Any]:
    if scheme == "SRR":
        return {"points": ["A"], "slides": "k2"}
    if scheme == "SGR":
        return _points(A=0, N2=v["N2"]) | {"slides": {"guide": "k2", "at": "N2"}}
    return _points(H=0, B=v["HB"]) if scheme == "DRRR" else _points(A=0, B=v["AB"])


def _points(**at: Any) -> dict[str, Any]:
    return {"points": {name: _pair(place) for name, place in at.items()}}


def _pair(place: Any) -> Any:
    """A place as the file writes it: one number along the link's x axis, or two."""
    place = complex(place)
    return float(place.real) if place.imag == 0 else [float(place.real), float(place.imag)]

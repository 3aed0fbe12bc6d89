"""Random mechanisms at the limits of Grashof's kind: lengths in millimetres as a student types them, whose equality
holds to the last decimal, so that two assemblies meet once or twice in a turn.

`away`: millimetres by which one length misses the equality, so that they only nearly meet.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

import numpy as np

Number = Fraction
Place = tuple[Fraction, Fraction]
OMEGA = 10


@dataclass(frozen=True)
class Step:
    """A dyad: `kind` RRR (links a, b; from A and C to B), RRP (link a from A to B on a guide through C along `along`)
    or RPR (link b about C, on its guide, a line beside C at the distance q, the pin A)."""

    kind: str
    a: str
    b: str
    A: str
    C: str
    B: str
    p: Fraction
    q: Fraction
    sign: int
    along: Place = (Fraction(1), Fraction(0))


@dataclass(frozen=True)
class Scene:
    """A mechanism: `crank`, mm; fixed points; steps of which the first is at its limit, `changes` the driver's angles
    at which its assemblies meet, in half turns from the direction `base`; `zero`, the driver's angle in position 0, in
    degrees as typed; points carried by links, in their axes; sliders."""

    family: str
    number: int
    crank: Fraction
    fixed: Mapping[str, Place]
    steps: tuple[Step, ...]
    base: Place
    changes: tuple[int, ...]
    zero: str
    sense: int
    carried: Mapping[str, tuple[str, Place]]
    guides: Mapping[str, tuple[str, str]]
    away: Fraction = Fraction(0)
    starts_at: bool = False  # in the change point itself

    @property
    def text(self) -> str:
        return _text(self)


def _mm(x: Fraction) -> str:
    """A typed number, mm."""
    return f"{_plain(x)} mm"


def _plain(x: Fraction) -> str:
    whole = round(x * 10**12)
    assert Fraction(whole, 10**12) == x
    digits = f"{abs(whole):013d}"
    return f"{'-' if whole < 0 else ''}{digits[:-12]}.{digits[-12:]}".rstrip("0").rstrip(".")


def _pair(place: Place) -> str:
    return f"[{_mm(place[0])}, {_mm(place[1])}]"


def _text(scene: Scene) -> str:
    """The variant's file."""
    lines = ["language: en", "mechanism:", "  frame:"]
    lines += [f"    {name}: {_pair(at)}" for name, at in scene.fixed.items()]
    guides, links, assembly = [], {"1": f"{{points: {{O: 0, A: {_mm(scene.crank)}}}}}"}, []
    for step in scene.steps:
        extra = {point: at for point, (link, at) in scene.carried.items() if link in (step.a, step.b)}
        of = {link: [p for p in extra if scene.carried[p][0] == link] for link in (step.a, step.b)}
        more = {
            link: "".join(f", {p}: {_pair(scene.carried[p][1])}" for p in points)
            for link, points in of.items()
        }
        if step.kind == "RRR":
            links[step.a] = f"{{points: {{{step.A}: 0, {step.B}: {_mm(step.p)}{more[step.a]}}}}}"
            links[step.b] = f"{{points: {{{step.C}: 0, {step.B}: {_mm(step.q)}{more[step.b]}}}}}"
            side = "left" if step.sign > 0 else "right"
            assembly.append(f"    {step.B}: {side} of {step.A}-{step.C}")
        elif step.kind == "RRP":
            angle = 0 if step.along[1] == 0 else 90
            guides.append(f"    g{step.b}: {{through: {step.C}, angle: {angle} deg}}")
            links[step.a] = f"{{points: {{{step.A}: 0, {step.B}: {_mm(step.p)}{more[step.a]}}}}}"
            links[step.b] = f"{{points: [{step.B}], slides: g{step.b}}}"
            side = {(0, 1): "right", (0, -1): "left", (90, 1): "up", (90, -1): "down"}[angle, step.sign]
            assembly.append(f"    {step.B}: {side}")
        else:
            beside = f", K: [0, {_mm(step.q)}]" if step.q else ""
            through = "K" if step.q else step.C
            guides.append(f"    g{step.b}: {{through: {through}, link: {step.b}}}")
            links[step.a] = f"{{points: [{step.A}], slides: g{step.b}}}"
            links[step.b] = f"{{points: {{{step.C}: 0{beside}{more[step.b]}}}}}"
            assembly.append(f"    {step.a}-{step.b}: '{'+' if step.sign > 0 else '-'}'")
    if guides:
        lines += ["  guides:", *guides]
    lines += ["  links:", *(f"    {name}: {said}" for name, said in sorted(links.items()))]
    rotation = "counter-clockwise" if scene.sense > 0 else "clockwise"
    lines.append(
        f"  driver: {{link: 1, speed: {OMEGA} rad/s, rotation: {rotation}, zero: {{angle: {scene.zero} deg}}}}"
    )
    lines += ["  assembly:", *assembly, "positions: {table: 12, diagram: 36}"]
    return "\n".join(lines) + "\n"


# ---------------------------------------------------------------- drawing

DIRECTIONS = (  # of the frame, so that its length is a number with few decimals
    (Fraction(1), Fraction(0)), (Fraction(0), Fraction(1)), (Fraction(-1), Fraction(0)),
    (Fraction(3, 5), Fraction(4, 5)), (Fraction(4, 5), Fraction(-3, 5)),
)  # fmt: skip


class _Dice:
    def __init__(self, seed: Sequence[int]):
        self.rng = np.random.default_rng(seed)

    def length(self, low: float, high: float) -> Fraction:
        """A typed length, mm, with 0 to 2 decimals."""
        places = int(self.rng.integers(0, 3))
        return Fraction(round(float(self.rng.uniform(low, high)) * 10**places), 10**places)

    def sign(self) -> int:
        return 1 if self.rng.random() < 0.5 else -1

    def pick(self, items: Sequence[object]) -> int:
        return int(self.rng.integers(len(items)))


def draw(family: str, number: int, seed: int, away: Fraction = Fraction(0)) -> Scene:
    """One mechanism of a family."""
    dice = _Dice([seed, list(FAMILIES).index(family), number])
    while True:
        scene = FAMILIES[family](family, number, dice, away)
        if scene is not None:
            return scene


def _started(dice: _Dice, base: Place, changes: Sequence[int]) -> tuple[str, bool]:
    """Position 0: anywhere, or in a change point where its angle can be typed."""
    angle = {(1, 0): 0, (0, 1): 90, (-1, 0): 180, (0, -1): 270}.get((base[0], base[1]))
    if angle is not None and dice.rng.random() < 0.25:
        return str((angle + 180 * changes[dice.pick(changes)]) % 360), True
    return f"{dice.rng.uniform(0, 360):.1f}", False


def _scaled(direction: Place, length: Fraction) -> Place:
    return direction[0] * length, direction[1] * length


def _bar(
    family: str, number: int, dice: _Dice, away: Fraction, lengths: Callable[[_Dice], tuple[Fraction, ...]]
) -> Scene | None:
    """A four-bar of crank, rod, rocker, frame."""
    a, p, q, c = lengths(dice)
    direction = DIRECTIONS[dice.pick(DIRECTIONS)]
    if min(a, p, q, c) < 8 or max(a, p, q, c) > 500:
        return None
    changes = _meetings(a, p, q, c)
    if changes is None:
        return None
    zero, starts_at = _started(dice, direction, changes)
    if away:  # the rod longer or shorter by so little that it still goes all round
        if p == q and a == c:  # of a kite the frame
            c, away_rod = c + away, Fraction(0)
        else:
            whole = [x for x in (away, -away) if _goes_round(a, p + x, q, c)]
            if not whole:
                return None
            away_rod = away = whole[0]
    step = Step("RRR", "2", "3", "A", "C", "B", p + (away_rod if away else 0), q, dice.sign())
    return Scene(
        family, number, a, {"O": (Fraction(0), Fraction(0)), "C": _scaled(direction, c)}, (step,), direction,
        changes, zero, dice.sign(), {}, {}, away, starts_at,
    )  # fmt: skip


def _goes_round(a: Fraction, p: Fraction, q: Fraction, c: Fraction) -> bool:
    return abs(c - a) > abs(p - q) and c + a < p + q


def _meetings(a: Fraction, p: Fraction, q: Fraction, c: Fraction) -> tuple[int, ...] | None:
    """Half turns from the frame's direction at which the assemblies meet; None where it does not go all round."""
    near, far = abs(c - a), c + a
    if near < abs(p - q) or far > p + q:
        return None
    return tuple(k for k, meets in ((0, near == abs(p - q)), (1, far == p + q)) if meets) or None


def _once(dice: _Dice) -> tuple[Fraction, ...]:
    """Four lengths of which two together are as long as the other two."""
    a, p, q = (dice.length(15, 200) for _ in range(3))
    c = (p + q - a, a + abs(p - q), a - abs(p - q))[dice.pick("xyz")]
    return a, p, q, c


def _kite_jumping(dice: _Dice) -> tuple[Fraction, ...]:
    a, p = dice.length(15, 120), dice.length(15, 300)
    return a, p, p, a


def _kite_folding(dice: _Dice) -> tuple[Fraction, ...]:
    a, c = dice.length(15, 200), dice.length(15, 200)
    return a, a, c, c


def _parallelogram(dice: _Dice) -> tuple[Fraction, ...]:
    a, c = dice.length(15, 200), dice.length(15, 200)
    return (a, a, a, a) if dice.rng.random() < 0.15 else (a, c, a, c)


def _slider(
    family: str, number: int, dice: _Dice, away: Fraction, lengths: Callable[[_Dice], tuple[Fraction, ...]]
) -> Scene | None:
    """A slider-crank of crank, rod, offset."""
    a, p, e = lengths(dice)
    if min(a, p) < 8:
        return None
    upright = dice.rng.random() < 0.5
    along = (Fraction(0), Fraction(1)) if upright else (Fraction(1), Fraction(0))
    beside = (Fraction(1), Fraction(0)) if upright else (Fraction(0), Fraction(1))
    side = dice.sign()
    base = (beside[0] * side, beside[1] * side)
    # the pin is farthest from the guide against the offset
    changes = (0, 1) if e == 0 else (1,)
    zero, starts_at = _started(dice, base, changes)
    step = Step("RRP", "2", "3", "A", "Q", "B", p + away, Fraction(0), dice.sign(), along)
    fixed = {"O": (Fraction(0), Fraction(0)), "Q": _scaled(base, e)}
    if e == 0:
        fixed["Q"] = _scaled(along, Fraction(5))
    return Scene(
        family,
        number,
        a,
        fixed,
        (step,),
        base,
        changes,
        zero,
        dice.sign(),
        {},
        {"B": ("3", "2")},
        away,
        starts_at,
    )


def _offset(dice: _Dice) -> tuple[Fraction, ...]:
    a, e = dice.length(15, 150), dice.length(5, 150)
    return a, a + e, e


def _equal(dice: _Dice) -> tuple[Fraction, ...]:
    a = dice.length(15, 150)
    return a, a, Fraction(0)


def _slide(family: str, number: int, dice: _Dice, away: Fraction, beside: bool) -> Scene | None:
    """A link that swings or turns with a slot, or a slot beside its pivot."""
    a = dice.length(15, 150)
    h = dice.length(5, 60) * dice.sign() if beside else Fraction(0)
    c = a + abs(h) if dice.rng.random() < 0.5 else a - abs(h)
    if c < 8:
        return None
    direction = DIRECTIONS[dice.pick(DIRECTIONS)]
    zero, starts_at = _started(dice, direction, (0,))
    if away and not abs(c + away - a) > abs(h):
        away = -away
    frame = c + away
    step = Step("RPR", "2", "3", "A", "C", "", Fraction(0), h, dice.sign())
    return Scene(
        family, number, a, {"O": (Fraction(0), Fraction(0)), "C": _scaled(direction, frame)}, (step,), direction,
        (0,), zero, dice.sign(), {}, {}, away, starts_at,
    )  # fmt: skip


def _carried_on(family: str, number: int, dice: _Dice, away: Fraction, first: str) -> Scene | None:
    """A six-bar: the rocker of such a group drives a slider by a rod."""
    scene = FAMILIES[first](family, number, dice, away)
    if scene is None:
        return None
    if dice.rng.random() < 0.5:
        at = (dice.length(20, 120), dice.length(-60, 60))
    else:
        at = (-dice.length(20, 120), Fraction(0))
    C = scene.fixed["C"]
    level = dice.length(-150, 150)
    far = abs(float(at[0])) + abs(float(at[1])) + abs(float(level)) + abs(float(C[1]))
    rod = Fraction(round(1.4 * far))
    step = Step("RRP", "4", "5", "D", "Q", "E", rod, Fraction(0), dice.sign())
    return Scene(
        family, number, scene.crank, {**scene.fixed, "Q": (Fraction(0), level)}, (*scene.steps, step), scene.base,
        scene.changes, scene.zero, scene.sense, {"D": ("3", at)}, {"E": ("5", "4")}, away, scene.starts_at,
    )  # fmt: skip


Family = Callable[[str, int, _Dice, Fraction], Scene | None]
FAMILIES: dict[str, Family] = {
    "four-bar": partial(_bar, lengths=_once),
    "kite, crank = frame": partial(_bar, lengths=_kite_jumping),
    "kite, crank = rod": partial(_bar, lengths=_kite_folding),
    "parallelogram": partial(_bar, lengths=_parallelogram),
    "offset = rod − crank": partial(_slider, lengths=_offset),
    "rod = crank": partial(_slider, lengths=_equal),
    "slot, crank = frame": partial(_slide, beside=False),
    "slot beside": partial(_slide, beside=True),
    "six-bar: four-bar": partial(_carried_on, first="four-bar"),
    "six-bar: kite": partial(_carried_on, first="kite, crank = frame"),
    "six-bar: parallelogram": partial(_carried_on, first="parallelogram"),
    "six-bar: slot": partial(_carried_on, first="slot, crank = frame"),
}

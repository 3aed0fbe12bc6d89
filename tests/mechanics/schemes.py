"""Mechanisms for the tests: every kind of dyad on fixed and on moving links, built without YAML.

`k` scales the dimensions one by one; every scheme closes all round for k within 0.94..1.06. Nothing is centred or
aligned that need not be, so that a lost offset or angle shows.
"""

from collections.abc import Callable, Sequence

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever import assur_groups, motion
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide

ONES = (1.0,) * 6
OMEGA = 7.0


def turned(angle):
    """Unit vector at an angle, or at an array of them."""
    return np.exp(1j * angle)


def mechanism(links: Sequence[Link], guides: Sequence[Guide] = (), slides: Sequence[Slide] = ()) -> Mechanism:
    named = {link.name: link for link in links}
    return Mechanism(named, Driver("1", OMEGA), {guide.name: guide for guide in guides}, tuple(slides))


def crank(length: float) -> Link:
    return Link("1", {"O": 0.01j, "A": length + 0.01j, "S1": 0.02 + 0.005j}, 0.7, "S1", 0.002)


def four_bar(k: Sequence[float] = ONES) -> Mechanism:
    rod = Link("2", {"A": 0j, "B": 0.18 * k[1] * turned(0.3), "S2": 0.07 + 0.02j}, 1.1, "S2", 0.004)
    rocker = Link("3", {"B": 0.02j, "C": 0.02j - 0.12 * k[2], "S3": 0.05 - 0.01j}, 0.9, "S3", 0.003)
    return mechanism([Link("0", {"O": 0.03 + 0.01j, "C": 0.22 * k[3]}), crank(0.05 * k[0]), rod, rocker])


def slider_crank(k: Sequence[float] = ONES) -> Mechanism:
    rod = Link("2", {"A": 0j, "B": 0.2 * k[1] * turned(-0.5), "S2": 0.07 + 0.02j}, 1.1, "S2", 0.004)
    slider = Link("3", {"B": 0.01 + 0.02j, "S3": -0.03j}, 0.9, "S3")
    guide = Guide("x", "0", 0.03j, turned(0.2 * k[2]))
    return mechanism(
        [Link("0", {"O": 0.01 + 0j}), crank(0.06 * k[0]), rod, slider],
        [guide],
        [Slide("3", "x", 0.005 - 0.01j * k[3], turned(0.4))],
    )


def slotted_link(k: Sequence[float] = ONES) -> Mechanism:
    """Kind 3, the rocking link carries the guide; the line passes beside both pivots."""
    block = Link("2", {"A": 0.01j, "S2": 0.01 + 0j}, 0.3, "S2", 0.0002)
    rocker = Link("3", {"C": 0j, "S3": 0.15 + 0.02j}, 1.2, "S3", 0.01)
    return mechanism(
        [Link("0", {"O": 0j, "C": 0.05 - 0.3j * k[1]}), crank(0.1 * k[0]), block, rocker],
        [Guide("k", "3", 0.02j * k[2], turned(0.2))],
        [Slide("2", "k", 0.015 - 0.01j * k[3], turned(-0.4))],
    )


def swinging_block(k: Sequence[float] = ONES) -> Mechanism:
    """Kind 3 the other way round: the block on the crank carries the guide, a rod slides through it."""
    block = Link("2", {"A": 0.01j, "S2": 0.01 + 0j}, 0.3, "S2", 0.0002)
    rod = Link("3", {"C": 0j, "S3": 0.15 + 0.02j}, 1.2, "S3", 0.01)
    return mechanism(
        [Link("0", {"O": 0j, "C": 0.05 - 0.3j * k[1]}), crank(0.1 * k[0]), block, rod],
        [Guide("k", "2", 0.02j * k[2], turned(0.2))],
        [Slide("3", "k", 0.015 - 0.01j * k[3], turned(-0.4))],
    )


def yoke(k: Sequence[float] = ONES) -> Mechanism:
    """Kind 5: a Scotch yoke with a leaning slot."""
    block = Link("2", {"A": 0.01j, "S2": 0.01 + 0j}, 0.3, "S2", 0.0002)
    slider = Link("3", {"S3": 0.03 + 0.02j}, 1.2, "S3", 0.01)
    return mechanism(
        [Link("0", {"O": 0j}), crank(0.1 * k[0]), block, slider],
        [Guide("x", "0", 0.05j, turned(0.3 * k[1])), Guide("s", "3", 0.02 - 0.01j, turned(1.4 * k[2]))],
        [Slide("2", "s", 0.015 - 0.01j * k[3], turned(-0.4)), Slide("3", "x", 0.01j, turned(0.1))],
    )


def two_slots(k: Sequence[float] = ONES) -> Mechanism:
    """Kind 4 that goes all round: four-bar, and a joint where a guide of the rocker crosses a fixed one."""
    base = four_bar(k)
    blocks = [
        Link("4", {"D": 0.01 + 0.02j, "S4": 0.01 + 0j}, 0.4, "S4", 0.0002),
        Link("5", {"D": 0j, "S5": 0.02 - 0.01j}, 0.5, "S5", 0.0003),
    ]
    return mechanism(
        [*base.links.values(), *blocks],
        [Guide("f", "0", 0.1 + 0.05j, turned(-0.3)), Guide("m", "3", 0.03j * k[4], turned(0.2 * k[5]))],
        [Slide("4", "f", 0.004j, turned(0.6)), Slide("5", "m", 0.01j, turned(-0.2))],
    )


def compound(k: Sequence[float] = ONES) -> Mechanism:
    """All five kinds hung on the moving links of a four-bar; three links share the pivot A."""
    base = dict(four_bar(k).links)
    base["2"] = Link("2", {**base["2"].points, "E": 0.1 + 0.12j}, 1.1, "S2", 0.004)
    base["3"] = Link("3", {**base["3"].points, "F": -0.3 - 0.1j}, 0.9, "S3", 0.003)
    bar = [
        # 4, 5: RRR between E and the far end F of the rocker
        Link("4", {"E": 0j, "G": 0.35 * k[4], "S4": 0.1 + 0.03j}, 0.8, "S4", 0.002),
        Link("5", {"F": 0j, "G": 0.4j * k[5], "S5": 0.1j}, 0.7, "S5", 0.002),
        # 6, 7: RRP from pin A, which three links share, to a guide of the rocker
        Link("6", {"A": 0j, "H": 0.4 * k[4], "S6": 0.1 - 0.02j}, 0.6, "S6", 0.001),
        Link("7", {"H": 0.01j, "S7": 0.02 + 0j}, 0.5, "S7", 0.001),
        # 8, 9: RPR, a block at E on a link pivoted at F
        Link("8", {"E": 0.01j, "S8": 0.01 + 0j}, 0.4, "S8", 0.0005),
        Link("9", {"F": 0j, "S9": 0.1 + 0.02j}, 0.8, "S9", 0.003),
        # 10, 11: PRP, where guides of links 2 and 3 cross
        Link("10", {"K": 0.01 + 0.02j, "S10": 0.01 + 0j}, 0.4, "S10", 0.0002),
        Link("11", {"K": 0j, "S11": 0.02 - 0.01j}, 0.5, "S11", 0.0003),
        # 12, 13: RPP, a block at B on a link that slides along link 2
        Link("12", {"E": 0.01j, "S12": 0.01 + 0j}, 0.3, "S12", 0.0002),
        Link("13", {"S13": 0.03 + 0.02j}, 0.6, "S13", 0.001),
    ]
    guides = [
        Guide("g7", "3", 0.02j, turned(0.4)),
        Guide("g9", "9", 0.02j, turned(0.2)),
        Guide("g10", "2", 0.01 + 0.03j, turned(0.1)),
        Guide("g11", "3", 0.02j, turned(-0.2)),
        Guide("g13", "3", 0.01 + 0.03j, turned(0.7)),
        Guide("g12", "13", 0.02 - 0.01j, turned(1.4)),
    ]
    slides = [
        Slide("7", "g7", 0.005 - 0.01j, turned(0.4)),
        Slide("8", "g9", 0.01 - 0.01j, turned(-0.4)),
        Slide("10", "g10", 0.004j, turned(0.6)),
        Slide("11", "g11", 0.01j, turned(-0.2)),
        Slide("12", "g12", 0.015 - 0.01j, turned(-0.4)),
        Slide("13", "g13", 0.01j, turned(0.1)),
    ]
    return mechanism([*base.values(), *bar], guides, slides)


SCHEMES: dict[str, Callable[..., Mechanism]] = {
    f.__name__: f for f in (four_bar, slider_crank, slotted_link, swinging_block, two_slots, yoke, compound)
}
KINDS = {
    "four_bar": [1], "slider_crank": [2], "slotted_link": [3], "swinging_block": [3], "two_slots": [1, 4], "yoke": [5],
    "compound": [1, 1, 2, 3, 4, 5],
}  # fmt: skip
# every scheme in both roots of its last dyad with two roots
ROOTED = [(name, sign) for name, kinds in KINDS.items() for sign in ((1, -1) if min(kinds) <= 3 else (1,))]


def linkage(scheme: Mechanism, sign: int = 1) -> motion.Linkage:
    """All dyads of the first root; the four-bar under the compound in the first, the rest in root `sign`."""
    found = assur_groups.decompose(scheme)
    first = 1 if len(found.groups) > 2 else sign
    return motion.linkage_of(found, [first, *(sign for _ in found.groups[1:])])


def turn(count: int = 24) -> np.ndarray:
    """Driver angles that avoid any symmetry, rad."""
    return 0.1234 + np.arange(count) * (2 * np.pi / count)


def random_loads(found: motion.Motion, seed: int = 1) -> dict[str, statics.Load]:
    """Gravity, inertia, and a force at every named point and a moment on every moving link."""
    random = np.random.default_rng(seed)
    loads = statics.inertia_and_gravity(found, -9.81j)
    for name in found.linkage.mechanism.moving:
        force, moment = loads[name].force, loads[name].moment + random.normal()
        for point in found.linkage.mechanism.links[name].points:
            push = complex(*random.normal(size=2)) * 30
            force, moment = force + push, moment + cross(found.place(point) - found.state.r[name], push)
        loads[name] = statics.Load(force, moment)
    return loads

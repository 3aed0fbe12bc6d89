"""The closed form of the parallelogram: of dyads, of groups of class III and IV with every kind of pair that it has.

Each mechanism is drawn at random in one position, in axes of the drawing, so that it exists there; then the closed form
is held against Newton's method on the constraint equations, which know nothing of the parallelogram.
"""

from __future__ import annotations

import numpy as np
import pytest
from conftest import solved
from exhaustive import many

from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide
from tmm_report.mechanics.rivals.motion.contours import recognised
from tmm_report.mechanics.rivals.motion.every import motion_method

CRANK = 0.04
COUNT = 36
Places = dict[str, dict[str, complex]]


def somewhere(seed: int, count: int) -> list[complex]:
    """Random vectors of 0.3 to 0.6 m, no two of them nearly along one line."""
    random = np.random.default_rng(seed)
    turns = random.permutation(count) * np.pi / count + random.uniform(-0.15, 0.15, count)
    return [complex(z) for z in random.uniform(0.3, 0.6, count) * np.exp(1j * turns)]


def built(points: Places, guides: list[Guide] = (), slides: list[Slide] = (), spoilt: complex = 0) -> Cycle:
    """The cycle from the drawn position on, every driven link in axes of its own. `spoilt`: by how much joint E of link
    2 is put wrong, m."""
    sketch = {point: at for places in points.values() for point, at in places.items()}
    points["2"]["E"] += spoilt
    turns = {name: np.exp(0.7j * int(name)) if name > "1" else 1 for name in points}
    links = {
        name: Link(name, {point: turns[name] * at + (turns[name] - 1) for point, at in places.items()})
        for name, places in points.items()
    }
    lines = {
        one.name: Guide(
            one.name, one.link, turns[one.link] * (one.through + 1) - 1, turns[one.link] * one.direction
        )
        for one in guides
    }
    blocks = [
        Slide(one.link, one.guide, turns[one.link] * (one.through + 1) - 1, turns[one.link] * one.direction)
        for one in slides
    ]
    return cycle_of(assemble(Mechanism(links, Driver("1", 5.0), lines, blocks, sketch=sketch)))


def basis(seed: int) -> tuple[complex, complex, complex, complex, complex]:
    """O = 0 and the crank's pin A; then joint C of link 2, its side C–E, and a rod of the parallelogram."""
    one, side, rod, *_ = somewhere(seed, 5)
    A = CRANK * np.exp(1j * seed)
    return A, A + one, side, rod, A + one + rod


def class_iv(seed: int, sliding: bool, spoilt: complex = 0, rocking: bool = False) -> Cycle:
    """Link 2 (A, C, E) on the crank, rods 3 and 4, link 5 (D, F) on a guide or a pivot of the frame; `rocking`: on a
    guide of rocker 7, which the crank swings through rod 6."""
    A, C, side, rod, D = basis(seed)
    G = D + somewhere(seed, 5)[3]
    points: Places = {
        "0": {"O": 0j, "G": G},
        "1": {"O": 0j, "A": A},
        "2": {"A": A, "C": C, "E": C + side},
        "3": {"C": C, "D": D},
        "4": {"E": C + side, "F": D + side},
        "5": {"D": D, "F": D + side, "G": G},
    }
    if not sliding:
        return built(points, spoilt=spoilt)
    del points["5"]["G"]
    along = rod / abs(rod) * np.exp(0.4j)
    if rocking:
        R = G + 0.2j
        B = R + 0.4
        points |= {"6": {"A": A, "B": B}, "7": {"B": B, "R": R}}
        points["0"]["R"] = R
    body = "7" if rocking else "0"
    return built(points, [Guide("g", body, G, along)], [Slide("5", "g", G, along)], spoilt)


def class_iii(seed: int, third: str, base: str = "0", spoilt: complex = 0) -> Cycle:
    """Basis link 2 (C, E, F), legs 3 and 4 of a parallelogram on link `base`, leg 5 as `third` says."""
    A, C, side, rod, P = basis(seed)
    if base == "1":  # near the shaft, so that it goes round
        P, side = 0.8j * A, side / 10
        C = P - rod
    F = C + somewhere(seed, 5)[3] * (0.1 if base == "1" else 1.0)
    H = A if base == "0" else F + somewhere(seed, 5)[4]
    points: Places = {
        "0": {"O": 0j},
        "1": {"O": 0j, "A": A},
        "2": {"C": C, "E": C + side, "F": F},
        "3": {"C": C, "P": P},
        "4": {"E": C + side, "Q": P + side},
        "5": {"F": F, "H": H},
    }
    points[base] |= {"P": P, "Q": P + side}
    other = "1" if base == "0" else "0"
    guides, slides = [], []
    if third == "outer":
        guides, slides = [Guide("g", other, H, rod / abs(rod))], [Slide("5", "g", H, rod / abs(rod))]
        del points["5"]["H"]
    else:
        points[other]["H"] = H
    if third == "inner":
        along = (F - H) / abs(F - H)
        guides, slides = [Guide("g", "2", F, along)], [Slide("5", "g", F, along)]
        del points["5"]["F"]
    return built(points, guides, slides, spoilt)


FORMS = {
    "IV, slider": lambda seed, spoilt=0: class_iv(seed, True, spoilt),
    "IV, slider on a rocker": lambda seed, spoilt=0: class_iv(seed, True, spoilt, True),
    "IV, rocker": lambda seed, spoilt=0: class_iv(seed, False, spoilt),
    "III, pivots": lambda seed, spoilt=0: class_iii(seed, "pivots", spoilt=spoilt),
    "III, third leg slides outside": lambda seed, spoilt=0: class_iii(seed, "outer", spoilt=spoilt),
    "III, third leg slides on the basis link": lambda seed, spoilt=0: class_iii(seed, "inner", spoilt=spoilt),
    "III, the parallelogram on the crank": lambda seed, spoilt=0: class_iii(seed, "pivots", "1", spoilt),
}


def off(found, exact, known) -> float:
    """Largest error of places and rates where both are known, relative."""
    return max(
        np.abs(getattr(found, of) - getattr(exact, of))[:, known].max()
        / np.abs(getattr(exact, of)[:, known]).max()
        for of in ("places", "velocities", "accelerations")
    )


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("seed", many([1, 2, 3, 4]))
def test_the_closed_form_is_the_motion_that_newtons_method_finds(form, seed):
    of = FORMS[form](seed)
    closed = motion_method("parallelogram")
    assert closed.refuses(of) is None
    found, exact = closed.run(of, COUNT), motion_method("newton").run(of, COUNT)
    clear = np.min(list(exact.sines.values()), axis=0) > 0.03  # rates lose digits beside a limit
    known = found.closes & exact.closes & clear
    assert known.sum() > COUNT / 6 and (found.closes >= exact.closes).all()
    assert off(found, exact, known) < 1e-10
    own = of.motion(of.once(COUNT))  # through the contour's change points, which end Newton's way
    known = found.closes & own.closes
    assert known.sum() > COUNT / 6 and np.abs(found.places - own.places)[:, known].max() < 1e-9


@pytest.mark.parametrize("form", FORMS)
def test_opposite_links_turn_alike(form):
    """Of class IV link 2 as link 5, of class III link 2 as the link on which both legs stand."""
    of = FORMS[form](1)
    found = motion_method("newton").run(of, COUNT)
    other = "5" if form.startswith("IV") else "1" if "crank" in form else "0"
    known = found.closes
    for one, like in (("2", other), ("3", "4")):
        turned = found.turn(one)[known] / found.turn(like)[known]
        assert turned == pytest.approx(np.full(known.sum(), turned[0]), abs=1e-12)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("amiss", [1e-10, 1e-4])
def test_a_side_that_is_not_quite_equal_is_no_parallelogram(form, amiss):
    of = FORMS[form](1, amiss)
    assert all(recognised(of.linkage.structure, group) is None for group in of.linkage.structure.groups)
    assert motion_method("parallelogram").refuses(of).text.startswith("no four links")


def test_the_press_with_twin_rods_has_one():
    """The press of the thesis: link 2 does not turn, and the slider-crank with the rod's length gives its slider."""
    of = solved("press").lever.kinematics.cycle
    found = motion_method("parallelogram").run(of, COUNT)
    assert np.abs(found.angular_velocity("2")).max() == 0
    assert off(found, of.motion(of.once(COUNT)), found.closes) < 1e-14
    s = 0.04 * np.sin(found.phi) - np.sqrt(0.185**2 - (0.04 * np.cos(found.phi)) ** 2)
    height = np.sqrt(0.09**2 - 0.0675**2)
    assert found.place("S5").imag == pytest.approx(s - height, abs=1e-15)


def test_a_dyad_parallelogram_goes_through_its_change_points():
    """All four joints in one line at positions 0 and 18: Newton's method ends, the sides stay parallel."""
    links = {
        "0": Link("0", {"O": 0j, "C": 0.3 + 0j}),
        "1": Link("1", {"O": 0j, "A": 0.1 + 0j}),
        "2": Link("2", {"A": 0j, "B": 0.3 + 0j}),
        "3": Link("3", {"B": 0.1 + 0j, "C": 0j}),
    }
    sketch = {"A": 0.1j, "B": 0.3 + 0.1j}
    of = cycle_of(assemble(Mechanism(links, Driver("1", 5.0), sketch=sketch)))
    found = motion_method("parallelogram").run(of, COUNT)
    assert found.place("B") == pytest.approx(0.3 + 0.1 * np.exp(1j * found.phi), abs=1e-16)
    assert np.abs(found.angular_velocity("2")).max() == 0
    assert found.acceleration("B") == pytest.approx(found.acceleration("A"), abs=1e-15)
    assert found.turn("3") == pytest.approx(found.turn("1"), abs=1e-15)
    with pytest.raises(ArithmeticError):
        motion_method("newton").run(of, COUNT)


def test_a_crossed_contour_is_refused_in_words():
    """The same lengths assembled as an antiparallelogram."""
    links = {
        "0": Link("0", {"O": 0j, "C": 0.3 + 0j}),
        "1": Link("1", {"O": 0j, "A": 0.1 + 0j}),
        "2": Link("2", {"A": 0j, "B": 0.3 + 0j}),
        "3": Link("3", {"B": 0.1 + 0j, "C": 0j}),
    }
    A, C = 0.1j, 0.3 + 0j
    along = (C - A) / abs(C - A)
    mirrored = (
        A + along * ((0.3 + 0.1j - A) / along).conjugate()
    )  # the parallelogram's B on the other side of A–C
    of = cycle_of(assemble(Mechanism(links, Driver("1", 5.0), sketch={"A": A, "B": mirrored})))
    assert "crossed" in motion_method("parallelogram").refuses(of).text


def test_a_mechanism_without_one_raises():
    of = solved("crank_rocker").lever.kinematics.cycle
    with pytest.raises(ArithmeticError):
        motion_method("parallelogram").run(of, 12)


def driven(*links: Link, **sketch: complex) -> Cycle:
    return cycle_of(assemble(Mechanism({one.name: one for one in links}, Driver("1", 5.0), sketch=sketch)))


def test_rod_pendulum_and_sieve_on_one_pin_are_a_parallelogram_all_the_same():
    """The sieve is told with the rod, but hangs on the pendulum as well."""
    of = driven(
        Link("0", {"O": 0j, "C": 0.35 + 0.4j, "D": 0.95 + 0.4j}),
        Link("1", {"O": 0j, "A": 0.025 + 0j}),
        Link("2", {"A": 0j, "B": 0.35 + 0j}),
        Link("3", {"C": 0j, "B": 0.4 + 0j}),
        Link("4", {"B": 0j, "E": 0.6 + 0j}),
        Link("5", {"D": 0j, "E": 0.4 + 0j}),
        A=0.025, B=0.37, E=0.97,
    )  # fmt: skip
    found = motion_method("parallelogram").run(of, COUNT)
    assert np.abs(found.angular_velocity("4")).max() == 0
    exact = motion_method("newton").run(of, COUNT)
    assert off(found, exact, found.closes) < 1e-12
    for link in of.linkage.mechanism.moving:
        assert found.turn(link) == pytest.approx(exact.turn(link), abs=1e-13)


def test_two_cranks_on_one_shaft_carry_a_parallelogram():
    """Their pivot is in common through the frame only; the vertex across is the sum of the two pins."""
    of = driven(
        Link("0", {"O": 0j}),
        Link("1", {"O": 0j, "A": 0.1 + 0j}),
        Link("2", {"A": 0j, "B": 0.2 + 0j}),
        Link("3", {"O": 0j, "B": 0.15 + 0j}),
        Link("4", {"A": 0j, "D": 0.15 + 0j}),
        Link("5", {"B": 0j, "D": 0.1 + 0j}),
        A=0.1, B=0.15 * np.exp(1.8j), D=0.1 + 0.15 * np.exp(1.8j),
    )  # fmt: skip
    found = motion_method("parallelogram").run(of, COUNT)
    assert found.place("D") == pytest.approx(found.place("A") + found.place("B"), abs=1e-16)

"""Which root a dyad takes: words, signs and sketches say the same; what says nothing is a mistake."""

import dataclasses

import numpy as np
import pytest
from schemes import KINDS, ROOTED, SCHEMES, linkage

from tmm_report.mechanics.lever.assembly.stated import assemble, keys_of
from tmm_report.mechanics.lever.mechanism import Assembly
from tmm_report.mechanics.lever.motion import solve
from tmm_report.problems import ProblemError


def stated(name, *assembly, sketch=None):
    choices = tuple(Assembly(key, choice) for key, choice in assembly)
    return dataclasses.replace(SCHEMES[name](), assembly=choices, sketch=sketch or {})


def signs(name, *assembly, sketch=None):
    return [d.sign for d in assemble(stated(name, *assembly, sketch=sketch)).groups]


def mistakes(name, *assembly, sketch=None):
    with pytest.raises(ProblemError) as caught:
        signs(name, *assembly, sketch=sketch)
    return caught.value.problems


@pytest.mark.parametrize(
    ("name", "key", "choice", "sign"),
    [
        ("four_bar", "B", 1, 1), ("four_bar", "2-3", -1, -1), ("four_bar", "3-2", -1, -1),
        ("four_bar", "B", ("left", "A", "C"), 1), ("four_bar", "B", ("right", "A", "C"), -1),
        ("four_bar", "B", ("left", "C", "A"), -1), ("four_bar", "2-3", ("right", "C", "A"), 1),
        ("slider_crank", "B", 1 + 0j, 1), ("slider_crank", "B", -1 + 0j, -1), ("slider_crank", "B", -1, -1),
        ("slider_crank", "2-3", 1j, 1),  # the guide rises by 0.2 rad: up is ahead
        ("slotted_link", "k", -1, -1), ("slotted_link", "2-3", 1, 1),
    ],
)  # fmt: skip
def test_words_and_signs(name, key, choice, sign):
    assert signs(name, (key, choice)) == [sign]


@pytest.mark.parametrize(("name", "sign"), [root for root in ROOTED if root[0] != "compound"])
def test_sketch_finds_the_root_it_was_drawn_in(name, sign):
    """A sketch off by a few millimetres, drawn at some angle of the crank."""
    lk = linkage(SCHEMES[name](), sign)
    found = solve(lk, np.array([0.8]))
    random = np.random.default_rng(3)
    sketch = {
        p: complex(found.place(p)[0]) + complex(*random.normal(size=2)) * 2e-3 for p in found.point_index
    }
    assert signs(name, sketch=sketch) == [d.sign if d.two_roots else 1 for d in lk.groups]


def test_words_win_over_the_sketch():
    found = solve(linkage(SCHEMES["four_bar"](), 1), np.array([0.8]))
    sketch = {p: complex(found.place(p)[0]) for p in "AB"}
    assert signs("four_bar", ("B", -1), sketch=sketch) == [-1]


@pytest.mark.parametrize("name", [name for name, kinds in KINDS.items() if kinds[-1] <= 3])
def test_nothing_is_guessed(name):
    (problem,) = mistakes(name)
    assert "can be assembled in two ways" in problem.text()
    assert problem.right is not None


def test_one_root_needs_no_choice():
    assert signs("yoke") == [1]
    (problem,) = mistakes("yoke", ("2-3", 1))
    assert problem.path == ("mechanism", "assembly", "2-3")


@pytest.mark.parametrize(
    ("name", "key", "choice"),
    [
        ("four_bar", "B", 1 + 0j),  # left, right of what?
        ("four_bar", "B", ("left", "O", "C")),  # not the line of the dyad
        ("slider_crank", "B", 1j * np.exp(0.2j)),  # across the guide
        ("slider_crank", "B", ("left", "A", "O")),
        ("slotted_link", "k", 1 + 0j),
    ],
)
def test_unclear_choices(name, key, choice):
    (problem,) = mistakes(name, (key, choice))
    assert "does not tell apart" in problem.text()
    assert problem.right is not None


def test_all_mistakes_at_once():
    problems = mistakes("two_slots", ("D", 1), ("Z", 1))
    assert sorted(p.path[-1] for p in problems if len(p.path) == 3) == ["D", "Z"]
    assert sum("can be assembled in two ways" in p.text() for p in problems) == 1


def test_sketch_without_the_crank_says_so():
    (problem,) = mistakes("four_bar", sketch={"B": 0.1 + 0.1j})
    assert "no moving point of driving link 1" in problem.text()


def test_sketch_that_does_not_tell():
    """B sketched on the line A–C: both roots are as near."""
    found = solve(linkage(SCHEMES["four_bar"]()), np.array([0.8]))
    A, C = complex(found.place("A")[0]), complex(found.place("C")[0])
    foot = A + (C - A) * 0.5
    (problem,) = mistakes("four_bar", sketch={"A": A, "B": foot})
    assert "can be assembled in two ways" in problem.text()


def test_keys_name_joint_or_links():
    (d,) = linkage(SCHEMES["four_bar"]()).groups
    assert keys_of(d) == ["B", "2-3", "3-2"]


def test_a_guide_is_no_key_of_a_variant():
    (problem,) = mistakes("slotted_link")
    assert "(key 3-2)" in problem.text()


def test_sketch_in_which_a_dyad_does_not_close():
    """The crank pin alone is sketched where the rod cannot reach."""
    mechanism = SCHEMES["slider_crank"]()
    rod = mechanism.links["2"]
    short = dataclasses.replace(rod, points={name: at * 1e-3 for name, at in rod.points.items()})
    links = {**mechanism.links, "2": short}
    sketch = {"A": 1j}
    with pytest.raises(ProblemError) as caught:
        assemble(dataclasses.replace(mechanism, links=links, assembly=(), sketch=sketch))
    assert any("cannot be assembled in the position of the sketch" in p.text() for p in caught.value.problems)

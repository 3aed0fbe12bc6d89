"""Structure: pairs, mobility, Assur groups and what is refused."""

import pytest
from schemes import KINDS, SCHEMES, mechanism

from tmm_report.mechanics.lever import assur_groups
from tmm_report.mechanics.lever.assembly import stated as assembly
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide
from tmm_report.problems import ProblemError


def links(**points: str) -> list[Link]:
    """Links by the letters of their points, l2="AB"; places do not matter for the structure."""
    return [
        Link(name[1:], {p: complex(k, ord(p)) for k, p in enumerate(letters)})
        for name, letters in points.items()
    ]


def refusal(scheme: Mechanism, solve=assur_groups.decompose) -> str:
    with pytest.raises(ProblemError) as caught:
        solve(scheme)
    (problem,) = caught.value.problems
    assert problem.path[0] == "mechanism"
    return problem.text()


@pytest.mark.parametrize("name", SCHEMES)
def test_kinds_are_found(name):
    found = assur_groups.decompose(SCHEMES[name]())
    assert [group.kind for group in found.groups] == KINDS[name]
    assert (found.mechanism_class, assur_groups.mobility(found.mechanism)) == (2, 1)
    assert all((group.group_class, group.order, len(group.inner)) == (2, 2, 1) for group in found.groups)


def test_formula_in_the_order_of_assembly():
    # described backwards: the groups are still found from the driving link on
    base = links(l0="OCF", l5="EF", l4="DE", l3="CBD", l2="AB", l1="OA")
    found = assur_groups.decompose(mechanism(base))
    assert found.formula == "I(0,1) → II2(3,2) → II2(5,4)"


def test_three_links_at_a_point_are_two_pairs():
    base = links(l0="OC", l1="OA", l2="AB", l3="BC", l4="AD", l5="D")
    scheme = mechanism(base, [Guide("x", "0", 0j, 1 + 0j)], [Slide("5", "x")])
    assert assur_groups.count_pairs(scheme) == 7
    found = assur_groups.decompose(scheme)
    # both rods hang on the crank, which is known first
    at_a = [pair.links for pair in found.pairs if pair.name == "A"]
    assert at_a == [("1", "2"), ("1", "4")]
    assert [group.kind for group in found.groups] == [1, 2]
    assert len(found.pairs) == 7


def test_driving_link_alone():
    found = assur_groups.decompose(mechanism(links(l0="O", l1="OA")))
    assert (found.formula, found.mechanism_class, len(found.pairs)) == ("I(0,1)", 1, 1)


@pytest.mark.parametrize(
    ("base", "w", "words"),
    [
        (links(l0="OC", l1="OA", l2="AB", l3="CB", l4="AB"), 0, "1 constraint(s) too many"),  # a passive link
        (links(l0="OC", l1="OA", l2="AB", l3="BD", l4="DC"), 2, "1 link end(s) too free"),
        (links(l0="OC", l1="OA", l2="AB", l3="CB", l4="PQ"), 4, "3 link end(s) too free"),
        (links(l0="OC", l1="OC"), -1, "2 constraint(s) too many"),
    ],
)
def test_wrong_mobility(base, w, words):
    text = refusal(mechanism(base))
    assert f"= {w} " in text
    assert words in text


@pytest.mark.parametrize(
    ("base", "words"),
    [
        # a passive rod 4 along rod 2, and a pendulum 5 on the rocker
        (links(l0="OC", l1="OA", l2="AB", l3="CBE", l4="AB", l5="EP"), "links 4 have redundant constraints"),
        # the driving link is held at two points, and a chain of two links hangs on it
        (links(l0="OC", l1="OAC", l2="AB", l3="BD"), "links 1 have redundant constraints"),
    ],
)
def test_redundant_here_and_loose_there(base, words):
    """W = 1 by count, but one part is over-constrained and another is loose."""
    scheme = mechanism(base)
    assert assur_groups.mobility(scheme) == 1
    assert words in refusal(scheme)


def test_a_truss_that_floats_is_no_group():
    """Four links and six pairs among themselves: freedom 0 by count, and joined to nothing."""
    scheme = mechanism(links(l0="OC", l1="OA", l2="AB", l3="CB", l4="PQSV", l5="QRT", l6="RSU", l7="TUV"))
    assert assur_groups.mobility(scheme) == 1
    assert "links 4, 5, 6, 7 form no Assur group" in refusal(scheme)


def test_driving_link_must_be_pivoted_to_the_frame():
    base = links(l0="C", l1="OA", l2="AB", l3="CB")
    assert "driving link 1 is not pivoted" in refusal(mechanism(base))


def test_three_sliding_pairs_are_no_dyad():
    guides = [Guide("x", "0", 0j, 1 + 0j), Guide("y", "1", 0j, 1j), Guide("z", "2", 0j, 1 + 1j)]
    slides = [Slide("3", "x"), Slide("2", "y"), Slide("3", "z")]
    assert "form no dyad" in refusal(mechanism(links(l0="O", l1="OA", l2="P", l3="Q"), guides, slides))


def class_three() -> Mechanism:
    """A ternary link on three rods: to the crank and to two fixed pivots."""
    return mechanism(links(l0="OEG", l1="OA", l2="AB", l3="BDF", l4="DE", l5="FG"))


def class_four() -> Mechanism:
    """A press with two rods: the closed contour 2-3-5-4 has four sides."""
    base = links(l0="O", l1="OB", l2="BCE", l3="CD", l4="EF", l5="DF")
    return mechanism(base, [Guide("y", "0", 0j, 1j)], [Slide("5", "y")])


@pytest.mark.parametrize(("scheme", "name"), [(class_three(), "III"), (class_four(), "IV")])
def test_higher_classes_are_recognised_and_want_a_sketch(scheme, name):
    (group,) = assur_groups.decompose(scheme).groups
    assert (assur_groups.ROMAN[group.group_class], group.links, group.kind) == (
        name,
        ("2", "3", "4", "5"),
        None,
    )
    text = refusal(scheme, assembly.assemble)
    assert f"of class {name} can be assembled in several ways, and only a sketch says in which" in text


def test_class_depends_on_the_driving_link():
    """The class III chain driven from a rod of its own is of class II."""
    scheme = class_three()
    driven = Mechanism(scheme.links, Driver("4", 1.0))
    found = assur_groups.decompose(driven)
    assert found.mechanism_class == 2
    assert found.formula == "I(0,4) → II2(3,5) → II2(1,2)"

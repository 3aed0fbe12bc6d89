"""A linkage written as straight lines of numpy gives what the general solver gives, to the last bit."""

import math
import pickle
import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import tmm_report
from tmm_report.mechanics.calculus.variants import together
from tmm_report.mechanics.lever import assur_groups, motion
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces.tape.tape import Tape, Untraceable
from tmm_report.mechanics.lever.many.blocks import blocks
from tmm_report.mechanics.lever.many.compiled import straight
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide
from tmm_report.mechanics.lever.meeting import settle

VARIANTS = sorted((Path(__file__).parents[3] / "variants").rglob("*.yaml"))
TURN = np.linspace(-7.0, 7.0, 41)


def bits(x):
    return np.ascontiguousarray(x).tobytes()


def all_numbers(linkage, phi):
    """Every number that a motion and its forces under weight and inertia have, by name."""
    with np.errstate(all="ignore"):
        found = motion.solve(linkage, phi)
        loads = statics.inertia_and_gravity(found, -9.81j)
        last = list(loads)[-1]
        loads[last] = statics.Load(loads[last].force + np.cos(phi), loads[last].moment - 0.3)
        forces = statics.solve(found, loads)
    numbers = {}
    for point in linkage.arms:
        rates = found.place(point), found.velocity(point), found.acceleration(point)
        numbers |= {(n, point): x for n, x in enumerate(rates)}
    for link in linkage.mechanism.links:
        numbers |= {("turn", link): found.turn(link), ("omega", link): found.angular_velocity(link)}
        numbers["eps", link] = found.angular_acceleration(link)
    numbers |= {("sine", key): x for key, x in found.sines.items()}
    for key, r in forces.reactions.items():
        numbers |= {(key, part): getattr(r, part) for part in ("force", "moment", "at")}
        if r.along is not None:
            numbers[key, "along"] = r.along
    s = found.state  # asked for last: from then on it is what all else is taken from
    numbers |= {
        (field, link): x
        for field in ("o", "r", "u", "v", "w", "a", "e", "iw", "ie")
        for link, x in getattr(s, field).items()
    }
    return numbers | {"balancing": forces.balancing, "closes": found.closes}


def differing(linkage, phi):
    compiled = straight(linkage)
    assert compiled.straight is not None
    one, other = all_numbers(linkage, phi), all_numbers(compiled, phi)
    assert one.keys() == other.keys()
    return [name for name in one if bits(one[name]) != bits(other[name])]


@pytest.mark.parametrize("path", VARIANTS, ids=lambda path: path.stem)
def test_every_ready_variant_of_dyads_to_the_last_bit(path):
    lever = tmm_report.load(path).lever
    if lever is None:
        pytest.skip("no lever mechanism")
    found = assur_groups.decompose(lever.mechanism)
    if any(group.group_class > 2 for group in found.groups):
        pytest.skip("a group above class II")
    for sign in (1, -1):
        linkage = motion.linkage_of(found, [sign] * len(found.groups))
        assert differing(linkage, TURN) == []


def crank(second, crank_length=0.1, axis=0j, omega=-4.0, slide=()):
    """A crank, and what is hung on its pin A; the frame has O and C."""
    links = [
        Link("0", {"O": 0j, "C": axis}),
        Link("1", {"O": 0j, "A": crank_length, "S": 0.3j * crank_length}, 1.3, "S", 0.02),
        *second,
    ]
    guides = {"x": Guide("x", "0", 0.01j, np.exp(0.2j))}
    return Mechanism({link.name: link for link in links}, Driver("1", omega), guides, slide)


def four_bar(crank_length, coupler, rocker, frame):
    mechanism = crank(
        [
            Link("2", {"A": 0j, "B": coupler, "S2": coupler * (0.4 + 0.1j)}, 2.0, "S2", 0.01),
            Link("3", {"B": rocker, "C": 0j, "S3": rocker * 0.5}, 1.0, "S3", 0.03),
        ],
        crank_length,
        frame,
    )
    return motion.linkage_of(assur_groups.decompose(mechanism), [1])


def slider(crank_length, rod):
    mechanism = crank(
        [Link("2", {"A": 0j, "B": rod, "S2": 0.3 * rod}, 2.0, "S2", 0.01), Link("3", {"B": 0j}, 1.0, "B")],
        crank_length,
        slide=[Slide("3", "x", 0j, 1 + 0j)],
    )
    return motion.linkage_of(assur_groups.decompose(mechanism), [1])


lengths = st.floats(0.05, 2.0)


@settings(max_examples=25, deadline=None)
@given(lengths, lengths, lengths, lengths)
def test_any_lengths_whether_it_closes_or_not(r, l2, l3, frame):
    assert differing(four_bar(r, l2, l3, frame), TURN) == []
    assert differing(slider(r, l2), TURN) == []


def test_a_singular_position_and_one_that_does_not_close():
    flat = four_bar(0.125, 0.25, 0.25, 0.375)  # stretched at 180°: crank, coupler and rocker in one line
    angles = math.pi - np.array([4e-7, 3e-7, 2e-7, 1e-7, 0.0, 1.0])
    assert (motion.solve(flat, angles).sines.popitem()[1] <= motion.SINGULAR).any()
    assert differing(flat, angles) == []
    short = slider(0.5, 0.2)
    assert not motion.solve(short, TURN).closes.all()
    assert differing(short, TURN) == []


def test_a_dyad_that_passes_its_change_points():
    linkage = four_bar(0.1, 0.3, 0.1, 0.3)
    group = linkage.groups[0]
    assert isinstance(group, Dyad)
    for change in (
        replace(group, changes=(0.0, math.pi), told_at=0.5),
        replace(group, corner=math.pi),
    ):
        assert differing(replace(linkage, groups=(change,)), np.append(TURN, [0.0, math.pi])) == []


def test_lengths_of_many_variants_at_once():
    some = np.random.default_rng(3).uniform(0.9, 1.1, (4, 7, 1))
    linkage = four_bar(*(a * x for a, x in zip((0.1, 0.3, 0.25, 0.28), some, strict=True)))
    assert linkage.axes == (7, 1)
    assert differing(linkage, TURN) == []


@pytest.mark.parametrize("size", [1, 100, 200])
def test_blocks_of_variants_are_the_whole_cut_up(size):
    some = np.random.default_rng(3).uniform(0.9, 1.1, (4, 7, 1))
    linkage = four_bar(*(a * x for a, x in zip((0.1, 0.3, 0.25, 0.28), some, strict=True)))
    whole = motion.solve(linkage, TURN)
    balancing = statics.solve(whole, statics.inertia_and_gravity(whole, -9.81j)).balancing
    for scheme in (linkage, straight(linkage)):
        seen = []
        for part, found in blocks(scheme, TURN, size):
            forces = statics.solve(found, statics.inertia_and_gravity(found, -9.81j))
            assert bits(found.acceleration("B")) == bits(whole.acceleration("B")[part])
            assert bits(forces.balancing) == bits(balancing[part])
            seen += range(7)[part]
        assert seen == list(range(7))


def test_blocks_of_positions_of_one_variant():
    linkage = straight(four_bar(0.1, 0.3, 0.25, 0.28))
    whole = motion.solve(linkage, TURN).velocity("B")
    parts = [found.velocity("B") for _, found in blocks(linkage, TURN, 8)]
    assert [len(x) for x in parts] == [8, 8, 8, 8, 8, 1]
    assert bits(np.concatenate(parts)) == bits(whole)


def test_another_speed_and_a_single_angle_go_the_general_way():
    linkage = four_bar(0.1, 0.3, 0.25, 0.28)
    compiled = straight(linkage)
    fast = motion.solve(compiled, TURN, 9.0)
    assert bits(fast.velocity("B")) == bits(motion.solve(linkage, TURN, 9.0).velocity("B"))
    assert motion.solve(compiled, 0.4).place("B") == motion.solve(linkage, 0.4).place("B")


def test_a_linkage_altered_after_it_was_compiled_goes_the_general_way():
    """Another assembly of the same lengths: the straight lines are those of the first."""
    linkage = four_bar(0.1, 0.3, 0.25, 0.28)
    other = motion.linkage_of(linkage.structure, [-1])
    mixed = replace(straight(linkage), groups=other.groups)
    place = bits(motion.solve(mixed, TURN).place("B"))
    assert place == bits(motion.solve(other, TURN).place("B"))
    assert place != bits(motion.solve(linkage, TURN).place("B"))


def test_limits_put_into_the_state_of_a_change_point_count():
    """A parallelogram: in its change points rates are limits of those beside, and so are the forces."""
    linkage = four_bar(0.1, 0.3, 0.1, 0.3)
    group = replace(linkage.groups[0], changes=(0.0, math.pi), told_at=0.5, sense=-1)
    linkage = replace(linkage, groups=(group,))
    angles = np.array([0.0, 1.0, math.pi])
    one, other = (motion.solve(scheme, angles) for scheme in (linkage, straight(linkage)))
    for found in (one, other):
        assert not settle(found).any()
    assert bits(other.velocity("B")) == bits(one.velocity("B"))
    assert [*map(bits, other.sines.values())] == [*map(bits, one.sines.values())]
    loads, others = (statics.inertia_and_gravity(found, -9.81j) for found in (one, other))
    assert all(bits(loads[link].force) == bits(others[link].force) for link in loads)


def test_it_goes_to_another_process_after_use_and_serves_threads_at_once():
    linkage = straight(four_bar(0.1, 0.3, 0.25, 0.28))
    angles = [TURN + k for k in range(16)]
    alone = [bits(motion.solve(linkage, phi).acceleration("B")) for phi in angles]
    sent = pickle.loads(pickle.dumps(linkage))
    assert sent.straight.serves(sent)
    assert [bits(motion.solve(sent, phi).acceleration("B")) for phi in angles] == alone
    with ThreadPoolExecutor(4) as pool:
        found = pool.map(lambda phi: bits(motion.solve(linkage, phi).acceleration("B")), angles)
        assert list(found) == alone


def test_a_cam_and_its_follower_stay_as_they_are():
    path = next(path for path in VARIANTS if path.stem == "cam_press")
    linkage = assemble(tmm_report.load(path).lever.mechanism)
    assert straight(linkage) is linkage


def test_loads_of_plain_numbers_without_inertia():
    linkage = slider(0.1, 0.3)
    loads = {link: statics.Load(3.1 - 0.7j, 0.3) for link in ("1", "2", "3")}
    one, other = (statics.solve(motion.solve(scheme, TURN), loads) for scheme in (linkage, straight(linkage)))
    assert bits(one.balancing) == bits(other.balancing)
    for key, r in one.reactions.items():
        assert bits(r.force) == bits(other.reactions[key].force)
        assert bits(r.moment) == bits(other.reactions[key].moment)


def test_one_text_serves_a_topology_and_names_nothing_of_the_variant():
    first, second = straight(four_bar(0.1, 0.3, 0.25, 0.28)), straight(four_bar(0.11, 0.32, 0.26, 0.3))
    text = first.straight.written.text
    assert text == second.straight.written.text
    words = set(re.findall(r"[A-Za-z_]\w*", text)) - {"def", "del", "motion", "loads", "sines", "forces"}
    numpy = {"np", "exp", "divide", "absolute", "sqrt", "conjugate", "imag", "real", "where", "maximum"}
    assert {word for word in words - numpy if not re.fullmatch(r"[xp]\d+|[pv]", word)} == set()


def test_a_stack_and_a_group_above_class_two_stay_as_they_are():
    linkage = four_bar(0.1, 0.3, 0.25, 0.28)
    stack = motion.linkage_of(together([linkage.structure, four_bar(0.11, 0.3, 0.25, 0.28).structure]), [1])
    assert straight(stack) is stack
    press = tmm_report.load(next(path for path in VARIANTS if path.stem == "press")).lever
    assert press is not None
    found = assur_groups.decompose(press.mechanism)
    assert any(group.group_class > 2 for group in found.groups)


def test_what_depends_on_values_is_refused():
    mark = Tape().given()
    with pytest.raises(Untraceable):
        bool(mark > 0)
    with pytest.raises(Untraceable):
        np.sum(mark)


def test_lengths_that_differ_in_the_last_bit_are_two():
    assert differing(slider(1.0, 1.0), TURN) == []
    assert differing(four_bar(1.0, 1.0, 1.0, 1.9999999999999998), TURN) == []


def test_an_equal_line_is_written_once_and_signs_of_zero_are_kept():
    tape = Tape()
    x = tape.given()
    assert (x * 2.0).line is (x * 2.0).line
    vector = 1j * x
    assert (vector - 0.0).line is vector.line
    assert (vector - -0.0).line is not vector.line  # −0 becomes 0
    turned = -x
    assert (-turned).line is x.line
    assert (0.0 + x).line is not x.line  # −0 becomes 0

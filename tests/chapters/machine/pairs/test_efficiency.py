"""Machines joined in a tree: products and shares, powers, derivatives, by two ways each."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from conftest import solved
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import course, loading
from tmm_report.chapters.machine.efficiency import quantities, solve
from tmm_report.chapters.machine.efficiency.draw import scheme
from tmm_report.chapters.machine.efficiency.given import Given, Joined, Module, modules
from tmm_report.figures.drawing import Item, Path
from tmm_report.figures.sheets.block import block
from tmm_report.mechanics.pairs import efficiency_chains
from tmm_report.problems import ProblemError

ETA = st.floats(0.05, 0.99)


def shared(parts):
    """The parts with random shares that add up to 1."""
    return st.lists(st.floats(0.1, 1.0), min_size=len(parts), max_size=len(parts)).map(
        lambda weights: tuple(replace(p, share=w / sum(weights)) for p, w in zip(parts, weights, strict=True))
    )


def groups(parts):
    """Of parts: in series, or side by side by shares of the input or of the output."""
    some = st.lists(parts, min_size=2, max_size=3).map(tuple)
    series = some.map(lambda found: Joined("series", found))
    parallel = st.builds(
        lambda found, by: Joined("parallel", found, by=by),
        some.flatmap(shared),
        st.sampled_from(["input", "output"]),
    )
    return series | parallel


TREES = groups(st.recursive(ETA.map(Module), groups, max_leaves=6))


def stated(text: str) -> solve.Found:
    found = course.solve(loading.loads(f"language: en\nefficiency: {text}\n")).efficiency
    assert found is not None
    return found


# ---------------------------------------------------------------- closed answers


def test_a_chain_is_the_product_and_worse_than_its_worst_module():
    found = stated("{series: [{efficiency: 0.9}, {efficiency: 0.8}, {efficiency: 0.95}]}")
    assert found.whole.efficiency == pytest.approx(0.9 * 0.8 * 0.95)
    assert found.whole.efficiency < found.worst.efficiency == 0.8
    assert found.first is found.worst  # ∂η/∂η_i = η/η_i is greatest for the least
    assert [part.slope for part in found.modules] == pytest.approx([0.76, 0.855, 0.72])


def test_shares_of_the_input_weigh_the_efficiencies():
    found = stated("{parallel: [{share: 0.6, efficiency: 0.8}, {share: 0.4, efficiency: 0.5}]}")
    assert found.whole.efficiency == pytest.approx(0.68)
    assert [part.slope for part in found.modules] == [0.6, 0.4]


def test_shares_of_the_output_weigh_what_is_needed():
    """Of 1 kW, 0.6 come through 0.8 and 0.4 through 0.5: 0.75 + 0.8 kW go in."""
    found = stated(
        "{output: 1 kW, parallel: [{output_share: 0.6, efficiency: 0.8}, {output_share: 0.4, efficiency: 0.5}]}"
    )
    assert found.whole.power == pytest.approx((1550, 1000))
    assert [part.power[0] for part in found.modules] == pytest.approx([750, 800])
    assert [part.power[1] for part in found.modules] == pytest.approx([600, 400])


def test_one_tree_by_hand():
    found = stated(
        "{input: 10 kW, series: [{name: motor, efficiency: 0.92}, {parallel: [{share: 0.6, efficiency: 0.8}, "
        "{share: 0.4, series: [{efficiency: 0.9}, {efficiency: 0.7}]}]}]}"
    )
    assert found.whole.efficiency == pytest.approx(0.92 * (0.6 * 0.8 + 0.4 * 0.9 * 0.7))
    assert [part.index for part in found.whole.within()] == ["", "1", "A", "2", "B", "3", "4"]
    assert found.modules[3].power[0] == pytest.approx(10e3 * 0.92 * 0.4 * 0.9)
    assert found.modules[2].slope == pytest.approx(0.92 * 0.4 * 0.7)


def test_equal_parts_side_by_side_are_as_good_as_one():
    for key in ("share", "output_share"):
        branch = f"{{{key}: 0.5, efficiency: 0.83}}"
        assert stated(f"{{parallel: [{branch}, {branch}]}}").whole.efficiency == pytest.approx(0.83)


# ---------------------------------------------------------------- two ways


@pytest.mark.exhaustive
@settings(max_examples=30)
@given(TREES)
def test_what_the_modules_lose_is_what_the_whole_loses(tree):
    found = solve.solve(Given(tree, input=1000.0), None)
    assert found.s.number("efficiency_imbalance") < 1e-12
    for part in found.whole.within():
        if part.parts and part.node.kind == "parallel":
            assert math.fsum(one.power[0] for one in part.parts) == pytest.approx(part.power[0])
            least, most = (pick(one.efficiency for one in part.parts) for pick in (min, max))
            assert least - 1e-12 <= part.efficiency <= most + 1e-12
        if part.parts:
            assert math.fsum(
                one.power[1] for one in (part.parts if part.node.kind == "parallel" else part.parts[-1:])
            ) == pytest.approx(part.power[1])


@settings(max_examples=30)
@given(TREES, st.integers(0, 20))
def test_derivatives_by_differences(tree, pick):
    count = len(list(modules(tree)))
    k, step = pick % count, 1e-6

    def whole(off: float) -> float:
        return solve.efficiency(changed(tree, k, off)[0])

    slope = (whole(step) - whole(-step)) / (2 * step)
    assert solve.solve(Given(tree), None).modules[k].slope == pytest.approx(slope, rel=1e-4, abs=1e-9)


def changed(node, k: int, off: float):
    """The tree whose module k is better by `off`, and how many modules were passed."""
    if isinstance(node, Module):
        return (replace(node, efficiency=node.efficiency + off) if k == 0 else node), 1
    parts, seen = [], 0
    for part in node.parts:
        other, count = changed(part, k - seen, off)
        parts.append(other)
        seen += count
    return replace(node, parts=tuple(parts)), seen


@settings(max_examples=15)
@given(TREES)
def test_the_output_stated_is_the_output_found(tree):
    found = solve.solve(Given(tree, output=777.0), None)
    assert found.whole.power[1] == pytest.approx(777.0)
    assert found.whole.power[0] == pytest.approx(777.0 / found.whole.efficiency)


def test_shares_of_input_and_output_say_the_same():
    outputs, etas = [0.7, 0.3], [0.85, 0.6]
    shares = efficiency_chains.input_shares(outputs, etas)
    assert sum(shares) == pytest.approx(1)
    assert efficiency_chains.by_input(shares, etas) == pytest.approx(
        efficiency_chains.by_output(outputs, etas)
    )


def boxes_of(items: Iterable[Item]) -> list[tuple[complex, ...]]:
    """Corners of the modules; the frames of groups are dashed."""
    closed = [item for item in items if isinstance(item, Path) and item.closed]
    return [item.strokes[0] for item in closed if item.pen and not item.pen.dash]


@settings(max_examples=15)
@given(TREES)
def test_no_boxes_of_the_scheme_overlap(tree):
    drawn = scheme(solve.solve(Given(tree), None), str)
    boxes = boxes_of(drawn.items)
    assert len(boxes) == len(list(modules(tree)))
    frames = [(min(z.real for z in b), min(z.imag for z in b), b) for b in boxes]
    for i, (x, y, _) in enumerate(frames):
        assert not [1 for u, v, _ in frames[i + 1 :] if abs(x - u) < 17 and abs(y - v) < 10]


def test_a_long_chain_is_folded_into_rows_that_fit_the_page():
    """18 modules in rows of six: each box once, in its order, and the arrows lead from the left to the right."""
    drawn = scheme(stated(f"{{series: [{', '.join(18 * ['{efficiency: 0.9}'])}]}}"), str)
    boxes = boxes_of(drawn.items)
    left = [(min(z.real for z in box), round(max(z.imag for z in box), 6)) for box in boxes]
    heights = sorted({y for _, y in left}, reverse=True)
    assert left == sorted(left, key=lambda at: (-at[1], at[0])) and len(set(left)) == 18
    assert len(heights) == 3 and drawn.size[0] < 165
    assert all(a - b >= 15 for a, b in pairwise(heights))


# ---------------------------------------------------------------- what cannot be


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{series: [{efficiency: 1}]}", "every machine loses some power"),
        ("{series: [{efficiency: 0}]}", "more than 0 and less than 1"),
        ("{series: [{efficiency: 0.9, share: 0.5}]}", "it has no share"),
        ("{parallel: [{efficiency: 0.9, share: 0.5}, {efficiency: 0.9, share: 0.4}]}", "add up to 0.9"),
        ("{parallel: [{efficiency: 0.9, share: 0.5}, {efficiency: 0.9}, {efficiency: 0.8}]}", "parts has a share"),
        ("{parallel: [{efficiency: 0.9, share: 0.5}, {efficiency: 0.9, output_share: 0.5}]}", "has a share|are mixed"),
        ("{input: 1 kW}", "joined in series or in parallel"),
        ("{input: 1 kW, output: 1 kW, series: [{efficiency: 0.9}]}", "the other follows from the efficiency"),
        ("{series: [{}]}", "the key efficiency is missing"),
        ("{series: [chain]}", "keys with values are expected here"),
        ("{series: [{series: [[0.9]]}]}", "keys with values are expected here"),
        (f"{{series: [{', '.join(25 * ['{efficiency: 0.9}'])}]}}", "24 machines at most"),
        ("{parallel: [{efficiency: 0.9}]}", "too few values"),
        ("{series: [{efficiency: 0.9, parallel: []}]}", "unknown key efficiency|too few values"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_told_with_its_reason(text, said):
    with pytest.raises(ProblemError, match=said):
        stated(text)


def test_the_summary_names_the_whole_and_the_module_to_improve():
    (line,) = stated("{series: [{name: motor, efficiency: 0.9}, {efficiency: 0.95}]}").summary()
    assert "0.855;" in str(line) and "motor" in str(line)


def test_of_equal_modules_the_first_is_named():
    """Products in another order differ by rounding: it must not choose."""
    found = stated(f"{{series: [{', '.join(18 * ['{efficiency: 0.9}'])}]}}")
    assert (found.first.index, found.greatest.index, found.worst.index) == ("1", "1", "1")
    assert len({part.slope for part in found.modules}) > 1


def test_the_worst_module_may_have_more_power_than_the_one_to_improve():
    """Then what follows it loses so much that its improvement brings less: nothing is said of the power through it."""
    found = stated(
        "{parallel: [{share: 0.6, series: [{efficiency: 0.35}, {efficiency: 0.4}]}, {share: 0.4, efficiency: 0.9}]}"
    )
    assert found.worst.index == "1" and found.first.index == "3"
    assert found.worst.power[0] > found.first.power[0] and found.worst.slope < found.first.slope


# ---------------------------------------------------------------- what the results say


def test_the_table_of_the_parts_holds_together():
    """ψ = 1 − η, P' = η P, the loss is their difference; of a chain the input of each is the output before it."""
    found = stated(
        "{input: 10 kW, series: [{efficiency: 0.92}, {parallel: [{share: 0.6, efficiency: 0.8}, "
        "{share: 0.4, efficiency: 0.7}]}, {efficiency: 0.9}]}"
    )
    (table,) = quantities.tables(found)
    eta, psi, into, out, lost = (table[key].numbers() for key in ("eta", "psi", "P_in", "P_out", "P_lost"))
    np.testing.assert_allclose(psi, 1 - eta)
    np.testing.assert_allclose(out, eta * into)
    np.testing.assert_allclose(lost, into - out)
    assert list(table["index"].values) == ["", "1", "A", "2", "3", "4"]
    assert into[0] == 10e3 and into[2] == out[1] and into[5] == out[2]
    assert into[3] + into[4] == pytest.approx(into[2])
    assert [str(table["eta"].symbol(row)) for row in range(3)] == ["eta", "eta_1", "eta_A"]


def test_on_a_sheet_each_module_holds_its_number_and_its_efficiency():
    """Written anew in the letters of a sheet: a value beside its box would be read as another's."""
    sheet = block(scheme(solved("machine_train").efficiency, str), (), 1.5)
    boxes = boxes_of(sheet.items)
    assert len(boxes) == 8
    for box in boxes:
        low, high = (complex(of(z.real for z in box), of(z.imag for z in box)) for of in (min, max))
        held = [one for one in sheet.letters if low.real < one.box[0] and one.box[2] < high.real]
        assert len([one for one in held if low.imag < one.box[1] and one.box[3] < high.imag]) == 2

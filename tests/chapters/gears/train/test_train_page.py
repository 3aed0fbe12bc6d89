"""The page of a compound train: words beside numbers, formulas in letters, arrows and diagrams, by second ways."""

import math

import pytest
from note import read
from notes import render
from test_train import (
    AXLE,
    CLOSED,
    ONE_CROWN,
    PLAIN,
    RING_DRIVES,
    SUNS,
    THREE_SETS,
    TWO_INPUTS,
    found,
    results,
)

from tmm_report.chapters.gears.train.draw.diagrams import _angular, _Linear
from tmm_report.chapters.gears.train.draw.scheme import Scheme
from tmm_report.chapters.gears.train.quantities import tables
from tmm_report.chapters.gears.train.steps import whole
from tmm_report.figures.drawing import Arrow
from tmm_report.figures.primitives import Path

LOSSES = {"external": 0.98, "internal": 0.99, "bevel": 0.97}


def note(stated, **changes):
    return read(render(results(stated, **changes), "html")["note.html"].decode())


def table(page, caption):
    """Heads, and rows of texts."""
    one = next(one for one in page.tables if caption in one.caption)
    return [head.text for head in one.heads], [[cell.text for cell in row] for row in one.rows]


def test_words_of_the_conditions_are_those_of_their_numbers():
    page = note({**CLOSED, "wheels": {**CLOSED["wheels"], "2": 35, "3": 88}})
    _, rows = table(page, "Condition of assembly")
    assert {row[3] for row in rows} == {"whole", "not whole"}
    for row in rows:
        assert (row[3] == "whole") == (float(row[2]) % 1 == 0)
    _, rows = table(page, "Condition of neighbourhood")
    assert {row[3] for row in rows} == {"free", "they touch"}
    for row in rows:
        assert (row[3] == "they touch") == row[2].startswith("−")


def test_distances_stand_beside_their_meshes():
    """Of one crown between two rings whose teeth differ: the second one is opened by shift."""
    made = {one.name: one for one in tables(found(ONE_CROWN, module="2 mm"))}["train_distances"]
    place = made["other"].values.index("g-e")
    assert made["mesh"].values[place] == "a-g" and made["a"].values[place] == pytest.approx(0.031)
    assert made["a_other"].values[place] == pytest.approx(0.033)
    assert made["gap"].values[place] == pytest.approx(2)


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        ({}, "No module is stated: the distances are those of a module of 1 mm."),
        (
            {"modules": {"a": "3 mm", "p": "3 mm", "b": "3 mm"}},
            "The module of wheels a′, b′, c, f, q, r is not stated",
        ),
        ({"module": "2 mm"}, None),
    ],
    ids=["none", "of one set", "of all"],
)
def test_the_note_says_which_modules_are_not_stated(stated, said):
    text = next(line for line in note(THREE_SETS, **stated).words if "The distances are compared" in line)
    assert (said in text.replace("'", "′")) if said else "odule" not in text


def test_the_heads_of_speeds_and_powers_are_of_what_stands_below():
    page = note(PLAIN, efficiency=LOSSES, torque="10 N*m")
    heads, rows = table(page, "Speeds of all the members")
    assert heads[1].startswith("ω") and heads[1].endswith("rad/s") and heads[2].startswith("n")
    assert float(rows[0][2]) == pytest.approx(900)
    heads, rows = table(page, "Flow of the power through the meshes")
    assert heads[4].startswith("Nfr") and float(rows[0][4]) == pytest.approx(
        0.02 * float(rows[0][3]), rel=1e-3
    )


def test_members_of_one_shaft_are_named_beside_it():
    _, rows = table(note(CLOSED), "Members of the gear train")
    beside = {row[0]: row[3] for row in rows}
    assert (beside["3"], beside["3'"], beside["5"], beside["H"], beside["1"]) == ("3'", "3", "H", "5", "—")


def test_what_drives_and_what_is_held_is_said():
    words = " ".join(note(RING_DRIVES).words)
    assert "Driven: 3; power is taken from: C. Held: 1, 4." in words


def test_other_motions_are_those_of_their_known_speeds():
    """Each row by Willis from the speeds that the list before it names."""
    cases = [{"1": "900 rpm", "5": "0 rpm"}, {"3": "100 rpm", "5": "40 rpm"}]
    page = note(AXLE, cases=cases)
    said = " ".join(one.text.replace(" ", "") for one in page.formulas if "rpm" in one.text)
    assert "n1=900rpm n5=0rpm n3=100rpm n5=40rpm" in said
    _, rows = table(page, "Speeds in the other motions")
    for number in ("1", "2"):
        n = {row[1]: float(row[3].replace("−", "-")) for row in rows if row[0] == number}
        assert n["3"] + n["5"] == pytest.approx(2 * n["H"], rel=1e-3)
        assert n["1"] * 11 == pytest.approx(n["H"] * 43, rel=1e-3)
    for row in rows:
        omega, turns = (float(one.replace("−", "-")) for one in row[2:])
        assert omega == pytest.approx(turns * math.pi / 30, rel=1e-3)
    assert float(rows[0][3]) == 900


def test_shares_with_losses_stand_under_their_head():
    of = found(CLOSED, efficiency=LOSSES, torque="10 N*m")
    heads, rows = table(note(CLOSED, efficiency=LOSSES, torque="10 N*m"), "Shares of the power")
    assert heads[2:] == ["Share without losses", "Share with losses"]
    for row, branch in zip(rows, whole(of).branches.values(), strict=True):
        printed = [float(one.replace("−", "-")) for one in row[2:]]
        assert printed == pytest.approx([branch["share_0"].value, branch["share"].value], rel=1e-4)
        assert printed[0] != printed[1]


def test_the_formulas_in_letters_are_those_of_the_wheels():
    """Distances by sum or difference, the number of assembly by the sense of the row, Willis with both differences."""
    said = {one.text for one in note(PLAIN).maths}
    assert {"a1,2 = m·(z1+z2)2", "a2,3 = m·(z3−z2)2", "u13(H) = ω1−ωHω3−ωH"} <= said
    assert "C = |z2·z1+z3·z2|k·D" in said  # of unlike senses
    assert "C = |zB·zD−zA·zC|k·D" in {one.text for one in note(SUNS).maths}  # of the same sense


def test_the_search_counts_by_reason_and_deviates_from_what_is_wanted():
    ranges = {"1": [17, 24], "2": [20, 40], "3": [60, 100]}
    of = found(PLAIN, wheels=ranges, find={"ratio": 5.07, "tolerance": "2 %"}, satellites=3)
    made = {one.name: one for one in tables(of)}
    reasons = dict(
        zip(made["train_rejected"]["reason"].values, made["train_rejected"]["count"].values, strict=True)
    )
    assert reasons == {reason.name.lower(): count for reason, count in of.sought.candidates.counts.items()}
    solutions = made["train_solutions"]
    for u, miss in zip(solutions["u"].values, solutions["delta_u"].values, strict=True):
        assert miss == pytest.approx(100 * (u - 5.07) / 5.07)


def test_the_force_in_a_mesh_is_that_of_either_wheel():
    """Two wheels of unlike size: the torque on the driving one, and on the driven one, by its own radius."""
    plain = {"wheels": {"1": 20, "2": 50}, "meshes": ["1-2"], "input": "1", "output": "2"}
    of = found(plain, torque="6 N*m", module="3 mm")
    force = whole(of).meshes[0]["F_t"].value
    assert force == pytest.approx(6 / 0.030) and force == pytest.approx(15 / 0.075)


@pytest.mark.parametrize("stated", [CLOSED, TWO_INPUTS], ids=["closed", "two inputs"])
def test_the_diagrams_lie_as_the_velocities_do(stated):
    of = found(stated)
    linear = _Linear(of, of.plans, zero=7.0)
    arrows = [one for one in linear.items() if isinstance(one, Arrow)]
    arrows.remove(max(arrows, key=lambda one: one.start.imag))  # of the axis
    drawn = sorted(((one.end - one.start).real, one.start.imag) for one in arrows)
    scales = of.plans.velocity, of.plans.length
    wanted = sorted((spot.v / scales[0], spot.y / scales[1]) for spot in of.plans.spots)
    seen = [one for one in wanted if abs(one[0]) > 0.05]
    assert sum(drawn, ()) == pytest.approx(sum(seen, ()))
    origin = 3 + 2j
    items, _ = _angular(of, of.plans, origin)
    pole = origin - 1j * of.plans.pole
    strokes = [one.strokes[0] for one in items if isinstance(one, Path)]
    rays = [end - origin for start, end in (stroke for stroke in strokes if stroke[0] == pole)]
    turned = [of.speed[body] / of.plans.angular for body in of.train.bodies]
    assert sorted(ray.real for ray in rays) == pytest.approx(sorted([0.0, *filter(None, turned)]))
    assert all(abs(ray.imag) < 1e-9 for ray in rays)


def test_arrows_lead_in_and_out_and_the_frame_holds_what_is_held():
    drawn = Scheme(found(PLAIN))
    arrows = [one for one in drawn._ends()[0] if isinstance(one, Arrow)]
    middle = complex((drawn.left + drawn.right) / 2, 0)
    into = [abs(one.end - middle) < abs(one.start - middle) for one in arrows]
    sides = [one.start.real < middle.real for one in arrows]
    assert sorted(zip(sides, into, strict=True)) == [
        (False, False),
        (True, True),
    ]  # in at the left, out at the right
    free = [one for one in Scheme(found(CLOSED))._ends()[0] if not isinstance(one, Arrow)]
    held = [one for one in Scheme(found(SUNS))._ends()[0] if not isinstance(one, Arrow)]
    assert not free and held

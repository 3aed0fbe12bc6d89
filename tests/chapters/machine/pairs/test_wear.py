"""Wear: volume by the law as a whole, the limit of no skew, sums written out point by point, the worn slider, pivots by
a second way, life, and what cannot be."""

import math
import re

import numpy as np
import pytest
from conftest import examples, solved
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import VARIANTS

from tmm_report import course, loading, note
from tmm_report.chapters.lever.kinetostatics.solve.positions import at, stated
from tmm_report.chapters.machine.wear import quantities
from tmm_report.chapters.machine.wear.given import Coefficient
from tmm_report.i18n import Translator
from tmm_report.mechanics.pairs import wear
from tmm_report.problems import ProblemError

TEXT = VARIANTS.joinpath("forging_machine_wear.yaml").read_text(encoding="utf-8")
PUMP = VARIANTS.joinpath("slider_crank_offset.yaml").read_text(encoding="utf-8")
OWN = "wear:\n  guides:\n    - {guide: x, length: 90 mm, width: 40 mm, cycles: 1e6, coefficient: 1e-15}\n"


def of(text: str):
    return course.solve(loading.loads(text)).wear


def written(block: str, text: str = PUMP):
    return of(text.split("\nbalancing:")[0] + "\n" + block)


@pytest.fixture(scope="module")
def forged():
    return solved("forging_machine_wear").wear


# --- guides


def test_volume_is_the_coefficient_by_the_reaction_by_the_path(forged):
    """On slider and guide alike, the couple on two halves; ∫R|ds| by the trapezoid over the same positions."""
    found = forged.guides[0]
    cycles, path = found.given.cycles, found.path
    couple = np.abs(found.moment) / (2 * found.given.length / 3)
    for side in ("guide", "slider"):
        for face, pressed in (("lower", found.force > 0), ("upper", found.force < 0)):
            one = found.surface(side, face)
            central = cycles * one.k[0] * np.sum(np.abs(found.force) * path * pressed)
            turning = cycles * one.k[1] * np.sum(couple * path)
            assert found.volume(one) == pytest.approx(central + turning, rel=1e-12, abs=0)


def test_finer_positions_and_parts_leave_the_volume_and_come_to_one_profile():
    coarse, fine = (
        of(
            re.sub(
                "parts: 100", f"parts: {parts}", TEXT.replace("wear:\n", f"wear:\n  positions: {count}\n", 1)
            )
        )
        for parts, count in ((100, 360), (400, 1440))
    )
    one, other = coarse.guides[0], fine.guides[0]
    for a, b in zip(one.surfaces, other.surfaces, strict=True):
        assert one.volume(a) == pytest.approx(other.volume(b), rel=0.02, abs=0)
        if a.side == "guide":
            line = np.interp(one.grid.x, other.grid.x, b.depth)
            assert np.abs(a.depth - line).mean() < 0.02 * b.greatest


def test_sums_of_the_points_written_out(forged):
    """Position by position and point by point, as the paper has it, with points counted from 1."""
    found = forged.guides[0]
    length, parts = found.given.length, found.given.parts
    step = (found.stroke + length) / parts
    covered = round(length / step) + 1
    sums = np.zeros((2, parts + 2)), np.zeros((2, parts + 2))
    xi = [(k - (covered + 1) / 2) * step for k in range(1, covered + 1)]
    half = sum(abs(x) for x in xi) / 2
    for S, R, M, q in zip(found.travel, found.force, found.moment, found.analogue, strict=True):
        start = min(round(S / step), parts + 1 - covered) + 1
        for k in range(1, covered + 1):
            j, path = start + k - 1, abs(q) * 2 * math.pi / 360
            sums[0][0 if R > 0 else 1, j] += abs(R) / covered * path
            if xi[k - 1] != 0:
                face = 0 if (M > 0) == (xi[k - 1] > 0) else 1
                sums[1][face, j] += abs(M) / (2 / 3 * length) * abs(xi[k - 1]) / half * path
    for n, face in enumerate(("lower", "upper")):
        ours = found.surface("guide", face).work
        for cause in range(2):
            assert np.allclose(ours[cause], sums[cause][n, 1:], rtol=1e-9, atol=1e-9 * sums[cause].max()), (
                face
            )


def test_coefficients_are_those_at_the_mean_pressure_and_c_is_in_micrometres(forged):
    found = forged.guides[0]
    one = found.surface("guide", "lower")
    assert one.k[0] == pytest.approx(
        1.2e-15 + (1.5e-15 - 1.2e-15) * one.pressure[0] / 0.5e6, rel=1e-12, abs=0
    )
    told = {(one.side, one.face): one.k for one in found.surfaces}
    assert told["guide", "upper"] == pytest.approx((1.6e-15, 2.0e-15), abs=0)
    assert told["slider", "lower"] == told["slider", "upper"] == pytest.approx((0.8e-15, 1.0e-15), abs=0)
    table = {t.name: t for t in quantities.tables(forged)}["wear_guide_1_surfaces"]
    c = found.given.cycles * 1e6 * one.k[0] / (found.given.width * found.grid.step)
    assert table["c"].values[0] == pytest.approx(c, rel=1e-12)
    slid = np.abs(found.analogue)[found.force > 0]
    mean = np.sum(slid * found.force[found.force > 0]) / slid.sum() / (found.given.width * found.given.length)
    assert one.pressure[0] == pytest.approx(mean, rel=1e-12)


def test_reaction_through_the_middle_wears_without_skew():
    """A slider with its pin in the middle, its mass there and the load there: the couple is nothing."""
    found = written(OWN).guides[0]
    assert not found.skewed
    for one in found.surfaces:
        assert np.allclose(one.parts[1], 0, atol=1e-12 * max(found.worst.greatest, 1e-300))
        if one.side == "slider":
            assert np.ptp(one.depth) < 1e-12 * found.worst.greatest  # worn evenly
    shift, tilt = found.settled
    assert np.isfinite(shift).all() and np.isfinite(tilt).all()


def test_a_middle_put_aside_skews_the_slider_by_as_much():
    block = OWN.replace("length: 90 mm", "length: 90 mm, middle: 12 mm")
    found = written(block).guides[0]
    assert found.skewed and np.allclose(found.arm[np.isfinite(found.arm)], -0.012, rtol=1e-9)


def test_reaction_moment_and_analogue_are_those_of_the_force_analysis():
    """The moment about the slider's middle, by the balance of the slider's own forces about it."""
    results = solved("forging_machine_wear")
    found, solved_ = results.wear.guides[0], results.lever.kinetostatics.diagram
    motion = solved_.motion
    every = len(found.force) // (len(solved_.turned) - 1)
    reaction = solved_.statics.reactions["0-3"]
    assert np.allclose(found.force[::every], reaction.force.imag[:-1], rtol=1e-9, atol=1e-6)
    middle = motion.place("B") + found.given.middle
    rod = -solved_.statics.force(
        "2", "3"
    )  # of the rod on the slider: that of the slider on the rod turned round
    tool, weight = solved_.loading.forces[0], solved_.loading.gravity["3"] + solved_.loading.inertia["3"]
    arms = [(motion.place("B"), rod), (motion.place("T"), tool), (motion.place("S3"), weight)]
    others = sum(((at - middle).conjugate() * force).imag for at, force in arms)
    assert np.allclose(found.moment[::every], -others[:-1], rtol=1e-6, atol=1e-6 * np.abs(others).max())
    rate = np.gradient(found.travel, found.step)
    assert np.allclose(found.analogue[1:-1], rate[1:-1], atol=1e-3)


@given(
    st.floats(0.05, 3.0),
    st.floats(0.01, 2.0),
    st.integers(10, 300),
    st.floats(-50.0, 50.0),
    st.floats(-9.0, 9.0),
)
@settings(max_examples=examples(60))
def test_all_that_is_laid_on_a_guide_is_there(stroke, length, parts, force, moment):
    travel = stroke / 2 * (1 - np.cos(np.linspace(0, 2 * math.pi, 48, endpoint=False)))
    cut = wear.grid(travel, stroke, length, parts)
    if cut.covered < 3:
        return
    path = np.full(48, 0.25)
    done = wear.rubbed(cut, np.full(48, force), np.full(48, moment), path, length)
    whole = abs(force) * 12.0
    assert sum(face.sum() for face in done.guide_force) == pytest.approx(whole, rel=1e-9, abs=1e-12)
    turning = 2 * abs(moment) / (2 * length / 3) * 12.0
    assert sum(face.sum() for face in done.guide_couple) == pytest.approx(turning, rel=1e-9, abs=1e-12)
    assert sum(face.sum() for face in done.slider_couple) == pytest.approx(turning, rel=1e-9, abs=1e-12)
    if moment:  # the couple of all points about the middle is the moment
        lower, upper = done.slider_couple
        about = np.sum((lower - upper) * cut.xi) / 12.0
        arm = 2 * np.sum(cut.xi**2) / np.sum(np.abs(cut.xi))
        assert about == pytest.approx(moment / (2 * length / 3) * arm, rel=1e-9)


def test_constant_load_on_a_slider_that_stands_at_one_place_wears_that_place_alone():
    cut = wear.grid(np.zeros(4), 0.5, 0.25, 60)
    done = wear.rubbed(cut, np.full(4, 8.0), np.zeros(4), np.full(4, 0.1), 0.25)
    lower, upper = done.guide_force
    assert cut.covered == 21
    assert np.allclose(lower[:21], 3.2 / 21) and not lower[21:].any() and not upper.any()
    assert np.allclose(done.slider_force[0], 3.2 / 21)


# --- the worn slider


def test_slider_on_an_evenly_worn_face_sinks_and_on_a_slope_tilts():
    travel = np.array([0.0, 0.1, 0.2])
    cut = wear.grid(travel, 0.2, 0.3, 50)
    sunk, tilted = wear.settling(cut, travel, np.full(51, 2e-5), np.full(cut.covered, 1e-5))
    assert np.allclose(sunk, 3e-5) and np.allclose(tilted, 0, atol=1e-15)
    sunk, tilted = wear.settling(cut, travel, 4e-4 * cut.x, np.zeros(cut.covered))
    assert np.allclose(tilted, 4e-4) and np.allclose(sunk, 4e-4 * (travel + 0.15))


def test_even_wear_has_the_volume_of_the_worst_face(forged):
    found = forged.guides[0]
    one = found.worst_guide
    worn = np.isfinite(found.resistance)
    assert found.even * worn.sum() == pytest.approx(one.depth.sum(), rel=1e-12, abs=0)
    # the coefficient falls as the resistance grows: uneven wear by uneven resistance is even
    assert np.allclose(one.depth[worn] / found.resistance[worn], one.greatest)
    assert found.resistance[one.worst] == 1


# --- time


@given(st.floats(1e-12, 1e-8), st.floats(1e-7, 1e-4), st.floats(10.0, 1e6), st.floats(1e-6, 1e-2))
def test_at_the_end_of_its_life_the_wear_is_the_limit(rate, run_in, constant, limit):
    life = wear.life(limit, rate, run_in, constant)
    assert float(wear.staged(life, run_in, constant, rate)) == pytest.approx(limit, rel=1e-9, abs=0)


def test_life_without_running_in_is_a_proportion(forged):
    found = written(OWN.replace("coefficient:", "limit: 0.5 mm, coefficient:")).guides[0]
    assert found.life == pytest.approx(0.5e-3 / found.worst.greatest * found.time, rel=1e-12)
    assert found.time == pytest.approx(1e6 * 0.1)  # 600 rpm
    assert wear.life(1e-3, 0.0) == math.inf
    ours = forged.guides[0]
    assert float(ours.worn(ours.life)) == pytest.approx(ours.given.limit, rel=1e-9, abs=0)


# --- pivots


@given(
    st.floats(0.2, math.pi / 2),
    st.sampled_from(["cosine", "uniform"]),
    st.integers(8, 120),
    st.integers(0, 1000),
)
@settings(max_examples=examples(60))
def test_volume_of_a_cylinder_is_that_of_the_law_as_a_whole(arc, law, sectors, seed):
    random = np.random.default_rng(seed)
    force, path, centre = random.uniform(0, 9, 30), random.uniform(0, 2, 30), random.uniform(-20, 20, 30)
    done = wear.pressure_path(arc, law, 0.03, 0.05, force, path, centre, sectors)
    volume = done.sum() * 0.03 * 0.05 * 2 * math.pi / sectors
    assert volume == pytest.approx(wear.spread(arc, law) * np.sum(force * path), rel=1e-9)
    assert done.min() >= -1e-12 * done.max()


@pytest.mark.parametrize("law", ["cosine", "uniform"])
def test_pressures_of_a_pivot_add_up_to_the_force(law):
    """Along the force, not across it; by a sum over fine sectors."""
    count, arc = 3600, 1.1
    done = wear.pressure_path(arc, law, 0.03, 0.05, np.array([70.0]), np.array([1.0]), np.array([0.7]), count)
    at = 2 * math.pi * (np.arange(count) + 0.5) / count
    total = np.sum(done * np.exp(1j * at)) * 0.03 * 0.05 * 2 * math.pi / count
    assert total == pytest.approx(70 * np.exp(0.7j), rel=1e-5)


def test_pivot_of_the_forging_machine_by_sampling_the_pressure(forged):
    found = forged.pivots[0]
    results = solved("forging_machine_wear")
    kinematics, given_loads = results.lever.kinematics, results.lever.kinetostatics
    turned = kinematics.cycle.turned(len(found.force))
    motion = kinematics.cycle.motion(turned)
    solved_ = at(given_loads.given, motion, turned, stated(given_loads.given, kinematics, motion, turned))
    on_journal = solved_.statics.force("1", "2")
    arc, r, b = math.radians(60), 0.06, 0.14
    top = np.abs(on_journal) / (r * b * (arc + math.sin(arc) * math.cos(arc)))
    step = 2 * math.pi / len(turned)
    slide = r * np.abs((motion.angular_velocity("2") - motion.angular_velocity("1")) / motion.omega) * step
    for member in found.members:
        here = np.angle(-on_journal / motion.turn(member.link))
        fine = (np.arange(72 * 20) + 0.5) * 2 * math.pi / (72 * 20)
        away = np.angle(np.exp(1j * (fine - here[:, None])))
        pressure = np.where(np.abs(away) < arc, top[:, None] * np.cos(away), 0.0)
        path = (slide[:, None] * pressure).sum(axis=0).reshape(72, 20).mean(axis=1)
        assert np.allclose(member.path, path, rtol=0, atol=2e-3 * path.max()), member.name
        assert np.allclose(
            member.depth, found.given.cycles * member.k * path, rtol=0, atol=2e-3 * member.greatest
        )


def test_constant_load_that_turns_with_a_shaft_wears_one_side_of_it():
    """The journal under the arc all the time, the bushing all round."""
    turn = np.linspace(0, 2 * math.pi, 720, endpoint=False)
    one, path = np.ones(720), np.full(720, 0.1)
    journal = wear.pressure_path(0.5, "uniform", 0.02, 0.05, one, path, 0 * turn, 72)
    bushing = wear.pressure_path(0.5, "uniform", 0.02, 0.05, one, path, turn, 72)
    assert np.count_nonzero(journal) in (12, 13) and np.ptp(bushing) < 1e-9 * bushing.max()
    assert journal.sum() == pytest.approx(bushing.sum(), rel=1e-12)


# --- quantities


def test_tables_have_their_rows_and_no_infinities(forged):
    tables = {table.name: table for table in quantities.tables(forged)}
    assert len(tables["wear_guide_1_profile"]) == 101 and len(tables["wear_guide_1_cycle"]) == 360
    assert len(tables["wear_pivot_1_sectors"]) == 72 and len(tables["wear_guide_1_surfaces"]) == 8
    for table in tables.values():
        for column in table.columns:
            if not isinstance(column.values[0], str):
                assert not np.isinf(np.asarray(column.values, float)).any(), (table.name, column.key)


def test_coefficient_is_interpolated_and_held_at_its_ends():
    of_table = Coefficient((1.0, 3.0), (10.0, 20.0))
    assert [of_table.at(p) for p in (0, 10, 15, 20, 99)] == [1, 1, 2, 3, 3]


def test_a_guide_that_stands_upright_has_a_right_and_a_left_face():
    upright = (
        PUMP.split("\nbalancing:")[0]
        .replace("angle: 0 deg", "angle: 90 deg")
        .replace("P: [0, 20 mm]", "P: [20 mm, 0]")
    )
    upright = re.sub(r"zero: \{.*?\}", "zero: {point: B, extreme: down}", upright).replace(
        "direction: left", "direction: down"
    )
    upright = upright.replace("zero: left", "zero: down")
    found = of(upright + "\n" + OWN).guides[0]
    flat = written(OWN).guides[0]
    assert found.upright and not flat.upright
    table = {one.name: one for one in quantities.guide_tables(found)}
    words = (
        str(table["wear_guide_1_profile"]["u_lower"].quantity.meaning.values),
        table["wear_guide_1_cycle"]["R"].quantity.meaning.text,
    )
    assert "right-hand" in words[0] and "to the left" in words[1]
    assert found.stroke == pytest.approx(flat.stroke, rel=1e-9)


# --- what cannot be


def complaint(text: str) -> list[tuple[str, str]]:
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(text))
    return [(".".join(map(str, problem.path)), str(problem.wrong)) for problem in error.value.problems]


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("guide: x", "guide: y", "wear.guides.0.guide", "no guide y"),
        ("cycles: 1e6", "cycles: 0", "wear.guides.0.cycles", "out of range"),
        ("length: 90 mm", "length: -90 mm", "wear.guides.0.length", "greater than zero"),
        ("coefficient: 1e-15", "coefficient: 3 mm", "wear.guides.0.coefficient", "expected"),
        (
            "coefficient: 1e-15",
            "coefficient: [[2e6, 1e-15], [1e6, 2e-15]]",
            "wear.guides.0.coefficient",
            "ascend",
        ),
        ("coefficient: 1e-15", "coefficient: {slider: 1e-15}", "wear.guides.0.coefficient.guide", "missing"),
        ("length: 90 mm", "length: 90 mm, slider: 2", "wear.guides.0.slider", "another link slides"),
    ],
)
def test_a_mistake_is_told_with_its_place(old, new, place, words):
    assert old in OWN
    told = complaint(PUMP.split("\nbalancing:")[0] + "\n" + OWN.replace(old, new))
    assert any(where == place and words in said for where, said in told), told


PIVOT = "wear:\n  pivots:\n    - {pivot: A, journal: 1, diameter: 4 cm, width: 4 cm, cycles: 9, coefficient: 1e-15}\n"


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("pivot: A", "pivot: Z", "wear.pivots.0.pivot", "no pivot"),
        ("journal: 1", "journal: 3", "wear.pivots.0.journal", "no pivot at A"),
        ("pivot: A", "pivot: S2", "wear.pivots.0.journal", "no pivot at S2"),
        ("diameter: 4 cm", "arc: 200 deg, diameter: 4 cm", "wear.pivots.0.arc", "out of range"),
    ],
)
def test_a_mistake_in_a_pivot_is_told_with_its_place(old, new, place, words):
    told = complaint(PUMP.split("\nbalancing:")[0] + "\n" + PIVOT.replace(old, new))
    assert any(where == place and words in said for where, said in told), told


def test_wear_asks_for_loads_and_for_pairs():
    bare = PUMP.split("\nloads:")[0]
    assert ("wear", "the wear follows from the reactions, and there are no loads") in complaint(
        bare + "\n" + OWN
    )
    assert ("wear", "nothing says which pairs wear") in complaint(
        PUMP.split("\nbalancing:")[0] + "\nwear: {}\n"
    )
    assert "wear" in [place for place, _ in complaint(OWN)]  # without a mechanism there is nothing to wear


def test_a_guide_that_moves_is_refused():
    text = VARIANTS.joinpath("piston_pump.yaml").read_text(encoding="utf-8")
    told = complaint(text + "\n" + OWN.replace("guide: x", "guide: k"))
    assert ("wear.guides.0.guide", "the guide k is not fixed") in told


# --- found by a review


def test_analogue_is_by_the_angle_turned_whichever_way():
    """Clockwise as well the displacement grows where q is above zero."""
    text = PUMP.split("\nbalancing:")[0]
    assert "rotation:" in text
    for way in ("clockwise", "counter-clockwise"):
        found = of(re.sub(r"rotation: [\w-]+", f"rotation: {way}", text) + "\n" + OWN).guides[0]
        rate = np.gradient(found.travel, found.step)
        assert np.allclose(found.analogue[1:-1], rate[1:-1], atol=1e-3)
        assert np.abs(rate).max() > 0.01


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("length: 90 mm", "length: 0.4 mm", "wear.guides.0.length", "shorter than two"),
        ("coefficient: 1e-15", "coefficient: 0", "wear.guides.0.coefficient", "nothing wears"),
        ("coefficient: 1e-15", "coefficient: 1e-9", "wear.guides.0.coefficient", "no pair works so long"),
    ],
)
def test_a_wear_that_means_nothing_is_refused(old, new, place, words):
    told = complaint(PUMP.split("\nbalancing:")[0] + "\n" + OWN.replace(old, new))
    assert [place] == [where for where, _ in told] and words in told[0][1]


@pytest.mark.parametrize("k", ["0", "1e-9"])
def test_a_pivot_that_does_not_wear_and_one_that_wears_away_are_refused(k):
    block = PIVOT.replace("cycles: 9, coefficient: 1e-15", f"cycles: 1e6, limit: 1 mm, coefficient: {k}")
    told = complaint(PUMP.split("\nbalancing:")[0] + "\n" + block)
    assert [where for where, _ in told] == ["wear.pivots.0.coefficient"]


def test_the_number_of_parts_that_a_refusal_asks_for_is_enough():
    short = OWN.replace("length: 90 mm", "length: 0.4 mm")
    with pytest.raises(ProblemError) as error:
        written(short)
    parts = int(error.value.problems[0].right.values["parts"])
    cut = wear.grid(np.zeros(1), 0.0996, 0.0004, parts)
    assert cut.covered >= 3


@pytest.mark.exhaustive
def test_a_guide_that_does_not_wear_has_a_note_all_the_same():
    text = PUMP.split("\nbalancing:")[0] + "\n" + OWN.replace("1e-15", "{slider: 1e-15, guide: 0}")
    made = note.render(course.solve(loading.loads(text)), "html", Translator("en"))["note.html"].decode()
    assert "only the slider is replaced" in made


def test_a_pressed_slider_sinks_into_the_face_that_presses_it_and_leans_to_the_deeper_side(forged):
    """Onto the lower face it goes down, under the upper one up; by hand at every position with a place of its own."""
    found = forged.guides[0]
    shift, tilt = found.settled
    xi = found.grid.xi
    for row in range(0, len(found.force), 7):
        face, way = ("lower", -1) if found.force[row] > 0 else ("upper", 1)
        along = found.travel[row] + xi - xi[0]
        worn = np.interp(along, found.grid.x, found.surface("guide", face).depth)
        height = way * (worn + found.surface("slider", face).depth)
        slope, level = np.polyfit(xi, height, 1)
        assert shift[row] == pytest.approx(level, rel=1e-9) and tilt[row] == pytest.approx(slope, rel=1e-6)
    assert (shift[found.force > 0] < 0).all() and (shift[found.force < 0] > 0).all()


def test_numbers_that_stand_only_in_tables(forged):
    """The mean pressure of the couple, the points counted from 1, and whose the journal is."""
    found = forged.guides[0]
    couple = np.abs(found.moment) / (2 * found.given.length / 3)
    mean = np.sum(couple * found.path) / found.path.sum() / (found.given.width * found.given.length / 2)
    assert all(one.pressure[1] == pytest.approx(mean, rel=1e-9) for one in found.surfaces)
    start = {one.name: one for one in quantities.tables(forged)}["wear_guide_1_cycle"]["start"].values
    assert start[0] == 1 and max(start) == 101 - found.grid.covered + 1
    assert [one.link for one in forged.pivots[0].members] == ["1", "2"]
    assert [one.k for one in forged.pivots[0].members] == pytest.approx([0.04e-15, 0.18e-15], abs=0)

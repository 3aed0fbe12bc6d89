"""Reactions corrected for friction: closed forms of a slider-crank, the power balance, jamming, materials."""

from dataclasses import replace

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.chapters.lever.friction import corrected as corrections
from tmm_report.chapters.lever.friction import quantities
from tmm_report.chapters.lever.friction import solve as friction
from tmm_report.chapters.lever.friction.given import Friction, Rubbing
from tmm_report.chapters.lever.kinetostatics.solve.positions import resultants
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces import reactions_with_friction
from tmm_report.mechanics.lever.forces.reactions import Load
from tmm_report.mechanics.pairs import friction as law
from tmm_report.mechanics.pairs.materials import BRONZE, IRON, STEEL, TABLE, Stock, materials, mean, stock
from tmm_report.problems import ProblemError

R, L, FORCE = 0.05, 0.2, 1000.0
SLIDER_CRANK = """
language: en
mechanism:
  frame: {{O: [0, 0], Q: [0, 0]}}
  guides: {{x: {{through: Q}}}}
  links:
    1: {{points: {{O: 0, A: {crank}}}}}
    2: {{points: {{A: 0, B: {rod}}}}}
    3: {{points: {{B: 0, T: {at}}}, slides: {{guide: x, at: B}}}}
  driver: {{link: 1, speed: 60 rpm, rotation: counter-clockwise}}
  assembly: {{B: right}}
loads:
  gravity: 0
  forces: [{{at: T, direction: {direction}, constant: {force} N}}]
friction: {friction}
positions: {{table: 24, diagram: 72}}
"""


def slider_crank(friction, direction="against motion", crank=R, rod=L, at="[10 mm, 0]", force=FORCE):
    text = SLIDER_CRANK.format(
        crank=crank, rod=rod, at=at, direction=direction, friction=friction, force=force
    )
    return course.solve(loading.loads(text)).lever


def rod_angle(lever) -> np.ndarray:
    """Of the rod with the guide, rad, and of the crank."""
    return np.arcsin(R * np.sin(lever.kinematics.turned) / L)


def corrected(results, given: Friction):
    return friction.solve(replace(given, corrected=True), results.lever.kinetostatics).corrected


# ---------------------------------------------------------------- closed forms


def test_friction_of_the_guide_alone():
    """S cos β = F + f S |sin β|: the rod's force is F/(cos β − f |sin β|), its moment on the crank S r sin(φ + β)."""
    f = 0.3
    lever = slider_crank(f"{{guides: {{coefficient: {f}}}, corrected: true}}")
    phi, found = lever.kinematics.turned, lever.friction.corrected.table
    beta = rod_angle(lever)
    rod = FORCE / (np.cos(beta) - f * np.abs(np.sin(beta)))
    moment = np.abs(rod * R * np.sin(phi + beta))
    moving = np.abs(np.sin(phi)) > 1e-9
    np.testing.assert_allclose(found.moment[moving], moment[moving], rtol=1e-11)
    (guide,) = found.pairs
    np.testing.assert_allclose(guide.pressing[moving], (rod * np.abs(np.sin(beta)))[moving], rtol=1e-11)


def test_a_load_that_drives_gives_less_through_friction():
    """The other way round: S (cos β + f |sin β|) = F."""
    f = 0.3
    lever = slider_crank(f"{{guides: {{coefficient: {f}}}, corrected: true}}", "along motion")
    phi, beta = lever.kinematics.turned, rod_angle(lever)
    moment = -FORCE / (np.cos(beta) + f * np.abs(np.sin(beta))) * np.abs(R * np.sin(phi + beta))
    moving = np.abs(np.sin(phi)) > 1e-9
    found = lever.friction.corrected.table
    np.testing.assert_allclose(found.moment[moving], moment[moving], rtol=1e-11)


@pytest.mark.parametrize("k", [2, 5, 9])
def test_friction_circles_of_the_pivots(k):
    """A massless rod carries a force along the common tangent of both friction circles; from 0 to 180° the piston that
    goes inwards drives the crank."""
    f, d = 0.2, (0.03, 0.04, 0.02)
    joints = ", ".join(
        f"{name}: {{coefficient: {f}, diameter: {size}}}" for name, size in zip("OAB", d, strict=True)
    )
    lever = slider_crank(f"{{joints: {{{joints}}}, corrected: true}}", "left")
    phi = lever.kinematics.turned[k]
    shaft, pin, wrist = (law.friction_circle(f, size) for size in d)
    wrist = wrist if phi < np.pi / 2 else -wrist  # the rod swings back past 90°
    tilt = law.tilted_rod(phi, R, pin + wrist, L)
    moment = law.crank_moment(FORCE, phi, R, tilt, shaft + pin)
    assert lever.friction.corrected.table.moment[k] == pytest.approx(-moment, rel=1e-11)


def test_a_slider_that_tilts_presses_both_its_ends():
    """A force h beside the guide turns the slider: of 100 mm, its ends are pressed by 2 M/l where that is above N."""
    h = 0.15
    short = slider_crank(
        "{guides: {coefficient: 0.1, length: 100 mm}, corrected: true}", at=f"[0, {h}]"
    ).friction.corrected.table
    long = slider_crank(
        "{guides: {coefficient: 0.1, length: 10 m}, corrected: true}", at=f"[0, {h}]"
    ).friction.corrected.table
    plain = slider_crank("{guides: {coefficient: 0.1}, corrected: true}", at=f"[0, {h}]")
    (tilted,), (held,) = short.pairs, long.pairs
    np.testing.assert_allclose(held.pressing, plain.friction.corrected.table.pairs[0].pressing, rtol=1e-12)
    moving = np.abs(np.sin(plain.kinematics.turned)) > 1e-9
    np.testing.assert_allclose(tilted.pressing[moving], 2 * FORCE * h / 0.1, rtol=1e-9)
    assert (np.abs(short.moment[moving]) > np.abs(long.moment[moving])).all()


# ---------------------------------------------------------------- two ways to each number


def test_power_balance_with_friction(results):
    """The force analysis with friction and the power balance give one moment, for every ready mechanism."""
    found = corrected(results, results.variant.lever.friction)
    assert found.worst < 1e-9
    for one in (found.table, found.diagram):
        seen = np.isfinite(one.moment)
        assert seen.any() and (one.lost[seen] >= -1e-9 * np.nanmax(one.lost)).all()


def test_reactions_and_friction_belong_to_one_another(compressor):
    """Friction of the found reactions is put on the links: the force analysis gives these reactions again."""
    given, solved = compressor.variant.lever.friction, compressor.lever.kinetostatics.table
    motion = solved.motion
    found = corrected(compressor, given).table
    loads = dict(resultants(compressor.lever.kinetostatics.given, motion, solved.loading))
    for loss in found.pairs:
        stated = friction.rubbing_of(given, loss.pair)
        rate = reactions_with_friction.relative_rate(motion, loss.pair)
        rate = np.where(
            np.abs(rate) < 1e-9 * np.abs(rate).max(), 0.0, rate
        )  # at its extremes a slider stands still
        if loss.pair.kind == "R":
            brake = -stated.coefficient * np.abs(loss.reaction) * stated.diameter / 2 * np.sign(rate)
            for sign, link in zip((-1, 1), loss.pair.links, strict=True):
                if link in loads:
                    loads[link] = Load(loads[link].force, loads[link].moment + sign * brake)
        else:
            brake = (
                -stated.coefficient * np.abs(loss.reaction) * np.sign(rate)
            )  # of the slider 3 or 5, on link 0
            slider = loads[loss.pair.slider]
            loads[loss.pair.slider] = Load(slider.force + brake, slider.moment)
    again = statics.solve(motion, loads)
    for loss in found.pairs:
        np.testing.assert_allclose(again.reactions[loss.pair.key].force, loss.reaction, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(again.balancing, found.moment, rtol=1e-9, atol=1e-9)


def test_newton_finds_what_plain_iteration_finds(compressor):
    """x ← |R0 + Σ x_k R_k|, some hundred times, for a random system that contracts."""
    rng = np.random.default_rng(7)
    force = rng.normal(size=(4, 5, 6)) + 1j * rng.normal(size=(4, 5, 6))
    force[:, 1:] *= 0.05
    found, steps, borne = reactions_with_friction._equilibrium(force, np.zeros_like(force))
    x = np.zeros((4, 6))
    for _ in range(200):
        x = np.abs(force[:, 0] + np.einsum("jkp,kp->jp", force[:, 1:], x))
    np.testing.assert_allclose(found, x, rtol=1e-12)
    assert steps < 8 and (borne == 1).all()


def test_the_first_approximation_errs_by_the_square_of_friction(compressor):
    """Ten times less friction: a hundred times less difference between the moments."""
    given = compressor.variant.lever.friction

    def off(part: float) -> float:
        pivots = replace(given.pivots, coefficient=part * given.pivots.coefficient)
        guides = replace(given.guides, coefficient=part * given.guides.coefficient)
        found = corrected(compressor, Friction(pivots, guides)).table
        return float(np.abs(found.moment - found.first).max())

    assert off(1.0) / off(0.1) == pytest.approx(100, rel=0.2)


def test_no_friction_changes_nothing(compressor):
    found = corrected(compressor, Friction(Rubbing(0.0, 0.05), Rubbing(0.0))).table
    np.testing.assert_allclose(found.moment, found.without, rtol=1e-13)
    assert not found.lost.any() and found.steps == 0


def test_what_is_not_asked_for_is_not_found(compressor):
    assert compressor.lever.friction.corrected is None


# ---------------------------------------------------------------- jamming


def test_a_steep_rod_jams_its_slider():
    """At the steepest rod tan β = 4/3: with f = 0.8 > 3/4 no force in the rod moves the slider against a load."""
    with pytest.raises(ProblemError, match="jams where the driving link has turned by") as told:
        slider_crank("{guides: {coefficient: 0.8}, corrected: true}", rod=R / 0.8)
    assert "it moves with 0.9" in str(told.value)  # of the stated friction, 0.75/0.8 = 0.94


def test_the_same_slider_moves_with_less_friction():
    lever = slider_crank("{guides: {coefficient: 0.7}, corrected: true}", rod=R / 0.8)
    phi = lever.kinematics.turned
    beta = np.arcsin(0.8 * np.sin(phi))
    moment = FORCE / (np.cos(beta) - 0.7 * np.abs(np.sin(beta))) * R * np.abs(np.sin(phi + beta))
    moving = np.abs(np.sin(phi)) > 1e-9
    np.testing.assert_allclose(lever.friction.corrected.table.moment[moving], moment[moving], rtol=1e-9)


# ---------------------------------------------------------------- materials


@pytest.mark.parametrize(
    ("text", "pair"),
    [
        ("steel–bronze", (STEEL, BRONZE)),
        ("bronze-steel", (STEEL, BRONZE)),
        ("Чугун — сталь", (STEEL, IRON)),
        ("cast iron–cast iron", (IRON, IRON)),
        ("cast-iron-steel", (STEEL, IRON)),
        ("бронза–бронза", (BRONZE, BRONZE)),
        ("steel–rubber", None),
        ("steel", None),
    ],
)
def test_materials_by_name(text, pair):
    assert materials(text) == pair


def test_the_table_of_the_course():
    """As printed: in motion dry and semi-fluid, at rest with its dashes."""
    assert set(TABLE) == {
        (STEEL, STEEL), (STEEL, IRON), (IRON, IRON), (STEEL, BRONZE), (IRON, BRONZE), (BRONZE, BRONZE)
    }  # fmt: skip
    moving = [mean(TABLE[pair]["moving"][0]) for pair in TABLE]
    assert moving == [0.15, 0.18, 0.15, 0.15, 0.2, 0.175]
    semi_fluid = [TABLE[pair]["moving"][1] for pair in TABLE]
    assert semi_fluid == [(0.05, 0.1), (0.07, 0.15), (0.07, 0.12), (0.1, 0.15), (0.07, 0.15), (0.05, 0.1)]
    assert [TABLE[pair]["rest"][0] and TABLE[pair]["rest"][0][0] for pair in TABLE] == [
        0.17, 0.3, None, 0.16, None, None
    ]  # fmt: skip
    rest = [TABLE[pair]["rest"][1] for pair in TABLE]
    assert rest == [(0.1, 0.12), None, (0.18, 0.18), (0.1, 0.15), None, (0.1, 0.1)]


def test_a_dash_of_the_table_is_told_with_what_there_is():
    wrong, right = stock("steel–cast iron", "semi-fluid", "rest")
    assert "no coefficient of steel on cast iron at rest" in str(wrong) and "0.3" in str(right)
    wrong, right = stock("cast iron–bronze", "dry", "rest")
    assert "in motion, 0.2" in str(right)


def test_a_variant_takes_the_middle_of_the_range():
    lever = slider_crank(
        "{pivots: {materials: bronze–steel, lubrication: semi-fluid, diameter: 30 mm}, "
        "guides: {materials: сталь–чугун}}"
    )
    given = lever.given.friction
    assert (given.pivots.coefficient, given.guides.coefficient) == (0.125, 0.18)
    assert given.pivots.stock == Stock(STEEL, BRONZE, "semi-fluid")


@pytest.mark.parametrize(
    ("friction", "said"),
    [
        ("{guides: {length: 10 mm}}", "by its coefficient or by the materials"),
        ("{guides: {coefficient: 0.1, materials: steel–steel}}", "exactly one of"),
        ("{guides: {materials: steel–wood}}", "no such pair of materials"),
        (
            "{guides: {materials: steel–cast iron, lubrication: semi-fluid, state: rest}}",
            "there is one for dry",
        ),
        ("{corrected: true}", "nothing to correct"),
        ("{joints: {x: {coefficient: 0.1, diameter: 10 mm}}}", "a guide has no journal"),
        ("{joints: {A: {coefficient: 0.1, diameter: 9 mm, length: 9 mm}}}", "no length of a slider"),
        ("{joints: {A: {coefficient: 0.1}}}", "needs the diameter of its journal"),
    ],
)
def test_what_cannot_be(friction, said):
    with pytest.raises(ProblemError, match=said):
        slider_crank(friction)


def test_where_nothing_presses_nothing_is_corrected():
    with pytest.raises(ProblemError, match="no force presses a pair"):
        slider_crank("{guides: {coefficient: 0.1}, corrected: true}", force=0)


FOUR_BAR = """
language: en
mechanism:
  frame: {O: [0, 0], C: [400 mm, 0]}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 350 mm}, mass: 4 kg, mass_centre: B}
    3: {points: {C: 0, B: 250 mm}}
  driver: {link: 1, speed: 120 rpm, rotation: counter-clockwise}
  assembly: {B: left of A-C}
loads: {gravity: 9.81 m/s^2}
friction: {guides: {coefficient: 0.1}, corrected: true}
"""


def test_friction_of_pairs_that_a_mechanism_has_not_is_told():
    with pytest.raises(ProblemError, match="no force presses a pair"):
        course.solve(loading.loads(FOUR_BAR))


def test_links_that_never_turn_against_one_another_have_no_friction_between_them():
    """A block in a fixed direction on the coupler of a parallelogram: its rate is the noise of the positions."""
    pivots = [Pair("R", name, links, {}) for name, links in (("O", ("0", "1")), ("D", ("2", "4")))]
    noise = np.array([3e-12, -5e-12, 1e-12])
    senses = corrections._senses(pivots, {"0-1": np.full(3, -12.0), "2-4": noise})
    np.testing.assert_array_equal(senses["0-1"], -1.0)
    np.testing.assert_array_equal(senses["2-4"], 0.0)


def test_the_force_on_a_tilting_slider_is_worked_out_from_its_moment():
    """2 |M|/l of the results where it tilts, else the normal reaction."""
    lever = slider_crank("{guides: {coefficient: 0.1, length: 20 mm}, corrected: true}", at="[10 mm, 12 mm]")
    tables = {table.name: table for table in quantities.tables(lever.friction)}
    assert tables["friction_given"]["l"].numbers() == pytest.approx(0.02)
    numbers = tables["friction_reactions_table"]
    ends = 2 * np.abs(numbers["M_03_fr"].numbers()) / 0.02
    normal, pressing = numbers["R_03_fr"].numbers(), numbers["N_fr_0-3"].numbers()
    assert (ends > normal).any()
    np.testing.assert_allclose(pressing, np.maximum(ends, normal))


def test_of_two_equilibria_that_is_taken_which_grows_from_no_friction():
    """x = |1.5 x − 1| holds at 0.4 and at 2; as friction grows from nothing x falls from 1 to 0.4."""
    x, _, borne = reactions_with_friction._equilibrium(
        np.array([[[-1.0], [1.5]]]) + 0j, np.zeros((1, 2, 1)) + 0j
    )
    assert x[0, 0] == pytest.approx(0.4) and borne[0] == 1


def test_newton_takes_the_ends_of_a_tilted_slider():
    """x = |10 + 0.5 x| of its couple: its slope, not that of the force, leads there in one step."""
    force, couple = np.array([[[1.0], [-0.9]]]) + 0j, np.array([[[10.0], [0.5]]]) + 0j
    x, steps, borne = reactions_with_friction._equilibrium(force, couple)
    assert x[0, 0] == pytest.approx(20) and borne[0] == 1 and steps == 1


SLOT = """
language: en
mechanism:
  frame: {O: [0, 0], C: [0, -300 mm]}
  guides: {k: {through: G, link: 3}}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: [A], slides: k}
    3: {points: {C: 0, B: 500 mm, G: [0, 60 mm]}, mass: 8 kg, mass_centre: B, inertia: 0.3 kg*m^2}
  driver: {link: 1, speed: 90 rpm, rotation: clockwise}
  sketch: {A: [0, 100 mm], B: [0, 200 mm]}
loads: {gravity: 9.81 m/s^2}
friction: {guides: {coefficient: 0.2}, pivots: {coefficient: 0.1, diameter: 40 mm}, corrected: true}
"""


def test_friction_in_a_slot_beside_the_pivot_of_its_link_turns_the_link():
    """The force of friction along the slot has an arm about the pivot; the power balance knows of no arms."""
    found = course.solve(loading.loads(SLOT)).lever.friction.corrected
    assert found.worst < 1e-9
    assert np.max(np.abs(found.table.moment - found.table.first)) > 1e-3 * np.max(np.abs(found.table.moment))


def test_the_sliding_velocity_in_a_slot_beside_the_pivot_by_differences():
    """Of the place of the block along the slot; a slot through the pivot would hide the turning of its link."""
    solved = course.solve(
        loading.loads(SLOT + "positions: {table: 12, diagram: 720}\n")
    ).lever.kinetostatics.diagram
    motion = solved.motion
    (pair,) = (pair for pair in motion.linkage.structure.pairs if pair.kind == "P")
    s = motion.state
    block, start = s.world("2", pair.at["2"]), s.world("3", pair.at["3"])
    along = ((block - start) / (s.u["3"] * pair.along["3"])).real
    step = (solved.turned[2] - solved.turned[0]) / abs(motion.omega)
    middle = (along[2:] - along[:-2]) / step
    np.testing.assert_allclose(reactions_with_friction.relative_rate(motion, pair)[1:-1], middle, atol=1e-3)


def test_positions_without_reactions_stay_without_a_number():
    """Where a group is singular its reactions are nan: such a position is neither jammed nor solved."""
    force = np.ones((2, 3, 4)) * (0.1 + 0.2j)
    force[..., 2] = np.nan
    x, _, borne = reactions_with_friction._equilibrium(force, np.zeros_like(force))
    np.testing.assert_array_equal(np.isnan(x[0]), [False, False, True, False])
    assert (borne == 1).all()


def test_only_what_rubs_is_asked_for():
    lever = slider_crank("{joints: {x: {coefficient: 0.2}}, corrected: true}")
    assert [loss.pair.name for loss in lever.friction.corrected.table.pairs] == ["x"]


def test_the_results_say_whose_each_number_is():
    """Columns of the results by the keys of the pairs; angles of friction of the materials in degrees."""
    lever = slider_crank(
        "{pivots: {materials: steel–bronze, diameter: 40 mm}, guides: {coefficient: 0.2}, corrected: true}"
    )
    tables = {table.name: table for table in quantities.tables(lever.friction)}
    found, reactions = lever.friction.corrected.table, tables["friction_reactions_table"]
    for loss in found.pairs:
        key = "".join(loss.pair.links)
        np.testing.assert_array_equal(reactions[f"R_{key}_fr"].numbers(), np.abs(loss.reaction))
        np.testing.assert_array_equal(reactions[f"N_fr_{loss.pair.key}"].numbers(), loss.pressing)
    moments = tables["friction_corrected_table"]
    first = found.without + lever.friction.table.total / found.omega
    np.testing.assert_allclose(moments["M_first"].numbers(), first)
    np.testing.assert_array_equal(moments["M_bal_fr"].numbers(), found.moment)
    assert tables["friction_materials"]["phi_fr"].numbers() == pytest.approx(np.degrees(np.arctan(0.15)))

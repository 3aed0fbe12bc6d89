"""Every quantity of every ready variant is explained: by a formula, by equations with numbers, or by a method and what
it starts with. A formula gives the number in the results; what is said to be given stands in the file."""

from __future__ import annotations

import re
from collections import defaultdict
from dataclasses import replace
from functools import cached_property
from itertools import chain
from pathlib import Path

import numpy as np
import pytest
from conftest import ALL_FILES, read, solved
from exhaustive import many
from told import Told

from tmm_report import course, loading
from tmm_report.commands.explain.listen import listen
from tmm_report.commands.explain.run import run, starts, written_out
from tmm_report.commands.explain.stated import stated, written
from tmm_report.commands.explain.target import Target, find, is_text
from tmm_report.commands.explain.way import Ways
from tmm_report.course import INITIAL_DATA, LEVER, OTHERS, room, solve
from tmm_report.i18n import Translator
from tmm_report.note import parts
from tmm_report.problems import Message
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.ways import GIVEN, STATED, Way, fits
from tmm_report.quantity.written import Equation, Unknown, variables
from tmm_report.results import tables, values

FILES = {file.stem: file for file in ALL_FILES}
TESTS = Path(__file__).parents[1]
STATED_SO = TESTS / "cases"
CASES = [
    *sorted(STATED_SO.glob("explain/*.yaml")),
    *sorted(STATED_SO.glob("mechanics/friction_length*.yaml")),
    *sorted(STATED_SO.glob("machine/crash_*.yaml")),
    TESTS / "statements" / "car_differential_on_a_curve.yaml",
    TESTS / "statements" / "reducer_3k.yaml",
    TESTS / "statements" / "steering_two_inputs.yaml",
    TESTS / "statements" / "jaw_crusher_from_swing.yaml",
    TESTS / "statements" / "cardan_drive.yaml",
    TESTS / "statements" / "dwell_from_arc.yaml",
    TESTS / "statements" / "geared_five_bar.yaml",
    TESTS / "statements" / "press_with_geared_cranks.yaml",
    TESTS / "statements" / "rack_on_slider.yaml",
    TESTS / "statements" / "rocker_by_law.yaml",
    TESTS / "statements" / "roller_on_rail.yaml",
    TESTS / "statements" / "slider_drives.yaml",
    TESTS / "statements" / "sun_and_planet.yaml",
    TESTS / "statements" / "tipper_by_cylinder.yaml",
    TESTS / "statements" / "uneven_crank.yaml",
]
"""With numbers that no ready variant has."""
POSITION = 2
ROWS = 24

USUAL = re.compile(
    r"accuracy|alpha_w_\d+|drive_step|cam_alpha_limit_\w+|(eccentric|stage\d)_(alpha|ha|c|accuracy)|governor_[gq]|k_part|methods_floor"
    r"|stage\d_(eta_stopped|external_least|external_most|rings_least|rings_most|beta|k_least|k_most|tolerance|least_tip|least_contact|phi|slack|eta_mesh|k|sigma|psi)|drive_tolerance"
    r"|contacts_\d+\.(z|groove|half_cone|n_hand|beta)|vibration_(g|isolators)|travel_g|dynamics_within|wear_\w+_\d+_(constant|arc)|dynamics_parts\.(eta|i)"
)
"""What a variant may leave out: it has a usual value then."""


class Explained:
    """A variant solved, its note and its ways, each once; a test that is done keeps nothing of it."""

    def __init__(self, variant):
        self.results = solve(written_out(variant, POSITION))
        self.ways = Ways.of(self.results)

    @cached_property
    def defined(self):
        """The formulas of the note that define a number, by the key of the number."""
        results = self.results
        heard = listen(lambda page: list(parts(results, page)), results.variant.title, Translator("en"))
        found = defaultdict(list)
        for spoken in heard.formulas:
            if isinstance(spoken.item, Formula) and spoken.item.ref is not None:
                found[spoken.item.ref.key].append(spoken.item)
        return found

    def in_the_note(self, target):
        start = starts(target)
        if target.table is not None and (target.worked or target.table.name.startswith("outputs_")):
            return any(map(start, chain.from_iterable(self.defined.values())))
        key = target.quantity.key
        return any(map(start, (*self.defined[key], *self.defined[key[:-2]])))

    def targets(self):
        """Every single value, and every column at a position or as a whole."""
        yield from (Target(value.quantity, value=float(value.value)) for value in values(self.results))
        for table in tables(self.results):
            position = POSITION if "position" in table else None
            for column in table.columns:
                target = Some(column.quantity, table, position)
                yield target if target.rows else replace(target, position=int(table["position"].values[0]))

    def says(self, target, told):
        if told is not None and told.says:
            return True
        # what has no number there has nothing to show, but its method is told
        nothing = bool(target.numbers) and not np.isfinite(target.numbers).any() and told is not None
        return nothing or self.in_the_note(target)

    def unexplained(self, every):
        """Names of the quantities that nothing explains."""
        return [target.name for target in every if not self.says(target, self.ways.told(target))]


class Some(Target):
    """Of a long table of things some of the rows are asked for, from the first to the last."""

    @property
    def rows(self):
        rows = super().rows
        return rows if len(rows) <= ROWS else [rows[k * (len(rows) - 1) // (ROWS - 1)] for k in range(ROWS)]


# ---------------------------------------------------------------- none is left


@pytest.mark.parametrize("file", [*ALL_FILES, *many(CASES, 3)], ids=lambda file: file.stem)
def test_every_number_is_explained_rightly(file):
    """Nothing is left unexplained; a formula of a way gives the number; what is said to be given stands in the file or
    is a usual value."""
    explained, values_of_file = Explained(loading.load(file)), stated(file)
    unexplained, wrong, missing = [], [], []
    for target in explained.targets():
        told = explained.ways.told(target)
        if not explained.says(target, told):
            unexplained.append(target.name)
        if told is not None:
            wrong += [(target.name, *pair) for pair in disagreeing(target, told)]
            if told.way.text == STATED:
                lacking = not_stated(target, told, values_of_file)
                if lacking and not explained.in_the_note(target):
                    missing.append((target.name, lacking))
    assert (unexplained, wrong, missing) == ([], [], [])


def disagreeing(target, told):
    """Values of formulas that are not the numbers, beside the numbers."""
    if told.way.by is None or not told.formulas:
        return
    numbers = [x for x in target.numbers if np.isfinite(x)]
    limit = 1e-9 * size(target)
    for k, formula in enumerate(told.formulas):
        value = np.degrees(formula.value) if formula.unit == "deg" else formula.value
        # where the formula has no value in some rows, the others are numbers of the column
        known = numbers[k : k + 1] if len(told.formulas) == len(numbers) else numbers
        if not np.any(np.abs(value - np.array(known)) <= limit):
            yield float(value), known


def size(target):
    """Beside which a difference of the numbers is rounding: of a component the size of its vector."""
    every = [target.column]
    if target.table is not None and target.quantity.key.endswith(("_x", "_y")):
        vector = target.quantity.key[:-2]
        every += [target.table[vector]] if vector in target.table else []
    found = max(map(largest, every))
    first = target.quantity.key[1:]  # dpsi_2 of ddpsi_2, which is but rounding where the link turns evenly
    if target.quantity.key.startswith("dd") and target.table is not None and first in target.table:
        even = largest(target.table[first])
        found = even if found <= 1e-12 * even else found
    return found or 1.0


def largest(column):
    return float(np.nanmax(np.abs(np.asarray(column.values, dtype=float)), initial=0.0))


def not_stated(target, told, values_of_file):
    """Numbers said to be given that neither stand in the file nor are usual values."""
    if is_text(target.column) or told.formulas or USUAL.fullmatch(target.name.partition(".")[2]):
        return []
    numbers = [x for x in target.numbers if np.isfinite(x) and x]
    return [x for x in numbers if not written(values_of_file, [x], target.quantity.unit)]


# ---------------------------------------------------------------- solved together


def systems(explained):
    """The lines of every system of equations that is worked out for a reaction of a variant."""
    for table in (table for table in tables(explained.results) if table.name == "reactions_table"):
        for column in table.columns[2:]:
            told = explained.ways.told(Target(column.quantity, table, POSITION))
            if told.worked:
                yield column.key, told.worked


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    "name", ["compressor", "press", "shaper", "quick_return", "cam_press", "elliptic_trammel"]
)
def test_the_equations_told_of_a_reaction_have_its_number_for_their_only_solution(name):
    """A second way to the reactions: the printed equations, as a matrix of their unknowns, solved by least squares."""
    explained, count = Explained(read(name)), 0
    table = next(table for table in tables(explained.results) if table.name == "reactions_table")
    for key, lines in systems(explained):
        equations = [line.expression for line in lines if isinstance(line, Equation) and line.numbers]
        unknown = {v.sign: v for one in equations for v in variables(one) if isinstance(v, Unknown)}
        matrix, right = linear(equations, list(unknown))
        found, *_, rank, _ = np.linalg.lstsq(matrix, right, rcond=None)
        assert rank == len(unknown), key
        largest = max(abs(found.max()), abs(found.min()), 1.0)
        for sign, number in zip(unknown, found, strict=True):
            column = next((c for c in table.columns if c.quantity.symbol == sign), None)
            if column is not None:
                assert number == pytest.approx(column.values[POSITION], abs=1e-8 * largest), (key, sign)
                count += 1
    assert count


def linear(equations, signs):
    """Coefficients and right sides of equations = 0 in their unknowns, by putting numbers in."""

    def put(numbers):
        return np.array([float(evaluated(one, numbers)) for one in equations])

    zero = put(dict.fromkeys(signs, 0.0))
    columns = [put({sign: float(sign == one) for sign in signs}) - zero for one in signs]
    return np.array(columns).T, -zero


def evaluated(node, numbers):
    """The value of an expression with other numbers for its unknowns."""
    if isinstance(node, Unknown):
        return numbers[node.sign]
    children = {k: v for k, v in vars(node).items() if hasattr(v, "evaluate")}
    if not children:
        return node.evaluate()
    from tmm_report.quantity.formula import Number

    return replace(node, **{k: Number(evaluated(v, numbers)) for k, v in children.items()}).evaluate()


@pytest.mark.exhaustive
def test_a_turned_sign_of_a_reaction_would_show_in_the_residual():
    _, lines = next(systems(Explained(read("compressor"))))
    equations = [line.expression for line in lines if isinstance(line, Equation) and line.numbers]
    assert max(abs(float(one.value)) for one in equations) < 1e-8
    unknown = {v.sign: v.number for one in equations for v in variables(one) if isinstance(v, Unknown)}
    largest = max(unknown, key=lambda sign: abs(unknown[sign]))
    turned = {**unknown, largest: -unknown[largest]}
    assert max(abs(evaluated(one, turned)) for one in equations) > 1.0


# ---------------------------------------------------------------- the count can fail


@pytest.mark.exhaustive
def test_a_planted_quantity_without_a_way_is_counted():
    planted = Target(Quantity("H_nowhere", Symbol("H"), "m", Message("planted")), value=1.0)
    explained = Explained(read("press"))
    explained.ways._of["values.H_nowhere"] = ("wear", None)
    assert explained.unexplained([planted]) == ["values.H_nowhere"]


@pytest.mark.exhaustive
def test_a_sentence_without_a_number_is_counted(monkeypatch):
    explained = Explained(read("press"))
    target = find(explained.results, "K_F", None)
    assert explained.unexplained([target]) == []
    monkeypatch.setattr(room("kinematics", "ways"), "WAYS", (Way("K_*", "Solved together."),))
    assert explained.unexplained([target]) == [target.name]


def test_a_way_names_its_numbers_by_letters_and_stars_alone():
    """Brackets and the like stand for themselves in a pattern, and no number's name has them: it would fit nothing."""
    rooms = [room(chapter, "ways").WAYS for chapter in (INITIAL_DATA, *LEVER, *OTHERS)]
    keys = [key for several in rooms for way in several for key in way.keys.split()]
    assert len(keys) > 400 and [key for key in keys if re.fullmatch(r"[\w.*,:]+", key) is None] == []


@pytest.mark.exhaustive
def test_every_chapter_has_its_ways_and_every_way_is_of_some_number():
    """A way that fits no number of any variant is a slip of its name, but for those whose number a variant may have."""
    chapters = [INITIAL_DATA, *LEVER, *OTHERS]
    every = {chapter: room(chapter, "ways").WAYS for chapter in chapters}
    cams = STATED_SO.parent.glob("statements/*cam*.yaml")
    read = [*CASES, *(file for file in cams if "answers" not in file.name)]
    results = [*(solved(file.stem) for file in ALL_FILES), *(solve(loading.load(file)) for file in read)]
    names = set().union(*map(named, results))
    names |= {re.sub(r"_diagram\.", "_table.", name) for name in names}
    used = {
        chapter: [
            any(fits(key, name) is not None for key in way.keys.split() for name in names) for way in several
        ]
        for chapter, several in every.items()
    }
    # of a cam alone and of a pair of a mechanism the same list by other names: once is enough
    assert len(every["cam"]) == len(every["cams"])
    used["cam"] = used["cams"] = [one or other for one, other in zip(used["cam"], used["cams"], strict=True)]
    idle = [
        (chapter, way.keys)
        for chapter, several in every.items()
        for way, once in zip(several, used[chapter], strict=True)
        if not once and chapter != "cams"
    ]
    assert len(idle) <= 6, idle
    assert all(way.text or way.by or way.worked for several in every.values() for way in several)
    assert course.room("kinematics", "ways").WAYS and STATED in GIVEN


def named(results):
    """The names of all numbers of the results."""
    columns = {f"{table.name}.{column.key}" for table in tables(results) for column in table.columns}
    return columns | {value.key for value in values(results)}


# ---------------------------------------------------------------- as it is told


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    ("name", "quantity", "said"),
    many(
        [
            ("hoist_drive", "drive_eta", "η = η_"),
            ("compressor", "H_B", "H_B = S_B,max − S_B,min = 0.2 − 0 = 0.2 m"),
            (
                "hoist_start",
                "dynamics_J",
                "J = J_red,1 + J_red,2 + J_red,3 + J_red,4 + J_red,5 = 0.16 + 0.014 + ",
            ),
            ("hoist_start", "dynamics_t_start", "t = ∫J dω/M"),
            ("compressor", "stage1_m", "drive.stages.0.module: 5 mm"),
            ("compressor", "flywheel_C_E", "A_exc/|W|"),
        ]
    ),
)
def test_single_numbers_are_derived(name, quantity, said):
    talk = Told()
    assert run(FILES[name], quantity, None, "en", talk)
    assert any(said in line for line in talk.lines), talk.lines


def test_the_start_up_is_checked_by_its_samples():
    talk = Told()
    run(FILES["hoist_start"], "dynamics_t_start", None, "en", talk)
    again = next(float(line.split(" = ")[1].split()[0]) for line in talk.lines if "t_Σ" in line)
    own = next(
        float(line.split(" = ")[1].split()[0]) for line in talk.lines if line.startswith("  t_start = ")
    )
    assert again == pytest.approx(own, rel=1e-3)


@pytest.mark.exhaustive
def test_texts_and_tables_of_quantities_are_explained_by_their_full_names():
    talk = Told()
    assert run(FILES["crank_rocker"], "force_extremes.key", None, "ru", talk)
    assert run(FILES["crank_rocker"], "comparison_7.delta", None, "ru", talk)
    assert run(FILES["crank_rocker"], "velocity_plan_7.value", None, "ru", talk)

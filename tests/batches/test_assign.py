"""Individual variants drawn from ranges: proven, different, the same for the same seed; mistakes with their lines."""

from __future__ import annotations

import re
import shlex
from decimal import Decimal
from itertools import product
from pathlib import Path

import pytest
from conftest import ALL_FILES
from exhaustive import many
from hypothesis import given
from hypothesis import strategies as st
from notes import VARIANTS

from tmm_report import load, solve
from tmm_report.assignments.draw import Draw, rows
from tmm_report.assignments.fill import form
from tmm_report.assignments.model import Parameter, Ranges, Template
from tmm_report.assignments.people import students
from tmm_report.assignments.prove import Rejection, proof
from tmm_report.assignments.ranges import read
from tmm_report.commands.assign import run
from tmm_report.intake.writing import xlsx_bytes
from tmm_report.loading import loads
from tmm_report.problems import Message, ProblemError
from tmm_report.results import values

DOCS = Path(__file__).parents[2] / "docs"
EXAMPLE = DOCS / "examples" / "compressor.ranges.yaml"
OA = "OA: {key: mechanism.links.1.points.A, from: 80 mm, to: 120 mm, step: 5 mm}"


class Heard:
    """A talk that keeps what it is told."""

    def __init__(self):
        self.lines: list[str] = []

    def speak(self, language): ...

    def stage(self, doing): ...

    def tell(self, line):
        self.lines.append(str(line))

    warn = tell


def ranges(folder: Path, text: str, template: str = "compressor") -> Path:
    """A ranges file with a template of the ready variants."""
    path = folder / "a.ranges.yaml"
    path.write_text(f"template: {VARIANTS / template}.yaml\n{text}", encoding="utf-8")
    return path


def parameters(*lines: str) -> str:
    return "parameters:\n" + "".join(f"  {line}\n" for line in lines)


def assign(path: Path, output: Path, count: int | None = 5, seed: int = 2026, **others) -> list[str]:
    heard = Heard()
    asked = {"students": None, "folder": None, "language": None} | others
    assert run(path, count, seed, output=output, talk=heard, **asked)
    return heard.lines


def filled(path: Path, *choice: int):
    """The variant of these options, loaded."""
    found = read(path)
    return loads(form(found.template, found.parameters).text(found.parameters, found.cells(choice), {}))


def verdict(path: Path, *choice: int) -> str:
    """Why the variant of these options is rejected."""
    found = read(path)
    held = proof(found, form(found.template, found.parameters))
    why = held.rejects(found.cells(choice), {})
    return str(why.why) if why is not None else ""


# --- what is drawn


@pytest.mark.exhaustive
def test_every_file_handed_out_is_solved_and_meets_what_is_asked(tmp_path):
    assign(EXAMPLE, tmp_path / "a.csv", 6, folder=tmp_path / "variants")
    files = sorted((tmp_path / "variants").iterdir())
    assert len(files) == 6
    for file in files:
        results = solve(load(file))
        found = {value.key: value.value for value in values(results)}
        assert 0.17 <= found["H_B"] <= 0.23 and found["M_bal_max"] <= 400
        lever = results.lever
        assert lever.kinetostatics.agrees and not lever.kinematics.gaps
        assert all(one.closeness.value >= 0.2 for one in lever.kinematics.closest)
        assert not lever.given.readings  # the template's, read off another plan


def test_lengths_that_follow_stay_in_their_ratio(tmp_path):
    variant = filled(EXAMPLE, 3, 1, 0, 2, 1, 2)
    places = variant.lever.mechanism.links["2"].points
    assert abs(places["B"]) == pytest.approx(0.29)
    assert abs(places["S2"]) == pytest.approx(0.145) and abs(places["C"]) == pytest.approx(0.0725)


def test_numbers_are_written_as_a_person_writes_them():
    found = read(EXAMPLE)
    text = form(found.template, found.parameters).text(found.parameters, found.cells([1, 1, 0, 0, 0, 1]), {})
    assert b"A: 85 mm}" in text and b"C: 72.5 mm" in text and b"mass: 0.6 kg" in text
    assert b"by_position: [1600, 800, 0, 0, 0, 0, 0, 400, 800, 1200, 1600, 1600]" in text


def test_one_factor_goes_to_both_cylinders_and_nothing_else_changes():
    template = load(VARIANTS / "compressor.yaml")
    variant = filled(EXAMPLE, 4, 2, 3, 1, 4, 1)
    was, now = template.lever.loads.forces, variant.lever.loads.forces
    for one, other in zip(was, now, strict=True):
        assert other.law.values == pytest.approx([1.2 * value for value in one.law.values])
        assert (other.name, other.at, other.direction) == (one.name, one.at, one.direction)
    assert variant.title.topic == template.title.topic and variant.drive is not None


def test_of_pairs_the_second_numbers_are_multiplied(tmp_path):
    path = tmp_path / "curve.yaml"
    path.write_text("curve: [[0, 1 kN], [1.5, -20 N]]\n")
    found = Parameter("p", (("curve",),), scales=True)
    template = Template({"curve": [[0, "1 kN"], [1.5, "-20 N"]]}, path)
    assert found.texts(Decimal("0.5"), template) == {("curve",): "[[0, 0.5 kN], [1.5, -10 N]]"}


def test_what_follows_is_rounded_to_its_step(tmp_path):
    third = "AC: {key: mechanism.links.2.points.C, of: OA, times: 0.3333, step: 5 mm}"
    found = read(ranges(tmp_path, parameters(OA, third)))
    assert [found.cells([n])["AC"] for n in range(3)] == [25, 30, 30]


def test_words_are_drawn_too(tmp_path):
    way = "way: {key: mechanism.driver.rotation, choose: [clockwise, counter-clockwise]}"
    path = ranges(tmp_path, parameters(way))
    speeds = {filled(path, n).lever.mechanism.driver.omega for n in (0, 1)}
    assert len(speeds) == 2 and sum(speeds) == 0


# --- by the seed


def grid(*counts: int) -> Ranges:
    """Ranges of bare numbers, which nothing is made of."""
    made = (
        Parameter(name, ((name,),), options=tuple(Decimal(n) for n in range(count)))
        for name, count in zip("abcdefgh", counts, strict=False)
    )
    return Ranges(Template({}, Path()), tuple(made))


def taken(of: Ranges, count: int, seed: int, good=lambda cells: True) -> list[tuple[int, ...]]:
    no = Rejection("no", Message("no"))
    found = rows(Draw(of), count, seed, lambda number, cells: None if good(cells) else no)
    return [tuple(map(int, cells.values())) for cells in found]


@given(st.integers(0, 2**60), st.integers(1, 30), st.integers(0, 30))
def test_a_row_does_not_depend_on_how_many_follow(seed, count, more):
    of = grid(9, 5, 3)
    assert taken(of, count + more, seed)[:count] == taken(of, count, seed)


@pytest.mark.exhaustive
@given(st.integers(0, 2**60), st.lists(st.integers(1, 4), min_size=1, max_size=4), st.data())
def test_small_ranges_are_used_up_to_the_last_variant_and_no_further(seed, counts, data):
    of = grid(*counts)
    everything = list(product(*map(range, counts)))
    good = data.draw(st.sets(st.sampled_from(everything), min_size=1))
    found = taken(of, len(good), seed, lambda cells: tuple(map(int, cells.values())) in good)
    assert set(found) == good and len(found) == len(good)
    with pytest.raises(ProblemError):
        taken(of, len(good) + 1, seed, lambda cells: tuple(map(int, cells.values())) in good)


def test_all_values_are_drawn_about_equally_often():
    found = taken(grid(5, 400), 1000, 1)
    counts = [sum(row[0] == n for row in found) for n in range(5)]
    assert min(counts) > 150 and max(counts) < 250


def test_the_draw_of_a_seed_is_what_it_was():
    """A table of last year is drawn again as it was, whatever the version of numpy."""
    assert taken(grid(9, 9, 3), 3, 2026) == [(3, 8, 1), (1, 5, 0), (7, 5, 2)]


@pytest.mark.exhaustive
@pytest.mark.parametrize("suffix", many(["csv", "xlsx"]))
def test_the_same_seed_gives_the_same_bytes(tmp_path, suffix):
    outputs = [tmp_path / f"{n}.{suffix}" for n in range(3)]
    for output, seed in zip(outputs, (1, 1, 2), strict=True):
        assign(EXAMPLE, output, 3, seed)
    first, again, other = (output.read_bytes() for output in outputs)
    assert first == again != other


# --- what is rejected


@pytest.mark.exhaustive
def test_what_cannot_be_assembled_all_over_the_cycle_is_rejected(tmp_path):
    long = "OA: {key: mechanism.links.1.points.A, choose: [100 mm, 320 mm]}"
    path = ranges(tmp_path, parameters(long))
    assert verdict(path, 0) == ""
    assert "assembled all over the cycle" in verdict(path, 1)


@pytest.mark.exhaustive
def test_what_comes_near_a_singular_position_is_rejected_as_far_as_is_stated(tmp_path):
    long = "OA: {key: mechanism.links.1.points.A, choose: [100 mm, 299 mm]}"
    assert "singular position" in verdict(ranges(tmp_path, parameters(long)), 1)
    assert verdict(ranges(tmp_path, parameters(long) + "least_closeness: 0.01\n"), 1) == ""
    assert "nearer than 0.99" in verdict(ranges(tmp_path, parameters(long) + "least_closeness: 0.99\n"), 0)


@pytest.mark.parametrize(
    ("limits", "met"),
    [
        ("[190 mm, 210 mm]", True),
        ("[0.2, 0.2]", True),
        ("[21 cm, null]", False),
        ("[null, 0.199 m]", False),
        ("[null, 0.21]", True),
    ],
)
def test_results_are_held_within_their_bounds(tmp_path, limits, met):
    one = "OA: {key: mechanism.links.1.points.A, choose: [100 mm]}"
    why = verdict(ranges(tmp_path, parameters(one) + f"require: {{H_B: {limits}}}\n"), 0)
    assert (why == "") is met and (met or "H_B" in why)


def test_a_mistake_of_the_variant_rejects_it_and_is_told(tmp_path):
    mass = "m: {key: mechanism.links.3.mass, choose: [1 kg, -2 kg]}"
    assert "-2 kg is negative" in verdict(ranges(tmp_path, parameters(mass)), 1)


@pytest.mark.exhaustive
def test_gears_that_change_are_solved_every_time(tmp_path):
    """The teeth that are stated do not give the other ratio; a pair's contact ratio is held as any result is."""
    ratio = "u: {key: drive.stages.0.ratio, choose: [6.56, 9]}"
    path = ranges(tmp_path, parameters(ratio))
    assert verdict(path, 0) == "" and "cannot be solved" in verdict(path, 1)
    far = "a: {key: drive.stages.1.centre_distance, choose: [130 mm, 60 mm]}"
    path = ranges(tmp_path, parameters(far) + "require: {stage2_eps: [1.2, null]}\n")
    assert verdict(path, 0) == "" and "stage2_eps" in verdict(path, 1)


@pytest.mark.exhaustive
def test_conditions_are_between_values_not_their_numbers(tmp_path):
    others = "AB: {key: mechanism.links.2.points.B, choose: [0.3 m, 0.31 m]}"
    path = ranges(tmp_path, parameters(OA, others) + 'conditions: ["3.1*OA<AB", "AB <= 30 cm"]\n')
    assert verdict(path, 3, 0) == ""
    assert "3.1*OA<AB" in verdict(path, 4, 0) and "AB <= 30 cm" in verdict(path, 0, 1)


@pytest.mark.exhaustive
def test_it_is_told_what_rejected_how_many(tmp_path):
    two = "OA: {key: mechanism.links.1.points.A, choose: [100 mm, 101 mm, 320 mm, 330 mm]}"
    path = ranges(tmp_path, parameters(two) + "require: {H_B: [0, 201 mm]}\n")
    with pytest.raises(ProblemError) as error:
        assign(path, tmp_path / "a.csv", 2)
    text = str(error.value)
    assert "of 4 different variants that the ranges hold 1 can be set, 2 are asked for" in text
    assert re.search(r"2 of 4 tries rejected: it cannot be assembled", text)
    assert re.search(r"1 of 4 tries rejected: H_B is outside 0 … 201 mm", text)
    assert not (tmp_path / "a.csv").exists()


def test_more_variants_than_the_ranges_hold_are_refused_before_any_is_solved(tmp_path):
    with pytest.raises(ProblemError, match="hold 9 different variants, 10 are asked for"):
        assign(ranges(tmp_path, parameters(OA)), tmp_path / "a.csv", 10)


@pytest.mark.exhaustive
@pytest.mark.parametrize("file", ALL_FILES, ids=lambda file: file.stem)
def test_every_ready_variant_can_be_a_template(tmp_path, file):
    path = ranges(
        tmp_path, parameters("c: {key: title.year, choose: [2027]}") + "least_closeness: 0\n", file.stem
    )
    if b"year:" in file.read_bytes():
        assert verdict(path, 0) == ""
    else:
        with pytest.raises(ProblemError, match="no key year in title"):
            read(path)


# --- mistakes of the ranges file


MISTAKES = {
    "key: mechanism.links.1.points.B, from: 1 mm, to: 2 mm, step: 1 mm": "no key B in mechanism.links.1.points",
    "key: mechanism.driver.perod, choose: [1 s]": "no key perod in mechanism.driver; did you mean period?",
    "key: loads.forces.2.at, choose: [B]": "loads.forces of the template is a list of 2",
    "key: mechanism.driver.link.x, choose: [1 s]": "is a single value: it has no x",
    "key: a..b, choose: [1]": "a..b is not a dotted key",
    "key: mechanism.links, choose: [1]": "mechanism.links of the template is not a single value",
    "key: title.student, choose: [I]": "title.student is each student's own already",
    "choose: [1]": "one key, or a list of keys",
    "key: mechanism.driver.period": "nothing says which values it takes",
    "key: mechanism.driver.period, from: 1 s, to: 2 s": "the key step is missing",
    "key: mechanism.driver.period, from: 1 s, to: 2 s, stp: 1 s": "unknown key stp; did you mean step?",
    "key: mechanism.driver.period, from: 1 mm, to: 2 s, step: 1 s": "1 mm is a length (mm); expected: a time",
    "key: mechanism.driver.period, from: 1 s, to: 2 min, step: 1 s": "unit is another than that of from; write it in s",
    "key: mechanism.driver.period, from: 2 s, to: 1 s, step: 1 s": "it ends before it begins",
    "key: mechanism.driver.period, from: 1 s, to: 2 s, step: 0 s": "the step must be greater than zero",
    "key: mechanism.driver.period, from: 1 s, to: 1e9 s, step: 1e-9 s": "more than 10000 values",
    "key: mechanism.driver.period, from: x, to: 1 s, step: 1 s": "x is not a number with a unit",
    "key: mechanism.driver.period, choose: [1 mm]": "1 mm is a length (mm); expected: a time",
    "key: mechanism.driver.period, choose: [1 s, 1.0 s]": "1.0 stands in the list twice",
    "key: mechanism.driver.period, choose: []": "a list in square brackets",
    "key: mechanism.driver.rotation, from: 1, to: 2, step: 1": "rotation of the template is not a number",
    "key: mechanism.driver.rotation, scale: [1, 2]": "clockwise is not a number with a unit",
    "key: mechanism.driver.period, of: OB, times: 2": "no parameter of numbers above this one",
}


@pytest.mark.parametrize("stated", MISTAKES)
def test_a_mistake_of_a_parameter_is_told_with_its_line(tmp_path, stated):
    path = ranges(tmp_path, parameters(OA, f"b: {{{stated}}}"))
    with pytest.raises(ProblemError) as error:
        read(path)
    assert {(problem.file, problem.line) for problem in error.value.problems} == {(str(path), 4)}
    assert MISTAKES[stated] in str(error.value)


def test_all_mistakes_are_told_at_once_in_the_order_of_the_file(tmp_path):
    text = (
        parameters(OA, "id: {key: mechanism.driver.period, choose: [1 s]}", "c: 3", f"d{OA[2:]}")
        + 'conditions: ["OA > AB", "OA >> 1", 5, "c > OA"]\nleast_closeness: 2\nrequire: {H_B: 3}\nrequires: 1\n'
    )
    with pytest.raises(ProblemError) as error:
        read(ranges(tmp_path, text))
    lines = [problem.line for problem in error.value.problems]
    assert lines == [4, 5, 6, 7, 7, 7, 8, 9, 10]
    said = str(error.value)
    assert (
        "no parameter AB" in said and "OA >> 1 does not compare" in said and "already written by OA" in said
    )


def test_a_template_that_is_not_there_is_a_mistake_of_its_name(tmp_path):
    path = tmp_path / "r.yaml"
    path.write_text(f"parameters:\n  {OA}\ntemplate: compresor.yaml\n")
    with pytest.raises(ProblemError) as error:
        read(path)
    assert [(p.line, p.key) for p in error.value.problems] == [(3, "template")]
    assert "there is no such file" in str(error.value)


def test_a_mistake_of_the_template_is_told_in_its_own_file(tmp_path):
    template = tmp_path / "t.yaml"
    broken = (VARIANTS / "compressor.yaml").read_text("utf-8").replace("mass: 1.5 kg", "mass: 1.5 mm")
    template.write_text(broken, encoding="utf-8")
    path = tmp_path / "r.yaml"
    path.write_text(f"template: t.yaml\nparameters:\n  {OA}\n")
    with pytest.raises(ProblemError) as error:
        assign(path, tmp_path / "a.csv")
    problem = error.value.problems[0]
    assert problem.file == str(template) and problem.key == "mechanism.links.2.mass"


def test_a_result_that_the_template_has_not_is_told_with_the_nearest(tmp_path):
    path = ranges(tmp_path, parameters(OA) + "require:\n  H_B: [1 s, 2 m]\n  H_C: [1, 2]\n")
    with pytest.raises(ProblemError) as error:
        assign(path, tmp_path / "a.csv")
    said = [(p.line, p.text()) for p in error.value.problems]
    assert [line for line, _ in said] == [5, 6]
    assert "expected m" in said[0][1] and "did you mean H_" in said[1][1]


@pytest.mark.parametrize(
    "expression", ["__import__('os').system('id') > 1", "OA > OA.real", "OA > (1", "1e99999 < OA"]
)
def test_a_condition_is_never_evaluated_as_a_program(tmp_path, expression):
    with pytest.raises(ProblemError):
        read(ranges(tmp_path, parameters(OA) + f'conditions: ["{expression}"]\n'))


# --- students


def test_a_list_may_be_text_csv_or_a_workbook(tmp_path):
    names = [["Student", "Группа", "e-mail"], ["Иванов И. И.", "М-21", "a@b"], ["Ким А.", "М-22", ""]]
    (tmp_path / "a.txt").write_text("Иванов И. И.\n\nКим А.\n", encoding="cp1251")
    (tmp_path / "a.csv").write_text("\n".join(";".join(row) for row in names), encoding="utf-8")
    (tmp_path / "a.xlsx").write_bytes(xlsx_bytes({"list": names}))
    found = {suffix: students(tmp_path / f"a.{suffix}") for suffix in ("txt", "csv", "xlsx")}
    assert [(one.student, one.variant) for one in found["txt"]] == [("Иванов И. И.", "1"), ("Ким А.", "2")]
    assert found["csv"] == found["xlsx"] and found["csv"][1].group == "М-22"


def test_namesakes_get_ids_of_their_own(tmp_path):
    (tmp_path / "a.txt").write_text("Ким А.\nКим А.\nКИМ А.\n../x\n", encoding="utf-8")
    ids = [one.id for one in students(tmp_path / "a.txt")]
    assert len({id.casefold() for id in ids}) == 4
    assert all("/" not in id and not id.startswith(".") for id in ids)


def test_a_list_without_a_column_of_students_is_refused(tmp_path):
    (tmp_path / "a.csv").write_text("mark;group\n5;M\n")
    with pytest.raises(ProblemError, match="no column student"):
        students(tmp_path / "a.csv")
    (tmp_path / "a.txt").write_text("\n")
    with pytest.raises(ProblemError, match="no students"):
        students(tmp_path / "a.txt")


@pytest.mark.exhaustive
def test_students_stand_on_their_title_pages_and_the_rest_is_in_reserve(tmp_path):
    (tmp_path / "a.csv").write_text("student;group\nИванов И. И.;М-22\n", encoding="utf-8")
    path = ranges(tmp_path, parameters(OA))
    assign(path, tmp_path / "t.csv", 2, students=tmp_path / "a.csv", folder=tmp_path / "v")
    titles = {file.stem: load(file).title for file in (tmp_path / "v").iterdir()}
    assert sorted(titles) == ["v002", "Иванов_И._И"]
    assert (titles["Иванов_И._И"].student, titles["Иванов_И._И"].group) == ("Иванов И. И.", "М-22")
    assert (titles["v002"].student, titles["v002"].group, titles["v002"].variant) == ("", "М-21", "2")
    assert titles["v002"].group.by == {"ru": "М-21", "en": "M-21"}


@pytest.mark.parametrize(
    ("language", "group", "said"),
    [
        ("en", {"ru": "М-21", "en": "M-21"}, "M-21"),
        ("en", {"ru": "М-21"}, "М-21"),
        ("ru", {"en": "M-21", "ru": "М-21"}, "М-21"),
        ("ru", "М-21", "М-21"),
    ],
)
def test_the_group_of_a_template_is_named_in_its_language_or_the_first(language, group, said):
    assert Template({"language": language, "title": {"group": group}}, Path("a.yaml")).group == said


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"count": None}, "how many variants"),
        ({"count": 0}, "from 1 to"),
        ({"seed": -1}, "not negative"),
        ({"output": Path("a.txt")}, ".csv or .xlsx"),
        ({"count": 1, "students": "list.txt"}, "the list has 2 students"),
    ],
)
def test_mistakes_of_the_command_line(tmp_path, asked, said):
    (tmp_path / "list.txt").write_text("A\nB\n")
    given = {"count": 3, "seed": 1, "students": None, "output": tmp_path / "a.csv"} | asked
    given["students"] = given["students"] and tmp_path / given["students"]
    with pytest.raises(ProblemError, match=re.escape(said)):
        run(EXAMPLE, folder=None, language=None, talk=Heard(), **given)


# --- the page for teachers


def blocks() -> list[str]:
    return re.findall(r"```\w*\n(.*?)```", (DOCS / "assign.md").read_text("utf-8"), re.S)


def test_the_example_of_the_page_is_the_file_beside_it():
    assert blocks()[1] == EXAMPLE.read_text("utf-8")


@pytest.mark.exhaustive
def test_the_example_of_the_page_draws_what_the_page_shows(tmp_path):
    command = shlex.split(blocks()[0].splitlines()[0])
    seed = int(command[command.index("--seed") + 1])
    lines = assign(EXAMPLE, tmp_path / "a.csv", 3, seed)
    assert (tmp_path / "a.csv").read_text("utf-8-sig").split() == blocks()[2].split()
    assert "variants drawn: 3" in lines[0] and str(tmp_path / "a.csv") in lines[-1]

"""`check`: nothing that changed goes unseen, nothing that did not is reported."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from conftest import ALL_FILES, solved
from hypothesis import given
from hypothesis import strategies as st
from told import Told

from tmm_report.commands.check import numbers, stored, structure
from tmm_report.commands.check.numbers import VALUES, Sheet, Tolerance, Tolerances, differences
from tmm_report.commands.check.run import run
from tmm_report.problems import Message, ProblemError

ROOT = Path(__file__).parents[2]
SAMPLES = Path(__file__).parents[1] / "samples"


def check(folder, *, update=False, to=None, language="en"):
    """Whether nothing differs, and what was said."""
    talk = Told()
    return run(folder, update=update, junit=to, language=language, talk=talk), talk.lines


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    """A folder with one sample of each kind, stored as they are."""
    folder = tmp_path_factory.mktemp("samples")
    for name in ("eccentric", "quick_return"):
        for suffix in (".yaml", stored.SUFFIX):
            shutil.copy(SAMPLES / f"{name}{suffix}", folder)
    return folder


@pytest.fixture
def folder(good, tmp_path):
    """A copy to be spoiled, of the quick sample alone."""
    for suffix in (".yaml", stored.SUFFIX):
        shutil.copy(good / f"eccentric{suffix}", tmp_path)
    return tmp_path


def edited(folder, change, name="eccentric"):
    """A stored file with something else in it."""
    path = folder / f"{name}{stored.SUFFIX}"
    document = json.loads(path.read_text("utf-8"))
    change(document)
    path.write_text(json.dumps(document, ensure_ascii=False), "utf-8")


# ---------------------------------------------------------------- the project's own samples


@pytest.mark.exhaustive
def test_the_projects_own_samples_are_as_they_were():
    same, lines = check(SAMPLES)
    assert same, "\n".join(lines)
    assert lines[-1] == "samples: 4; different: 0 (numbers: 0, lines of notes: 0)"


@pytest.mark.parametrize("name", ["compressor", "eccentric", "hoist_drive", "quick_return"])
def test_a_stored_file_is_small_and_watches_every_table(name):
    path = SAMPLES / f"{name}{stored.SUFFIX}"
    assert path.stat().st_size < 150_000
    expected = stored.read(path)
    assert expected.structure and expected.numbers[VALUES]
    for columns in expected.numbers.values():
        assert all(len(cells) <= numbers.MOST_ROWS for cells in columns.values())


@pytest.mark.parametrize("name", [file.stem for file in ALL_FILES])
def test_what_is_written_is_read_back_without_a_difference(name, tmp_path):
    sheets = numbers.sheets(solved(name))
    tolerances = stored.tolerances_of(sheets)
    path = tmp_path / "one.expected.json"
    path.write_bytes(stored.written(tolerances, "en", sheets, ["# 1 Title"]))
    back = stored.read(path)
    assert back.tolerances == tolerances and back.structure == ("# 1 Title",)
    assert differences(back.numbers, sheets, Tolerances(Tolerance(0.0, 0.0))) == []


# ---------------------------------------------------------------- what is planted is found


@pytest.mark.exhaustive
def test_one_number_changed_is_the_one_difference(folder):
    def change(document):
        document["tables"]["eccentric_wheels"]["d"][1] *= 1.001

    edited(folder, change)
    same, lines = check(folder)
    assert not same
    assert lines[0] == "eccentric, numbers:"
    assert lines[1].startswith(
        "  chapter eccentric, table eccentric_wheels, row 2, column d: was 0.12012, is 0.12, "
    )
    assert "difference 0.00012" in lines[1]
    assert lines[2:] == ["samples: 1; different: 1 (numbers: 1, lines of notes: 0)"]


@pytest.mark.exhaustive
def test_one_heading_changed_is_the_one_difference(folder):
    def change(document):
        at = next(i for i, line in enumerate(document["structure"]) if line.startswith("## 1.3"))
        document["structure"][at] = "## 1.3 Something else"

    edited(folder, change)
    same, lines = check(folder)
    assert not same and lines[0] == "eccentric, structure of the note:"
    assert [line for line in lines if line.startswith("  -")] == ["  -## 1.3 Something else"]
    assert [line for line in lines if line.startswith("  +")] == ["  +## 1.3 Условие сборки"]
    assert lines[-1] == "samples: 1; different: 1 (numbers: 0, lines of notes: 2)"


@pytest.mark.exhaustive
def test_null_against_a_number_is_a_difference(folder):
    def change(document):
        document["values"]["eccentric_e"] = None

    edited(folder, change)
    assert "  chapter eccentric, value eccentric_e: was null, is 0.018" in check(folder)[1]


@pytest.mark.exhaustive
def test_what_came_and_what_went_is_a_difference(folder):
    def change(document):
        document["values"]["of_old"] = 7
        del document["tables"]["eccentric_wheels"]["d_a"]
        document["tables"]["eccentric_wheels"]["z"].append(1)

    edited(folder, change)
    same, lines = check(folder)
    assert not same and len(lines) == 5
    assert "  chapter —, value of_old: was 7, is —" in lines
    assert "  chapter eccentric, table eccentric_wheels, column d_a: was —, is [5]" in lines
    assert "  chapter eccentric, table eccentric_wheels, column z: was [6], is [5]" in lines


@pytest.mark.exhaustive
def test_a_tolerance_of_the_stored_file_lets_a_number_pass(folder):
    def change(document):
        document["tables"]["eccentric_wheels"]["d"][1] *= 1.001
        document["tolerance"]["tables.eccentric_wheels.d"] = 0.01

    edited(folder, change)
    assert check(folder)[0]


@pytest.mark.exhaustive
def test_another_teachers_variant_is_seen_in_numbers_and_structure(folder):
    text = (folder / "eccentric.yaml").read_text("utf-8")
    (folder / "eccentric.yaml").write_text(
        text.replace("eccentricity: 18 mm", "eccentricity: 20 mm"), "utf-8"
    )
    assert text != (folder / "eccentric.yaml").read_text("utf-8")
    same, lines = check(folder)
    assert not same and "  … and " in "\n".join(lines)


# ---------------------------------------------------------------- comparing


def sheet(columns, units=None, name="t"):
    rows = len(next(iter(columns.values())))
    units = units or {}
    labels = tuple(map(str, range(rows)))
    return Sheet("c", name, labels, columns, {key: [units.get(key, "N")] * rows for key in columns})


def found(old, new, tolerances=None, units=None):
    return differences({"t": old}, [sheet(new, units)], tolerances or Tolerances())


def test_noise_around_zero_is_no_difference():
    assert not found({"R": [1e-8, 5000.0]}, {"R": [-3e-7, 5000.0]})
    assert found({"R": [1e-8, 5000.0]}, {"R": [-3e-4, 5000.0]})


def test_a_component_is_as_exact_as_its_vector():
    assert not found({"R": [5000.0], "R_x": [1e-9]}, {"R": [5000.0], "R_x": [-1e-7]})
    assert found({"R": [5000.0], "R_x": [1e-9]}, {"R": [5000.0], "R_x": [1.0]})


def test_a_column_of_noise_beside_large_ones_is_no_difference():
    assert not found({"R": [5e6], "Q": [1e-9]}, {"R": [5e6], "Q": [3e-9]})
    assert found({"R": [5e6], "Q": [1e-2]}, {"R": [5e6], "Q": [2e-2]})
    assert found({"R": [5e6], "Q": [1e-9]}, {"R": [5e6], "Q": [3e-9]}, units={"Q": "m"})


def test_the_narrowest_tolerance_that_is_stated_counts():
    stated = Tolerances(places={"tables.t": Tolerance(0.1), "tables.t.R": Tolerance(0.0, 0.0)})
    assert [one.column for one in found({"R": [1.0], "Q": [1.0]}, {"R": [1.01], "Q": [1.01]}, stated)] == [
        "R"
    ]


finite = st.floats(-1e9, 1e9, allow_nan=False)
cells = st.none() | finite | st.text(max_size=4)


@given(st.lists(cells, min_size=1, max_size=6))
def test_a_column_is_like_itself(column):
    assert not found({"R": column}, {"R": column}, Tolerances(Tolerance(0.0, 0.0)))


@given(st.lists(finite, min_size=1, max_size=6), st.data())
def test_one_changed_cell_is_one_difference_there(column, data):
    row = data.draw(st.integers(0, len(column) - 1))
    other = [*column]
    other[row] = column[row] + 1.0 + abs(column[row])
    (one,) = found({"R": column}, {"R": other}, Tolerances(Tolerance(1e-12, 1e-12)))
    assert one.row == str(row) and one.size == pytest.approx(1.0 + abs(column[row]))


@given(st.lists(finite, min_size=1, max_size=6), st.lists(finite, min_size=1, max_size=6))
def test_forwards_and_backwards_differ_alike(one, other):
    forwards, backwards = found({"R": one}, {"R": other}), found({"R": other}, {"R": one})
    assert [(x.row, x.size) for x in forwards] == [(x.row, x.size) for x in backwards]


def test_the_structure_of_a_page_is_its_headings_captions_heads_and_labels():
    page = (
        '<nav class="contents"><h1>Contents</h1><p><a>1 One</a></p></nav><h1 id="a">1 One &amp; <b>all</b></h1>'
        '<p>words</p><div class="formula"><div class="math"><math><mi>v</mi></math></div>'
        '<div class="number">(1.1)</div></div><p class="caption">Table 1 – Numbers</p>'
        "<table><thead><tr><th>Position</th><th><math><mi>v</mi></math>, m/s</th></tr></thead>"
        "<tbody><tr><td>1</td></tr></tbody></table>"
        "<figure><svg><text>label</text></svg><figcaption>Figure 1 –\n A  picture</figcaption></figure><h2>1.1 Two</h2>"
    )
    assert structure.lines(page) == [
        "# 1 One & all", "(1.1)", "Table 1 – Numbers", "| Position | v, m/s |", "Figure 1 – A picture", "## 1.1 Two",
    ]  # fmt: skip


# ---------------------------------------------------------------- storing


@pytest.mark.exhaustive
def test_a_variant_without_a_stored_file_differs_until_it_is_stored(folder):
    path = folder / f"eccentric{stored.SUFFIX}"
    before = path.read_bytes()
    path.unlink()
    same, lines = check(folder)
    assert not same and "  no stored result; --update stores it" in lines and not path.exists()
    assert check(folder, update=True)[0] and path.read_bytes() == before
    assert check(folder)[0]


@pytest.mark.exhaustive
def test_update_says_what_changed_and_writes_only_that(good, tmp_path):
    shutil.copytree(good, tmp_path, dirs_exist_ok=True)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}

    def change(document):
        document["values"]["eccentric_e"] = 1.0
        document["tolerance"]["values.eccentric_e"] = 1e-6

    edited(tmp_path, change)
    done, lines = check(tmp_path, update=True)
    assert done and any("value eccentric_e: was 1, is 0.018" in line for line in lines)
    assert lines[-1] == f"written: {tmp_path / 'eccentric.expected.json'}"
    after = stored.read(tmp_path / "eccentric.expected.json")
    assert after.tolerances.places["values.eccentric_e"].relative == 1e-6
    assert (tmp_path / "quick_return.expected.json").read_bytes() == before["quick_return.expected.json"]
    assert check(tmp_path, update=True)[1] == ["nothing to store: no sample differs"]


@pytest.mark.exhaustive
def test_nothing_is_stored_where_one_sample_cannot_be_solved(folder):
    (folder / f"eccentric{stored.SUFFIX}").unlink()
    (folder / "broken.yaml").write_text("mechanism: 7\n", "utf-8")
    talk = Told()
    with pytest.raises(ProblemError, match=r"broken\.yaml"):
        run(folder, update=True, junit=folder / "out.xml", language="en", talk=talk)
    assert "eccentric, numbers:" in talk.lines
    assert not (folder / f"eccentric{stored.SUFFIX}").exists()
    assert b"<error" in (folder / "out.xml").read_bytes()


@pytest.mark.exhaustive
def test_a_stored_file_without_its_variant_is_a_difference_and_is_kept(folder):
    shutil.move(folder / "eccentric.yaml", folder / "other.yaml")
    same, lines = check(folder)
    assert not same
    assert any("eccentric.expected.json has no variant: put eccentric.yaml back" in line for line in lines)
    assert not check(folder, update=True)[0]
    assert (folder / f"eccentric{stored.SUFFIX}").exists() and (folder / f"other{stored.SUFFIX}").exists()
    assert "nothing to store: no sample differs" not in check(folder, update=True)[1]


@pytest.mark.exhaustive
def test_what_is_said_of_a_broken_stored_file_mends_it(folder):
    path = folder / f"eccentric{stored.SUFFIX}"
    path.unlink()
    check(folder, update=True)
    before = path.read_bytes()  # as this machine rounds
    path.write_bytes(before[:-9])
    with pytest.raises(ProblemError, match="remove it, then store anew: tmm-report check --update"):
        check(folder, update=True)
    path.unlink()
    assert check(folder, update=True)[0] and path.read_bytes() == before


@pytest.mark.parametrize("name", ["missing", "empty"])
def test_a_folder_without_variants_is_a_mistake(name, tmp_path):
    (tmp_path / "empty").mkdir()
    with pytest.raises(ProblemError):
        check(tmp_path / name)


def test_messages_carry_their_values():
    one = numbers.Difference("c", VALUES, "H_B\u202e", "", "1", "2", 1.0, 2.0)
    assert isinstance(one.message, Message)
    assert (
        str(one.message)
        == "chapter c, value H_B\N{REPLACEMENT CHARACTER}: was 1, is 2, difference 1 (5.0e-01 of the largest)"
    )

"""The batch: bad variants stop no good one, a stopped run goes on where it was, the same input gives the same bytes."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from urllib.parse import unquote

import batch_chores
import pytest
from batching import GAP, TEXT, Heard, batch, mixed, rows, statuses, student, tree, write
from hypothesis import given
from hypothesis import strategies as st
from notes import VARIANTS

from tmm_report import load, render, solve
from tmm_report.commands.batch import page, progress, summary
from tmm_report.commands.batch import record as records
from tmm_report.commands.batch import run as command
from tmm_report.commands.batch.inputs import Task, inputs
from tmm_report.i18n import Translator
from tmm_report.problems import Message, Problem, ProblemError
from tmm_report.quantity.text import Amount, Typed
from tmm_report.running.journal import read

POSIX = pytest.mark.skipif(sys.platform == "win32", reason="signals")


@pytest.fixture
def source(tmp_path) -> Path:
    return mixed(tmp_path / "variants")


# ---------------------------------------------------------------- what comes out


@pytest.mark.exhaustive
def test_bad_variants_among_good_ones(source, tmp_path):
    talk = Heard()
    assert not batch([source], tmp_path / "out", talk=talk)
    found = statuses(tmp_path / "out")
    assert list(found) == ["anna", "b_no_link", "boris", "c_deep", "d_gap", "vera"]
    assert {id for id, status in found.items() if status == "done"} == {"anna", "boris", "vera"}
    assert found["b_no_link"] == found["c_deep"] == "wrong" and found["d_gap"] == "check"
    told = "\n".join(talk.warned)
    assert re.search(r"variants/b_no_link\.yaml:\d+:\d+: mechanism\.link", told)
    assert re.search(r"variants/c_deep\.yaml:1:\d+: ", told)
    assert "variants: 6; done: 3;" in talk.told[0]


def test_outputs_are_those_of_solve(source, tmp_path):
    batch([source / "boris.yaml"], tmp_path / "out", "json,csv,html")
    results = solve(load(source / "boris.yaml"))
    expected = {
        name: content
        for fmt in ("json", "csv", "html")
        for name, content in render(results, fmt, "en").items()
    }
    assert tree(tmp_path / "out" / "boris") == expected


@pytest.mark.exhaustive
def test_nothing_but_folders_and_summaries_is_left(source, tmp_path):
    batch([source], tmp_path / "out")
    left = {file.name for file in (tmp_path / "out").iterdir()}
    assert left == {"anna", "boris", "d_gap", "vera", "summary.csv", "index.html", "journal.jsonl"}


@pytest.mark.exhaustive
def test_the_same_input_gives_the_same_bytes_whatever_the_processes(source, tmp_path):
    batch([source], tmp_path / "one", jobs=1)
    batch([source], tmp_path / "three", jobs=3)
    assert tree(tmp_path / "one") == tree(tmp_path / "three")


@pytest.mark.exhaustive
def test_the_summary_has_a_line_a_variant_with_its_main_numbers(source, tmp_path):
    batch([source, VARIANTS / "compressor.yaml"], tmp_path / "out")
    found = {row["id"]: row for row in rows(tmp_path / "out")}
    assert found["anna"]["student"] == "Anna" and found["anna"]["messages"] == ""
    results = solve(load(VARIANTS / "compressor.yaml"))
    assert float(found["compressor"]["H_B, m"]) == pytest.approx(0.2)
    assert float(found["compressor"]["drive_u"]) == pytest.approx(results.drive.ratio)
    ends = [extreme.value for extreme in results.lever.kinetostatics.extremes]
    assert float(found["compressor"]["M_bal, N·m"]) == pytest.approx(max(ends, key=abs))
    assert found["compressor"]["formula"] == results.lever.structure.formula
    assert "b_no_link.yaml" in found["b_no_link"]["messages"]


@pytest.mark.exhaustive
def test_the_page_links_to_what_is_there(source, tmp_path):
    write(source, **{"ö#1 %41&": student("<script>alert(1)</script>")})
    batch([source], tmp_path / "out", "json")
    text = (tmp_path / "out" / "index.html").read_text("utf-8")
    links = [unquote(link) for link in re.findall(r'<td><a href="([^"]+)"', text)]
    assert len(links) >= 4 and all((tmp_path / "out" / link).is_file() for link in links)
    assert "<script" not in text and "&lt;script&gt;" in text
    assert "Anna" in text and "not solved: 2" in text and "a check failed: 1" in text


def test_a_failed_check_is_told_and_its_note_is_written(tmp_path):
    talk = Heard()
    assert not batch([write(tmp_path / "one", gap=GAP)], tmp_path / "out", talk=talk)
    assert statuses(tmp_path / "out") == {"gap": "check"}
    assert (tmp_path / "out" / "gap" / "results.json").is_file()
    what = r"gap\.yaml:\d+:5: mechanism\.links\.2: error: rod AB = 90 mm cannot reach guide x"
    assert re.search(what, talk.warned[0])


def test_a_wrong_number_of_the_students_own_is_told_with_its_place(tmp_path):
    text = re.sub(r"\bv_C: [\d.]+", "v_C: 99", (VARIANTS / "compressor.yaml").read_text("utf-8"))
    batch([write(tmp_path / "one", own=text)], tmp_path / "out")
    (row,) = rows(tmp_path / "out")
    assert row["status"] == "check" and row["student"] == "Ivanov I. I."  # in the language of the note
    assert re.search(r"own\.yaml:\d+:\d+: readings\.\d+\.v_C: ", row["messages"])


def test_many_variants_go_over_several_pages(tmp_path, monkeypatch):
    monkeypatch.setattr(page, "ROWS", 2)
    monkeypatch.setattr(command, "work", batch_chores.trivial)
    source = write(tmp_path / "in", **{f"v{k}": TEXT for k in range(5)})
    batch([source], tmp_path / "out")
    pages = [tmp_path / "out" / name for name in ("index.html", "index-2.html", "index-3.html")]
    listed = [
        re.findall(r'class="number">(\d+)</td>', path.read_text("utf-8").replace("\n", "")) for path in pages
    ]
    assert listed == [["1", "2"], ["3", "4"], ["5"]]
    assert all(f'href="{name.name}"' in pages[0].read_text("utf-8") for name in pages[1:])
    for k in (2, 3, 4):
        (source / f"v{k}.yaml").unlink()
    batch([source], tmp_path / "out", resume=True)
    assert [path.exists() for path in pages] == [True, False, False]


def test_files_that_are_no_variants_are_told_and_the_rest_goes_on(source, tmp_path):
    (source / "folder.yaml").mkdir()
    talk = Heard()
    only = [source / "anna.yaml", source / "folder.yaml", tmp_path / "nowhere.yaml"]
    assert not batch(only, tmp_path / "out", talk=talk)
    assert statuses(tmp_path / "out") == {"anna": "done"}
    assert "nowhere.yaml" in "\n".join(talk.warned)
    assert "nowhere.yaml" in (tmp_path / "out" / "index.html").read_text("utf-8")


def test_no_variant_at_all_is_a_mistake(tmp_path):
    with pytest.raises(ProblemError, match="nowhere"):
        batch([tmp_path / "nowhere"], tmp_path / "out")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "name", ["index.html", "summary.csv", "journal.jsonl", "INDEX-2.html", "_index.html"]
)
def test_a_variant_named_like_a_file_of_the_batch_takes_nothing_from_it(tmp_path, name):
    source = write(tmp_path / "in", **{name: student("Anna"), "boris": student("Boris")})
    assert batch([source], tmp_path / "out")
    folder = tmp_path / "out" / f"_{name}"
    assert json.loads((folder / "results.json").read_text("utf-8"))["title"]["student"] == "Anna"
    assert (tmp_path / "out" / "index.html").is_file() and len(rows(tmp_path / "out")) == 2


def test_twins_have_a_folder_each(tmp_path):
    one, two = write(tmp_path / "a", ivanov=student("One")), write(tmp_path / "b", Ivanov=student("Two"))
    assert batch([one, two], tmp_path / "out")
    folders = [path.parent for path in (tmp_path / "out").rglob("results.json")]
    names = {
        json.loads((path / "results.json").read_text("utf-8"))["title"]["student"]: path for path in folders
    }
    assert names.keys() == {"One", "Two"}
    assert len({path.name.casefold() for path in folders}) == 2


@pytest.mark.parametrize(
    "options", [{"jobs": 0}, {"seconds": 0.0}, {"seconds": float("nan")}, {"formats": "pdf"}]
)
def test_senseless_options_are_mistakes(source, tmp_path, options):
    with pytest.raises(ProblemError):
        batch([source], tmp_path / "out", **options)


def test_a_table_gives_a_variant_a_row(tmp_path):
    table = tmp_path / "table.csv"
    table.write_text("id;student;mechanism.driver.speed\r\nanna;Anna;100 rpm\r\nboris;Boris;x\r\n", "utf-8")
    (tmp_path / "template.yaml").write_text(
        re.sub(r"(?m)^(\s+)period:.*$", r"\1speed: 60 rpm", TEXT), encoding="utf-8"
    )
    assert not batch([tmp_path / "template.yaml"], tmp_path / "out", table=table)
    assert statuses(tmp_path / "out") == {"anna": "done", "boris": "wrong"}
    assert "table.csv:3" in rows(tmp_path / "out")[1]["messages"]


# ---------------------------------------------------------------- accidents


@pytest.mark.exhaustive
def test_a_row_that_turned_wrong_has_no_old_note(tmp_path):
    talk, head = Heard(), "id;mechanism.driver.speed\n"
    table = tmp_path / "rows.csv"
    template = tmp_path / "one.yaml"
    template.write_text(TEXT, "utf-8")
    table.write_text(head + "v1;60 rpm\nv2;90 rpm\nv3;90 rpm\n", "utf-8")
    batch([template], tmp_path / "out", table=table)
    assert (tmp_path / "out" / "v3" / "results.json").is_file()
    table.write_text(head + "v1;60 rpm\nv2;90 kg\nv3;\n", "utf-8")
    batch([template], tmp_path / "out", talk=talk, table=table, resume=True)
    assert statuses(tmp_path / "out") == {"v1": "done", "v2": "wrong", "v3": "wrong"}
    assert not (tmp_path / "out" / "v2").exists() and not (tmp_path / "out" / "v3").exists()
    told = "\n".join(talk.warned)
    assert "rows.csv:3: mechanism.driver.speed" in told  # the line of the table, none of the template


def test_a_table_without_rows_is_a_mistake(tmp_path):
    (tmp_path / "one.yaml").write_text(TEXT, "utf-8")
    (tmp_path / "rows.csv").write_text("id;mechanism.driver.speed\n", "utf-8")
    with pytest.raises(ProblemError, match=r"rows\.csv: the table is empty"):
        batch([tmp_path / "one.yaml"], tmp_path / "out", table=tmp_path / "rows.csv")


@given(st.lists(st.sampled_from(["Ann", "Ann-2", "Ann-3", "ann-3", "Ann-3-3", "row-4"]), max_size=9))
def test_rows_never_share_a_folder(tmp_path_factory, names):
    folder = tmp_path_factory.mktemp("rows")
    (folder / "one.yaml").write_text(TEXT, "utf-8")
    lines = [f"{name};60 rpm" for name in [*names, "Ann"]]
    (folder / "rows.csv").write_text("\n".join(["student;mechanism.driver.speed", *lines]), "utf-8")
    ids = [task.id.casefold() for task in inputs([str(folder / "one.yaml")], folder / "rows.csv", []).tasks]
    assert len(ids) == len(names) + 1 and len(set(ids)) == len(ids)


# ---------------------------------------------------------------- what stands in the output folder already


@pytest.mark.exhaustive
def test_variants_and_notes_in_one_folder_lose_no_variant(source, tmp_path):
    (source / "petrov").mkdir()
    (source / "petrov" / "work.yaml").write_text(TEXT, "utf-8")
    (source / "anna.yaml.yaml").write_text(TEXT, "utf-8")
    before, talk = tree(source), Heard()
    assert not batch([source], source, talk=talk)
    assert before.items() <= tree(source).items()
    found = statuses(source)
    assert found["petrov"] == found["anna.yaml"] == "lost" and found["boris"] == "done"
    assert "petrov/work.yaml is not of the batch; move it away" in "\n".join(talk.warned)


@pytest.mark.parametrize("text", [TEXT, TEXT.replace("links:", "link:")], ids=["solved", "wrong"])
def test_a_folder_of_somebody_else_is_never_removed(tmp_path, text):
    (tmp_path / "out").mkdir()
    own = write(tmp_path / "out" / "anna", thesis="mine")
    batch([write(tmp_path / "in", anna=text)], tmp_path / "out")
    assert tree(own) == {"thesis.yaml": b"mine"} and statuses(tmp_path / "out") == {"anna": "lost"}


def test_what_tex_and_systems_leave_beside_a_note_stops_nothing(tmp_path):
    source = write(tmp_path / "in", anna=TEXT)
    batch([source], tmp_path / "out")
    for name in ("note.pdf", "note.aux", ".DS_Store"):
        (tmp_path / "out" / "anna" / name).write_text("x")
    write(source, anna=student("Another"))
    assert batch([source], tmp_path / "out", resume=True)
    assert list(tree(tmp_path / "out" / "anna")) == ["results.json"]


@pytest.mark.exhaustive
def test_variants_that_kill_hang_and_raise_are_lost_alone(tmp_path, monkeypatch):
    monkeypatch.setattr(command, "work", batch_chores.work)
    names = ("anna", "hangs", "kills", "raises", "vera")
    source = write(tmp_path / "in", **{name: student(name) for name in names})
    talk = Heard()
    assert not batch([source], tmp_path / "out", talk=talk, jobs=2, seconds=4.0)
    assert statuses(tmp_path / "out") == dict.fromkeys(names, "done") | dict.fromkeys(names[1:4], "lost")
    told = "\n".join(talk.warned)
    assert "hangs.yaml: not solved within 4 s" in told and "kills.yaml: the process" in told
    assert "raises.yaml: an error of the program: ZeroDivisionError: what nobody foresaw" in told
    kept = {record["id"]: record for _, record in read(tmp_path / "out" / "journal.jsonl")}
    assert "Traceback" in kept["raises"]["trace"]


@pytest.mark.exhaustive
def test_what_was_lost_is_tried_again_on_resuming(tmp_path, monkeypatch):
    monkeypatch.setattr(command, "work", batch_chores.work)
    source = write(tmp_path / "in", anna=student("Anna"), kills=student("Boris"))
    assert not batch([source], tmp_path / "out", jobs=2)
    monkeypatch.setenv("KILLS", "nobody")
    assert batch([source], tmp_path / "out", jobs=2, resume=True)
    batch([source], tmp_path / "other")
    assert tree(tmp_path / "out") == tree(tmp_path / "other")


# ---------------------------------------------------------------- parts


VALUES = st.one_of(
    st.text(max_size=9),
    st.integers(-9, 9),
    st.floats(allow_nan=False, allow_infinity=False),
    st.builds(Amount, st.floats(-1e9, 1e9), st.integers(1, 9), st.sampled_from(["", "mm", "deg"])),
    st.builds(Typed, st.sampled_from(["at: [40 deg, 0.5 m]", "2"])),
)
MESSAGES = st.recursive(
    st.builds(lambda v: Message("%(x)s", {"x": v}), VALUES),
    lambda inner: st.builds(lambda v: Message("%(x)s!", {"x": v}), inner),
    max_leaves=3,
)
PROBLEMS = st.builds(
    Problem, MESSAGES, st.none() | MESSAGES, st.lists(st.text(max_size=5)).map(tuple), st.text(max_size=5)
)


@pytest.mark.exhaustive
@given(st.lists(PROBLEMS, max_size=3))
def test_a_mistake_is_told_alike_before_and_after_the_journal(given_problems):
    task = Task(0, "a", "a.yaml", b"", "k")
    record = json.loads(json.dumps(records.failed(task, records.WRONG, given_problems)))
    for say in (str, Translator("ru").gettext):
        assert [p.text(say) for p in records.problems(record)] == [p.text(say) for p in given_problems]


@pytest.mark.parametrize(
    "seconds, said", [(0, "0:00"), (59.6, "1:00"), (61, "1:01"), (3599, "59:59"), (3661, "1:01:01")]
)
def test_time_left_is_read_as_a_clock(seconds, said):
    assert progress.clock(seconds) == said


def test_before_the_first_is_done_it_is_said_how_many_there_are(tmp_path):
    talk = Heard()
    batch([write(tmp_path / "in", anna=TEXT, boris=TEXT)], tmp_path / "out", talk=talk)
    assert talk.stages[0] == "0 of 2, 0 a second, — left"


def test_progress_tells_rate_and_time_left_at_most_five_times_a_second(monkeypatch):
    now = [0.0]
    monkeypatch.setattr(progress, "monotonic", lambda: now[0])
    talk = Heard()
    meter = progress.Progress(talk, 100)
    for k in range(1, 51):
        now[0] = 0.02 * k
        meter.done()
    assert len(talk.stages) in (4, 5)
    assert talk.stages[0].endswith("of 100, 50 a second, 0:02 left")


def test_the_key_goes_by_text_options_and_id(tmp_path):
    source = write(tmp_path / "in", a=TEXT, b=TEXT)

    def keys(*options: str) -> dict[str, str]:
        return {task.id: task.key for task in inputs([str(source)], None, options).tasks}

    first = keys("json")
    assert first["a"] != first["b"]
    assert keys("html")["a"] != first["a"] and keys("json") == first
    write(source, a=TEXT + "\n")
    assert keys("json")["a"] != first["a"] and keys("json")["b"] == first["b"]


def test_the_summary_holds_no_formula_of_a_spreadsheet(tmp_path):
    source = write(tmp_path / "in", a=student("=HYPERLINK(1)"))
    batch([source], tmp_path / "out")
    assert rows(tmp_path / "out")[0]["student"].startswith("'=")


def test_what_the_journal_brings_reverses_no_line_of_the_page(tmp_path):
    path = tmp_path / "journal.jsonl"
    line = {"key": "0", "id": "a", "status": "done", "student": "Анна\u202egnp.exe", "topic": "x"}
    path.write_text(json.dumps(line) + "\n", "utf-8")
    page.write(path, tmp_path, summary.counts(path), (), Translator("ru"))
    text = (tmp_path / "index.html").read_text("utf-8")
    assert "Анна" in text and "\u202e" not in text


def test_the_summary_keeps_few_columns_of_numbers(tmp_path):
    path = tmp_path / "journal.jsonl"
    lines = [
        {"key": "0", "id": str(k), "status": "done", "numbers": {f"H_{k}": [1.0, "m"]}} for k in range(99)
    ]
    path.write_text("".join(json.dumps(line) + "\n" for line in lines), "utf-8")
    summary.write(path, tmp_path, Translator("en"))
    assert len(rows(tmp_path)[0]) == 8 + summary.MOST

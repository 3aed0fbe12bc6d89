"""What students hand in, as it really comes: Moodle's folders of both kinds, folders without a sheet, archives of other
kinds, photographs, empty sheets. Who has answered is marked; nobody gets nought for what was not read."""

from __future__ import annotations

import csv
import io
import json
import os
import zipfile
from functools import partial
from itertools import product
from pathlib import Path

import pytest
from exhaustive import many
from notes import VARIANTS
from told import Told

from tmm_report.commands.grade import run as grade_run
from tmm_report.intake.sheets import read_sheets
from tmm_report.intake.writing import xlsx_bytes
from tmm_report.problems import ProblemError

RUBRIC = "positions: [7]\ntables: {rates_table: {columns: [v_B, v_D]}}\n"
GOOD = "position;v_B, м/с;v_D, м/с\n7;4,444;6,818\n"
HALF = "position;v_B;v_D\n7;4,444;1\n"
BLANK = "position;v_B;v_D\n7;;\n"
NAMES = {
    "s1": "Ёлкина-Петрова Анна",
    "s2": "Иванов Иван",
    "s3": "Иванов Пётр Сергеевич",
    "s4": "O'Brien Seán",
    "s5": "Смирнов С. А.",
}
GRADEBOOKS = {
    "marks.csv": ("id", "points"),
    "moodle.csv": ("ID number", "Grade"),
    "canvas.csv": ("SIS User ID", "TMM"),
}


def in_this_process(do, lists, **limits):
    """What processes of their own do, without the time that they take to start."""
    for some in lists:
        for index, found in do(some):
            yield some[index], found


@pytest.fixture
def year(tmp_path, monkeypatch) -> Path:
    """Five students' variants, a rubric, an empty folder for their answers."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(grade_run, "over", in_this_process)
    (tmp_path / "variants").mkdir()
    (tmp_path / "answers").mkdir()
    text = (VARIANTS / "compressor.yaml").read_text("utf-8")
    text = text[: text.index("\nloads:")] + "\npositions: {table: 12}\n"
    body = text[text.index("\nmechanism:") :]
    for id, name in NAMES.items():
        title = f'title: {{student: "{name}", group: М-31, variant: {id}}}\nlanguage: ru\n'
        (tmp_path / "variants" / f"{id}.yaml").write_text(title + body, "utf-8")
    (tmp_path / "rubric.yaml").write_text(RUBRIC, "utf-8")
    return tmp_path


def lay(name: str, content: str | bytes = GOOD) -> None:
    path = Path("answers", name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content.encode() if isinstance(content, str) else content)


def graded(*answers: str, **more) -> tuple[bool, list[str]]:
    """Whether every work was marked, and what was told."""
    told = Told()
    run = partial(grade_run.run, rubric=Path("rubric.yaml"), jobs=1)
    done = run(["variants"], answers or ["answers"], Path("marks"), None, "en", told, **more)
    return done, told.lines


def column(file: str = "marks.csv", of: str = "") -> dict[str, str]:
    """Id -> what a gradebook has in a column, the mark by default."""
    key, mark = GRADEBOOKS[file]
    text = Path("marks", file).read_text("utf-8-sig")
    delimiter = ";" if ";" in text.partition("\n")[0] else ","
    rows = csv.DictReader(io.StringIO(text), delimiter=delimiter)
    return {row[key]: row[of or mark] for row in rows if row[key]}


def marks(file: str = "marks.csv") -> dict[str, float | None]:
    return {id: float(text) if text else None for id, text in column(file).items()}


def page(id: str) -> str:
    return Path("marks", "feedback", f"{id}.html").read_text("utf-8")


# ---------------------------------------------------------------- Moodle's folders

OWNERS = {
    "s1": "Анна Елкина Петрова_101",  # another order, е for ё, no hyphen
    "s2": "Кто-то Другой_102",  # by the number of the list alone
    "s3": "М-31-Иванов Пётр_103",  # a group before the name, the patronymic left out
    "s4": "OBrien Sea\u0301n_104",  # decomposed
    "s5": "Смирнов Сергей Андреевич_105",  # the list has initials
}


def submissions(kind: str) -> dict[str, bytes]:
    """Moodle's download of a class: `old` with the underscore behind, `new` without, `flat` without folders."""
    end = {"old": "_assignsubmission_file_/sheet.csv", "new": "_assignsubmission_file/sheet.csv"}
    files = {
        f"{name}{end.get(kind, '_assignsubmission_file_sheet.csv')}": GOOD.encode()
        for name in OWNERS.values()
    }
    tail = "_assignsubmission_onlinetext" + ("_/" if kind == "old" else "/" if kind == "new" else "_")
    return {**files, f"{OWNERS['s1']}{tail}onlinetext.html": b"<p>see the file</p>"}


KINDS, PACKED = ("old", "new", "flat"), ("folder", "folder within", "zip", "zip of a folder")
DOWNLOADS = [("old", "zip of a folder"), ("new", "folder within"), ("flat", "folder"), ("flat", "zip")]
OTHERS = [case for case in product(KINDS, PACKED) if case not in DOWNLOADS]


@pytest.mark.parametrize(("kind", "packed"), many([*DOWNLOADS, *OTHERS], len(DOWNLOADS)))
def test_moodles_download_is_matched_by_number_then_by_name(year, kind, packed):
    roster = "id,name,moodle_id\n" + "".join(
        f"{id},{name},{'102' * (id == 's2')}\n" for id, name in NAMES.items()
    )
    Path("roster.csv").write_text(roster, "utf-8")
    around = {"folder within": "ТММ-лист-12/", "zip of a folder": "ТММ-лист-12/"}.get(packed, "")
    if kind == "flat" and packed == "folder within":
        pytest.skip("nothing tells that folder from a student's")
    place = "answers"
    if packed.startswith("zip"):
        place = "answers.zip"
        with zipfile.ZipFile(place, "w") as archive:
            for name, content in submissions(kind).items():
                archive.writestr(around + name, content)
    else:
        for name, content in submissions(kind).items():
            lay(around + name, content)
    done, told = graded(place, roster=Path("roster.csv"))
    assert done and marks() == dict.fromkeys(NAMES, 100.0), told
    assert any("texts typed into Moodle are passed over: 1" in line for line in told)
    numbers = {id: name.rpartition("_")[2] for id, name in OWNERS.items()}
    assert column("moodle.csv", "Identifier") == {
        id: f"Participant {number}" for id, number in numbers.items()
    }


def test_without_a_list_the_variants_say_the_names(year):
    """Of one that is given by languages the first."""
    file = year / "variants/s1.yaml"
    text = file.read_text("utf-8")
    file.write_text(text.replace(f'"{NAMES["s1"]}"', f'{{ru: "{NAMES["s1"]}", en: John}}'), "utf-8")
    for id, name in OWNERS.items():
        if id != "s2":
            lay(f"{name}_assignsubmission_file_/sheet.csv")
    assert not graded()[0]
    assert marks() == {**dict.fromkeys(NAMES, 100.0), "s2": None}


@pytest.mark.exhaustive
def test_namesakes_are_told_and_neither_gets_the_others_mark(year):
    for number in ("7", "8"):
        lay(f"Иванов Иван_{number}_assignsubmission_file_/sheet.csv")
    lay("Иванов_9_assignsubmission_file_/sheet.csv")
    done, told = graded()
    assert not done and marks()["s2"] is None and marks()["s3"] is None
    assert any(
        "works of two students, or of one twice: Иванов Иван_7, Иванов Иван_8" in line for line in told
    )
    Path("roster.csv").write_text("id,moodle_id\ns2,8\n", "utf-8")
    graded(roster=Path("roster.csv"))
    assert marks()["s2"] == 100


def test_the_parts_of_a_sheet_may_lie_loose(year):
    lay("s1.csv", "position;v_B\n7;4,444\n")
    lay("s1-rates_table.csv", "position;v_D\n7;6,818\n")
    graded()
    assert marks()["s1"] == 100


# ---------------------------------------------------------------- nothing that can be marked

CANNOT = {
    "pdf": ("s2.pdf", b"%PDF-1.4", "s2.pdf: this is none of"),
    "pdf in a folder": ("s2/work.pdf", b"%PDF-1.4", "s2/work.pdf: this is none of"),
    "document": ("s2/work.docx", b"PK", "work.docx"),
    "photograph": ("s2/photo.JPG", b"\xff\xd8", "photo.JPG"),
    "old Excel": ("s2.xls", b"\xd0\xcf", "save it as .xlsx or .csv"),
    "rar": ("s2.rar", b"Rar!", "make it a ZIP"),
    "7z in a folder": ("s2/work.7z", b"7z", "make it a ZIP"),
    "tar": ("s2.tar", b"x", "make it a ZIP"),
    "typed": ("Иванов Иван_5_assignsubmission_onlinetext_/onlinetext.html", b"x", "text typed into Moodle"),
    "broken workbook": ("s2.xlsx", b"PK\x03\x04", "s2.xlsx"),
    "control characters": ("s2.csv", b"position;v_B\n7;\x004\n", "s2.csv:2"),
    "no names": ("s2.csv", b"a;b\n7;4\n", "s2.csv"),
}


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", many(CANNOT, 4))
def test_what_cannot_be_read_gets_its_reason_and_no_mark_anywhere(year, name):
    file, content, reason = CANNOT[name]
    lay("s1.csv")
    lay(file, content)
    done, told = graded()
    assert not done
    line = next(line for line in told if line.startswith("s2: could not be read: "))
    assert reason in line
    no_mark("s2")
    assert marks()["s1"] == 100 and reason in column(of="likely causes")["s2"]
    assert column(of="remark")["s2"] == "could not be read"
    assert "Без оценки: не удалось прочитать" in page("s2") and "Иванов Иван" in page("s2")
    assert "could not be read" not in page("s2") and "Баллы" not in page("s2")
    assert reason in Path("marks", "statistics.html").read_text("utf-8") or "'" in reason


def no_mark(id: str) -> None:
    """No gradebook has a mark, be it 0."""
    assert [column(file)[id] for file in GRADEBOOKS] == ["", "", ""]
    assert "score" not in json.loads(Path("marks", "gradescope", id, "results.json").read_bytes())
    for sheet in read_sheets("marks", "marks.xlsx", Path("marks/marks.xlsx").read_bytes()):
        [row] = [row for row in sheet.rows if row[0].text == id]
        assert not [cell.text for cell in row[4:11] if cell.text]


ABSENT = {
    "no file": {},
    "an empty folder": {"s2/.keep": b""},
    "a sheet left empty": {"s2.csv": BLANK.encode()},
    "a workbook left empty": {
        "s2.xlsx": xlsx_bytes({"rates_table": [["position", "v_B"], [7, None]], "values": []})
    },
    "scales alone": {"s2.yaml": b"scales: {mu_v: 0.1}\n7: {v_B: , v_D: '-'}\n"},
}


@pytest.mark.parametrize("name", many(ABSENT, 2))
def test_what_is_not_handed_in_is_not_nought(year, name):
    for id in NAMES:
        if id != "s2":
            lay(f"{id}.csv")
    for file, content in ABSENT[name].items():
        lay(file, content)
    done, told = graded()
    assert not done and "works marked: 4, not handed in: 1, not marked: 0" in told
    assert any(line.startswith("s2: not handed in") for line in told)
    no_mark("s2")
    assert "points: mean 100 %, median 100 %, half of the works from 100 to 100 %" in told
    statistics = Path("marks", "statistics.html").read_text("utf-8")
    assert "<h2>Not handed in</h2>" in statistics and "Иванов Иван (s2)" in statistics
    assert "Без оценки: не сдано" in page("s2")


@pytest.mark.parametrize(
    ("place", "content", "state"),
    [("nowhere", None, "not handed in"), ("empty", b"", "not handed in"), ("all.rar", b"Rar!", "could not be read"),
     ("all.zip", b"PK\x03\x04 broken", "could not be read"), ("all.tar.gz", b"\x1f\x8b", "could not be read")],
)  # fmt: skip
def test_a_place_without_answers_gives_nobody_a_mark(year, place, content, state):
    if place == "empty":
        Path("empty").mkdir()
    elif content is not None:
        Path(place).write_bytes(content)
    done, told = graded(place)
    assert not done and marks() == dict.fromkeys(NAMES)
    assert set(column(of="remark").values()) == {state}
    assert all(place in reason for reason in column(of="likely causes").values()) and place in " ".join(told)


@pytest.mark.exhaustive
def test_a_report_beside_the_sheet_is_passed_over_and_a_broken_sheet_told(year):
    for id in NAMES:
        lay(f"{id}/sheet.csv")
    lay("s1/report.pdf", b"%PDF")
    lay("s1/deeper/photo.jpg", b"x")
    done, told = graded()
    assert done and not any("report.pdf" in line for line in told)
    lay("s1/values.xlsx", b"PK broken")
    done, told = graded()
    assert not done and marks()["s1"] == 100 and any("values.xlsx" in line for line in told)


def test_a_work_at_two_places_is_nobodys(year):
    lay("s1.csv")
    Path("more").mkdir()
    Path("more", "s1.csv").write_text(HALF, "utf-8")
    graded("answers", "more")
    assert marks()["s1"] is None and "handed in at two places" in column(of="likely causes")["s1"]


def test_of_an_archive_empty_folders_and_other_files_are_told_as_of_a_folder(year):
    with zipfile.ZipFile("answers.zip", "w") as archive:
        archive.mkdir("лист/s1")
        archive.writestr("лист/s2/work.pdf", b"%PDF")
        archive.writestr("лист/s3/sheet.csv", GOOD)
        archive.writestr("лист/s4/inner/sheet.csv", GOOD)
        archive.writestr("лист/s5/inner.7z", b"7z")
        archive.writestr("__MACOSX/лист/._s1.csv", b"x")
    graded("answers.zip")
    assert marks() == {**dict.fromkeys(NAMES), "s3": 100, "s4": 100}
    states = column(of="remark")
    assert (states["s1"], states["s2"], states["s5"]) == (
        "not handed in",
        "could not be read",
        "could not be read",
    )
    assert "the folder holds no sheet" in column(of="likely causes")["s1"]
    assert "answers.zip:лист/s2/work.pdf" in column(of="likely causes")["s2"]


# ---------------------------------------------------------------- attempts

TRIES = {
    "a copy": {"s1/sheet.csv": HALF, "s1/sheet (1).csv": GOOD, "s1/sheet (2).csv": BLANK},
    "a number": {"s1.csv": HALF, "s1_2.csv": GOOD},
    "folders": {"s1/attempt1/sheet.csv": HALF, "s1/attempt2/sheet.csv": GOOD},
    "in Russian": {"s1/Попытка 1/a.csv": HALF, "s1/Попытка 2/b.csv": GOOD},
    "of all": {"attempt1/s1.csv": HALF, "attempt2/s1/sheet.csv": GOOD},
    "worse later": {"s1/sheet.csv": GOOD, "s1/sheet (1).csv": HALF},
    "a part again": {"s1/sheet.csv": "position;v_B\n7;4,444\n", "s1/b.csv": "position;v_D\n7;1\n",
                     "s1/b (1).csv": "position;v_D\n7;6,818\n"},
}  # fmt: skip


LAST, BEST = "attempts: last\n", "attempts: best\n"
RULED = [*((name, "") for name in TRIES), ("worse later", BEST)]
OTHERWISE = [case for case in product(TRIES, (LAST, BEST)) if case not in RULED]


@pytest.mark.parametrize(("name", "rule"), many([*RULED, *OTHERWISE], len(RULED)))
def test_of_several_attempts_the_last_counts_or_the_best(year, name, rule):
    for file, content in TRIES[name].items():
        lay(file, content)
    Path("rubric.yaml").write_text(RUBRIC + rule, "utf-8")
    graded()
    worse = name == "worse later" and "best" not in rule
    assert marks()["s1"] == (50 if worse else 100)
    which = 2 if name != "worse later" or worse else 1
    several = len(TRIES[name]) if name != "a part again" else 2
    assert column(of="remark")["s1"] == f"attempt {which} of {several}"
    assert f"попытка {which} из {several}" in page("s1")


# ---------------------------------------------------------------- marks set by hand


@pytest.mark.exhaustive
def test_a_mark_set_by_hand_stands_at_the_next_run(year):
    lay("s1.csv", HALF)
    lay("s3.csv")
    graded()
    Path("marks", "overrides.csv").write_text(
        "id;points;reason\ns1;85,5;=устная защита\ns2;60;work on paper\n", "utf-8"
    )
    for _ in range(2):
        _, told = graded()
        assert marks() == {"s1": 85.5, "s2": 60.0, "s3": 100.0, "s4": None, "s5": None}
        assert marks("moodle.csv") == marks() == marks("canvas.csv")
    assert "works marked: 3, not handed in: 2, not marked: 0" in told
    assert column(of="points reckoned")["s1"] == "50.0" and column(of="points reckoned")["s2"] == ""
    assert column(of="remark")["s2"] == "not handed in; set by hand: work on paper"
    assert "устная защита" in column("moodle.csv", "Feedback comments")["s1"]
    assert json.loads(Path("marks/gradescope/s1/results.json").read_bytes())["score"] == 85.5
    assert (
        "85,5 из 100" in page("s1")
        and "устная защита" in page("s1")
        and "Баллов по расчёту: 50 из 100" in page("s1")
    )
    assert "60 из 100" in page("s2") and "по расчёту" not in page("s2")
    assert "Иванов Иван (s2): 60, reckoned: —; work on paper" in Path("marks/statistics.html").read_text(
        "utf-8"
    )
    Path("marks", "overrides.csv").unlink()
    graded()
    assert marks()["s1"] == 50 and marks()["s2"] is None


def test_bad_rows_are_told_and_whom_they_name_gets_no_other_mark(year):
    for id in NAMES:
        lay(f"{id}.csv")
    Path("marks").mkdir()
    rows = ["id,points,reason", "s1,many,", "nobody,5,", "s2,101,", "s3,50,a", "s3,60,b", "s4,-1,", "s5,70,"]
    Path("marks", "overrides.csv").write_text("\n".join(rows) + "\n", "utf-8")
    done, told = graded()
    assert not done and marks() == {"s1": None, "s2": None, "s3": None, "s4": None, "s5": 70.0}
    for line, words in ((2, "many are no points"), (3, "there is no work nobody"), (4, "101 are no points"),
                        (6, "s3 has two marks"), (7, "-1 are no points")):  # fmt: skip
        assert any(f"overrides.csv:{line}: {words}" in said for said in told), (line, told)
    assert "overrides" not in page("s1")
    Path("marks", "overrides.csv").write_text("id,mark\ns1,5\n", "utf-8")
    with pytest.raises(ProblemError, match="has no column points"):
        graded()


# ---------------------------------------------------------------- where it is written


@pytest.mark.skipif(os.name == "nt", reason="links of a POSIX system")
@pytest.mark.parametrize("name", ["feedback", "gradescope", "gradescope/s1", ".tmm-report.part"])
def test_no_mark_goes_through_a_link(year, name):
    lay("s1.csv")
    thesis = Path("elsewhere", "s1.html")
    thesis.parent.mkdir()
    thesis.write_text("thesis")
    Path("marks", name).parent.mkdir(parents=True)
    Path("marks", name).symlink_to(thesis.parent.resolve())
    with pytest.raises(ProblemError, match="is a link: nothing is written through it"):
        graded()
    assert thesis.read_text() == "thesis" and [*thesis.parent.iterdir()] == [thesis]
    assert not Path("marks", "marks.csv").exists()


@pytest.mark.skipif(os.name == "nt", reason="links of a POSIX system")
def test_a_linked_file_is_replaced_and_what_it_leads_to_stays(year):
    lay("s1.csv")
    Path("thesis").write_text("thesis")
    Path("marks", "feedback").mkdir(parents=True)
    for name in ("marks.csv", "feedback/s1.html"):
        Path("marks", name).symlink_to(Path("thesis").resolve())
    graded()
    assert Path("thesis").read_text() == "thesis" and not Path("marks", "feedback", "s1.html").is_symlink()


def tree() -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in Path("marks").rglob("*") if path.is_file()}


@pytest.mark.exhaustive
@pytest.mark.skipif(os.name == "nt", reason="limits of a POSIX system")
@pytest.mark.parametrize("late", [False, True], ids=["at a page", "when all pages are made"])
def test_a_full_disk_leaves_all_as_it_was(year, late, monkeypatch):
    import resource

    lay("s1.csv")
    graded()
    before = tree()
    lay("s1.csv", HALF)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)

    def filled(*given):
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
        return statistics(*given)

    statistics = grade_run.statistics
    monkeypatch.setattr(grade_run, "statistics", filled)
    try:
        if not late:
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
        with pytest.raises(ProblemError, match="cannot write into"):
            graded()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert tree() == before
    monkeypatch.setattr(grade_run, "statistics", statistics)
    graded()
    assert marks()["s1"] == 50 and not [name for name in tree() if ".part" in name]

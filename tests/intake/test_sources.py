"""Places -> sources: folders, students' folders, patterns, archives; what is refused is told, the rest goes on."""

import os
import pickle
import zipfile
from pathlib import Path

import pytest
from confined import confined
from packing import packed

from tmm_report.intake.sources import sources
from tmm_report.problems import ProblemError

YAML = {".yaml", ".yml"}
TABLES = {".csv", ".xlsx"}
ATTACKS = Path(__file__).parent / "attacks"


@pytest.fixture
def here(tmp_path, monkeypatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def lay(*names: str) -> None:
    for name in names:
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).write_bytes(name.encode())


def found(*places: str, suffixes=YAML) -> dict[str, tuple[str, str]]:
    """Label -> id, group, of places at which nothing is refused."""
    made, problems = sources(places, suffixes)
    assert problems == []
    assert len({source.id for source in made}) == len(made)
    return {source.label: (source.id, source.group) for source in made}


def refused(*places: str, suffixes=YAML) -> list[str]:
    return [problem.text() for problem in sources(places, suffixes)[1]]


def test_files_of_a_folder_by_suffix_in_the_order_of_their_names(here):
    lay("v/petrov.yaml", "v/ivanov.YAML", "v/Сидоров.yml", "v/readme.txt", "v/.git/x.yaml", "v/._petrov.yaml")
    assert found("v") == {
        "v/ivanov.YAML": ("ivanov", "ivanov"), "v/petrov.yaml": ("petrov", "petrov"),
        "v/Сидоров.yml": ("Сидоров", "Сидоров"),
    }  # fmt: skip
    assert list(found("v")) == sorted(found("v"))


def test_a_source_reads_its_file_and_travels_between_processes(here):
    lay("v/a.yaml")
    Path("v.zip").write_bytes(packed({"a.yaml": b"packed"}))
    (plain, inside), _ = sources(["v", "v.zip"], YAML)
    assert (plain.read(), inside.read()) == (b"v/a.yaml", b"packed")
    assert [pickle.loads(pickle.dumps(source)) for source in (plain, inside)] == [plain, inside]
    assert len(pickle.dumps(inside)) < 400


def test_a_file_a_pattern_and_several_places(here):
    lay("v/a.yaml", "v/b.yaml", "w/c.yaml", "w/d.txt")
    assert list(found("w/c.yaml", "v/*.yaml")) == ["w/c.yaml", "v/a.yaml", "v/b.yaml"]
    assert list(found(str(here / "v" / "a.yaml"))) == [(here / "v" / "a.yaml").as_posix()]


def test_a_file_found_twice_counts_once(here):
    lay("v/a.yaml", "v/b.yaml")
    assert list(found("v/b.yaml", "v", "./v", "v/*", "v/a.yaml")) == ["v/b.yaml", "v/a.yaml"]


def test_a_name_that_looks_like_a_pattern_is_the_file_first(here):
    lay("a[1].yaml", "a1.yaml")
    assert list(found("a[1].yaml")) == ["a[1].yaml"]


def test_a_students_folder_is_one_student(here):
    lay("answers/ivanov/answers.csv", "answers/petrov/a.csv", "answers/petrov/b.xlsx", "answers/sidorov.csv")
    lay("answers/ivanov/report.pdf")
    assert found("answers", suffixes=TABLES) == {
        "answers/ivanov/answers.csv": ("ivanov", "ivanov"),
        "answers/petrov/a.csv": ("petrov-a.csv", "petrov"),
        "answers/petrov/b.xlsx": ("petrov-b.xlsx", "petrov"),
        "answers/sidorov.csv": ("sidorov", "sidorov"),
    }


def test_two_kinds_of_file_of_one_name_are_one_students(here):
    lay("ivanov.csv", "ivanov.xlsx")
    assert found(".", suffixes=TABLES) == {
        "ivanov.csv": ("ivanov-csv", "ivanov"),
        "ivanov.xlsx": ("ivanov-xlsx", "ivanov"),
    }


def test_twins_are_two_whatever_the_order(here):
    lay("a/ivanov.yaml", "b/Ivanov.yaml", "c/petrov.yaml")
    there = found("a", "b", "c")
    assert there == found("c", "b", "a")
    assert there["c/petrov.yaml"] == ("petrov", "petrov")
    for label in ("a/ivanov.yaml", "b/Ivanov.yaml"):
        name, group = there[label]
        assert name == group and len(name) == len("ivanov-") + 8


@pytest.mark.skipif(os.name == "nt", reason="other names are legal there")
def test_odd_names_are_listed_with_safe_ids(here):
    odd = [
        "a\nb.yaml",
        "-rf.yaml",
        "x .yaml",
        "CON.yaml",
        "й.yaml",
        "и\u0306.yaml",
        "\x1b[31m.yaml",
        "ж" * 100 + ".yaml",
    ]
    lay(*(f"v/{name}" for name in odd))
    made = found("v")
    assert len(made) == len(odd)
    assert not any(set("\n\x1b \\/") & set(name) for name, _ in made.values())
    assert not any(set("\n\x1b") & set(label) for label in made)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs links and pipes")
def test_links_pipes_folders_and_undecodable_names_are_told_and_the_rest_goes_on(here):
    lay("v/good.yaml", "secret/passwd")
    os.symlink(here / "secret" / "passwd", "v/link.yaml")
    os.symlink(here / "secret", "v/student")
    os.symlink("/dev/zero", "v/zero.yaml")
    os.mkfifo("v/pipe.yaml")
    Path("v/folder.yaml").mkdir()
    with open(b"v/iv\xff.yaml", "wb"):
        pass
    made, problems = sources(["v"], YAML)
    assert [source.label for source in made] == ["v/good.yaml"]
    assert [problem.text() for problem in problems] == [
        "v/folder.yaml: this is a folder",
        "v/iv\\xff.yaml: the file's name is not in UTF-8; rename the file",
        "v/link.yaml: the file is a link; name the file itself",
        "v/pipe.yaml: this is not a regular file",
        "v/student: the folder is a link; name the folder itself",
        "v/zero.yaml: the file is a link; name the file itself",
    ]
    assert refused("v/link.yaml") == ["v/link.yaml: the file is a link; name the file itself"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs links and pipes")
def test_a_file_that_becomes_a_link_or_a_pipe_after_it_was_listed_is_not_read(here):
    lay("a.yaml", "b.yaml", "secret")
    made, _ = sources(["."], YAML)
    Path("a.yaml").unlink()
    os.symlink("secret", "a.yaml")
    Path("b.yaml").unlink()
    os.mkfifo("b.yaml")
    for source, wrong in zip(made, ("is a link", "not a regular file"), strict=True):
        with pytest.raises(ProblemError, match=wrong):
            source.read()


def test_places_without_files_are_told(here):
    lay("v/readme.txt")
    assert refused("nowhere", "no*where", "v", "v/readme.txt") == [
        "nowhere: there is no such file or folder",
        "no*where: there is no such file or folder",
        "v: there is no file *.yaml, *.yml here",
        "v/readme.txt: the file is none of *.yaml, *.yml",
    ]
    assert refused("a\0b.yaml") == ["a�b.yaml: there is no such file or folder"]


def test_other_archives_are_not_read(here):
    lay("v/a.yaml", "v/more.zip", "all.tar.gz", "all.rar")
    assert refused("v", "all.tar.gz", "all.rar", str(ATTACKS / "A04_tar_slip.tar"))[:3] == [
        "v/more.zip: an archive in a folder is not opened; name the archive itself",
        "all.tar.gz: this archive is not read; make it a ZIP",
        "all.rar: this archive is not read; make it a ZIP",
    ]


def test_files_of_an_archive(here):
    Path("v.zip").write_bytes(
        packed({"b.yaml": b"", "a.yaml": b"", "c/d.yaml": b"", "readme.txt": b"", "__MACOSX/._a.yaml": b""})
    )
    assert found("v.zip") == {
        "v.zip:a.yaml": ("a", "a"),
        "v.zip:b.yaml": ("b", "b"),
        "v.zip:c/d.yaml": ("c", "c"),
    }


def test_the_folder_around_a_packed_folder_is_nobodys_name(here):
    Path("v.zip").write_bytes(
        packed({"answers/ivanov.csv": b"", "answers/petrov.csv": b"", "answers/sidorov/x.csv": b""})
    )
    assert [group for _, group in found("v.zip", suffixes=TABLES).values()] == ["ivanov", "petrov", "sidorov"]


def test_moodles_submissions(here):
    tail = "_assignsubmission_file_"
    Path("all.zip").write_bytes(
        packed(
            {
                f"Иванов Иван_12345{tail}/answers.xlsx": b"",
                f"Петров Пётр_777{tail}/answers.csv": b"",
                f"Петров Пётр_777{tail}/work/plans.csv": b"",
                f"Яковлев Я_9{tail}answers.csv": b"",
            }
        )
    )
    assert [group for _, group in found("all.zip", suffixes=TABLES).values()] == [
        "Иванов_Иван_12345", "Петров_Пётр_777", "Петров_Пётр_777", "Яковлев_Я_9",
    ]  # fmt: skip


def test_one_students_archive_of_moodle_keeps_its_name(here):
    Path("one.zip").write_bytes(packed({f"Иванов_1_assignsubmission_file_/{n}.csv": b"" for n in "ab"}))
    assert {group for _, group in found("one.zip", suffixes=TABLES).values()} == {"Иванов_1"}


@pytest.mark.exhaustive
def test_hostile_archives_are_told_and_the_rest_goes_on(here):
    lay("good.yaml")
    Path("broken.zip").write_bytes(b"PK\3\4 no")
    with zipfile.ZipFile("bomb.zip", "w", zipfile.ZIP_DEFLATED) as bomb:
        bomb.writestr("ivanov.yaml", bytes(2**20 * 100))
    places = ["A01_zip_slip.zip", "A02_zip_symlink.zip"]
    made, problems = sources(
        [*(str(ATTACKS / name) for name in places), "broken.zip", "bomb.zip", "good.yaml"], YAML
    )
    assert [source.id for source in made] == ["ok", "good"]
    assert [problem.text().rpartition(": ")[2] for problem in problems] == [
        *["the name leads out of the archive"] * 3,
        "the file is a link; pack the file itself",
        "this is not a ZIP archive, or it is broken; make an ordinary ZIP archive",
        "the file is larger than 5120 kB",
    ]


def test_members_whose_paths_are_one_on_a_disk_are_two_in_an_archive(here):
    Path("twins.zip").write_bytes(
        packed({f"class/ivanov/{way}a.yaml": b"a: 1" for way in ("", "/", "./")} | {"class/petrov.yaml": b""})
    )
    made = found("twins.zip")
    assert sorted(group for _, group in made.values()) == ["ivanov"] * 3 + ["petrov"]


@pytest.mark.exhaustive
def test_names_of_endless_marks_are_not_put_in_order(here):
    """Sixty names of thirty thousand marks each: in order they would take a minute."""
    marks = "\u0301\u0316" * 15_000
    Path("marks.zip").write_bytes(packed({f"{n}x{marks}.yaml": b"a: 1" for n in range(60)}))
    said = confined(
        'made, _ = sources.sources(["marks.zip"], {".yaml"})\nprint(len({one.id for one in made}))'
    )
    assert said == "60\n"


@pytest.mark.exhaustive
def test_a_large_file_is_not_read_whole(here):
    program = """
import os
with open("big.yaml", "wb") as stream:
    stream.truncate(10 * 2**30)
(source,), _ = sources.sources(["big.yaml"], {".yaml"})
try:
    source.read()
except ProblemError as error:
    print(error)
os.unlink("big.yaml")
"""
    if os.name == "nt":
        pytest.skip("files there are not sparse")
    assert confined(program) == "big.yaml: the file is larger than 5120 kB\n"


def test_a_thousand_files_of_an_archive_do_not_cost_a_thousand_directories(here, monkeypatch):
    Path("v.zip").write_bytes(packed({f"{n}.yaml": b"a: 1" for n in range(1000)}))
    made, _ = sources(["v.zip"], YAML)
    monkeypatch.delattr(zipfile, "ZipFile")  # the directory is not read again
    assert all(source.read() == b"a: 1" for source in made)

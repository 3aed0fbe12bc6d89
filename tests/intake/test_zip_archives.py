"""Archives of students' files: what is honest is read, what is not is told and left, nothing is unpacked to disk."""

import io
import os
import zipfile
from pathlib import Path

import pytest
from confined import confined
from hypothesis import given, settings
from hypothesis import strategies as st
from packing import dos, entry, packed

from tmm_report.intake import archive
from tmm_report.problems import ProblemError

ATTACKS = Path(__file__).parent / "attacks"


def listed(content: bytes, **limits):
    members, problems = archive.members(io.BytesIO(content), "a.zip", **limits)
    return members, [problem.text() for problem in problems]


def read(content: bytes) -> dict[str, bytes]:
    members, problems = listed(content)
    assert problems == []
    return {member.name: archive.content(io.BytesIO(content), member, "a.zip") for member in members}


def refusal(content: bytes) -> str:
    with pytest.raises(ProblemError) as caught:
        listed(content)
    return str(caught.value)


@pytest.mark.parametrize("method", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED])
def test_files_come_out_as_they_went_in(method):
    files = {"ivanov.yaml": b"a: 1", "Петров/ответы.csv": b"k;v\n" * 100, "empty.csv": b""}
    assert read(packed(files, method)) == files


def test_an_archive_behind_other_bytes_is_read():
    assert read(b"MZ stub" * 100 + packed({"a.yaml": b"a: 1"})) == {"a.yaml": b"a: 1"}


@pytest.mark.parametrize(
    ("raw", "name"),
    [
        ("Иванов.csv".encode("cp866"), "Иванов.csv"), ("Щёголев И.csv".encode("cp866"), "Щёголев И.csv"),
        ("Иванов.csv".encode(), "Иванов.csv"), ("Эюя.csv".encode("cp1251"), "Эюя.csv"),
        ("René.csv".encode("cp437"), "René.csv"), ("и\u0306.csv".encode(), "й.csv"), (b"plain.csv", "plain.csv"),
    ],
)  # fmt: skip
def test_names_without_a_word_of_their_encoding_are_read_sensibly(raw, name):
    assert list(read(dos({raw: b"1"}))) == [name]


def test_backslashes_of_old_packers_part_folders():
    assert list(read(packed({"ivanov\\answers.csv": b"1"}))) == ["ivanov/answers.csv"]


def test_names_that_lead_out_of_the_archive_are_refused_and_the_rest_is_read():
    members, problems = listed((ATTACKS / "A01_zip_slip.zip").read_bytes())
    assert [member.name for member in members] == ["ok.yaml"]
    assert len(problems) == 3
    assert all(text.startswith("a.zip:") and "leads out of the archive" in text for text in problems)


@pytest.mark.parametrize(
    "name", ["../a.yaml", "x/../../a.yaml", "/a.yaml", "C:\\a.yaml", "c:a.yaml", "..\\a.yaml", "\\a.yaml"]
)
def test_every_way_out_is_closed(name):
    members, problems = listed(packed({name: b"1"}))
    assert members == []
    assert "leads out of the archive" in problems[0]


def test_a_link_is_refused():
    members, problems = listed((ATTACKS / "A02_zip_symlink.zip").read_bytes())
    assert members == []
    assert problems == ["a.zip:link.yaml: the file is a link; pack the file itself"]


@pytest.mark.parametrize("kind", [0o010000, 0o020000, 0o060000, 0o140000])
def test_pipes_devices_and_sockets_are_refused(kind):
    info = zipfile.ZipInfo("a.yaml")
    info.external_attr = (kind | 0o644) << 16
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as made:
        made.writestr(info, b"1")
    assert listed(out.getvalue())[0] == []


@pytest.mark.parametrize("name", ["inner.zip", "inner.ZIP", "x/inner.tar.gz", "inner.7z"])
def test_an_archive_within_an_archive_is_told_and_not_opened(name):
    members, problems = listed(packed({name: packed({"a.yaml": b"1"}), "b.yaml": b"2"}))
    assert [member.name for member in members] == ["b.yaml"]
    assert "an archive within an archive" in problems[0]


def test_an_encrypted_file_is_refused():
    members, problems = listed(entry(packed({"a.yaml": b"1"}), 8, "<H", 1))
    assert (members, problems) == ([], ["a.zip:a.yaml: the file is encrypted; pack it without a password"])


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_unusual_packing_is_refused(method):
    assert "unusual" in listed(packed({"a.yaml": b"1"}, method))[1][0]


def test_a_name_that_stands_twice_is_told():
    content = packed({"a.yaml": b"1", "b.yaml": b"2"}).replace(b"b.yaml", b"a.yaml")
    members, problems = listed(content)
    assert len(members) == 1
    assert "holds this name twice" in problems[0]


def test_a_folder_with_the_name_of_a_file_is_told():
    members, problems = archive.members(
        io.BytesIO(packed({"x.yaml/": b"", "y/": b""})), "a.zip", lambda name: name.endswith(".yaml")
    )
    assert members == []
    assert [problem.text() for problem in problems] == ["a.zip:x.yaml/: this is a folder"]


def test_what_is_not_wanted_is_not_weighed():
    content = packed({"report.pdf": bytes(6 * 2**20), "a.yaml": b"1"})
    members, problems = archive.members(io.BytesIO(content), "a.zip", lambda name: name.endswith(".yaml"))
    assert ([member.name for member in members], problems) == (["a.yaml"], [])


def test_too_much_altogether_is_refused():
    with pytest.raises(ProblemError, match=r"a\.zip: the files of the archive are larger than 1 MB"):
        listed(packed({f"{n}.yaml": os.urandom(300_000) for n in range(4)}), total=2**20)


def test_what_is_packed_too_well_is_refused():
    assert "packed more than 100 times" in listed(packed({"a.yaml": bytes(2**20)}))[1][0]
    assert read(packed({"a.yaml": bytes(60_000)})) == {"a.yaml": bytes(60_000)}


@pytest.mark.parametrize(
    "content",
    [b"", b"PK", b"PK\5\6" + bytes(18)[:-1], b"hello" * 1000, packed({"a": b"1"})[:-30]],
    ids=["empty", "two letters", "end cut off", "text", "archive cut off"],
)
def test_what_is_no_archive_is_told(content):
    assert "not a ZIP archive" in refusal(content)


def test_an_empty_archive_has_no_files():
    assert listed(packed({})) == ([], [])


@pytest.mark.exhaustive
def test_a_size_that_is_a_lie_ends_the_reading():
    """A member that says 10 bytes and holds 100 MB: never more is unpacked than was said."""
    content = packed({"a.yaml": bytes(100 * 2**20)})
    lied = entry(content, 24, "<L", 10)
    (member,), _ = listed(lied)
    with pytest.raises(ProblemError, match="the archive is broken here"):
        archive.content(io.BytesIO(lied), member, "a.zip")


def test_changed_bytes_are_noticed():
    content = packed({"a.yaml": b"mark: 5"}, zipfile.ZIP_STORED)
    (member,), _ = listed(content)
    with pytest.raises(ProblemError, match="broken"):
        archive.content(io.BytesIO(content.replace(b"mark: 5", b"mark: 9", 1)), member, "a.zip")


def test_names_in_messages_are_printable():
    assert "\x1b" not in listed(packed({"../\x1b[31m.yaml": b"1"}))[1][0]


BOMBS = """
import io, os, zipfile, zlib, struct
def attempt(content):
    try:
        members, problems = archive.members(io.BytesIO(content), "a.zip")
        for member in members:
            archive.content(io.BytesIO(content), member, member.name)
    except ProblemError as error:
        problems = error.problems
    print(problems[0].text())

def made(files):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files:
            archive.writestr(name, content)
    return out.getvalue()

attempt(made([("a.yaml", bytes(100 * 2**20))]))
lie = made([("a.yaml", bytes(100 * 2**20))])
at = lie.index(b"PK\\1\\2") + 24
attempt(lie[:at] + struct.pack("<L", 100_000) + lie[at + 4:])
attempt(made((f"{n}.yaml", b"") for n in range(20_001)))
one = made([("a", b"")])
begin, end = one.index(b"PK\\1\\2"), one.index(b"PK\\5\\6")
count = 400_000
size = (end - begin) * count
attempt(one[:begin] + one[begin:end] * count + one[end:end + 12] + struct.pack("<LLH", size, begin, 0))
"""


@pytest.mark.exhaustive
def test_bombs_cost_neither_memory_nor_time():
    assert confined(BOMBS).splitlines() == [
        "a.zip:a.yaml: the file is larger than 5120 kB",
        "a.yaml: the archive is broken here",
        "a.zip: the archive holds more than 20000 files",
        "a.zip: the archive holds more than 20000 files",
    ]


@pytest.mark.exhaustive
@settings(max_examples=200, deadline=None)
@given(st.data())
def test_a_damaged_archive_is_a_problem_and_never_a_trace(data):
    content = bytearray(packed({"a.yaml": b"a: 1" * 20, "Я/b.csv": b"k;v"}))
    for _ in range(data.draw(st.integers(1, 4))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    try:
        members, _ = archive.members(io.BytesIO(bytes(content)), "a.zip")
        for member in members:
            archive.content(io.BytesIO(bytes(content)), member, "a.zip")
    except ProblemError:
        pass

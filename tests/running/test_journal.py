"""The journal: what was added is read again, and a torn line takes no other with it."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.running import journal
from tmm_report.running.journal import Index, Journal, digest, line, read

TEXT = st.text(st.characters(exclude_categories=["Cs"]))
RECORDS = st.lists(
    st.fixed_dictionaries({"key": st.integers(0, 9).map(lambda k: digest(str(k))), "text": TEXT}), max_size=12
)


def written(path: Path, records: list[dict]) -> list[int]:
    path.unlink(missing_ok=True)
    with Journal(path) as opened:
        return [opened.add(record) for record in records]


@given(RECORDS)
def test_what_is_added_is_read_again_at_its_place(tmp_path_factory, records):
    path = tmp_path_factory.getbasetemp() / "journal.jsonl"
    places = written(path, records)
    assert list(read(path)) == list(zip(places, records, strict=True))
    with Journal(path) as opened:
        assert [opened.at(place) for place in places] == records


@given(RECORDS)
def test_the_last_record_of_a_key_holds(tmp_path_factory, records):
    path = tmp_path_factory.getbasetemp() / "journal.jsonl"
    places = written(path, records)
    index = Index(path)
    last = {record["key"]: place for place, record in zip(places, records, strict=True)}
    assert {key: index.find(key) for key in last} == last
    assert index.find(digest("none of these")) is None


@given(RECORDS, st.integers(0, 10_000))
def test_a_file_cut_anywhere_keeps_every_whole_line_and_can_be_added_to(tmp_path_factory, records, cut):
    path = tmp_path_factory.getbasetemp() / "journal.jsonl"
    written(path, records)
    content = path.read_bytes()
    path.write_bytes(content[: cut % (len(content) + 1)])
    whole = path.read_bytes().count(b"\n")
    assert [record for _, record in read(path)] == records[:whole]
    with Journal(path) as opened:
        opened.add({"key": digest("new")})
    assert [record for _, record in read(path)] == [*records[:whole], {"key": digest("new")}]


def test_lines_that_are_no_records_are_passed_over(tmp_path):
    path = tmp_path / "journal.jsonl"
    good = line({"key": digest("a")})
    rubbish = [b"\0\0\0\n", b'{"key": 1}\n', b"[]\n", b"\xff\xfe\n", b"\n", b"[" * 100_000 + b"\n"]
    path.write_bytes(b"".join([good, *rubbish, good]))
    assert len(list(read(path))) == 2


def test_a_text_with_line_breaks_is_one_line():
    assert line({"key": "a", "text": "1\n2\u2028\r3"}).count(b"\n") == 1


def test_half_a_surrogate_in_a_name_stops_nothing(tmp_path):
    written(tmp_path / "journal.jsonl", [{"key": digest("a"), "text": "\udc80"}])
    assert len(list(read(tmp_path / "journal.jsonl"))) == 1


def test_the_same_record_is_the_same_bytes():
    assert line({"b": 1.5, "a": "é"}) == '{"b":1.5,"a":"é"}\n'.encode()


@pytest.mark.parametrize("one, other", [(("ab", "c"), ("a", "bc")), (("a",), ("a", "")), (("1:a",), ("a",))])
def test_parts_do_not_run_into_each_other(one, other):
    assert digest(*one) != digest(*other)


def test_every_record_is_with_the_system_at_once(tmp_path):
    path = tmp_path / "journal.jsonl"
    with Journal(path) as opened:
        for k in range(3):
            opened.add({"key": digest(str(k))})
            assert len(list(read(path))) == k + 1


def test_the_disk_is_waited_for_now_and_then(tmp_path, monkeypatch):
    now, synced = [0.0], []
    monkeypatch.setattr(journal, "monotonic", lambda: now[0])
    monkeypatch.setattr(journal.os, "fsync", synced.append)
    with Journal(tmp_path / "journal.jsonl") as opened:
        for k in range(50):
            now[0] = 0.1 * k
            opened.add({"key": digest(str(k))})
        assert len(synced) == 4
    assert len(synced) == 5


def test_a_long_torn_end_is_cut_off(tmp_path):
    path = tmp_path / "journal.jsonl"
    good = line({"key": digest("a")})
    path.write_bytes(good + b"x" * 200_000)
    Journal(path).close()
    assert path.read_bytes() == good
    assert json.loads(good)["key"] == digest("a")


@pytest.mark.skipif(sys.platform == "win32", reason="has no such locks")
def test_two_at_once_do_not_write_into_one_file(tmp_path):
    path = tmp_path / "journal.jsonl"
    with Journal(path) as opened:
        opened.add({"key": digest("a")})
        with pytest.raises(BlockingIOError):
            Journal(path)
    Journal(path).close()
    assert len(list(read(path))) == 1

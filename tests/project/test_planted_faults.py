"""The planted faults of tools/faults.py: each finds its place in the program as it is; who is asked first."""

import runpy
from functools import cache
from pathlib import Path

import pytest


@cache
def tool() -> dict:
    """Read by the test that needs it: to find the words that can be planted takes seconds."""
    return runpy.run_path(str(Path(__file__).parents[2] / "tools" / "planted_faults.py"))


def test_every_fault_finds_its_text():
    assert not [fault.name for fault in tool()["FAULTS"] if not tool()["placed"](fault)]


def test_faults_are_many_and_have_names_of_their_own():
    faults = tool()["FAULTS"]
    assert len({fault.name for fault in faults}) == len(faults) >= 800
    assert all(fault.old != fault.new for fault in faults)


def test_a_fault_without_its_text_is_told():
    assert not tool()["placed"](tool()["FAULTS"][0]._replace(old="this stands nowhere"))


# ---------------------------------------------------------------- who is asked


ALONE = "tests/page/test_a.py::test_alone[press - two]"


def fault(name, variants="press"):
    return tool()["Fault"](name, "code.py", "right", "wrong", variants)


@pytest.fixture
def planter(tmp_path, monkeypatch):
    """A planter of one folder, where a test of `fails` fails beside a fault, one of `anyway` without one, too."""
    (tmp_path / "code.py").write_text("right")
    asked, fails, anyway = [], {}, set()

    def failing(folder, fault, tests, first=False):
        planted = (folder / "code.py").read_text() == "wrong"
        asked.append((planted, tests))
        known = [*fails.get(fault.name, ()), *anyway] if planted else [*anyway]
        named = [test for test in known if test in tests or "all" in tests]
        return frozenset(named[:1] if first else named)

    tools = tool()["Planter"].told.__globals__
    monkeypatch.setitem(tools, "failing", failing)
    monkeypatch.setitem(tools, "_asked", lambda fault, golden: [["all"]])
    made = tool()["Planter"]([tmp_path], False, {"old": ALONE})
    return made, asked, fails, anyway


def test_who_noticed_a_fault_last_is_asked_alone(planter):
    made, asked, fails, _ = planter
    fails["old"] = [ALONE, "tests/other"]
    made.ready([fault("old")])
    assert made.told(fault("old"))[1] == [ALONE]
    assert asked == [(False, [ALONE]), (True, [ALONE])]


def test_where_it_passes_all_are_asked_and_the_first_that_fails_once_more_without_the_fault(planter):
    made, asked, fails, _ = planter
    fails["old"] = ["tests/other"]
    made.ready([fault("old")])
    assert made.told(fault("old"))[1] == ["tests/other"]
    assert asked[2:] == [(True, ["all"]), (False, ["tests/other"])]
    made.told(fault("old"))
    assert len(asked) == 6  # that it passes is known now


def test_a_test_that_fails_anyway_notices_nothing(planter):
    made, _, fails, anyway = planter
    anyway.add(ALONE)
    made.ready([fault("old")])
    assert made.told(fault("old"))[1] == []
    fails["old"] = ["tests/other"]
    assert made.told(fault("old"))[1] == ["tests/other"]


def test_a_text_that_is_not_there_is_told_and_the_folder_is_as_it_was(planter, tmp_path):
    made, asked, _, _ = planter
    assert "0 times" in made.told(fault("new")._replace(old="nowhere"))[2] and not asked
    assert made.told(fault("new"))[1:] == ([], "") and (tmp_path / "code.py").read_text() == "right"


def test_what_noticed_faults_is_read_as_it_is_written():
    noticed = {"b": ALONE, "a": ALONE, "c": "tests/page/test_a.py"}
    text = tool()["written"](noticed)
    assert tool()["remembered"](text) == noticed
    assert text.splitlines()[1:] == ["tests/page/test_a.py", "  c", ALONE, "  a", "  b"]
    kept = tool()["NOTICED"].read_text("utf-8")
    assert tool()["written"](tool()["remembered"](kept)) == kept


def test_names_of_failed_tests_are_read_whole():
    said = f"FAILED {ALONE} - assert 1 == 2\nERROR tests/page/test_b.py\n"
    assert tool()["FAILED"].findall(said) == [ALONE, "tests/page/test_b.py"]

"""The planted faults of tools/faults.py: each finds its place in the program as it is."""

import runpy
from functools import cache
from pathlib import Path


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

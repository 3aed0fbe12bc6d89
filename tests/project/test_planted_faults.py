"""The planted faults of tools/faults.py: each finds its place in the program as it is."""

import runpy
from pathlib import Path

TOOL = runpy.run_path(str(Path(__file__).parents[2] / "tools" / "planted_faults.py"))
FAULTS = TOOL["FAULTS"]


def test_every_fault_finds_its_text():
    assert not [fault.name for fault in FAULTS if not TOOL["placed"](fault)]


def test_faults_are_many_and_have_names_of_their_own():
    assert len({fault.name for fault in FAULTS}) == len(FAULTS) >= 50
    assert all(fault.old != fault.new for fault in FAULTS)


def test_a_fault_without_its_text_is_told():
    lost = FAULTS[0]._replace(old="this stands nowhere")
    assert not TOOL["placed"](lost)

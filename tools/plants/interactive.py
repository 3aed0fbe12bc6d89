"""Faults of the first hour: ready variants, results at a prompt, sweeps."""

from faults import Fault

ROOM = "tmm_report/interactive/"
ASKED = ("tests/interactive/test_interactive.py",)
BEGUN = ("tests/commands/test_new_and_examples.py",)
FAULTS = (
    Fault("a first hour: any kind is that of levers", "tmm_report/commands/examples.py",
          "any(block in self.blocks for block in KINDS[kind])", "True", tests=BEGUN),
    Fault("a first hour: a copy keeps its language", "tmm_report/commands/new.py", "return text if lang is None else",
          "return text if True else", tests=BEGUN),
    Fault("a first hour: a schema is written over any file", "tmm_report/commands/new.py",
          "return stream.read(len(BEGINS)) == BEGINS.encode()", "return True", tests=BEGUN),
    Fault("a first hour: the diagram goes before the table", ROOM + "solved.py",
          'key=lambda one: one.name.endswith("_diagram")',
          'key=lambda one: not one.name.endswith("_diagram")', tests=ASKED),
    Fault("a first hour: what is reckoned keeps its unit", ROOM + "numbers.py",
          "plain = np.asarray(array).view(np.ndarray)", "plain = array", tests=ASKED),
    Fault("a first hour: a topic is markup", ROOM + "brief.py", "<caption>{escape(heading(results, tr))}",
          "<caption>{heading(results, tr)}", tests=ASKED),
    Fault("a first hour: the greatest speed with its sign", "tmm_report/chapters/lever/kinematics/quantities.py",
          "yield replace(speed, key=f\"V_{name}_most\", meaning=meaning).value(abs(fastest.value)",
          "yield replace(speed, key=f\"V_{name}_most\", meaning=meaning).value(-abs(fastest.value)", tests=ASKED),
    Fault("a first hour: a sweep takes the first value alone", ROOM + "sweeps.py",
          "dict(zip(paths, row, strict=True))", "dict(zip(paths, rows[0], strict=True))", tests=ASKED),
    Fault("a first hour: what cannot be solved is 0", ROOM + "sweeps.py", "np.full(shape, np.nan)",
          "np.zeros(shape)", tests=ASKED),
)  # fmt: skip

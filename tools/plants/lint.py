"""Faults of the norm control: offences that it would pass over, and right notes that it would blame."""

from faults import Fault

ROOM = "tmm_report/lint/"
PLANTED, READERS, COMMAND = (
    ("tests/lint/test_offences.py",),
    ("tests/lint/test_lint_readers.py",),
    ("tests/lint/test_lint_command.py",),
)
FAULTS = (
    Fault("a range refers to its ends alone", ROOM + "page.py",
          'inner = [f"{match[1]}{k}" for k in range(first, number)]', "inner = []", tests=READERS),
    Fault("references of tables are not looked for", ROOM + "order.py", 'REFERRED = ("figure", "table")',
          'REFERRED = ("figure",)', tests=PLANTED),
    Fault("what is referred to too late passes", ROOM + "order.py", "                if step.anchor in stands:",
          "                if False:", tests=PLANTED),
    Fault("the order of references is not seen", ROOM + "order.py", "            if number > before:",
          "            if True:", tests=PLANTED),
    Fault("a number left out is passed over", ROOM + "order.py", "            if number != expected:",
          "            if number < expected:", tests=PLANTED),
    Fault("the noise of a column against 1e-9 of it", ROOM + "numbers.py", "NOISE = 1e-6", "NOISE = 1e-9",
          tests=PLANTED),
    Fault("a decimal less passes anywhere", ROOM + "numbers.py",
          "if one.number.cell or other.number.cell:", "if True:", tests=PLANTED),
    Fault("one value to three digits passes", ROOM + "numbers.py", "b.half <= 50 * _unit(b.value)",
          "b.half <= 1e9 * _unit(b.value)", tests=PLANTED),
    Fault("a rounded column is blamed", ROOM + "numbers.py", "return abs(a.value - b.value) <= (a.half",
          "return False and abs(a.value - b.value) <= (a.half", tests=PLANTED),
    Fault("units by the last column of the head", ROOM + "units.py", "around = [names[column], said(cell)",
          "around = [names[-1], said(cell)", tests=PLANTED),
    Fault("arcs of SVG read the other way round", ROOM + "lettered.py", "(-1j if clockwise else 1j) * half",
          "(1j if clockwise else -1j) * half", tests=READERS),
    Fault("lettering measured as if it began in its middle", ROOM + "lettered.py", '{"middle": 0.5, "end": 1.0}',
          '{"middle": 1.0, "end": 0.5}', tests=READERS),
    Fault("lines through lettering are not looked at in a solved folder", ROOM + "checks.py",
          "(*QUICK, drawings.on_lines, sheets.empty)", "QUICK", tests=PLANTED),
    Fault("a box over the margin by ten points passes", ROOM + "paper.py", "OVERFULL = 1.0", "OVERFULL = 100.0",
          tests=PLANTED),
    Fault("the number of a page fills it", ROOM + "sheets.py", "FOOT = 0.06", "FOOT = 0.0", tests=PLANTED),
    Fault("findings end with code 0", "tmm_report/commands/lint.py", "return not found.every", "return True",
          tests=COMMAND),
    Fault("lines are counted from one anchor to the next alone", ROOM + "made.py",
          "line, at = line + (self.html", "line, at = 1 + (self.html", tests=PLANTED),
    Fault("the last time of the regimes over the margin", "tmm_report/figures/charts/sheet.py",
          "top.right + RIGHT - 1.0 - widths[-1] / 2", "top.right + RIGHT", "tram_start",
          tests=("tests/chapters/machine/dynamics/test_dynamics_joined.py",)),
)  # fmt: skip

"""Faults of the first hour: ready variants, results at a prompt, sweeps."""

from faults import Fault

ROOM = "tmm_report/interactive/"
ASKED = ("tests/interactive/test_interactive.py",)
BEGUN = ("tests/commands/test_new_and_examples.py",)
WATCHED, SHOWN = ("tests/terminal/test_watch.py",), ("tests/terminal/test_terminal.py",)
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
          "plain = np.asarray(array).view(np.ndarray)", "plain = np.asarray(array).view(Numbers)", tests=ASKED),
    Fault("a first hour: a topic is markup", ROOM + "brief.py", "<caption>{escape(heading(results, tr))}",
          "<caption>{heading(results, tr)}", tests=ASKED),
    Fault("a first hour: the greatest speed with its sign", "tmm_report/chapters/lever/kinematics/quantities.py",
          "yield replace(speed, key=f\"V_{name}_most\", meaning=meaning).value(abs(fastest.value)",
          "yield replace(speed, key=f\"V_{name}_most\", meaning=meaning).value(-abs(fastest.value)", tests=ASKED),
    Fault("a first hour: a sweep takes the first value alone", ROOM + "sweeps.py",
          "dict(zip(paths, row, strict=True))", "dict(zip(paths, rows[0], strict=True))", tests=ASKED),
    Fault("a first hour: what cannot be solved is 0", ROOM + "sweeps.py", "np.full(shape, np.nan)",
          "np.zeros(shape)", tests=ASKED),
    Fault("a first hour: after mistakes the old note stays", "tmm_report/commands/watch.py",
          "page = mistakes(error, said)", 'page = (folder / "note.html").read_bytes()', tests=WATCHED),
    Fault("a first hour: the page of a watch goes back to its top", "templates/live.js",
          "if (isNote) store(here());", "", tests=WATCHED),
    Fault("a first hour: mistakes forget the place in the note", "templates/live.js",
          "if (isNote) store(here());", "store(here());", tests=WATCHED),
    Fault("a first hour: the department's file is not watched", "tmm_report/commands/watch.py",
          "files = [variant, *(variant.parent / name for name in (*NAMES, *TEMPLATES))]", "files = [variant]",
          tests=WATCHED),
    Fault("a first hour: the live page stays behind", "tmm_report/commands/watch.py", "(folder / name).unlink()",
          "pass", tests=WATCHED),
    Fault("a first hour: colours though they are not wanted", "tmm_report/terminal.py",
          'and not os.environ.get("NO_COLOR")', "", tests=SHOWN),
    Fault("a first hour: coloured cells are not cleaned", "tmm_report/terminal.py",
          "typer.style(_clean(cell), **style)", "typer.style(cell, **style)", tests=SHOWN),
    Fault("a first hour: quiet talks", "tmm_report/terminal.py", "        if self.quiet:\n            return\n", "",
          tests=SHOWN),
    Fault("a first hour: help of commands alone is translated", "tmm_report/terminal.py",
          "one.help = say(one.help)", "one.help = one.help", tests=SHOWN),
    Fault("a first hour: mistakes of the command line in English alone", "tmm_report/misused.py",
          "return say(told) % found.groupdict()", "return told % found.groupdict()", tests=SHOWN),
    Fault("a first hour: a wrong command line loses what was wrong", "tmm_report/misused.py",
          'write(say(ERROR) % {"a": said(error.format_message(), say)})', 'write(say(ERROR) % {"a": ""})', tests=SHOWN),
)  # fmt: skip

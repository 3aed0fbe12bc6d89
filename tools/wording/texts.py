"""Where the texts of the program stand, and which of its two catalogues each belongs to.

`note`: whatever reaches paper or is handed in, in every language. `messages`: what the command line says, and what is
wrong in a variant. A text belongs to the catalogue of the file that it stands in; if it stands in files of both, to
`note`. The program finds it from either.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from fnmatch import fnmatch
from functools import cache
from pathlib import Path

import typer
from babel.messages.extract import DEFAULT_KEYWORDS, extract_from_dir

from tmm_report.cli import app
from tmm_report.i18n import Domain

ROOT = Path(__file__).resolve().parents[2]
ONE = {"gettext", "N_", "t"}  # of a text
CONTEXT = {"pgettext", "NP_"}  # of a context and a text
COUNTED = {"ngettext", "count"}  # of a text for one and for many
TEMPLATES = {**DEFAULT_KEYWORDS, "t": None, "count": (1, 2)}
JINJA = {"silent": "false"}  # the templates' delimiters go here when they are not Jinja's own
Text = tuple[str, str | tuple[str, ...], str | None]
"""File, message id, context."""

COMMAND_LINE = (
    *(
        "tmm_report/cli.py",
        "tmm_report/terminal.py",
        "tmm_report/misused.py",
        "tmm_report/loading.py",
        "tmm_report/languages.py",
    ),
    *("tmm_report/course.py", "tmm_report/backwards.py", "tmm_report/results.py"),
    *("tmm_report/commands/*", "tmm_report/assignments/*", "tmm_report/interactive/*"),
    *("tmm_report/lint/*", "tmm_report/running/*", "tmm_report/variant/*", "tmm_report/mechanics/*"),
    *("tmm_report/report/own/*", "tmm_report/quantity/naming.py", "templates/mistakes.html.j2"),
)
MISTAKES = tuple(
    f"tmm_report/chapters/*/{file}"
    for file in (
        *(
            "block.py",
            "block/*",
            "given.py",
            "mistakes.py",
            "refusals.py",
            "limits.py",
            "solve.py",
            "solve/*",
        ),
        *(
            "checks/*",
            "find/asking.py",
            "find/pair.py",
            "find/target.py",
            "drive/bounds.py",
            "drive/crank.py",
        ),
        *(
            "drive/stages.py",
            "power/ahead.py",
            "power/plan.py",
            "ordinary/crossing.py",
            "ordinary/parallel.py",
        ),
        *("ordinary/steps/*", "flywheel/loads.py"),
        *(
            "friction/corrected.py",
            "kinetostatics/ties.py",
            "plans/scales.py",
            "drafting/sheet.py",
            "plant.py",
        ),
        *(
            "press/steps.py",
            "synthesis/positions_steps.py",
            "synthesis/rocker_steps.py",
            "synthesis/steps.py",
        ),
        *("synthesis/rounding.py", "flywheel/sizes.py", "vibration/shaking.py", "wear/pivot.py"),
    )
)
"""Where a chapter says what is wrong with what is given, or why it cannot be solved: then there is no note."""
PRINTED = (
    *("tmm_report/commands/explain/*", "tmm_report/commands/grade/*", "tmm_report/commands/*/page.py"),
    *("tmm_report/commands/batch/summary.py", "tmm_report/commands/methods/measured.py"),
    *(
        "tmm_report/mechanics/pairs/materials.py",
        "tmm_report/mechanics/rivals/*",
        "tmm_report/variant/slips/odd.py",
    ),
    *(
        f"tmm_report/chapters/{file}"
        for file in (
            *("cams/cam/block/__init__.py", "gears/drive/block.py", "gears/drive/crank.py"),
            *("gears/drive/power/solve.py", "gears/drive/solve.py", "gears/ordinary/steps/chain.py"),
            *("gears/planetary/solve/stated_shifts.py", "gears/spur/block.py"),
            *("gears/spur/solve/pair.py", "gears/train/solve/train.py", "lever/force_plans/block.py"),
            *("lever/force_plans/solve.py", "lever/friction/block.py"),
            *("lever/kinematics/checks/digits_left.py", "lever/kinetostatics/block/doubts.py"),
            *("lever/kinetostatics/solve/acting_forces.py", "lever/kinetostatics/solve/lengths.py"),
            *("lever/structure/block/doubts.py", "lever/structure/block/odd.py"),
            *("lever/structure/solve.py", "lever/synthesis/solve.py"),
            *("machine/dynamics/block/__init__.py", "machine/dynamics/solve.py"),
            *("gears/planetary/solve/limits.py", "lever/kinematics/contours/solve.py"),
            *("lever/kinematics/solve/analogues.py", "lever/kinematics/solve/points_and_links.py"),
            "lever/kinematics/solve/relating.py",
            *("lever/readings/solve.py", "machine/flywheel/given.py"),
        )
    ),
)
"""What of those a note or another page prints: a doubt, under the initial data; what a mistake and a note say alike."""


def domain(file: str) -> Domain:
    """The catalogue that the texts of a file belong to."""
    printed = any(fnmatch(file, pattern) for pattern in PRINTED)
    said = any(fnmatch(file, pattern) for pattern in (*COMMAND_LINE, *MISTAKES))
    return "messages" if said and not printed else "note"


@cache
def extracted() -> tuple[Text, ...]:
    """Every text of the program and its templates."""
    return (*_of_templates(), *_of_program(), *_of_the_command_line())


def _of_templates() -> Iterator[Text]:
    found = extract_from_dir(
        ROOT / "templates",
        [("**.j2", "jinja2")],
        {"**.j2": JINJA},
        TEMPLATES,
        directory_filter=lambda _: True,
    )
    for file, _, message, _, context in found:
        if message:
            yield f"templates/{Path(file).as_posix()}", message, context


def _of_program() -> Iterator[Text]:
    """By the syntax tree: Babel's own reading of Python passes over a text inside an f-string, and over some others."""
    for file in sorted((ROOT / "tmm_report").rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_bytes())):
            if isinstance(node, ast.Call) and (text := _marked(node)):
                yield file.relative_to(ROOT).as_posix(), *text


def _marked(call: ast.Call) -> tuple[str | tuple[str, ...], str | None] | None:
    """Message id and context of a call that marks or translates a text."""
    name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
    said = [
        one.value for one in call.args[:2] if isinstance(one, ast.Constant) and isinstance(one.value, str)
    ]
    if name in ONE and said[:1] and said[0]:
        return said[0], None
    if name in CONTEXT and len(said) == 2:
        return said[1], said[0]
    if name in COUNTED and len(said) == 2:
        return (said[0], said[1]), None
    return None


def _of_the_command_line() -> Iterator[Text]:
    """Help of the commands and of their options."""
    group = typer.main.get_group(app)
    for command in (group, *group.commands.values()):
        for one in (command, *command.params):
            if help_of := getattr(one, "help", None):
                yield "tmm_report/cli.py", help_of, None

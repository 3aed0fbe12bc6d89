"""The command line: the only place that prints and exits; what a command does is in `commands`.

Exit codes: 0 done; 1 done, but a check failed or something asked for could not be made; 2 the input, the place to
write to or the size of the task is wrong, and nothing was written; 130 stopped by Ctrl-C.
"""

from __future__ import annotations

import atexit
import gc
import locale
import os
import sys
import threading
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmm_report import languages
from tmm_report.problems import N_, Message, Problem, ProblemError

if TYPE_CHECKING:
    from tmm_report.commands.streams import Careful

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Course projects in the theory of mechanisms and machines: a YAML variant in, an explanatory note out.",
)

Language = Annotated[
    str | None,
    typer.Option("--lang", help=f"Language of the note and of messages: {' or '.join(languages.LANGUAGES)}."),
]
Jobs = Annotated[
    int | None,
    typer.Option("--jobs", help="Processes; by default as many as there are cores.", show_default=False),
]
Seconds = Annotated[float, typer.Option("--seconds", help="A variant that takes longer is given up.")]
VariantFile = Annotated[Path, typer.Argument(help="The variant, a YAML file.", show_default=False)]


def main() -> None:
    _for_one_command()
    from tmm_report.commands.streams import careful, see_open

    see_open()
    sys.stdout = out = careful(sys.stdout, 1)  # type: ignore[assignment]
    sys.stderr = careful(sys.stderr, 2)  # type: ignore[assignment]
    try:
        app()
    except SystemExit as end:
        sys.exit(_ended(end.code, out))


def _ended(code: str | int | None, out: Careful) -> str | int | None:
    """The exit code, where what was said may have been lost on the way out."""
    out.flush()
    if out.error is None:
        return code
    from tmm_report.commands.talk import reason

    text = Message(N_("the standard output could not be written: %(reason)s"), {"reason": reason(out.error)})
    _Console(_users_language()).warn(text)
    return code or 1


def _for_one_command() -> None:
    """What makes a process that runs one command and ends start and end sooner."""
    # What is built lives until the end: looking through it for rings every few hundred objects, and once more on the
    # way out, finds next to nothing and takes a tenth of the time. A batch of hundreds of variants is still collected.
    gc.set_threshold(100_000)
    atexit.register(gc.freeze)
    # Plugins of other packages would be looked for among everything installed, and run on text that nobody has checked.
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")


def _show_version(wanted: bool) -> None:
    if wanted:
        from tmm_report import __version__

        typer.echo(f"tmm-report {__version__}")
        raise typer.Exit


@app.callback()
def program(
    version: Annotated[
        bool,
        typer.Option("--version", help="Print the version and exit.", is_eager=True, callback=_show_version),
    ] = False,
) -> None:
    """Options of the program itself."""


@app.command()
def solve(
    variant: VariantFile,
    output: Annotated[Path | None, typer.Option("-o", "--output", help="Folder for the note.")] = None,
    formats: Annotated[
        str, typer.Option("--format", help="Any of html,tex,json,csv,png, joined by commas.")
    ] = "html,tex",
    lang: Language = None,
    all_: Annotated[
        bool,
        typer.Option(
            "--all", help="Also list all combinations of teeth of planetary stages, with the reasons."
        ),
    ] = False,
    pdf: Annotated[
        bool, typer.Option("--pdf", help="Also compile note.tex to note.pdf with pdflatex.")
    ] = False,
    open_note: Annotated[bool, typer.Option("--open", help="Open the note in the browser.")] = False,
) -> None:
    """Solve a variant and write its note."""
    with _console(lang) as console:
        console.stage(Message(N_("solving")))  # before the imports, which take time
        from tmm_report.commands.solve import run

        done = run(
            variant, output, formats, lang, console, combinations_too=all_, pdf=pdf, open_note=open_note
        )
    _exit(done)


@app.command()
def schema() -> None:
    """Print the JSON Schema of the variant format, for editors that complete and check YAML."""
    from tmm_report.commands.schema import text

    typer.echo(text())


@app.command()
def new(
    file: Annotated[Path, typer.Argument(help="Where to write it.")] = Path("variant.yaml"),
    lang: Language = None,
) -> None:
    """Write a commented starting variant. An existing file is not overwritten."""
    with _console(lang) as console:
        from tmm_report.commands.new import run

        done = run(file, console.language, console)
    _exit(done)


@app.command()
def gallery(
    folder: Annotated[
        Path | None, typer.Argument(help="A folder with variants; by default the ready ones.")
    ] = None,
    output: Annotated[
        Path, typer.Option("-o", "--output", help="Folder for the page and its pictures.")
    ] = Path("gallery"),
    lang: Language = None,
) -> None:
    """Solve every variant of a folder and write a page with their schemes and main numbers."""
    with _console(lang) as console:
        console.stage(Message(N_("solving")))
        from tmm_report.commands.gallery import run

        done = run(folder, output, console.language, console)
    _exit(done)


@app.command()
def assemblies(
    variant: VariantFile,
    angle: Annotated[
        str | None,
        typer.Option(
            "--angle",
            help="Angle of the driving link, such as '30 deg'; by default that of the sketch or of position 0.",
            show_default=False,
        ),
    ] = None,
    output: Annotated[Path | None, typer.Option("-o", "--output", help="Folder for the page.")] = None,
    lang: Language = None,
) -> None:
    """List and draw every way in which the mechanism can be put together, each with its sketch for the variant."""
    with _console(lang) as console:
        console.stage(Message(N_("looking for assemblies")))
        from tmm_report.commands.assemblies import run

        done = run(variant, angle, output, lang, console)
    _exit(done)


@app.command()
def batch(
    places: Annotated[
        list[str],
        typer.Argument(help="Variants: files, folders, patterns or ZIP archives; with --table a template."),
    ],
    output: Annotated[Path, typer.Option("-o", "--output", help="Folder for all that is made.")],
    table: Annotated[
        Path | None,
        typer.Option("--table", help="CSV or XLSX: a variant a row, made from the template."),
    ] = None,
    formats: Annotated[
        str, typer.Option("--format", help="Any of html,tex,json,csv,png, joined by commas.")
    ] = "html,json",
    jobs: Jobs = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on with a run that was stopped.")] = False,
    seconds: Seconds = 60.0,
    cluster: Annotated[
        str | None,
        typer.Option(
            "--cluster", help="Address of a Dask scheduler, tcp://host:8786; or local.", show_default=False
        ),
    ] = None,
    lang: Language = None,
) -> None:
    """Solve and write up many variants; what was done already is not done again with --resume."""
    with _console(lang) as console:
        console.stage(Message(N_("looking for variants")))
        from tmm_report.commands.batch.run import run

        done = run(
            places, output, formats, lang, console,
            jobs=jobs, resume=resume, seconds=seconds, cluster=cluster, table=table,
        )  # fmt: skip
    _exit(done)


@app.command()
def grade(
    variants: Annotated[str, typer.Argument(help="The variants: a file, folder, pattern or ZIP archive.")],
    answers: Annotated[
        list[str] | None,
        typer.Argument(
            help="What was handed in: YAML, CSV, XLSX, folders or ZIP archives.", show_default=False
        ),
    ] = None,
    output: Annotated[Path, typer.Option("-o", "--output", help="Folder for marks and feedback.")] = Path(
        "marks"
    ),
    rubric: Annotated[
        Path | None,
        typer.Option("--rubric", help="YAML: what is asked and what it is worth.", show_default=False),
    ] = None,
    template: Annotated[
        Path | None,
        typer.Option(
            "--template",
            help="Write the sheet that students fill in, .xlsx, .csv or .yaml; a folder: one a variant.",
            show_default=False,
        ),
    ] = None,
    table: Annotated[
        Path | None, typer.Option("--table", help="The table of parameters, where variants are a template.")
    ] = None,
    roster: Annotated[
        Path | None,
        typer.Option(
            "--roster", help="CSV or XLSX: id, name, email, moodle_id, canvas_id.", show_default=False
        ),
    ] = None,
    title: Annotated[str, typer.Option("--title", help="Name of the column in Canvas.")] = "TMM",
    show_answers: Annotated[
        bool, typer.Option("--answers", help="Feedback gives the right numbers, too.")
    ] = False,
    jobs: Jobs = None,
    seconds: Seconds = 60.0,
    lang: Language = None,
) -> None:
    """Mark students' own numbers: feedback for each, a gradebook and statistics for the teacher."""
    with _console(lang) as console:
        console.stage(Message(N_("solving")))
        if template is not None:
            from tmm_report.commands.grade.sheet import run as write_sheet

            done = write_sheet(variants, template, console.language, console, rubric=rubric, table=table)
        else:
            from tmm_report.commands.grade.run import run

            done = run(
                [variants], answers or [], output, lang, console.language, console,
                rubric=rubric, roster=roster, table=table, title=title, show=show_answers, jobs=jobs, seconds=seconds,
            )  # fmt: skip
    _exit(done)


@app.command()
def check(
    samples: Annotated[Path, typer.Argument(help="Folder with variants and their stored results.")],
    update: Annotated[
        bool, typer.Option("--update", help="Store what is found now; look at the difference first.")
    ] = False,
    junit: Annotated[
        Path | None,
        typer.Option("--junit", help="Also write JUnit XML for a CI service.", show_default=False),
    ] = None,
    lang: Language = None,
) -> None:
    """Solve sample variants anew and compare numbers and notes with what is stored; exit code 1 on a difference."""
    with _console(lang) as console:
        console.stage(Message(N_("solving")))
        from tmm_report.commands.check.run import run

        done = run(samples, update=update, junit=junit, language=console.language, talk=console)
    _exit(done)


@app.command()
def assign(
    ranges: Annotated[Path, typer.Argument(help="YAML: a template and the ranges of its parameters.")],
    count: Annotated[
        int | None, typer.Option("-n", "--count", help="How many variants.", show_default=False)
    ] = None,
    seed: Annotated[int, typer.Option("--seed", help="The same seed draws the same variants.")] = 1,
    students: Annotated[
        Path | None,
        typer.Option(
            "--students", help="A list of students: CSV, XLSX or a name a line.", show_default=False
        ),
    ] = None,
    output: Annotated[Path, typer.Option("-o", "--output", help="The table, .csv or .xlsx.")] = Path(
        "assignments.csv"
    ),
    variants: Annotated[
        Path | None,
        typer.Option("--variants", help="Also write a variant a student into a folder.", show_default=False),
    ] = None,
    lang: Language = None,
) -> None:
    """Draw individual variants from ranges, every one solvable, no two alike, as a table a row a student."""
    with _console(lang) as console:
        console.stage(Message(N_("drawing variants")))
        from tmm_report.commands.assign import run

        done = run(ranges, count, seed, students, output, variants, lang, console)
    _exit(done)


@app.command()
def explain(
    variant: VariantFile,
    quantity: Annotated[str, typer.Argument(help="Its key or symbol: v_B, R12, M_bal.", show_default=False)],
    position: Annotated[
        int | None, typer.Argument(help="The position, of what goes by positions.", show_default=False)
    ] = None,
    lang: Language = None,
) -> None:
    """Print how a quantity is derived, with numbers."""
    with _console(lang) as console:
        console.stage(Message(N_("solving")))
        from tmm_report.commands.explain import run

        done = run(variant, quantity, position, lang, console)
    _exit(done)


# ---------------------------------------------------------------- talking to the user


def _exit(done: bool) -> None:
    if not done:
        raise typer.Exit(1)


@contextmanager
def _console(lang: str | None) -> Iterator[_Console]:
    """The terminal in the language asked for, or in the user's own. A user's mistakes are printed, exit code 2."""
    console = _Console(_users_language())
    try:
        if lang is not None:
            console.speak(_known(lang))
        yield console
    except ProblemError as error:
        if lang is None and error.language:  # a variant's mistakes are told in its language
            console.speak(error.language)
        for problem in error.problems:
            console.warn(problem)
        raise typer.Exit(2) from None
    except OSError as error:  # a disk that is full, no folder for temporary files
        from tmm_report.commands.talk import outside

        console.warn(outside(error))
        raise typer.Exit(2) from None
    except (MemoryError, RecursionError):
        console.warn(
            Message(N_("not enough memory: this variant is too large; shorten its lists and tables"))
        )
        raise typer.Exit(2) from None
    except KeyboardInterrupt:
        if not console.warned:  # a batch says itself how to go on
            console.warn(Message(N_("stopped")))
        raise typer.Exit(130) from None
    finally:
        console.wipe()


def _known(lang: str) -> str:
    """The value of --lang. Raises ProblemError with the languages there are."""
    try:
        return languages.language(lang).code
    except ProblemError as error:
        raise ProblemError([replace(problem, path=("--lang",)) for problem in error.problems]) from None


def _users_language() -> str:
    """The user's language from the environment."""
    names = [os.environ.get(name, "") for name in ("LC_ALL", "LC_MESSAGES", "LANG")]
    return languages.of_locale(next((name for name in names if name), "") or (locale.getlocale()[0] or ""))


class _Console:
    """The user's terminal as the `Talk` of a command; what is being done is shown when it takes over a second."""

    def __init__(self, language: str):
        self.language = language
        self._doing, self._shown = Message(""), False
        self.warned = False
        self._timer: threading.Timer | None = None

    def speak(self, language: str) -> None:
        self.language = language

    def stage(self, doing: Message) -> None:
        self._doing = doing
        if self._shown:
            self._show()
        elif self._timer is None and sys.stderr.isatty():
            self._timer = threading.Timer(1.0, self._show)
            self._timer.daemon = True
            self._timer.start()

    def tell(self, line: Message | str) -> None:
        self._print(line if isinstance(line, str) else line.render(self._say), err=False)

    def warn(self, line: Message | Problem | str) -> None:
        self.warned = True
        words = line.text(self._say) if isinstance(line, Problem) else line
        self._print(words.render(self._say) if isinstance(words, Message) else words, err=True)

    def wipe(self) -> None:
        """Take the line of what is being done away."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if self._shown:
            typer.echo(f"\r{'':60}\r", nl=False, err=True)
            self._shown = False

    def _say(self, text: str) -> str:
        from tmm_report.i18n import Translator

        return Translator(self.language).gettext(text)

    def _show(self) -> None:
        self._shown = True
        typer.echo(f"\r{self._doing.render(self._say) + '…':60}", nl=False, err=True)

    def _print(self, text: str, err: bool) -> None:
        self.wipe()
        typer.echo(_clean(text), err=err)


def _clean(text: str) -> str:
    """Text for the terminal: no control, format or bidirectional characters, which could forge what is shown."""
    return "".join(
        c if not unicodedata.category(c).startswith("C") else "\N{REPLACEMENT CHARACTER}" for c in text
    )

"""The command line; what a command does is in `commands`, how it is said in `terminal`.

Exit codes: 0 done; 1 done, but a check failed or something asked for could not be made; 2 the input, the place to
write to or the size of the task is wrong, and nothing was written; 130 stopped by Ctrl-C.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from tmm_report import languages
from tmm_report.problems import N_, Message
from tmm_report.terminal import (
    PdfMayStandAlone,
    Spoken,
    complete,
    console_of,
    ended,
    for_one_command,
    lost,
)

app = typer.Typer(
    cls=Spoken,
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
Quiet = Annotated[bool, typer.Option("--quiet", help="Say only what is wrong.")]
VariantFile = Annotated[Path, typer.Argument(help="The variant, a YAML file.", show_default=False)]


def main() -> None:
    for_one_command(app)
    complete()
    from tmm_report.commands.streams import careful, see_open

    see_open()
    sys.stdout = out = careful(sys.stdout, 1)  # type: ignore[assignment]
    sys.stderr = careful(sys.stderr, 2)  # type: ignore[assignment]
    try:
        app()
    except SystemExit as end:
        sys.exit(lost(end.code, out))


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


@app.command(cls=PdfMayStandAlone)
def solve(
    variant: VariantFile,
    output: Annotated[Path | None, typer.Option("-o", "--output", help="Folder for the note.")] = None,
    formats: Annotated[
        str | None,
        typer.Option(
            "--format",
            help="Any of html,tex,docx,json,csv,png,dxf,sheets, by commas; by default html,tex, watched html alone.",
            show_default=False,
        ),
    ] = None,
    lang: Language = None,
    depth: Annotated[
        str | None, typer.Option("--depth", help="How much the note says: short, course or full.")
    ] = None,
    all_: Annotated[
        bool,
        typer.Option(
            "--all", help="Also list all combinations of teeth of planetary stages, with the reasons."
        ),
    ] = False,
    pdf: Annotated[
        str | None,
        typer.Option(
            "--pdf",
            help="Also make note.pdf: with pdflatex, or with Typst where that is not installed; "
            "--pdf tex, --pdf typst: with this one.",
            metavar="[tex|typst]",
            show_default=False,
        ),
    ] = None,
    print_: Annotated[
        bool,
        typer.Option(
            "--print",
            help="Also print note.html to note-print.pdf with an installed Chromium, Chrome or Edge.",
        ),
    ] = False,
    open_note: Annotated[bool, typer.Option("--open", help="Open the note in the browser.")] = False,
    watched: Annotated[
        bool,
        typer.Option(
            "--watch", help="Solve again as the file is saved, and keep live.html up to date, until Ctrl-C."
        ),
    ] = False,
    quiet: Quiet = False,
) -> None:
    """Solve a variant and write its note."""
    with console_of(lang, quiet) as console:
        console.stage(Message(N_("solving")))  # before the imports, which take time
        if watched:
            from tmm_report.commands import watch

            watch.run(
                variant, output, formats or watch.FORMATS, lang, console,
                depth=depth, combinations_too=all_, pdf=pdf, print_it=print_, open_note=open_note,
            )  # fmt: skip
            return
        from tmm_report.commands.solve import run

        done = run(
            variant, output, formats or "html,tex", lang, console,
            depth=depth, combinations_too=all_, pdf=pdf, print_it=print_, open_note=open_note,
        )  # fmt: skip
    ended(done)


@app.command()
def schema(
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", help="Write it to a file; by default it is printed.", show_default=False
        ),
    ] = None,
    lang: Language = None,
) -> None:
    """Print the JSON Schema of the variant format, for editors that complete and check YAML."""
    with console_of(lang) as console:
        from tmm_report.commands.schema import run, text

        if output is None:
            return typer.echo(text(console.language))
        done = run(output, console.language, console)
    ended(done)


@app.command()
def new(
    file: Annotated[
        Path | None, typer.Argument(help="Where to write it; by default variant.yaml.", show_default=False)
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="The same.", show_default=False)
    ] = None,
    like: Annotated[
        str | None,
        typer.Option("--like", help="A ready variant to begin with: see examples.", show_default=False),
    ] = None,
    kind: Annotated[
        str | None, typer.Option("--kind", help="lever, cam, drive or flywheel.", show_default=False)
    ] = None,
    lang: Language = None,
    quiet: Quiet = False,
) -> None:
    """Write a commented starting variant. An existing file is not overwritten."""
    with console_of(lang, quiet) as console:
        from tmm_report.commands.new import place, run

        done = run(place(file, output, like), console.language, console, like, kind, lang)
    ended(done)


@app.command()
def examples(
    names: Annotated[
        list[str] | None,
        typer.Argument(help="Names of ready variants; by default all of them.", show_default=False),
    ] = None,
    kind: Annotated[
        str | None,
        typer.Option(
            "--kind", help="lever, cam, drive, flywheel, or the name of a block.", show_default=False
        ),
    ] = None,
    open_page: Annotated[bool, typer.Option("--open", help="Draw their schemes in the browser.")] = False,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="Write the page with their schemes there.", show_default=False),
    ] = None,
    lang: Language = None,
) -> None:
    """List the ready variants, a line each; new --like begins with one of them."""
    with console_of(lang) as console:
        from tmm_report.commands.examples import run

        done = run(names or [], kind, output, open_page, console, console.language)
    ended(done)


@app.command()
def gallery(
    folder: Annotated[
        Path | None, typer.Argument(help="A folder with variants; by default the ready ones.")
    ] = None,
    output: Annotated[
        Path, typer.Option("-o", "--output", help="Folder for the page and its pictures.")
    ] = Path("gallery"),
    lang: Language = None,
    quiet: Quiet = False,
) -> None:
    """Solve every variant of a folder and write a page with their schemes and main numbers."""
    with console_of(lang, quiet) as console:
        console.stage(Message(N_("solving")))
        from tmm_report.commands.gallery.run import run

        done = run(folder, output, console.language, console)
    ended(done)


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
    quiet: Quiet = False,
) -> None:
    """List and draw every way in which the mechanism can be put together, each with its sketch for the variant."""
    with console_of(lang, quiet) as console:
        console.stage(Message(N_("looking for assemblies")))
        from tmm_report.commands.assemblies.run import run

        done = run(variant, angle, output, lang, console)
    ended(done)


@app.command()
def methods(
    variant: VariantFile,
    output: Annotated[Path | None, typer.Option("-o", "--output", help="Folder for the page.")] = None,
    accuracy: Annotated[
        str | None,
        typer.Option(
            "--accuracy",
            help="Relative error to hold, such as 1e-6; by default that of the variant.",
            show_default=False,
        ),
    ] = None,
    formats: Annotated[
        str, typer.Option("--format", help="Any of html,json,csv, joined by commas.")
    ] = "html,json",
    quick: Annotated[bool, typer.Option("--quick", help="Measure the times roughly.")] = False,
    lang: Language = None,
    quiet: Quiet = False,
) -> None:
    """Run every method that can solve a variant: times, errors against 40 digits, the cheapest that is good enough."""
    with console_of(lang, quiet) as console:
        console.stage(Message(N_("solving")))
        from tmm_report.commands.methods.run import run

        done = run(variant, output, accuracy, formats, lang, console, quick=quick)
    ended(done)


@app.command()
def verify(
    names: Annotated[
        list[str] | None,
        typer.Argument(help="Names of ready variants; by default all of them.", show_default=False),
    ] = None,
    lang: Language = None,
) -> None:
    """Solve the ready variants on this machine and hold the numbers against references of 40 digits."""
    with console_of(lang) as console:
        console.stage(Message(N_("solving")))
        from tmm_report.commands.verify.run import run

        done = run(names or [], console.language, console)
    ended(done)


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
        str, typer.Option("--format", help="Any of html,tex,docx,json,csv,png,dxf,sheets, joined by commas.")
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
    quiet: Quiet = False,
) -> None:
    """Solve and write up many variants; what was done already is not done again with --resume."""
    with console_of(lang, quiet) as console:
        console.stage(Message(N_("looking for variants")))
        from tmm_report.commands.batch.run import run

        done = run(
            places, output, formats, lang, console,
            jobs=jobs, resume=resume, seconds=seconds, cluster=cluster, table=table,
        )  # fmt: skip
    ended(done)


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
    quiet: Quiet = False,
) -> None:
    """Mark students' own numbers: feedback for each, a gradebook and statistics for the teacher."""
    with console_of(lang, quiet) as console:
        console.stage(Message(N_("solving")))
        if template is not None:
            from tmm_report.commands.grade.sheet import run as write_sheet

            done = write_sheet(variants, template, lang, console, rubric=rubric, table=table)
        else:
            from tmm_report.commands.grade.run import run

            done = run(
                [variants], answers or [], output, lang, console.language, console,
                rubric=rubric, roster=roster, table=table, title=title, show=show_answers, jobs=jobs, seconds=seconds,
            )  # fmt: skip
    ended(done)


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
    quiet: Quiet = False,
) -> None:
    """Solve sample variants anew and compare numbers and notes with what is stored; exit code 1 on a difference."""
    with console_of(lang, quiet) as console:
        console.stage(Message(N_("solving")))
        from tmm_report.commands.check.run import run

        done = run(samples, update=update, junit=junit, language=console.language, talk=console)
    ended(done)


@app.command()
def lint(
    folder: Annotated[Path, typer.Argument(help="The folder of a note that was solved.", show_default=False)],
    lang: Language = None,
) -> None:
    """Norm control of a note: references, numbers, units, drawings, margins; exit code 1 on a finding."""
    with console_of(lang) as console:
        console.stage(Message(N_("reading the note")))
        from tmm_report.commands.lint import run

        done = run(folder, console)
    ended(done)


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
    quiet: Quiet = False,
) -> None:
    """Draw individual variants from ranges, every one solvable, no two alike, as a table a row a student."""
    with console_of(lang, quiet) as console:
        console.stage(Message(N_("drawing variants")))
        from tmm_report.commands.assign import run

        done = run(ranges, count, seed, students, output, variants, lang, console)
    ended(done)


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
    with console_of(lang) as console:
        console.stage(Message(N_("solving")))
        from tmm_report.commands.explain.run import run

        done = run(variant, quantity, position, lang, console)
    ended(done)

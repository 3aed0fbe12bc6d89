"""The command line: the only place that prints and exits.

Exit codes: 0 done; 1 done, but a check failed or something asked for could not be made; 2 the input is wrong.
"""

from __future__ import annotations

import locale
import os
import sys
import threading
import unicodedata
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer

from tmm_report.problems import N_, ProblemError

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Course projects in the theory of mechanisms and machines: a YAML variant in, an explanatory note out.",
)

Language = Annotated[
    str | None, typer.Option("--lang", help="Language of the note and of messages: ru or en.")
]
VariantFile = Annotated[Path, typer.Argument(help="The variant, a YAML file.", show_default=False)]


def main() -> None:
    for stream in (sys.stdout, sys.stderr):
        # a name that the terminal cannot show must not stop the run
        stream.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    app()


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
        str, typer.Option("--format", help="Any of html,tex,json,csv, joined by commas.")
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
    say = _translate(lang)
    wanted = _formats(formats, open_note, say)
    folder = output or Path(f"{variant.stem}-note")
    with _progress(say(N_("solving"))) as stage, _mistakes(lambda text: say(text)):
        from tmm_report import load
        from tmm_report import solve as solve_variant
        from tmm_report.output import combinations, render, write

        loaded = load(variant)
        say = _translate(lang or loaded.language)
        results = solve_variant(loaded)
        files: dict[str, bytes] = {}
        for fmt in wanted:
            stage(say(N_("writing %s")) % fmt)
            files |= render(results, fmt, lang)
        if all_:
            files |= combinations(results, lang)
        failed = _add_pdf(results, lang, files, stage, say) if pdf else None
        try:
            write(folder, files)
        except OSError as error:
            _fail(say(N_("cannot write into %s: %s")) % (folder, error.strerror))
    bad = _summary(results, folder, list(files), say)
    if failed:
        typer.echo(failed, err=True)
    if open_note:
        import webbrowser

        webbrowser.open((folder / "note.html").resolve().as_uri())
    if bad or failed:
        raise typer.Exit(1)


def _formats(text: str, open_note: bool, say: Callable[[str], str]) -> list[str]:
    known = ("html", "tex", "json", "csv")
    wanted = list(dict.fromkeys(part.strip().lower() for part in text.split(",") if part.strip()))
    unknown = [part for part in wanted if part not in known]
    if unknown or not wanted:
        _fail(say(N_("--format: unknown %s; known: %s")) % (", ".join(unknown) or "''", ", ".join(known)))
    if open_note and "html" not in wanted:
        wanted.append("html")
    return wanted


def _add_pdf(
    results: Any,
    lang: str | None,
    files: dict[str, bytes],
    stage: Callable[[str], None],
    say: Callable[[str], str],
) -> str | None:
    """Add note.pdf to the files; what went wrong, in words, if it could not be made."""
    from tmm_report.output import render
    from tmm_report.pdf import NoTex, TexFailed, compile_pdf

    stage(say(N_("compiling the PDF")))
    try:
        source = files if "note.tex" in files else render(results, "tex", lang)
        files["note.pdf"] = compile_pdf({name: text for name, text in source.items() if name != "note.html"})
    except NoTex:
        return say(
            N_(
                "no PDF: pdflatex is not installed. Windows: install MiKTeX (miktex.org). Debian, Ubuntu: apt install "
                "texlive-latex-recommended texlive-pictures texlive-lang-cyrillic cm-super. macOS: MacTeX"
            )
        )
    except TexFailed as error:
        return say(N_("no PDF: pdflatex stopped. The end of its log:")) + "\n" + _clean(str(error), keep="\n")
    return None


def _summary(results: Any, folder: Path, names: list[str], say: Callable[[str], str]) -> bool:
    """Print what was found and written; whether a check failed."""
    bad = _lever_summary(results.lever, say) if results.lever else False
    for found in (results.drive, results.eccentric):
        for message in found.summary() if found is not None else ():
            typer.echo(_clean(message.render(say)))
    shown = [name for name in names if "/" not in name]
    for part in sorted({name.split("/")[0] for name in names if "/" in name}):
        shown.append(part + "/")
    typer.echo(say(N_("written: %s")) % ", ".join(_clean(str(folder / name)) for name in shown))
    return bad


def _lever_summary(results: Any, say: Callable[[str], str]) -> bool:
    """Print what was found of the lever mechanism; whether a check failed."""
    plans, forces = results.plans, results.kinetostatics
    typer.echo(f"{results.structure.formula}")
    worst = max(plans.worst, results.force_plans.worst if results.force_plans else 0.0)
    typer.echo(say(N_("largest difference of the graph-analytical method: %.3g %%")) % worst)
    if any(drawn.readings for drawn in plans.drawn):
        typer.echo(say(N_("largest difference of the student's readings: %.3g %%")) % plans.worst_reading)
    if plans.singular:
        text = say(N_("no plans at singular positions: %s"))
        typer.echo(text % ", ".join(map(str, plans.singular)))
    bad = results.partial
    for gap in results.kinematics.gaps:
        text = say(N_("error: %s")) if bad else "%s"
        typer.echo(_clean(text % gap.text.render(say)), err=bad)
    if forces is not None:
        text = say(
            N_("checks of the balancing moment, relative disagreement: lever %.1e, power balance %.1e")
        )
        typer.echo(text % (forces.worst_lever, forces.worst_power))
    if forces is not None and not forces.agrees:
        bad = True
        typer.echo(say(N_("error: the checks of the balancing moment disagree by more than 1e-9")), err=True)
    return bad


@app.command()
def schema() -> None:
    """Print the JSON Schema of the variant format, for editors that complete and check YAML."""
    import json

    from tmm_report.course import schema as make

    typer.echo(json.dumps(make(), ensure_ascii=False, indent=2))


@app.command()
def new(
    file: Annotated[Path, typer.Argument(help="Where to write it.")] = Path("variant.yaml"),
    lang: Language = None,
) -> None:
    """Write a commented starting variant. An existing file is not overwritten."""
    from tmm_report.variant import new as make

    say = _translate(lang)
    try:
        with file.open("x", encoding="utf-8", newline="\n") as stream:
            stream.write(make(lang or _language()))
    except FileExistsError:
        _fail(say(N_("%s exists already; choose another name")) % _clean(str(file)))
    except OSError as error:
        _fail(f"{_clean(str(file))}: {error.strerror}")
    typer.echo(say(N_("written: %s")) % _clean(str(file)))


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
    from tmm_report.gallery import make, variants
    from tmm_report.i18n import Translator

    say = _translate(lang)
    try:
        files = variants(folder)
    except OSError as error:
        _fail(f"{folder}: {error.strerror}")
    if not files:
        _fail(say(N_("%s holds no variants: no files *.yaml")) % folder)
    with _progress(say(N_("solving"))) as stage:
        try:
            tr = Translator(lang or _language())
            page, failed = make(files, output, tr, lambda name: stage(say(N_("solving %s")) % name))
        except OSError as error:
            _fail(say(N_("cannot write into %s: %s")) % (output, error.strerror))
    for entry in failed:
        for problem in entry.problems:
            typer.echo(_clean(problem.text(say)), err=True)
    typer.echo(say(N_("written: %s")) % _clean(str(page)))
    if failed:
        raise typer.Exit(1)


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
    say = _translate(lang)
    folder = output or Path(f"{variant.stem}-assemblies")
    with _progress(say(N_("looking for assemblies"))), _mistakes(lambda text: say(text)):
        from tmm_report import load
        from tmm_report.assemblies_page import degrees, find, page
        from tmm_report.i18n import Translator
        from tmm_report.output import write

        phi = _angle(angle, say) if angle is not None else None
        loaded = load(variant)
        tr = Translator(lang or loaded.language, loaded.decimal_sign if lang is None else None)
        say = tr.gettext
        found = find(loaded, phi)
        files = page(found, tr) if found.ways else {}
        try:
            write(folder, files)
        except OSError as error:
            _fail(say(N_("cannot write into %s: %s")) % (folder, error.strerror))
    typer.echo(found.structure.formula)
    if not found.ways:
        text = N_(
            "error: at %s the mechanism cannot be assembled; choose another --angle or check the lengths"
        )
        typer.echo(say(text) % degrees(found, tr), err=True)
        raise typer.Exit(1)
    _list_ways(found, tr)
    typer.echo(say(N_("written: %s")) % _clean(", ".join(str(folder / name) for name in files)))


def _angle(text: str, say: Callable[[str], str]) -> float:
    """The value of --angle, rad."""
    from tmm_report.quantity.units import WrongValue, parse

    try:
        return parse(text, "angle")
    except WrongValue as error:
        parts = [part.render(say) for part in (error.wrong, error.right) if part is not None]
        _fail("--angle: " + "; ".join(parts))


def _list_ways(found: Any, tr: Any) -> None:
    """Print the ways, each with the line that chooses it, indented as it stands in a variant."""
    from tmm_report.assemblies_page import heading, remarks

    say = tr.gettext
    typer.echo(heading(found, tr).render(say))
    for number, sketch in enumerate(found.sketches, 1):
        mark = f" ({say(N_('stated by the variant'))})" if number == found.stated else ""
        typer.echo(f"{number}{mark}\n  {sketch}")
    for remark in remarks(found):
        typer.echo(remark.render(say))
    for problem in found.unsaid:
        typer.echo(_clean(say(N_("The variant states none of them: %s")) % problem.text(say)))


# ---------------------------------------------------------------- talking to the user


def _language() -> str:
    """The user's language from the environment."""
    names = [os.environ.get(name, "") for name in ("LC_ALL", "LC_MESSAGES", "LANG")]
    name = next((n for n in names if n), "") or (locale.getlocale()[0] or "")
    return "ru" if name.lower().startswith("ru") else "en"


def _translate(lang: str | None) -> Callable[[str], str]:
    from tmm_report.i18n import Translator

    if lang not in (None, "ru", "en"):
        _fail(Translator(_language()).gettext(N_("--lang: ru or en")))
    return Translator(lang or _language()).gettext


def _clean(text: str, keep: str = "") -> str:
    """Text for the terminal: no control, format or bidirectional characters, which could forge what is shown."""
    return "".join(
        c if c in keep or not unicodedata.category(c).startswith("C") else "\N{REPLACEMENT CHARACTER}"
        for c in text
    )


def _fail(text: str) -> NoReturn:
    typer.echo(_clean(text, keep="\n"), err=True)
    raise typer.Exit(2)


@contextmanager
def _mistakes(say: Callable[[str], str]) -> Iterator[None]:
    """Print a user's mistakes, one a line, and exit with 2."""
    try:
        yield
    except ProblemError as error:
        _fail("\n".join(_clean(problem.text(say)) for problem in error.problems))


@contextmanager
def _progress(first: str) -> Iterator[Callable[[str], None]]:
    """A line on the terminal that says what is being done, shown when that takes over a second."""
    current, shown = [first], threading.Event()

    def show() -> None:
        shown.set()
        typer.echo(f"\r{current[0] + '…':60}", nl=False, err=True)

    timer = threading.Timer(1.0, show)
    timer.daemon = True
    if sys.stderr.isatty():
        timer.start()

    def stage(text: str) -> None:
        current[0] = text
        if shown.is_set():
            show()

    try:
        yield stage
    finally:
        timer.cancel()
        if shown.is_set():
            typer.echo(f"\r{'':60}\r", nl=False, err=True)

"""`tmm-report solve`: a variant's note written into a folder, and what was found in a few lines."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from pathlib import Path

from tmm_report import __version__
from tmm_report import solve as solve_variant
from tmm_report.commands.files import FORMATS, combinations, for_typst, render, translator
from tmm_report.commands.talk import Talk, failure, in_columns, reason, unwritable, written
from tmm_report.commands.whole import Put, put
from tmm_report.course import DEPTHS, Depth, LeverFound, Results, doubts, sound
from tmm_report.course import summary as in_short
from tmm_report.i18n import Translator
from tmm_report.interactive.brief import rows
from tmm_report.loading import loads, stated
from tmm_report.problems import N_, Message, mistake
from tmm_report.quantity.text import Amount, amounts, printed
from tmm_report.running.journal import digest
from tmm_report.variant import locate
from tmm_report.variant.department import beside

NO_TEX = N_(
    "no PDF: pdflatex is not installed. Windows: install MiKTeX (miktex.org). Debian, Ubuntu: apt install "
    "texlive-latex-recommended texlive-pictures texlive-lang-cyrillic cm-super. macOS: MacTeX"
)
NO_TYPST = N_("no PDF: Typst is not installed: pip install 'tmm-report[pdf]', or pip install typst")
NEITHER = N_("no PDF: neither pdflatex nor Typst is installed; the latter: pip install 'tmm-report[pdf]'")
ANY, TEX, TYPST = PROGRAMS = ("any", "tex", "typst")  # what makes a PDF; any: TeX where there is one

NO_EZDXF = N_(
    "no DXF of the sheets, SVG and PDF alone: ezdxf is not installed (pip install 'tmm-report[sheets]')"
)
NO_BROWSER = N_("no print: no Chromium, Chrome or Edge is installed")


def usual_folder(variant: Path) -> Path:
    """The folder of a note for which none is named."""
    return Path(f"{variant.stem}-note")


def run(
    variant: Path,
    folder: Path | None,
    formats: str,
    language: str | None,
    talk: Talk,
    *,
    depth: str | None = None,
    combinations_too: bool = False,
    pdf: str | None = None,
    print_it: bool = False,
    open_note: bool = False,
    shown: Callable[[bytes], None] | None = None,
) -> bool:
    """Whether everything asked for was made and every check held. `pdf`: one of PROGRAMS; `shown` is given the page as
    soon as it is made, before what takes longer. Raises ProblemError."""
    wanted, deep = chosen(formats, open_note or shown is not None), depth_of(depth)
    see_known(pdf)
    folder = folder or usual_folder(variant)
    text, file = stated(variant)
    department = beside(variant)
    loaded = loads(text, file, department)
    talk.speak(language or loaded.language)
    if deep:
        loaded = replace(loaded, note=replace(loaded.note, depth=deep))
    results = solve_variant(loaded)
    files = {}
    if shown is not None:
        files = _made(results, ["html"], language, talk)
        shown(files["note.html"])
    files |= _made(results, [fmt for fmt in wanted if fmt != "html" or shown is None], language, talk)
    if combinations_too:
        files |= combinations(results, language)
    no_pdf = _add_pdf(results, language, files, talk, pdf) if pdf else []
    no_pdf += _add_print(results, language, files, talk) if print_it else []
    changed = _put(folder, files, digest(__version__, text, department.told if department else b""))
    tr = translator(results.variant, language)
    good = summary(results, tr, talk)
    for row in in_columns(rows(results, tr)):
        talk.tell(row)
    _control(files, folder, talk)
    talk.tell(written(*(folder / name for name in _shown(files))))
    tell_changed(folder, changed, talk)
    for line in no_pdf:
        talk.warn(line)
    if "sheets" in wanted and not any(name.startswith("sheets/") and name.endswith(".dxf") for name in files):
        talk.warn(Message(NO_EZDXF))
    if open_note:
        opened(folder / "note.html")
    return good and not no_pdf


def see_known(pdf: str | None) -> None:
    """See that a program that makes a PDF is one of PROGRAMS. Raises ProblemError."""
    if pdf is not None and pdf not in PROGRAMS:
        raise failure(N_("--pdf: unknown %(words)s; known: %(known)s"), words=pdf, known=f"{TEX}, {TYPST}")


def depth_of(text: str | None) -> Depth | None:
    """The depth of the note that a text names. Raises ProblemError."""
    found = next((depth for depth in DEPTHS if depth == text), None)
    if text is not None and found is None:
        raise failure(N_("--depth: unknown %(words)s; known: %(known)s"), words=text, known=", ".join(DEPTHS))
    return found


def chosen(formats: str, open_note: bool = False) -> list[str]:
    """The formats that a text names; a note that is to be opened is made. Raises ProblemError."""
    wanted = list(dict.fromkeys(part.strip().lower() for part in formats.split(",") if part.strip()))
    unknown = [part for part in wanted if part not in FORMATS]
    if unknown or not wanted:
        text = N_("--format: unknown %(words)s; known: %(known)s")
        raise failure(text, words=", ".join(unknown) or "''", known=", ".join(FORMATS))
    return [*wanted, "html"] if open_note and "html" not in wanted else wanted


def _made(results: Results, formats: Sequence[str], language: str | None, talk: Talk) -> dict[str, bytes]:
    """The files of the formats."""
    files: dict[str, bytes] = {}
    for fmt in formats:
        talk.stage(Message(N_("writing %(format)s"), {"format": fmt}))
        files |= render(results, fmt, language)
    return files


def _add_pdf(
    results: Results, language: str | None, files: dict[str, bytes], talk: Talk, program: str
) -> list[Message | str]:
    """Add note.pdf, and TeX's log, to the files; what went wrong, a line each, if it could not be made."""
    from tmm_report.commands.pdf import NoTex

    talk.stage(Message(N_("compiling the PDF")))
    try:
        if program != TYPST:
            try:
                return _by_tex(results, language, files)
            except NoTex:
                if program == TEX:
                    return [Message(NO_TEX)]
        return _by_typst(results, language, files, program)
    except OSError as error:
        return [Message(N_("no PDF: %(reason)s"), {"reason": reason(error)})]


def _by_tex(results: Results, language: str | None, files: dict[str, bytes]) -> list[Message | str]:
    """Raises NoTex, OSError."""
    from tmm_report.commands.pdf import TexFailed, compiled, found

    found()  # before a source that nothing else has asked for is written
    source = files if "note.tex" in files else render(results, "tex", language)
    try:
        files |= compiled({name: text for name, text in source.items() if name.endswith(".tex")})
    except TexFailed as error:
        said = Message(N_("no PDF: pdflatex stopped. The end of its log:"))
        return [said, *str(error).split("\n")]
    return []


def _by_typst(
    results: Results, language: str | None, files: dict[str, bytes], program: str
) -> list[Message | str]:
    """Raises OSError."""
    from tmm_report.commands.by_typst import NoTypst, TypstFailed, typeset

    try:
        files["note.pdf"] = typeset(for_typst(results, language))
    except NoTypst:
        return [Message(NO_TYPST if program == TYPST else NEITHER)]
    except TypstFailed as error:
        return [Message(N_("no PDF: Typst stopped. It says:")), *str(error).split("\n")]
    return []


def _add_print(
    results: Results, language: str | None, files: dict[str, bytes], talk: Talk
) -> list[Message | str]:
    """Add note-print.pdf to the files; what went wrong, a line each, if it could not be made."""
    from tmm_report.commands.printing import NoBrowser, PrintFailed, print_pdf

    talk.stage(Message(N_("printing the note")))
    note = files.get("note.html") or render(results, "html", language)["note.html"]
    try:
        files["note-print.pdf"] = print_pdf(note)
    except NoBrowser:
        return [Message(NO_BROWSER)]
    except (OSError, PrintFailed) as error:
        why = reason(error) if isinstance(error, OSError) else str(error).strip().split("\n")[-1]
        return [Message(N_("no print: %(reason)s"), {"reason": why})]
    return []


def _put(folder: Path, files: dict[str, bytes], source: str) -> Put:
    """Put the files into the folder as a whole. Raises ProblemError."""
    try:
        return put(folder, files, source)
    except OSError as error:
        raise unwritable(folder, error) from None


def tell_changed(folder: Path, changed: Put, talk: Talk) -> None:
    """What the user had changed and where it is kept; what stands there from earlier runs."""
    for name, kept in changed.kept.items():
        text = N_("%(file)s had been changed: what it was is kept as %(kept)s")
        talk.warn(Message(text, {"file": folder / name, "kept": folder / kept}))
    if changed.left:
        text = N_("left as an earlier run wrote them, of another state of the variant: %(files)s")
        names = ", ".join(str(folder / name) for name in _shown(changed.left))
        talk.warn(Message(text, {"files": names}))


def _control(files: dict[str, bytes], folder: Path, talk: Talk) -> None:
    """The norm control of a note that was made."""
    if "note.html" in files or "note.tex" in files:
        from tmm_report.commands.lint import after_solve

        after_solve(files, folder, talk)


def _shown(files: Collection[str]) -> list[str]:
    """The files, of folders only the name."""
    parts = sorted({name.split("/")[0] for name in files if "/" in name})
    return [name for name in files if "/" not in name] + [part + "/" for part in parts]


def opened(note: Path) -> None:
    import webbrowser

    webbrowser.open(note.resolve().as_uri())


# ---------------------------------------------------------------- what was found


def summary(results: Results, tr: Translator, talk: Talk) -> bool:
    """Tell what was found, its numbers as in `tr`; whether every check held."""
    for problem in doubts(results):
        talk.warn(locate(problem, results.variant))
    good = _lever(results, results.lever, tr, talk) if results.lever else True
    for message in in_short(results):
        talk.tell(printed(message, tr))
    return good and sound(results)


def _lever(results: Results, lever: LeverFound, tr: Translator, talk: Talk) -> bool:
    """Tell what was found of the lever mechanism; whether every check held."""
    talk.tell(lever.structure.formula)
    _differences(lever, tr, talk)
    _no_plans(lever, talk)
    _gaps(results, lever, talk)
    own = _own_numbers(results, tr, talk)
    missed = lever.kinematics.missed
    if missed is not None:
        talk.warn(locate(missed, results.variant))
    return _balance(lever, tr, talk) and own and missed is None and not lever.partial


def _differences(lever: LeverFound, tr: Translator, talk: Talk) -> None:
    """How far the drawn plans are from the exact solution."""
    plans, forces = lever.plans, lever.force_plans
    if not plans.drawn and not (forces and forces.drawn):
        return
    worst = max(plans.worst, forces.worst if forces else 0.0)
    text = N_("largest difference of the graphical method: %(percent)s %%")
    talk.tell(printed(Message(text, {"percent": Amount(worst, 3)}), tr))


def _own_numbers(results: Results, tr: Translator, talk: Talk) -> bool:
    """How far a student's own numbers are from the exact solution, the wrong ones one by one; whether none is wrong."""
    found = results.lever.readings if results.lever else None
    if found is None:
        return True
    text = N_("largest difference of the student's readings: %(percent)s %%")
    talk.tell(printed(Message(text, {"percent": Amount(found.worst, 3)}), tr))
    for one in found.wrong:
        talk.warn(locate(one.problem, results.variant))
    if found.unsigned:
        text = N_(
            "compared without signs, as polygons give them; the analytical values are negative: %(names)s"
        )
        names = ", ".join(dict.fromkeys(one.written for one in found.unsigned))
        talk.tell(Message(text, {"names": names}))
    return not found.wrong


def _no_plans(lever: LeverFound, talk: Talk) -> None:
    """Of which positions that were asked for there are no plans."""
    missing = [k for k in lever.plans.singular if k in lever.kinematics.missing]
    singular = [k for k in lever.plans.singular if k not in missing]
    texts = (
        N_("no polygons at singular positions: %(numbers)s"),
        N_("no polygons at positions that do not exist: %(numbers)s"),
    )
    for text, numbers in zip(texts, (singular, missing), strict=True):
        if numbers:
            talk.tell(Message(text, {"numbers": ", ".join(map(str, numbers))}))


def _gaps(results: Results, lever: LeverFound, talk: Talk) -> None:
    """Over which part of the cycle the mechanism cannot be assembled: an error where that is not meant so."""
    for gap in lever.kinematics.gaps:
        if lever.partial:
            talk.warn(locate(mistake(N_("error: %(what)s"), gap.path, what=gap.text), results.variant))
        else:
            talk.tell(gap.text)


def _balance(lever: LeverFound, tr: Translator, talk: Talk) -> bool:
    """How well the ways to the balancing moment agree; whether they do."""
    forces = lever.kinetostatics
    if forces is None:
        return True
    text = N_(
        "checks of the balancing moment, relative disagreement: lever %(lever)s, power balance %(power)s"
    )
    worst = {"lever": forces.worst_lever, "power": forces.worst_power}
    talk.tell(printed(Message(text, amounts(worst, 2)), tr))
    if not forces.agrees:
        talk.warn(Message(N_("error: the checks of the balancing moment disagree by more than 1e-9")))
    elif forces.strained:
        talk.tell(
            Message(N_("the checks differ by no more than rounding does near the singular positions named"))
        )
    return forces.agrees

"""`tmm-report assemblies`: every way to put a mechanism together, listed and drawn."""

from __future__ import annotations

from pathlib import Path

from tmm_report import load
from tmm_report.commands.assemblies.page import degrees, heading, page, remarks
from tmm_report.commands.assemblies.ways import Assemblies, find
from tmm_report.commands.files import translator
from tmm_report.commands.solve import tell_changed
from tmm_report.commands.talk import Talk, unwritable, written
from tmm_report.commands.whole import Put, put
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message, Problem, ProblemError
from tmm_report.quantity.units import WrongValue, parse


def run(variant: Path, angle: str | None, folder: Path | None, language: str | None, talk: Talk) -> bool:
    """Write the page of the ways; whether there is one at least. Raises ProblemError."""
    folder = folder or Path(f"{variant.stem}-assemblies")
    phi = _angle(angle) if angle is not None else None
    loaded = load(variant)
    tr = translator(loaded, language)
    talk.speak(tr.language)
    found = find(loaded, phi)
    files = page(found, tr) if found.ways else {}
    try:
        changed = put(folder, files) if files else Put({}, ())
    except OSError as error:
        raise unwritable(folder, error) from None
    talk.tell(found.structure.formula)
    if found.ways:
        _list(found, tr, talk)
        talk.tell(written(*(folder / name for name in files)))
        tell_changed(folder, changed, talk)
    else:
        text = N_(
            "error: at %(angle)s the mechanism cannot be assembled; choose another --angle or check the lengths"
        )
        talk.warn(Message(text, {"angle": degrees(found, tr)}))
    return bool(found.ways)


def _angle(text: str) -> float:
    """The value of --angle, rad. Raises ProblemError."""
    try:
        return parse(text, "angle")
    except WrongValue as error:
        raise ProblemError([Problem(error.wrong, error.right, ("--angle",))]) from None


def _list(found: Assemblies, tr: Translator, talk: Talk) -> None:
    """Tell the ways, each with the line that chooses it, indented as it stands in a variant."""
    talk.tell(heading(found, tr))
    for number, sketch in enumerate(found.sketches, 1):
        mark = f" ({tr.gettext(N_('stated by the variant'))})" if number == found.stated else ""
        talk.tell(f"{number}{mark}")
        talk.tell(f"  {sketch}")
    for remark in remarks(found):
        talk.tell(remark)
    for problem in found.unsaid:
        why = {"why": problem.text(tr.gettext)}
        talk.tell(Message(N_("The variant states none of them: %(why)s"), why))

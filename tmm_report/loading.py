"""A variant read from its text: the chapters' blocks make of it what each chapter is given."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from tmm_report import yamlread
from tmm_report.course import BESIDE, LEVER, LeverGiven, Variant, gears_unsolvable, lever_unsolvable, room
from tmm_report.languages import FALLBACK, stated_in
from tmm_report.problems import N_, Problem, ProblemError, mistake, shown
from tmm_report.variant.department import Department, beside, read, under

if TYPE_CHECKING:
    from tmm_report.chapters.find import solve as find
    from tmm_report.variant.model import Read, Rooms


def load(path: str | os.PathLike[str]) -> Variant:
    """Read a variant's file, over what stands in its department's beside it. Raises ProblemError with all the mistakes
    of the file."""
    return loads(*stated(path), beside(path))


def stated(path: str | os.PathLike[str]) -> tuple[bytes, str]:
    """A variant's text, and the name of its file for messages. Raises ProblemError."""
    file = yamlread.file_label(path)
    return yamlread.opened(path, file, yamlread.BYTES), file


def loads(text: str | bytes, file: str = "", department: Department | None = None) -> Variant:
    """The variant that a text states, over what its department does; `file` is its name for messages. Raises
    ProblemError."""
    soft: list[Problem] = []
    try:
        document = yamlread.loads(text, file, soft)
        if department is not None:
            document = under(document, _sound(department), department.file)
        made = _variant(document, file, soft)
        return replace(made, template=department.template) if department and department.template else made
    except ProblemError as error:
        language = stated_in(text) or stated_in(department.text if department else "")
        raise ProblemError(error.problems, language) from None


def of_document(document: yamlread.Document, file: str = "") -> Variant:
    """The variant of data that no file states. Raises ProblemError."""
    soft: list[Problem] = []
    return _variant(document, file, soft)


def path_of(variant: Variant, name: str) -> yamlread.Path:
    """The path of a key that a variant states: "mechanism.driver.speed"; items of lists by their numbers. Raises
    ProblemError."""
    inside: Any = variant.document.data if variant.document is not None else {}
    path: yamlread.Path = ()
    for part in name.split("."):
        key: str | int = part
        if isinstance(inside, list) and part.isdecimal():
            key = int(part)
        known = range(len(inside)) if isinstance(inside, list) else inside if isinstance(inside, dict) else ()
        if key not in known:
            from tmm_report.variant.errors import near

            text = N_("there is no %(part)s in %(key)s") if path else N_("there is no %(part)s in the file")
            told = {"part": shown(part), "key": ".".join(map(str, path))}
            raise ProblemError([mistake(text, (), near(part, [str(one) for one in known]), **told)])
        inside, path = inside[key], (*path, key)
    return path


def restated(variant: Variant, values: Mapping[yamlread.Path, object]) -> Variant:
    """The variant with other values at some paths. Raises ProblemError for one that may not stand there."""
    from tmm_report.chapters.find.given import put  # only many variants of one file need it

    document = variant.document or yamlread.Document({})
    data = document.data
    for path, value in values.items():
        data = put(data, path, value)
    changed = [path for path in document.raw if any(path[: len(one)] == one for one in values)]
    raw = {path: text for path, text in document.raw.items() if path not in changed}
    made = _variant(replace(document, data=data, raw=raw), variant.file, [])
    return replace(made, template=variant.template)


def _sound(department: Department) -> yamlread.Document:
    """A department's file, whose keys are right in themselves. Raises ProblemError with its mistakes."""
    from tmm_report.variant.model import Rooms
    from tmm_report.variant.reading import read as read_blocks

    document = read(department)
    rooms = Rooms(
        [room("title", "block"), room("plans", "block")], {"profile": partial(room, "profile", "block")}
    )
    read_blocks(document, department.file, [], rooms, lambda found: ())
    return document


def schema(language: str = FALLBACK) -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of the format, for editors; what its keys mean is said in the language."""
    from tmm_report.variant.editor import schema_of, translated  # only `tmm-report schema` needs it

    kinds = "a lever mechanism, a cam, a gear train or drive, an eccentric mechanism, or several of them"
    made = schema_of([block.Block for block in _rooms().all()], f"A variant of a course project: {kinds}.")
    found: dict[str, Any] = translated(made, language)
    return found


def _rooms() -> Rooms:
    """The blocks of all chapters; that of a gear chapter is loaded only for a file that has it."""
    from tmm_report.variant.model import Rooms

    beside = {name: partial(room, name, "block") for name in BESIDE}
    return Rooms([room(name, "block") for name in ("title", *LEVER)], beside)


def _variant(document: yamlread.Document, file: str, soft: list[Problem], doubted: bool = True) -> Variant:
    from tmm_report.chapters.lever.structure.block import stated
    from tmm_report.variant.reading import read as read_blocks

    found = read_blocks(document, file, soft, _rooms(), _further, doubted)
    if "drive" in found.data and (stated(found) or "cam" in found.data):
        found = _geared(found, document, file)
    made = Variant(
        lever=LeverGiven(**_given(LEVER, found)) if stated(found) else None,
        **_given(["title", *(name for name in BESIDE if name in found.data)], found),
        places=document.places,
        file=file,
        doubts=found.doubts,
        document=document,
    )
    if (asked := made.find) is not None:
        made = replace(made, find=replace(asked, restated=partial(_restated, document, file, asked)))
    return made


def _restated(document: yamlread.Document, file: str, asked: find.Given, numbers: Sequence[float]) -> Variant:
    """The variant with numbers in the places of the unknowns, without doubts: those of the file are told. Raises
    ProblemError for one that may not stand there."""
    data, paths = asked.put(document.data, numbers), {one.path for one in asked.unknowns}
    raw = {path: text for path, text in document.raw.items() if path not in paths}
    rest = {key: value for key, value in data.items() if key != "find"}
    return _variant(replace(document, data=rest, raw=raw), file, [], doubted=False)


def _further(read: Read) -> Iterator[Problem]:
    """What cannot be solved of the parts of a file with mistakes that have none themselves."""
    from tmm_report.chapters.lever.structure.block import stated

    if stated(read) and not any(map(read.is_broken, ("mechanism", "positions", "drawing", "synthesis"))):
        yield from lever_unsolvable(LeverGiven(**_given(("structure", "kinematics"), read)))
    gears = [one for one in ("train", "drive", "eccentric") if one in read.data and not read.is_broken(one)]
    yield from gears_unsolvable(Variant(**_given(gears, read)))


def _geared(found: Read, document: yamlread.Document, file: str) -> Read:
    """The driving link, and a cam alone, with the speed of the drive's output, where they are to have that. Raises
    ProblemError."""
    from tmm_report.chapters.gears.drive.block import geared, geared_cam

    try:
        found = geared(found)
        return geared_cam(found) if "cam" in found.data else found
    except ProblemError as error:
        problems = [yamlread.located(problem, document.places, file) for problem in error.problems]
        raise ProblemError(problems) from None


def _given(names: Iterable[str], read: Read) -> dict[str, Any]:
    """What the chapters are given, by the fields of the records (a test holds their types against them)."""
    return {key: value for name in names for key, value in room(name, "block").given(read).items()}

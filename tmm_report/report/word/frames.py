"""Frames and title blocks by GOST 2.104 in a file for word processors: a header for each kind of sheet.

What is drawn stands in the header as a metafile at its place on the paper, behind the text; the numbers are fields in
frames of their own. The first sheet, that of the contents, is the first page of its section.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

from tmm_report.figures.drawing import Drawing, Path
from tmm_report.figures.emf import emf
from tmm_report.figures.title_block import THICK, WIDE
from tmm_report.profiles import A4, BINDING, EDGE
from tmm_report.report.formats.docx import EMU, MEDIA, twips
from tmm_report.report.page import template
from tmm_report.report.paper.frames import Cell, Frames
from tmm_report.report.paper.sheets import POINT
from tmm_report.report.word.sections import HEADERS, Setup

if TYPE_CHECKING:
    from tmm_report.report.page import Page
    from tmm_report.report.part import Title

LINE = 11.0 * 1.2 * POINT  # mm: height of a line of the numbers, whose letters are those of the other formats
COUNTED = ("PAGE", "NUMPAGES")


class Number(NamedTuple):
    """A field in a header: what it counts; left and upper edge, width and height of its line, twips."""

    command: str
    left: int
    above: int
    wide: int
    tall: int


def framed(title: Title, page: Page, setup: Setup) -> Iterator[tuple[str, bytes]]:
    """The parts for the sections that `setup` has had, by their places in the file."""
    frames = Frames(title, page)
    cells: Mapping[str, list[Cell]] = {"first": [frames.number_first, frames.sheets_first], "": []}
    papers = {name: ("following", size) for name, size in setup.papers.items()}
    fixed = {"title": ("", A4), "opening": ("first", A4), "": ("following", A4)}
    for number, (name, (form, size)) in enumerate({**fixed, **papers}.items(), 1):
        picture = _drawn(frames, form, *size)
        numbers = cells.get(form, [frames.number(size[0])])
        yield f"{MEDIA}/sheet{number}.emf", emf(picture)
        yield (
            f"word/{name}header.xml",
            _part(
                "frame",
                page,
                number=number,
                places=[round(EMU * (one - THICK.width / 2)) for one in (BINDING, EDGE)],
                sizes=[round(EMU * one) for one in picture.size],
                numbers=[
                    _field(command, cell, size[1]) for command, cell in zip(COUNTED, numbers, strict=False)
                ],
            ),
        )
        yield f"word/_rels/{name}header.xml.rels", _part("frame.rels", page, number=number)
    # the foot of the first sheet keeps the text above its larger block
    room = setup.margins[2] + twips(frames.lower) - setup.beyond[1]
    yield "word/openingfooter.xml", _part("openingfooter", page, room=room)


def _drawn(frames: Frames, form: str, wide: float, tall: float) -> Drawing:
    """The frame of a sheet with its title block; zero is the lower left corner of the sheet."""
    low, high = complex(BINDING, EDGE), complex(wide - EDGE, tall - EDGE)
    around = (low, complex(high.real, low.imag), high, complex(low.real, high.imag), low)
    block = getattr(frames, form).moved(complex(wide - EDGE - WIDE, EDGE)).items if form else ()
    return Drawing((Path((around,), THICK), *block), margin=THICK.width / 2)


def _field(command: str, cell: Cell, paper: float) -> Number:
    """In the middle of its cell, which goes from the lower left corner of the sheet; `paper`: its height, mm."""
    left, below, wide, tall = cell
    above = paper - below - (tall + LINE) / 2
    return Number(command, twips(left), twips(above), twips(wide), twips(LINE))


def _part(name: str, page: Page, **given: object) -> bytes:
    return template(f"word/{name}.xml.j2").render(given, page=page).strip().encode()


def headers(setup: Setup) -> tuple[list[str], list[str]]:
    """Names of the headers and footers of a file."""
    if not setup.profile.frames:
        return [*HEADERS], [*HEADERS]
    return [*HEADERS, "opening", *setup.papers], [*HEADERS, "opening"]

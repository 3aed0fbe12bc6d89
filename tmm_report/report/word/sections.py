"""Sections of a document: on which paper their pages are, and what stands at their head and foot."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field
from xml.etree.ElementTree import Element

from tmm_report.profiles import A4, Profile
from tmm_report.records import dataclass
from tmm_report.report.formats.docx import TWIPS, twips

NAMESPACES = {
    "w": "http://schemas.openxmlformats.org/wordprocessingml/2006/main",
    "m": "http://schemas.openxmlformats.org/officeDocument/2006/math",
    "r": "http://schemas.openxmlformats.org/officeDocument/2006/relationships",
    "wp": "http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing",
    "a": "http://schemas.openxmlformats.org/drawingml/2006/main",
    "mc": "http://schemas.openxmlformats.org/markup-compatibility/2006",
    "pic": "http://schemas.openxmlformats.org/drawingml/2006/picture",
}
W, R = f"{{{NAMESPACES['w']}}}", f"{{{NAMESPACES['r']}}}"
COLUMNS = 8.0  # mm between two columns
HEADERS = ("", "title")  # kinds of pages by what stands at their head and foot; more where there are frames


def element(tag: str, /, *children: Element, **attributes: str) -> Element:
    """An element of WordprocessingML."""
    made = Element(f"{W}{tag}", {f"{W}{key}": value for key, value in attributes.items()})
    made.extend(children)
    return made


@dataclass
class Setup:
    """The usual page of a document by its profile; `foot`: what stands at the foot of the title page; `papers`: the
    sheets that have a frame of their own, by the names of their headers, width and height in mm."""

    profile: Profile
    foot: list[Element] = field(default_factory=list)
    papers: dict[str, tuple[float, float]] = field(default_factory=dict)

    def keep(self, foot: Iterable[Element]) -> None:
        self.foot += foot

    @property
    def margins(self) -> tuple[int, int, int, int]:
        """Above, right, below, left, twips."""
        one = self.profile.margins
        above, right, below, left = map(twips, (one.top, one.right, one.bottom, one.left))
        return above, right, below, left

    @property
    def beyond(self) -> tuple[int, int]:
        """Of a head and a foot to the edge of the paper: a number of a page stands in the middle of the margin."""
        above, _, below, _ = self.margins
        return round(0.4 * above), round(0.4 * below)

    def header(self, kind: str, wide: int, tall: int) -> str:
        """The name of the header of a section; `wide`, `tall`: of its paper, twips."""
        if kind != "sheet" or not self.profile.frames:
            return "title" if kind == "title" else ""
        name = f"sheet{wide}x{tall}"
        self.papers[name] = wide / TWIPS, tall / TWIPS
        return name


def section(end: Element, setup: Setup, goes_on: bool = False) -> Element:
    """The layout of the pages of a section. `goes_on`: on the page of the one before it."""
    kind = end.get("kind", "text")
    wide, tall = (int(end.get(side, "0")) for side in ("wide", "tall"))
    made = element("sectPr")
    opens = kind == "opening" and setup.profile.frames
    names = [("default", "header", setup.header(kind, wide, tall))]
    names += [("default", "footer", "title" if kind == "title" else "")]
    names += [("first", part, "opening") for part in ("header", "footer") if opens]
    for page, part, name in names:
        reference = element(f"{part}Reference", type=page)
        reference.set(f"{R}id", f"{name}{part}")
        made.append(reference)
    made.append(element("type", val="continuous" if goes_on else "nextPage"))
    above, right, below, left = setup.margins
    if kind == "sheet":
        above, right, below, left = map(int, end.get("margins", "").split())
    else:
        wide, tall = map(twips, A4)
    paper = element("pgSz", w=str(wide), h=str(tall))
    if wide > tall:
        paper.set(f"{W}orient", "landscape")
    head, foot = map(str, setup.beyond)
    sides = {"top": above, "right": right, "bottom": below, "left": left}
    where = {side: str(size) for side, size in sides.items()}
    made.extend([paper, element("pgMar", **where, header=head, footer=foot, gutter="0")])
    made.append(element("cols", num="2", space=str(twips(COLUMNS))) if kind == "columns" else element("cols"))
    if kind == "sheet":
        made.append(element("vAlign", val="center"))
    if opens:
        made.append(element("titlePg"))
    return made

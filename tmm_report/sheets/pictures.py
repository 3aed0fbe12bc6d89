"""The pictures of a note, the sheet to which each belongs, and its title with the scales that it states."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import field
from functools import cached_property
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report import note
from tmm_report.course import Results
from tmm_report.figures.charts.axes import ALONG
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing, Text
from tmm_report.figures.lettering import Part as Piece
from tmm_report.figures.lettering import Parts, lettered
from tmm_report.figures.sheets.block import Block, Size, Title, block, least
from tmm_report.i18n import Translator
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula, Inline, VectorEquation
from tmm_report.quantity.paper import ROUND
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.text import number
from tmm_report.quantity.written import Equation
from tmm_report.records import dataclass
from tmm_report.report import plain, written
from tmm_report.report.formats import Tex, TexFigure
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page
from tmm_report.report.part import Part

KINDS = (
    ("kinematics", N_("Kinematic analysis")), ("forces", N_("Force analysis")), ("machine", N_("Machine in motion")),
    ("gears", N_("Gear train")), ("cam", N_("Cam mechanism")),
)  # fmt: skip
FORCES = ("kinetostatics", "force_plans", "friction", "translation", "transmission", "press")
MACHINE = ("reduction",)  # of the lever's chapters that which speaks of the machine
ENLARGED = (2.0, 2.5, 4.0, 5.0)  # GOST 2.302
TIMES = (1.25, 1.6, *ENLARGED)  # from one round scale to another
# where a title may go on to the next line: neither behind a short word nor before a number
TORN = re.compile(r"(?<!(?<!\w)[^\W\d_])(?<!(?<!\w)[^\W\d_]{2})[ \t\n]+(?!\d)")
MARK = "\N{NULL}"  # around the number of a scale in a title that is not yet written; in no text


class Scale(NamedTuple):
    """What a millimetre stands for, as a title says it."""

    item: Inline

    @property
    def per_mm(self) -> bool:
        return self.item.unit.endswith("/mm")

    def written(self, times: float, tr: Translator) -> Parts:
        one = self.item
        text = number(one.value / times if self.per_mm else one.value, one.digits, tr.decimal)
        return lettered(_sign(one.symbol), tr.in_index), f" = {text}{plain.gap(one.unit, tr)}"


@dataclass(frozen=True, eq=False)
class Figure:
    """A picture of the note, the sheet it belongs to (of KINDS), its title in pieces; `made`: it as it stands on a
    sheet, by how many times it is larger."""

    picture: Drawing | Graph
    kind: str
    title: tuple[str | Scale | Symbol, ...]
    made: dict[float, Block] = field(default_factory=dict)

    @property
    def diagram(self) -> bool:
        return isinstance(self.picture, Graph)

    @property
    def drawing(self) -> Drawing:
        """As it is in the note."""
        return self.picture.drawing if isinstance(self.picture, Graph) else self.picture

    def titled(self, times: float, tr: Translator) -> Title:
        """Word by word; what follows a symbol without a space stands with it."""
        words: list[list[Piece]] = [[]]
        for one in self.title:
            if not isinstance(one, str):
                words[-1] += (
                    one.written(times, tr) if isinstance(one, Scale) else (lettered(one, tr.in_index),)
                )
                continue
            first, *others = TORN.split(one)
            words[-1] += [first] if first else []
            words += [[other] if other else [] for other in others]
        if times < 1 and not self.scales:
            words.append([f"({_ratio(times, tr)})"])
        return tuple(tuple(one) for one in words if one)

    @property
    def ratio(self) -> bool:
        """Whether the title states one."""
        return any(re.search(r"\d:\d", one) for one in self.title if isinstance(one, str))

    @cached_property
    def scales(self) -> list[float]:
        """What a millimetre stands for, where the title tells all of it."""
        if self.ratio:
            return []
        return [one.item.value for one in self.title if isinstance(one, Scale) and one.per_mm]

    @cached_property
    def larger(self) -> tuple[float, ...]:
        """By how many times it may be: one not to scale by any, one whose title states a ratio not at all. One out of a
        row stays in it, those of axes in that of axes; where one is in none, by a ratio of the standard."""
        if not self.scales:
            return () if self.ratio else TIMES
        rows = (ROUND, ALONG) if self.diagram else (ROUND,)
        row = next((row for row in rows if all(_in(row, one) for one in self.scales)), None)
        if row is None:
            return ENLARGED
        return tuple(times for times in TIMES if all(_in(row, one / times) for one in self.scales))

    @property
    def crowd(self) -> float:
        """How many letters stand on a square millimetre of it."""
        wide, tall = self.drawing.size
        return sum(isinstance(one, Text) for one in self.drawing.items) / (wide * tall)

    def block(self, times: float, tr: Translator) -> Block:
        if times not in self.made:
            self.made[times] = block(self.picture, self.titled(times, tr), times)
        return self.made[times]

    def least(self, times: float) -> Size:
        """What it takes at least."""
        return least(self.picture, times)


def _in(row: Sequence[float], value: float) -> bool:
    """Whether a number is one of a row, times a power of ten."""
    digits = float(f"{abs(value):.5e}".partition("e")[0])
    return any(abs(digits - one) < 1e-4 for one in row)


def _ratio(times: float, tr: Translator) -> str:
    return f"{number(times, 3, tr.decimal)}:1" if times > 1 else f"1:{number(1 / times, 3, tr.decimal)}"


def _sign(symbol: Symbol | str) -> Symbol:
    return math_symbol(symbol) if isinstance(symbol, str) else symbol


@dataclass
class Kept(Tex):
    """A note of which only pictures and their titles are kept, the titles as plain text."""

    kind: str = KINDS[0][0]
    figures: list[Figure] = field(default_factory=list)
    told: list[Scale | Symbol] = field(default_factory=list)

    def escape(self, text: str) -> Markup:
        return Markup(text)

    def math(self, item: Any, tr: Translator, display: bool = False) -> Markup:
        if isinstance(item, Inline):
            self.told.append(Scale(item))
            return Markup(f"{MARK}{len(self.told) - 1}{MARK}")
        if isinstance(item, Formula | VectorEquation | Equation) and not display:
            return Markup(plain.text(item, tr))
        if isinstance(item, Symbol):
            self.told.append(item)
            return Markup(f"{MARK}{len(self.told) - 1}{MARK}")
        return Markup("")

    def picture(self, picture: Drawing | Graph, anchor: str) -> Markup:
        return Markup("")

    def placed(self, figure: TexFigure, picture: Drawing | Graph) -> Markup:
        self.figures.append(Figure(picture, self.kind, tuple(self._pieces(str(figure[1])))))
        return Markup("")

    def _pieces(self, caption: str) -> Iterator[str | Scale | Symbol]:
        for n, piece in enumerate(caption.split(MARK)):
            if n % 2 == 0:
                yield piece
                continue
            yield self.told[int(piece)]


class _Titled(Page):
    """Titles of figures stand without their numbers in the note, and no table is laid out."""

    def parts(self, table: Any) -> Sequence[Any]:
        return ()

    def called(self, name: str, **values: Any) -> Markup:
        return self.text(values["title"]) if name == "figure" else super().called(name, **values)


def kind_of(template: str) -> str:
    """The sheet of the chapter that prints this template."""
    wing, _, rest = template.partition("/")
    chapter = rest.partition("/")[0]
    if wing in ("machine", "gears"):
        return wing
    if wing == "cams" or chapter == "cams":
        return "cam"
    return "forces" if chapter in FORCES else "machine" if chapter in MACHINE else "kinematics"


def figures(results: Results, tr: Translator) -> list[Figure]:
    """The pictures of the note in its order."""
    form = Kept()
    variant = results.variant
    page = _Titled(form, tr, Numbering(), variant.note, variant.profile)

    def before(part: Part) -> None:
        form.kind = kind_of(part.template)

    written(note.parts(results, page), variant.title, page, before)
    return form.figures

"""The templates' environment: only here jinja2 is known, and what a chapter's template may call.

A template is written once for all formats; its markup comes from `macros.<format>.j2`. It is given the results,
the macros `m` and the functions of `Page`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, lru_cache, partial
from itertools import groupby
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

import jinja2
import numpy as np
from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template, nodes, pass_context
from jinja2.compiler import CodeGenerator, Frame
from jinja2.runtime import Context, Undefined
from markupsafe import Markup

from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message, in_language
from tmm_report.profiles import Profile, filled, shipped, usual
from tmm_report.quantity.formula import Formula, Inline, Var
from tmm_report.quantity.model import Column, Table, Value
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol, latex_escape, math_symbol, xml_escape
from tmm_report.quantity.text import UNITS, column, short_and_full, unit_text
from tmm_report.quantity.text import number as written
from tmm_report.quantity.written import Equation, explained
from tmm_report.report import diagrams
from tmm_report.report.bytecode import bytecode_cache
from tmm_report.report.heard import Heard, overhear
from tmm_report.report.numbering import Numbering, Place, Section
from tmm_report.report.paper import layout
from tmm_report.report.paper.layout import Cell, Words, runs
from tmm_report.report.paper.sheets import Paper
from tmm_report.report.part import WHOLE, Note
from tmm_report.report.sources import SOURCES, Cited
from tmm_report.report.symbol_list import SymbolList, thing
from tmm_report.resources import data_root

if TYPE_CHECKING:
    from tmm_report.report.formats import Format

P = ParamSpec("P")
T = TypeVar("T")
_POINTS = re.compile(
    r"(?:[A-Z]\d{0,2}){1,2}(?:, (?:[A-Z]\d{0,2}){1,2})*"
)  # names of points as a mechanism has them, of segments by their ends, or a list of such
LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_VALUE = re.compile(r"%(?:\((\w+)\)[sd]|%)")


@pass_context  # without it jinja2 folds string literals at compile time, html-escaping them before `finalize`
def _finalize(context: Context, value: Any) -> Any:
    if isinstance(value, Markup):
        return value
    return str(value) if isinstance(value, Undefined) else context["page"].text(value)


class _Once(CodeGenerator):
    """What is put out is escaped by `finalize`: jinja2 would copy it by escaping it once more."""

    def _output_child_pre(self, node: nodes.Expr, frame: Frame, finalize: Any) -> None:
        self.write(finalize.src)

    def _output_child_post(self, node: nodes.Expr, frame: Frame, finalize: Any) -> None:
        self.write(")")


class _Environment(Environment):
    code_generator_class = _Once


BEHIND = "\N{NULL}"  # begins what belongs to the sentence before; in no text
ROUNDING = 1e-6  # what is smaller beside 1 is no result of the note: a second way to a number leaves so much
OTHERS = ".others"  # ends the name of pieces that work out other positions in the same way
TRIMMED = True  # blocks take their line's blanks and end with them


@cache
def environment() -> Environment:
    compiled_as = (
        f"jinja {getattr(jinja2, '__version__', '')}, escaped once, finalized in context, trimmed {TRIMMED}"
    )
    return _Environment(
        loader=FileSystemLoader(data_root() / "templates"),
        undefined=StrictUndefined,
        autoescape=True,
        finalize=_finalize,
        trim_blocks=TRIMMED,
        lstrip_blocks=TRIMMED,
        bytecode_cache=bytecode_cache(compiled_as),
        auto_reload=False,
    )


def template(name: str) -> Template:
    return environment().get_template(name)


@lru_cache(maxsize=4096)
def _pieces(text: str, language: str) -> tuple[tuple[str, bool], ...]:
    """A message in pieces: what it says, and the names of what is put in."""
    pieces, end = list[tuple[str, bool]](), 0
    text = _before_unit(language).sub("\\1\N{NO-BREAK SPACE}", text)
    for match in _VALUE.finditer(text):
        pieces += [(text[end : match.start()], False), (match[1], True) if match[1] else ("%", False)]
        end = match.end()
    return (*pieces, (text[end:], False))


@cache
def _before_unit(language: str) -> re.Pattern[str]:
    """A number, or what is put in, and a space before its unit, at which no line ends (GOST 2.105)."""
    units = "|".join(re.escape(unit_text(unit, language)) for unit in UNITS)
    return re.compile(rf"(%\(\w+\)s|\d) (?=(?:{units})(?!\w)|%%|%\(unit\)s)")


def _indexed(value: Any) -> Any:
    """Names of points with their numbers as indices, S₂: in running text as in formulas."""
    return value.translate(LOWERED) if type(value) is str and _POINTS.fullmatch(value) else value


class Page:
    """What templates call: text, mathematics and numbers in one format and one language."""

    def __init__(
        self,
        form: Format,
        tr: Translator,
        numbering: Numbering,
        note: Note = WHOLE,
        profile: Profile | None = None,
    ):
        """`note`: how much the note says; `profile`: how it looks, by default as the standard has it."""
        self.form, self.tr, self.numbering, self.note = form, tr, numbering, note
        self.profile = profile or shipped(usual(tr.language))
        self.form.paper = Paper(self.profile.margins, self.profile.text, self.form.most)
        self.numbering.scheme = self.profile.numbers
        self.symbols = SymbolList()
        self.cited = Cited(tr.cited)
        self.aside: Heard | None = (
            None  # for a page on the screen: formulas that a note of its depth leaves out
        )
        self._made: dict[tuple[Any, ...], Any] = {}

    def once(self, make: Callable[P, T], *arguments: P.args, **named: P.kwargs) -> T:
        """What `make` gives of these arguments: made once a note, however many of its chapters ask for it."""
        key = (make, *arguments, *named.items())
        if key not in self._made:
            self._made[key] = make(*arguments, **named)
        return self._made[key]

    def laid(self, piece: str, write: Callable[[], Markup]) -> Markup:
        """A piece where it stands: here, among the appendices, one a chapter, or nowhere; "" stands always here."""
        where = self.note.stand(piece) if piece else "body"
        if where == "omit":
            if self.aside is not None and not piece.endswith(OTHERS):
                overhear(self, write)
            return Markup("")
        if where != "appendix":
            return write()
        appendix = self.numbering.appendix(self.tr.letters)
        with self.numbering.within(appendix):
            text = self.form.apart(write)
        if text.strip():
            appendix.pieces.append(text)
        elif not appendix.pieces:  # this variant has nothing of it
            self.numbering.appendices.remove(appendix)
        return Markup("")

    def leaves_out(self, formulas: Iterable[Formula]) -> None:
        """Of formulas of one kind those that a shorter note does not work out."""
        if self.aside is not None:
            self.aside.left_out(formulas, self)

    def figure(self, picture: Drawing | Graph, label: str) -> Place:
        """The number of a figure: among those of the text, or of the drawings that have sheets of their own."""
        if self.form.paper.sheet_of(picture.size) is None:
            return self.numbering.take("figure", label)
        return self.numbering.drawing(label, self.t(N_("Drawings")))

    def text(self, value: Any) -> Markup:
        """Anything for output: Markup as it is, other text escaped for the format."""
        return value if isinstance(value, Markup) else self.form.escape(self.name(value))

    def name(self, value: Any) -> str:
        """Text as it is; of a name in several languages that of the note."""
        return in_language(value, self.tr.gettext)

    def called(self, name: str, **values: Any) -> Markup:
        """A word of the note as its profile has it, with what is put into it: "figure", n and title."""
        template = self.profile.word(name, self.tr.language)
        return Markup("".join(map(self.text, filled(template, values))))

    def parts(self, table: layout.Table) -> Sequence[layout.Part]:
        """A table cut to the width of the page; in a shorter note tall narrow ones stand in halves."""
        parts = table.cut(self.form.paper)
        return parts if self.note.every or table.words else [layout.folded(part) for part in parts]

    def caption(self, place: Place, title: Any, first: bool, last: bool = False) -> Markup:
        """Of a table, or of a part of it behind the first."""
        name = "table" if first else "last" if last else "continued"
        return self.called(name, n=place.number, title=title)

    def on_one_line(self, text: str) -> Markup:
        """Text that stands where no markup is read."""
        return Markup(xml_escape(self.name(text)))

    def in_properties(self, text: str) -> Markup:
        """Text of the properties of a PDF, where LaTeX reads no mathematics."""
        return Markup(latex_escape(text))

    def said(self, cell: Cell) -> Markup:
        """A cell in running text."""
        return self.form.marked(cell, cell.ref)

    def t(self, message: str, **values: Any) -> Markup:
        """A message translated and escaped, with values put in for %(name)s; of these, too, only Markup is trusted."""
        return self._filled(self.tr.gettext(message), values)

    def count(self, one: str, many: str, count: int, **values: Any) -> Markup:
        """A message that depends on a number, in the form that the number asks for."""
        return self._filled(self.tr.ngettext(one, many, count), values)

    def explained(self, name: str, of: Value | Column, unit: str = "") -> dict[str, Any]:
        """What a "where" list says of a quantity; `name`: by which it knows what was explained before."""
        return {"id": name, "symbol": of.quantity.symbol, "unit": unit, "message": of.quantity.meaning}

    def _filled(self, text: str, values: dict[str, Any]) -> Markup:
        parts = _pieces(text, self.tr.language)
        if len(parts) == 1:
            return self.text(parts[0][0])
        pieces = [
            self.text(_indexed(values[piece]) if named else piece) for piece, named in parts if named or piece
        ]
        return Markup("".join(pieces))

    def message(self, message: Message) -> Markup:
        """A message that brings its values, symbols among them."""
        values = {
            name: self.message(value) if isinstance(value, Message) else self._shown_value(value)
            for name, value in message.values.items()
        }
        return self.t(message.text, **values)

    def _shown_value(self, value: Any) -> Any:
        return self.sym(value) if isinstance(value, Symbol) else value

    def sentence(self, message: Message) -> Markup:
        """A message whose numbers are ready texts, with the note's decimal sign."""
        text = message.render(self.tr.gettext)
        return self.text(re.sub(r"(?<=\d)\.(?=\d)", self.tr.decimal, text))

    def where(self, *formulas: Formula | Equation, kinds_once: bool = False) -> list[dict[str, Any]]:
        """Items of a "where" list: every quantity of the formulas in their order, with its meaning and unit.

        Segments differ only by their ends, which name themselves: one of them is explained for all; `kinds_once`: so
        is of what is called alike the first.
        """
        items = []
        for sign, meaning, unit in explained(*formulas):
            key = "segment" if sign.kind == "segment" else (sign, str(thing(meaning)))
            kind = {"kind": meaning.text} if kinds_once else {}
            items.append({"symbol": sign, "id": key, "unit": unit, "message": meaning, **kind})
        return items

    def fresh(self, items: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
        """Those of a "where" list that have not been explained before, with their meanings in words, and with their
        `symbols`: neighbours of one base and meaning are explained together. All go into the list of symbols."""
        for item in items:
            sign = math_symbol(item["symbol"]) if isinstance(item["symbol"], str) else item["symbol"]
            if isinstance(sign, Symbol):
                self.means(sign, item.get("message") or item["meaning"], item.get("unit", ""))
        told = [
            {"meaning": self.message(item["message"]), **item} if "message" in item else item
            for item in items
        ]
        return _together(self.numbering.fresh(told))

    def lines_of_first_sheet(self, sections: Sequence[Section]) -> int:
        """How many lines of the contents stand above the larger title block of the first sheet; 0: it has none."""
        if not self.profile.frames:
            return 0
        from tmm_report.report.paper.frames import lines_above_first

        return lines_above_first(sections, self)

    def means(self, sign: Symbol, meaning: Message | Markup, unit: str) -> None:
        """Puts a symbol into the list of symbols."""
        self.symbols.add(sign, meaning, unit, self.numbering.here)

    def contents(self) -> list[Markup]:
        """The numbered chapters written so far, by their titles."""
        text = N_('"%(title)s" (section %(n)s)')
        return [self.t(text, title=one.title, n=one.place.number) for one in self.numbering.chapters]

    # ------------------------------------------------------------ sources

    def references(self, names: Iterable[str]) -> list[Markup]:
        return [self.t(SOURCES[name]) for name in names]

    def behind(self, cited: Markup) -> Markup:
        """Sources that a paragraph names within the sentence before, in front of its stop."""
        return Markup(f"{BEHIND}{cited}")

    def paragraph(self, parts: Iterable[Any]) -> Markup:
        """Sentences one after another, with the sources behind what they are cited for; those go that refer to what the
        note leaves out."""
        texts = [text for text in map(self.text, parts) if text]
        if len(texts) > 1 and texts[0].startswith(BEHIND):  # cited for what follows
            texts[:2] = texts[1::-1]
        said: list[str] = []
        for text in texts:
            if text.startswith(BEHIND) and said:
                before = said.pop()
                stop = before[-1:] if before[-1:] in (".", ":") else ""
                text = Markup(f"{before.removesuffix(stop)} {text.removeprefix(BEHIND)}{stop}")
            said.append(text.removeprefix(BEHIND))
        return Markup(" ".join(map(self.numbering.sentence, said)))

    # ------------------------------------------------------------ mathematics

    def percent(self, picture: Drawing | Graph) -> int:
        """To how many per cent a picture is reduced that no sheet holds; 100: it is not."""
        return self.form.percent(picture)

    def scales(self, picture: Drawing | Graph) -> Markup:
        """What goes on a caption: what 1 mm along the axes of the picture stands for."""
        found = diagrams.scales(picture)
        return self.listed(["; ", self.values(found)], "") if found else Markup("")

    def math(self, item: Any, display: bool = False) -> Markup:
        return self.form.math(item, self.tr, display)

    def sym(self, key: str | Symbol) -> Markup:
        """The symbol of a key, "v_BA"."""
        return self.math(math_symbol(key) if isinstance(key, str) else key)

    @staticmethod
    def plain(text: Markup) -> str:
        """What is read without its markup: the title of a picture, which browsers show as they get it."""
        return Markup(re.sub(r"<mspace[^>]*>", " ", text)).striptags()

    def value(self, of: Var, digits: int | None = None) -> Markup:
        """symbol = value unit."""
        digits = digits or of.digits or 5
        return self.math(Inline(of.sign, float(of.number), of.unit, digits, of.ref))

    def values(self, items: Iterable[Var]) -> Markup:
        """Several `value`s."""
        return self.listed(self.value(item) for item in items)

    def num(self, x: float, digits: int = 5, places: int | None = None, scale: float = 1.0) -> str:
        return written(float(x), digits, self.tr.decimal, places, scale)

    def col(self, values: Iterable[float], digits: int = 5) -> list[str]:
        """A table column."""
        return column(values, digits, self.tr.decimal)

    # ------------------------------------------------------------ numbers of the results

    def head(self, symbol: Symbol | str | Markup, unit: str = "") -> Markup:
        """Symbol, which may be ready, and unit of a column or row."""
        text = symbol if isinstance(symbol, Markup) else self.sym(symbol)
        return self.listed([text, self.unit(unit)]) if unit else text

    def column(
        self,
        table: Table,
        key: str,
        unit: str = "",
        *,
        size: bool = False,
        rows: int | None = None,
        digits: int = 5,
    ) -> layout.Column:
        """A column of the results as a table of the note prints it: symbol and unit, one number of decimals.

        `unit`: of print, where it is not that of the declaration; `size`: magnitudes; `rows`: only the first so many.
        """
        column = table[key]
        unit = unit or column.quantity.shown
        self.means(column.symbol(), column.meaning, unit or column.unit)
        numbers = column.numbers(unit)[:rows]
        texts = self.col(np.abs(numbers) if size else numbers, digits)
        cells = list(map(Cell, texts, table.refs(key, unit, size)))
        letter = self.sym(column.symbol())
        return layout.Column(self.head(letter, unit or column.unit), cells, letter)

    def singles(self, table: Table, key: str, rows: int | None = None, **form: Any) -> layout.Column:
        """A column of the results whose numbers have each its own decimals; `rows`: only the first so many."""
        column = table[key]
        cells = [self.cell(table, key, row, **form) for row in range(len(table) if rows is None else rows)]
        letter = self.sym(column.symbol())
        return layout.Column(self.head(letter, column.quantity.printed), cells, letter)

    def cell(
        self,
        of: Value | Table,
        key: str = "",
        row: int = 0,
        unit: str = "",
        *,
        size: bool = False,
        digits: int = 5,
        places: int | None = None,
        scale: float = 1.0,
    ) -> Cell:
        """One number of the results as text that knows its place: a single value, or a row of a table's column."""
        unit = unit or (of if isinstance(of, Value) else of[key]).quantity.shown
        if isinstance(of, Value):
            number, ref = of.number(unit), of.ref(unit, size)
        else:
            number, ref = of[key].number(row, unit), of.ref(key, row, unit, size)
        number = abs(number) if size else number
        short, full = short_and_full(float(number), digits, self.tr.decimal, places, scale)
        return Cell(short, ref, full, partial(self._to_places, float(number)))

    def _to_places(self, number: float, places: int) -> str:
        return written(number, decimal=self.tr.decimal, places=places, scale=0, keep_zeros=True)

    def word(self, text: str | Markup, table: Table, key: str, row: int) -> Cell | Words:
        """A translated word or a name that stands for a cell of the results."""
        ref = table.ref(key, row)
        return Words(text, ref) if isinstance(text, Markup) else Cell(self.name(text), ref)

    def named(self, table: Table, key: str, row: int) -> Cell:
        """The name of a point, or names of points, that stand in a cell of the results; a dash for none."""
        text = table[key].values[row]
        return Cell(_indexed(text) if text else layout.DASH, table.ref(key, row))

    def shown(self, of: Value | Table, *args: Any, **form: Any) -> Markup:
        """`cell` in running text."""
        cell = self.cell(of, *args, **form)
        return self.form.marked(cell, cell.ref)

    @staticmethod
    def nothing(of: Value) -> bool:
        """Whether a relative number is nothing but the error of rounding."""
        return abs(of.value) < ROUNDING

    def bound(self, of: Value | Table, key: str = "", row: int = 0) -> Markup:
        """A relative difference that is not exceeded; what is nothing but rounding is said so."""
        value = of.value if isinstance(of, Value) else of[key].number(row)
        if abs(value) < ROUNDING:
            return self.t(N_("the rounding error"))
        return self.shown(of, key, row, digits=2, scale=0)

    def measured(self, of: Value, **form: Any) -> Markup:
        """A single number in running text with its unit."""
        return self.in_unit(self.shown(of, **form), form.get("unit") or of.quantity.printed)

    def in_unit(self, number: Any, unit: str) -> Markup:
        """A number with its unit on the same line."""
        text = self.unit(unit)
        return self.listed([number, text], "" if text in ("", "°") else "\N{NO-BREAK SPACE}")

    def turned(self, of: Value, places: int = 1) -> Cell:
        """The angle turned from position 0 at which a single number holds, in degrees; a dash where there is none."""
        at = np.nan if of.at is None else np.degrees(of.at)
        return Cell(self.num(at, places=places), Ref(of.key, by="at_deg"))

    def positions(self, table: Table, rows: int | None = None) -> layout.Column:
        """The numbers of the positions, the first column of a table by positions."""
        head = self.t("Position")
        numbers = list(table["position"].values)[:rows]
        cells = [Cell(str(k), table.ref("position", row)) for row, k in enumerate(numbers)]
        return layout.Column(head, cells)

    def unit(self, unit: str) -> str:
        return unit_text(unit, self.tr.language)

    def runs(self, numbers: Sequence[int]) -> Markup:
        """Numbers in their order, three and more that follow one another as "7–9"."""
        return self.listed(
            text
            for run in runs(numbers)
            for text in ([f"{run[0]}–{run[-1]}"] if len(run) > 2 else map(str, run))
        )

    def listed(self, items: Iterable[Any], between: str = ", ") -> Markup:
        return Markup(str.join(self.text(between), map(self.text, map(_indexed, items))))


def _together(items: Iterable[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Neighbours of a "where" list with one base and one meaning in one line: P_1, P_0 – power of a shaft, kW."""
    alike = [list(group) for _, group in groupby(items, key=_said)]
    return [{**one[0], "symbols": [item["symbol"] for item in one]} for one in alike]


def _said(item: Mapping[str, Any]) -> tuple[str, str, str]:
    sign = item["symbol"]
    base = sign.base if isinstance(sign, Symbol) else str(sign).partition("_")[0]
    return base, str(item["meaning"]), str(item.get("unit", ""))

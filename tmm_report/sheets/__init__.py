"""The drawing sheets of the project: the pictures of the note, by its chapters, on sheets with frame and title block.

    files = render(results, translator)     # {"sheets/1_kinematics.svg": b"..."}

A picture stands at the note's own size, each of its lengths the same. Where its title states what a millimetre stands
for and the sheet has room, it is larger, at another scale of the same row, which the title says.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec

from tmm_report.course import Results
from tmm_report.figures.sheets.block import Block, Size
from tmm_report.figures.sheets.form import Said
from tmm_report.figures.sheets.sheet import FORMATS, LARGEST, Format, Sheet, placed, places, spread
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message, Problem, ProblemError
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page
from tmm_report.report.paper.frames import ROLES, WORDS, signers
from tmm_report.sheets.pictures import KINDS, Figure, Kept, figures

SMALLER = (2.0, 2.5, 4.0, 5.0, 10.0, 15.0, 20.0, 25.0, 40.0, 50.0, 75.0, 100.0)
NOTE = re.compile(
    r"[\W_]*\bПЗ$"
)  # GOST 2.102: of the designation that which makes it the note's and not the drawings'
FORM = WORDS | {"Масса": N_("Mass"), "Масштаб": N_("Scale"), "Формат": N_("Format")}
ROLES_HERE = (*ROLES[:2], N_("Tech. check"), "", *ROLES[3:])


def composed(results: Results, tr: Translator, drawn: Sequence[Figure] | None = None) -> list[Sheet]:
    """The sheets in their order; `drawn`: the pictures of the note, where they are known."""
    drawn = figures(results, tr) if drawn is None else drawn
    laid: list[tuple[str, str, Format, list[Block]]] = []
    for kind, title in KINDS:
        own = [one for one in drawn if one.kind == kind]
        for n, (size, blocks) in enumerate(_sheets(own, tr)):
            laid.append((f"{kind}_{n + 1}" if n else kind, title, size, blocks))
    return [
        Sheet(f"{n}_{name}", size, tuple(blocks), _said(results, tr, title, n, len(laid)))
        for n, (name, title, size, blocks) in enumerate(laid, 1)
    ]


def _said(results: Results, tr: Translator, sheet: str, n: int, count: int) -> Said:
    title, t = results.variant.title, tr.gettext
    page = Page(Kept(), tr, Numbering())
    own = [page.name(text) for text in (title.institution, title.group) if text]
    return Said(
        NOTE.sub("", page.name(title.designation)), page.name(title.topic), t(sheet), ", ".join(own),
        signers(title, page, ROLES_HERE),
        "\N{EN DASH}", n, count, {word: t(text) for word, text in FORM.items()},
    )  # fmt: skip


def _sheets(figures: Sequence[Figure], tr: Translator) -> Iterator[tuple[Format, list[Block]]]:
    """The smallest format that holds all of them, or as many of the largest as they need."""
    left = list(figures)
    while left:
        sizes = [one.block(1.0, tr).size for one in left]
        size = next((one for one in FORMATS[: LARGEST + 1] if len(places(one, sizes)) == len(left)), None)
        if size is None:
            size = FORMATS[LARGEST]
            here = sorted(places(size, sizes))
        else:
            here = list(range(len(left)))
        if not here:  # even the first alone is too large
            here, size = [0], _for_one(sizes[0])
        yield size, _enlarged(size, [left[n] for n in here], tr)
        left = [one for n, one in enumerate(left) if n not in here]


def _for_one(one: Size) -> Format:
    return next((size for size in FORMATS[LARGEST:] if places(size, [one])), FORMATS[-1])


def _enlarged(size: Format, figures: Sequence[Figure], tr: Translator) -> list[Block]:
    """Each picture as large as there is room for: those whose letters meet until they do not, then schemes and plans,
    then diagrams, the most crowded first; one that no paper holds is smaller."""
    blocks = [one.block(1.0, tr) for one in figures]
    sizes = [one.size for one in blocks]
    found = places(size, sizes)  # nothing is moved before all have their size
    if len(found) < len(blocks):
        small = (figures[0].block(1 / times, tr) for times in SMALLER)
        return spread(size, list(next(held for one in small if (held := placed(size, [one]))).values()))
    left = [list(one.larger) for one in figures]
    asked: tuple[Callable[[int], bool], ...] = (
        lambda n: not blocks[n].clear,
        lambda n: not figures[n].diagram,
        lambda n: figures[n].diagram,
    )
    for wanted in asked:
        order = sorted(range(len(figures)), key=lambda n: -figures[n].crowd)
        while order := [n for n in order if left[n] and wanted(n)]:
            for n in order:
                tried = _held(size, sizes, n, figures[n], left[n].pop(0), tr)
                if tried:
                    blocks[n], found = tried
                    sizes[n] = blocks[n].size
                else:
                    left[n] = []  # still larger it has no room either
    return spread(size, [one.at(*found[n]) for n, one in enumerate(blocks)])


def _held(
    size: Format, sizes: Sequence[Size], n: int, figure: Figure, times: float, tr: Translator
) -> tuple[Block, dict[int, tuple[float, float]]] | None:
    """One of several pictures at one of its larger sizes, and the places of all where they have room."""
    made = figure.made.get(times)
    for one in (
        made.size if made else figure.least(times),
        None,
    ):  # its letters are placed where its lines have room
        large = one or figure.block(times, tr).size
        found = places(size, [*sizes[:n], large, *sizes[n + 1 :]])
        if len(found) < len(sizes):
            return None
    return figure.block(times, tr), found


def render(results: Results, tr: Translator) -> dict[str, bytes]:
    """File name -> content. Raises ProblemError of a variant without a picture."""
    sheets = composed(results, tr)
    if not sheets:
        raise ProblemError(
            [Problem(Message(N_("there is nothing to draw on sheets: this variant has no picture")))]
        )
    return written(sheets)


def written(sheets: Sequence[Sheet]) -> dict[str, bytes]:
    """Every sheet as SVG and, where ezdxf is installed, as DXF; all of them in one PDF."""
    from tmm_report.figures.drawing import svg
    from tmm_report.figures.sheets.pdf import pdf

    files = {f"sheets/{one.name}.svg": svg(one.drawing).encode() for one in sheets}
    files["sheets/sheets.pdf"] = pdf([one.drawing for one in sheets], sheets[0].said.name)
    if find_spec("ezdxf"):
        from tmm_report.figures.sheets.cad import dxf

        files |= {f"sheets/{one.name}.dxf": dxf(one) for one in sheets}
    return files

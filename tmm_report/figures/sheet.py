"""A sheet of paper that matplotlib writes: lines, markers and letters at places in mm, without its axes.

matplotlib is imported inside the functions, for it takes longer to load than a note to solve; pyplot never is.
The text of the SVG stays text: it is selectable, small, and set in the reader's own sans-serif font.
"""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.figures.lettering import xml_text

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from matplotlib.artist import Artist
    from matplotlib.figure import Figure

MM_PER_INCH = 25.4
POINT = MM_PER_INCH / 72  # mm
SETTINGS: dict[Any, Any] = {"svg.fonttype": "none", "pdf.fonttype": 42}
FONTS = ["DejaVu Sans", "sans-serif"]


@dataclass(eq=False)
class Sheet:
    """Paper of a size in mm, its origin in the lower left corner; what is put on it later covers what was before."""

    wide: float
    tall: float
    figure: Figure = field(init=False)
    _mm: Any = field(init=False)

    def __post_init__(self) -> None:
        from matplotlib.figure import Figure
        from matplotlib.transforms import Affine2D

        self.figure = Figure(figsize=(self.wide / MM_PER_INCH, self.tall / MM_PER_INCH))
        self._mm = Affine2D().scale(1 / MM_PER_INCH) + self.figure.dpi_scale_trans

    def strokes(
        self, strokes: Sequence[np.ndarray], colour: str, pen: float, dash: Sequence[float] = ()
    ) -> None:
        """Lines of one look as one path; `pen` in points, `dash` in widths of the pen."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        if strokes:
            codes = np.concatenate([[Path.MOVETO] + [Path.LINETO] * (len(stroke) - 1) for stroke in strokes])
            look = {"linestyle": (0, tuple(dash))} if dash else {}
            path = Path(np.concatenate(strokes), codes)
            path.should_simplify = False  # decided when a path is made, before `SETTINGS` hold
            self._add(PathPatch(path, fill=False, edgecolor=colour, linewidth=pen, capstyle="butt", **look))

    def block(self, corner: tuple[float, float], wide: float, tall: float, edge: str = "none") -> None:
        """White ground under letters."""
        from matplotlib.patches import Rectangle

        self._add(Rectangle(corner, wide, tall, facecolor=(1, 1, 1, 0.85), edgecolor=edge, linewidth=0.5))

    def markers(
        self, places: np.ndarray, marker: str, colour: str, size: float, hollow: bool = False
    ) -> None:
        """`size` in points."""
        from matplotlib.lines import Line2D

        line = Line2D(*places.T, linestyle="none", marker=marker, markersize=size)
        line.set_markeredgecolor(colour)
        line.set_markerfacecolor("white" if hollow else colour)
        self._add(line)

    def letters(self, at: tuple[float, float], text: str, size: float, **look: Any) -> None:
        """Plain text `size` mm high; `ha`, `va`, `rotation` and `color` as matplotlib knows them."""
        self.figure.text(
            *at, text, size=size / POINT, family=FONTS, parse_math=False, transform=self._mm, zorder=1, **look
        )

    def svg(self, salt: str, title: str = "") -> str:
        """One `svg` element; its ids are made with `salt`. Not by savefig, which draws everything twice."""
        from matplotlib.backends.backend_svg import FigureCanvasSVG

        out, nothing = io.StringIO(), {"Date": None, "Creator": None, "Format": None, "Type": None}
        with _settings(salt):
            FigureCanvasSVG(self.figure).print_svg(out, metadata=nothing)
        return _inline(out.getvalue(), title)

    def pdf(self, salt: str) -> bytes:
        from matplotlib.backends.backend_pdf import FigureCanvasPdf

        out, nothing = io.BytesIO(), {"CreationDate": None, "Creator": None, "Producer": None}
        with _settings(salt):
            FigureCanvasPdf(self.figure).print_pdf(out, metadata=nothing)
        return out.getvalue()

    def _add(self, artist: Artist) -> None:
        artist.set(transform=self._mm, zorder=1)
        self.figure.add_artist(artist)


def _settings(salt: str) -> AbstractContextManager[None]:
    from matplotlib import rc_context

    return rc_context(SETTINGS | {"svg.hashsalt": salt})


def _inline(text: str, title: str) -> str:
    """Drops what only a file needs (prologue) and every id that nothing refers to; names the picture."""
    text = text[text.index("<svg") :].strip()
    used = set(re.findall(r"#([\w.-]+)", text))
    text = re.sub(r' id="([\w.-]+)"', lambda match: match[0] if match[1] in used else "", text)
    head, body = text.split(">", 1)
    return f'{head} role="img"><title>{xml_text(title)}</title>{body}'

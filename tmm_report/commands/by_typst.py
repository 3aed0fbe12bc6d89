"""note.typst -> PDF by the wheel `typst` (extra `pdf`), shut off from the rest of the machine."""

from __future__ import annotations

import tempfile
from typing import Literal

from tmm_report.resources import data_root

STANDARD: Literal["a-2u"] = "a-2u"  # PDF/A: to be kept, every letter readable


class NoTypst(Exception):
    """The wheel is not installed."""


class TypstFailed(Exception):
    """Typst stopped; the text is what it says."""


def typeset(source: bytes) -> bytes:
    """The PDF of the text of `render(..., "typst")`: a PDF/A-2u, the same bytes of the same text.

    Raises NoTypst, TypstFailed, or OSError where there is no place.

    A student's text is escaped already; still Typst has an empty folder as its root, outside of which it reads nothing,
    and no packages but those in it. Its letters are those of the note's own faces, on every machine.
    """
    try:
        import typst
    except ImportError:
        raise NoTypst from None
    faces = data_root() / "templates" / "fonts"
    fonts = typst.Fonts(include_system_fonts=False, include_embedded_fonts=False, font_paths=[str(faces)])
    with tempfile.TemporaryDirectory() as empty:
        shut = typst.Compiler(
            source, root=empty, font_paths=fonts, package_path=empty, package_cache_path=empty
        )
        try:
            made = shut.compile(format="pdf", pdf_standards=[STANDARD], timestamp=0)
        except typst.TypstError as error:
            raise TypstFailed(f"{error.message}\n{error.diagnostic}"[:2000]) from None
    assert isinstance(made, bytes)
    return made

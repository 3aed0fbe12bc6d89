"""What captions of figures say of them: the scale, the position."""

from __future__ import annotations

import re
from collections.abc import Iterator

from curves import is_graph
from note import Note, formulas_of, text_of


def figures(note: Note, symbol: str) -> Iterator[tuple[str, str, float]]:
    """Anchor, caption and scale of the figures, but for diagrams, that state this scale."""
    for figure in note.root.iter("figure"):
        if is_graph(note.drawings[figure.get("id") or ""]):
            continue
        caption = figure.find("figcaption")
        assert caption is not None
        for math in caption.iter("math"):
            stated = formulas_of([math], "", False)[0][1]
            if stated.symbol == symbol and stated.result is not None:
                yield figure.get("id") or "", text_of(caption), stated.result.value


def position_of(caption: str) -> int | None:
    """The position that a caption names, by its words."""
    match = re.search(r"(?:position|положение) (\d+)", caption)
    return int(match[1]) if match else None

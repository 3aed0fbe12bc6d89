"""Formulas of Typst and of MathML read back into one tree of what stands where, so that the two can be compared."""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element, fromstring

Tree = tuple["str | tuple[str, ...] | Tree", ...]

_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|\\[()|]|[A-Za-z]{2,}|[bt]:|\s+|.', re.S)
_ESCAPED = re.compile(r"\\(u\{(\w+)\}|.)", re.S)
_SHAPES = {
    "frac": "frac",
    "sqrt": "root",
    "overline": "bar",
    "underline": "line",
    "lr": "",
    "op": "",
    "limits": "",
}
_SIGNS = {"gt": ">", "lt": "<", "⋅": "·", "thin": ""}


def of_typst(text: str) -> Tree:
    """What a formula of Typst says; its blanks say nothing. Raises ValueError for a bracket too many or too few."""
    tokens = [token for token in _TOKEN.findall(text) if not token.isspace()]
    tree, rest = _row(tokens)
    if rest:
        raise ValueError(f"left over: {rest}")
    return tree


def _row(tokens: list[str]) -> tuple[Tree, list[str]]:
    row = list[object]()
    while tokens and tokens[0] not in (",", ")"):
        token, tokens = tokens[0], tokens[1:]
        if tokens[:1] == ["("] and token.isalpha():
            parts, tokens = _arguments(tokens[1:])
            row += _shaped(token, parts)
        elif token.startswith('"'):
            row += _ESCAPED.sub(lambda one: chr(int(one[2], 16)) if one[2] else one[1], token[1:-1])
        else:
            row += _SIGNS.get(token, token.removeprefix("\\"))
    return tuple(row), tokens  # type: ignore[arg-type]


def _arguments(tokens: list[str]) -> tuple[list[tuple[str, Tree]], list[str]]:
    parts = list[tuple[str, Tree]]()
    while True:
        name = ""
        if tokens[0] in ("b:", "t:"):
            name, tokens = tokens[0][0], tokens[1:]
        tree, tokens = _row(tokens)
        parts.append((name, tree))
        end, tokens = tokens[0], tokens[1:]
        if end == ")":
            return parts, tokens


def _shaped(name: str, parts: list[tuple[str, Tree]]) -> list[object]:
    if name == "attach":
        (_, base), *others = parts
        below = dict(others)
        under = base[0] == "limits" if base and isinstance(base[0], str) else False
        return [("script", base[1:] if under else base, below.get("b", ()), below.get("t", ()))]
    inner = [tree for _, tree in parts]
    if name == "limits":
        return ["limits", *inner[0]]
    shape = _SHAPES[name]
    return [(shape, *inner)] if shape else [*inner[0]]


def of_mathml(text: str) -> Tree:
    """What neighbouring elements of MathML say."""
    return tuple(_nodes(fromstring(f"<mrow>{text.replace('<wbr/>', '')}</mrow>")))


def _nodes(parent: Element) -> Iterator[object]:
    for node in parent:
        yield from _node(node)


def _node(node: Element) -> Iterator[object]:
    inner = [tuple(_node(child)) for child in node]
    match node.tag:
        case "mfrac":
            yield "frac", *inner
        case "msqrt":
            yield "root", sum(inner, ())
        case "msub" | "msup" | "msubsup" | "munder":
            base, *others = inner
            below = others[0] if node.tag != "msup" else ()
            yield "script", base, below, others[-1] if node.tag in ("msup", "msubsup") else ()
        case "mover":
            yield "bar", inner[0]
        case "mspace":
            return
        case "mrow" | "math":
            row = sum(inner, ())
            lines = {"0.06em solid": 1, "0.2em double": 2}
            for _ in range(next((n for how, n in lines.items() if how in (node.get("style") or "")), 0)):
                row = (("line", row),)
            yield from row
        case _:
            yield from (node.text or "").replace("″", "′′").replace("‴", "′′′")

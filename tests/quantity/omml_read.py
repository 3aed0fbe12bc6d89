"""Formulas of Office Math read back into the tree of what stands where that `typst_read` makes of MathML."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree.ElementTree import Element, fromstring

from typst_read import Tree

NS = "http://schemas.openxmlformats.org/officeDocument/2006/math"
_UNSEEN = dict.fromkeys(map(ord, "\N{THIN SPACE}\N{ZERO WIDTH SPACE}"))


def of_omml(text: str) -> Tree:
    """What neighbouring elements say. Raises ValueError for one that no formula of ours has."""
    return _row(fromstring(f'<m:e xmlns:m="{NS}">{text}</m:e>'))


def _row(node: Element) -> Tree:
    return tuple(part for child in node for part in _said(child))


def _name(node: Element) -> str:
    return node.tag.removeprefix(f"{{{NS}}}")


def _said(node: Element) -> Iterator[object]:
    name = _name(node)
    if name == "r":
        text = "".join(one.text or "" for one in node.iter(f"{{{NS}}}t"))
        yield from text.replace("″", "′′").replace("‴", "′′′").translate(_UNSEEN)
        return
    properties = [part for part in node if _name(part) == f"{name}Pr"]
    how = {_name(one): one.get(f"{{{NS}}}val") for part in properties for one in part}
    inner = [_row(part) for part in node if part not in properties] if name != "oMath" else []
    match name:
        case "oMath":
            yield from _row(node)
        case "f":
            yield "frac", *inner
        case "rad" if how.get("degHide") == "1" and inner[0] == ():
            yield "root", inner[1]
        case "sSub" | "limLow":
            yield "script", inner[0], inner[1], ()
        case "sSup":
            yield "script", inner[0], (), inner[1]
        case "sSubSup":
            yield "script", *inner
        case "bar":
            yield {"top": "bar", "bot": "line"}[how["pos"]], inner[0]
        case "d":
            yield from (how["begChr"], *inner[0], how["endChr"])
        case "func":
            yield from (*inner[0], *inner[1])
        case "nary":
            yield "script", (how["chr"],), inner[0], inner[1]
            yield from inner[2]
        case _:
            raise ValueError(f"unknown: {name}")

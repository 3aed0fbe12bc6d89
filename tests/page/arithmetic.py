"""The numbers of a printed formula worked out again, with what the digits that were not printed may do.

An evaluator of its own over MathML: sums, products, fractions, powers, roots, functions by the names of both languages,
magnitudes, degrees. A number is its value and its error; errors add up, whatever their signs.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple
from xml.etree.ElementTree import Element

from note import children, text_of, whole_number


class Near(NamedTuple):
    """A value and by how much it may be off."""

    value: float
    error: float


class NotNumbers(ValueError):
    """A side that holds symbols."""


def involute(x: float) -> float:
    return math.tan(x) - x


FUNCTIONS: dict[str, tuple[Callable[[float], float], Callable[[float], float]]] = {
    "sin": (math.sin, math.cos),
    "cos": (math.cos, lambda x: -math.sin(x)),
    "tan tg": (math.tan, lambda x: 1 + math.tan(x) ** 2),
    "arctan arctg atan": (math.atan, lambda x: 1 / (1 + x * x)),
    "arccos": (lambda x: math.acos(max(-1.0, min(1.0, x))), lambda x: 1 / math.sqrt(max(1e-12, 1 - x * x))),
    "arcsin": (lambda x: math.asin(max(-1.0, min(1.0, x))), lambda x: 1 / math.sqrt(max(1e-12, 1 - x * x))),
    "exp": (math.exp, math.exp),
    "inv": (involute, lambda x: math.tan(x) ** 2),
}
BY_NAME = {name: found for names, found in FUNCTIONS.items() for name in names.split()}


def evaluate(nodes: list[Element]) -> Near:
    """Raises NotNumbers."""
    total, sign, product, operator = Near(0.0, 0.0), 1.0, None, "·"
    for k, node in enumerate(nodes):
        text = node.text or ""
        if node.tag == "mo" and text in ("+", "−", "-"):
            if product is not None:
                total = Near(total.value + sign * product.value, total.error + product.error)
            elif k:
                raise NotNumbers(text)
            sign, product = (1.0 if text == "+" else -1.0), None
        elif node.tag == "mo" and text in ("·", "×", "/", ":"):
            operator = "·" if text in "·×" else "/"
        elif node.tag == "mtext" and text == "°":
            if product is None:
                raise NotNumbers(text)  # pragma: no cover
            product = _degrees(product, nodes[k - 1])
        else:
            factor = one(node)
            product = factor if product is None else (times if operator == "·" else over)(product, factor)
            operator = "·"
    if product is None:
        raise NotNumbers("nothing")
    return Near(total.value + sign * product.value, total.error + product.error)


def _degrees(product: Near, _node: Element) -> Near:
    return Near(math.radians(product.value), math.radians(product.error))


def one(node: Element) -> Near:
    """A number, fraction, root, power, function or bracket."""
    found = whole_number(node)
    if found is not None:
        return Near(found.printed.value, 0.0 if len(found.text) == 1 else found.printed.off)
    inside = children(node)
    match node.tag:
        case "mfrac":
            return over(evaluate([inside[0]]), evaluate([inside[1]]))
        case "msqrt":
            return root(evaluate(inside))
        case "msup":
            return power(evaluate([inside[0]]), evaluate([inside[1]]).value)
        case "mrow":
            return row(inside)
    raise NotNumbers(text_of(node))


def row(inside: list[Element]) -> Near:
    """A bracket, a magnitude, a function of an argument, or an expression that holds together."""
    if inside and inside[0].get("form") == "prefix" and inside[0].text in ("(", "[", "{", "|"):
        body = evaluate(inside[1:-1])
        return Near(abs(body.value), body.error) if inside[0].text == "|" else body
    if inside and inside[0].tag in ("mi", "mtext") and (inside[0].text or "") in BY_NAME:
        apply, slope = BY_NAME[inside[0].text or ""]
        argument = evaluate(inside[1:])
        return Near(apply(argument.value), abs(slope(argument.value)) * argument.error)
    return evaluate(inside)


def times(a: Near, b: Near) -> Near:
    return Near(a.value * b.value, abs(a.value) * b.error + abs(b.value) * a.error + a.error * b.error)


def over(a: Near, b: Near) -> Near:
    value = a.value / b.value
    return Near(value, (a.error + abs(value) * b.error) / max(abs(b.value) - b.error, 1e-300))


def power(a: Near, exponent: float) -> Near:
    slope = abs(exponent) * abs(a.value) ** (exponent - 1) if a.value else 0.0
    return Near(a.value**exponent, slope * a.error)


def root(a: Near) -> Near:
    value = math.sqrt(max(0.0, a.value))
    return Near(value, a.error / (2 * value) if value else math.sqrt(a.error))

"""Slips inside { } and [ ] that are good YAML and mean something else: a decimal comma, a colon without a space.

A comma inside brackets parts two values: `{B: 0,4 m}` is B: 0 and a key `4 m` without a value. What is meant is read
all the same, with a mistake that says so.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, NamedTuple

import yaml

from tmm_report.problems import N_, Message, shown

_WHOLE = re.compile(r"[-+]?[0-9]+")
_REST = re.compile(r"[0-9]+([eE][-+]?[0-9]+)?(\s*[^\s0-9:].*)?")  # of a number, behind its comma
_MEASURED = re.compile(r"[-+−]?[0-9][0-9.,]*(\s*[^\s0-9:][^:]*)?")
_TIGHT = re.compile(r"([^\W\d][\w'’-]*|[0-9]+'?):(\S.*)")
_LOOSE = re.compile(r"([^\W\d][\w'’-]*|[0-9]+'?)\s+([-+]?[0-9].*)")


class Item(NamedTuple):
    """What is meant: a key with its value as text, and the mistake. `joined`: the value goes on from the key before."""

    key: str
    value: str
    wrong: Message
    right: Message
    joined: bool = False


def lone(text: str, before: tuple[str, str] | None, touching: bool) -> Item | None:
    """What a word without a colon inside { } is meant to be, if it is a slip.

    `before`: the key before it and the plain text of its value; `touching`: only a comma is between them.
    """
    if before is not None and touching and _REST.fullmatch(text) and _WHOLE.fullmatch(before[1]):
        return _comma(before, text)
    if before is not None and (listed := _listed(before[1], text)):
        wrong = Message(N_("a comma inside { } ends the value: a list stands in square brackets"))
        right = Message(N_("write %(text)s"), {"text": shown(f"{before[0]}: {listed}")})
        return Item(before[0], listed, wrong, right, joined=True)
    if found := _TIGHT.fullmatch(text):
        right = Message(N_("write %(text)s"), {"text": shown(f"{found[1]}: {found[2]}")})
        return Item(found[1], found[2], Message(N_("a space is missing after the colon")), right)
    if found := _LOOSE.fullmatch(text):
        right = Message(N_("write %(text)s"), {"text": shown(f"{found[1]}: {found[2]}")})
        return Item(found[1], found[2], Message(N_("a colon is missing")), right)
    if before is not None and before[1][:1].isalpha() and " " in text and text[:1].isalpha():
        whole = f"{before[1]}, {text}"
        wrong = Message(N_("a comma inside { } ends the text"))
        right = Message(N_("put the text into quotes: '%(text)s'"), {"text": shown(whole)})
        return Item(before[0], whole, wrong, right, joined=True)
    return None


def _listed(first: str, second: str) -> str | None:
    """Two halves of `(350, -50)` or of `350 mm, -50 mm` as the list that they are meant to be."""
    if first.startswith("(") and second.endswith(")"):
        return f"[{first[1:].strip()}, {second[:-1].strip()}]"
    both = _MEASURED.fullmatch(first) and _MEASURED.fullmatch(second)
    return f"[{first}, {second}]" if both else None


def _comma(before: tuple[str, str], rest: str) -> Item:
    key, whole = before
    values = {"point": shown(f"{whole}.{rest}"), "comma": shown(f"{whole},{rest}")}
    wrong = Message(N_("decimal comma inside { }, where a comma parts two values"))
    return Item(
        key, f"{whole},{rest}", wrong, Message(N_("write %(point)s or '%(comma)s'"), values), joined=True
    )


def rejoined(events: Sequence[Any]) -> str | None:
    """A list of plain numbers as it would be without decimal commas, `[0,3, 0,2]` -> "[0.3, 0.2]"; None if none
    stands in it: a whole number, a comma and digits without a space between them."""
    items: list[str] = []
    open_, end = False, -1
    for event in events:
        text = event.value
        if open_ and event.start_mark.index == end + 1 and _REST.fullmatch(text):
            items[-1] += "." + text
            open_ = False
        else:
            items.append(text)
            open_ = bool(_WHOLE.fullmatch(text))
        end = event.end_mark.index
    return f"[{', '.join(items)}]" if len(items) < len(events) else None


def is_plain(event: Any) -> bool:
    """Whether it is a text without quotes."""
    return isinstance(event, yaml.ScalarEvent) and bool(event.implicit[0])


def is_left_out(value: Any, key: Any) -> bool:
    """Whether a plain key inside { } has neither a value nor a colon."""
    ends = value.start_mark.index, value.end_mark.index
    return is_plain(value) and is_plain(key) and ends == (key.end_mark.index, key.end_mark.index)


def meant(text: str, event: Any, last: tuple[str, Any] | None) -> Item | None:
    """What a word without a colon inside { } is meant to be, if it is a slip."""
    if last is None:
        return lone(text, None, False)
    key, value = last
    return lone(text, (key, value.value), event.start_mark.index == value.end_mark.index + 1)

"""What broke a YAML text, and what would mend it: a parser's complaint -> the slip of the pen behind it.

The parser stops where it cannot go on, which is often a line after the slip. What it was reading then (its context)
and the lines around tell which of the usual slips it is.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from tmm_report.problems import N_, Message, shown
from tmm_report.yamlread.broken import Broken, Place, Slip, content, indent

CLOSING = {"{": "}", "[": "]"}
_SPACE = re.compile(r"^[ \t]*([\u00a0\u2000-\u200b\u202f\u205f\u3000\ufeff])")
_KEY = re.compile(r"\s*(?:- +)*([^\s:#][^:#]*?)\s*:(?=\s|$)")
_TIGHT = re.compile(r"\s*(?:- +)*([^\W\d_][\w'’-]*|[0-9]+):([^\s/].*)")
_EQUAL = re.compile(r"\s*(?:- +)*([\w'’-]+)\s*[=：]\s*(.*)")
_LOOSE = re.compile(r"\s*(?:- +)*([\w'’-]+)\s+(\S.*)")
_SENTENCE = re.compile(
    r"\s*[\u0400-\u052f]{2,}(\s+[^\s\d:]+)+"
)  # no key has more than a name's letters of it
_WORD = re.compile(r"\s*(?:- +)*([\w'’-]+)\s*(?:#.*)?")


def slip(error: Any, text: str) -> Slip:
    """The slip behind an error of the parser."""
    mark, begun = getattr(error, "problem_mark", None), getattr(error, "context_mark", None)
    broken = Broken(
        text,
        str(getattr(error, "problem", None) or ""),
        (mark.line + 1, mark.column + 1) if mark else (1, 1),
        str(getattr(error, "context", None) or ""),
        (begun.line + 1, begun.column + 1) if begun else None,
    )
    found = (slip for look in _LOOKS for slip in look(broken))
    return next(found, None) or _unknown(broken)


def _unknown(broken: Broken) -> Slip:
    reason = shown(broken.problem or N_("the text is broken"), 80)
    right = Message(N_("look at the brackets, quotes, colons and indents of this line and the one before"))
    return Slip(broken.place, Message(N_("this is not YAML: %(reason)s"), {"reason": reason}), right)


# ---------------------------------------------------------------- spaces


def _spaces(broken: Broken) -> Iterator[Slip]:
    """Tabs, and characters that only look like spaces, at the beginning of a line."""
    for number in (broken.place[0], broken.above):
        line = broken.line(number)
        if "\t" in line[: len(line) - len(line.lstrip())]:
            wrong = Message(N_("a tab stands in the indent"))
            yield Slip(
                (number, line.index("\t") + 1), wrong, Message(N_("indent with spaces, not with tabs"))
            )
        if found := _SPACE.match(line):
            wrong = Message(N_("U+%(code)s stands in the indent"), {"code": f"{ord(found[1]):04X}"})
            yield Slip((number, found.start(1) + 1), wrong, Message(N_("indent with ordinary spaces")))


def _levels(broken: Broken) -> Iterator[Slip]:
    """An indent that is none of those that are open."""
    if "block mapping" not in broken.context or "expected key" not in broken.problem:
        return
    own = indent(broken.here)
    if broken.before.strip(" -"):
        return
    open_: dict[int, int] = {}  # indent -> the nearest line above with it
    least = 1 << 30
    for number in range(broken.place[0] - 1, 0, -1):
        line = broken.line(number)
        if content(line) and (wide := indent(line)) < least:
            open_.setdefault(wide, number)
            least = wide
    if not open_ or own in open_:
        return
    if (begun := _too_shallow(broken, open_)) is not None:
        yield begun
        return
    wanted = min(open_, key=lambda wide: (abs(wide - own), -wide))
    wrong = N_("the line is indented by %(own)s spaces, like none of the keys around it")
    right = N_("indent it by %(wanted)s, as line %(line)s, if it belongs beside that")
    told = {"wanted": wanted, "line": open_[wanted]}
    yield Slip((broken.place[0], own + 1), Message(wrong, {"own": own}), Message(right, told))


def _too_shallow(broken: Broken, open_: Mapping[int, int]) -> Slip | None:
    """The head of the block above, if that is what slipped: its lines, more than one, are a level deeper than the
    line where the parser stopped, which stands as deep as those before the head."""
    own, its = indent(broken.here), min(open_)
    head = open_[its]
    inner = [indent(line) for line in broken.lines[head : broken.place[0] - 1] if content(line)]
    before = (n for n in range(head - 1, 0, -1) if content(broken.line(n)) and indent(broken.line(n)) <= own)
    beside = next(before, 0)
    if len(inner) < 2 or min(inner) < 2 * own - its or indent(broken.line(beside)) != own or not beside:
        return None
    text = N_("the line is indented by %(own)s spaces, and line %(next)s, behind its block, by %(its)s")
    wrong = Message(text, {"own": its, "next": broken.place[0], "its": own})
    right = N_("indent it by %(wanted)s, as line %(line)s, if it belongs beside that")
    return Slip((head, its + 1), wrong, Message(right, {"wanted": own, "line": beside}))


# ---------------------------------------------------------------- quotes


def _quotes(broken: Broken) -> Iterator[Slip]:
    if "quoted scalar" in broken.context and broken.begun:
        mark = broken.line(broken.begun[0])[broken.begun[1] - 1 : broken.begun[1]]
        wrong = Message(N_("the quote %(mark)s opened here is not closed"), {"mark": mark})
        yield Slip(broken.begun, wrong, Message(N_("close it with %(mark)s"), {"mark": mark}))
        return
    mark = broken.before.rstrip()[-1:]
    if mark not in ("'", '"') or broken.char in (",", "}", "]", ""):
        return
    opened = _opened(broken, mark)
    if opened is not None and opened[0] < broken.place[0]:
        wrong = Message(
            N_("the quote %(mark)s opened here runs on to line %(line)s"), _of(mark, broken.place[0])
        )
        yield Slip(opened, wrong, Message(N_("close it with %(mark)s"), {"mark": mark}))
        return
    twice = "''" if mark == "'" else '\\"'
    right = Message(N_("inside quotes write %(twice)s, or use the other kind of quotes"), {"twice": twice})
    yield Slip(broken.place, Message(N_("the text goes on behind its closing quote")), right)


def _of(mark: str, line: int) -> dict[str, object]:
    return {"mark": mark, "line": line}


def _opened(broken: Broken, mark: str) -> Place | None:
    """Where the quote that ends just before the place was opened."""
    end = len(broken.before.rstrip()) - 1
    for number in range(broken.place[0], 0, -1):
        line = broken.line(number)
        column = line.rfind(mark, 0, end if number == broken.place[0] else len(line))
        if column >= 0:
            return number, column + 1
    return None


# ---------------------------------------------------------------- brackets


def _brackets(broken: Broken) -> Iterator[Slip]:
    """What goes wrong inside { } and [ ], and closing ones that close nothing."""
    if "flow" in broken.context and broken.begun:
        opening = broken.line(broken.begun[0])[broken.begun[1] - 1 : broken.begun[1]]
        if opening in CLOSING:
            yield from _inside(broken, opening, broken.begun)
    elif broken.char and broken.char in "}]":
        wrong = Message(N_("this %(mark)s closes nothing"), {"mark": broken.char})
        yield Slip(broken.place, wrong, Message(N_("take it out, or open what it closes")))


def _inside(broken: Broken, opening: str, begun: Place) -> Iterator[Slip]:
    closing = CLOSING[opening]
    told = {"open": opening, "close": closing, "line": begun[0], "column": begun[1]}
    if broken.char and broken.char in "}]":
        text = N_("%(found)s stands here, and %(open)s is open since line %(line)s, column %(column)s")
        wrong = Message(text, {**told, "found": broken.char})
        yield Slip(broken.place, wrong, Message(N_("close it with %(close)s"), told))
    elif _begins(broken) and broken.place[0] > begun[0]:
        text = N_("the %(open)s opened here is not closed before line %(next)s begins")
        right = Message(
            N_("close it with %(close)s at the end of line %(last)s"), {**told, "last": broken.above}
        )
        yield Slip(begun, Message(text, {**told, "next": broken.place[0]}), right)
    elif ";" in broken.before[-40:]:
        yield Slip(broken.place, Message(N_("; parts nothing")), Message(N_("write a comma")))
    elif broken.char == ":":
        word = shown((broken.before.split() or [""])[-1])
        wrong = Message(N_("a second colon in one value"))
        right = Message(N_("a comma is missing before %(word)s, or the text needs quotes"), {"word": word})
        yield Slip(broken.place, wrong, right)
    else:
        text = N_("neither a comma nor %(close)s follows here; the %(open)s is open since line %(line)s")
        yield Slip(broken.place, Message(text, told), Message(N_("part the values by commas")))


def _begins(broken: Broken) -> bool:
    """Whether the parser stopped at the first word of a line, or at its colon, or at the end of the file."""
    return not broken.here.strip() or bool(re.fullmatch(r"\s*(- +)?[^\s:,{}\[\]]*", broken.before))


# ---------------------------------------------------------------- colons and dashes


def _without_colon(broken: Broken) -> Iterator[Slip]:
    """A line that was taken for a key, and has no colon that is one."""
    if "could not find expected ':'" not in broken.problem or not broken.begun:
        return
    line = broken.line(broken.begun[0])
    yield from _colon(line, (broken.begun[0], indent(line) + 1))


def _colon(line: str, place: Place) -> Iterator[Slip]:
    missing = Message(N_("a colon is missing"))
    if found := _TIGHT.fullmatch(line):
        yield _written(place, Message(N_("a space is missing after the colon")), found[1], found[2])
    elif found := _EQUAL.fullmatch(line):
        yield _written(
            place, Message(N_("a key is parted from its value by a colon and a space")), *found.groups()
        )
    elif _SENTENCE.fullmatch(line):
        yield _no_key(place)
    elif found := _LOOSE.fullmatch(line):
        yield _written(place, missing, found[1], found[2])
    elif found := _WORD.fullmatch(line):
        yield Slip(place, missing, Message(N_("write %(text)s"), {"text": shown(f"{found[1]}:")}))


def _written(place: Place, wrong: Message, key: str, value: str) -> Slip:
    return Slip(place, wrong, Message(N_("write %(text)s"), {"text": shown(f"{key}: {value}".rstrip())}))


def _two_colons(broken: Broken) -> Iterator[Slip]:
    """A key where none can be: behind another in its line, or under a line that has its value, or no colon."""
    if "mapping values are not allowed" not in broken.problem:
        return
    if found := _KEY.match(broken.before):
        wrong = Message(N_("a second colon in the value of %(key)s"), {"key": shown(found[1])})
        right = Message(N_("put a text into quotes, a block into { }, another key on a line of its own"))
        yield Slip(broken.place, wrong, right)
        return
    line, number = broken.line(broken.above), broken.above
    if found := re.match(r"\s*-[^\s-]", line):
        wrong = Message(N_("a space is missing after -"))
        yield Slip((number, found.end()), wrong, Message(N_("write - and a space before the item")))
    elif _KEY.match(line):
        wrong = Message(
            N_("the line is indented deeper than line %(line)s, which has its value"), {"line": number}
        )
        right = Message(
            N_("indent it by %(wanted)s, as line %(line)s"), {"wanted": _key_indent(line), "line": number}
        )
        yield Slip((broken.place[0], indent(broken.here) + 1), wrong, right)
    else:
        yield from _colon(line, (number, indent(line) + 1))


def _key_indent(line: str) -> int:
    """The indent of a line's key, behind dashes."""
    found = re.match(r"\s*(?:- +)*", line)
    return found.end() if found else 0


def _glued(broken: Broken) -> Iterator[Slip]:
    """`points:{` inside braces."""
    if "unexpected ':'" in broken.problem:
        wrong = Message(N_("a space is missing after the colon"))
        yield Slip(broken.place, wrong, Message(N_("write a space after every colon")))


def _dash(broken: Broken) -> Iterator[Slip]:
    if "'-' indicator" in broken.problem and broken.begun:
        wrong = Message(
            N_("the list begun on line %(line)s goes on here without -"), {"line": broken.begun[0]}
        )
        right = N_(
            "begin a new item with - and a space; what belongs to the item before is indented by %(wanted)s"
        )
        wanted = _key_indent(broken.line(broken.begun[0]))
        yield Slip(broken.place, wrong, Message(right, {"wanted": wanted}))


def _first_letter(broken: Broken) -> Iterator[Slip]:
    """Characters with which a text cannot begin."""
    signs = "*&!@`%|>"
    place = broken.begun if "alias" in broken.context or "anchor" in broken.context else broken.place
    char = broken.line(place[0])[place[1] - 1 : place[1]] if place else ""
    if place and char and char in signs:
        wrong = Message(N_("a text cannot begin with %(char)s"), {"char": char})
        yield Slip(place, wrong, Message(N_("put the text into quotes")))


def _beginning(broken: Broken) -> Iterator[Slip]:
    """A file that begins with a line that is no key."""
    number = next((n for n, line in enumerate(broken.lines, 1) if content(line)), 1)
    line = broken.line(number)
    if "<document start>" in broken.problem and not _KEY.match(line):
        yield _no_key((number, indent(line) + 1))


def _no_key(place: Place) -> Slip:
    wrong = Message(N_("the line is neither a key nor a comment"))
    return Slip(place, wrong, Message(N_("write key: value, or begin it with #")))


_LOOKS: Sequence[Callable[[Broken], Iterator[Slip]]] = (
    _spaces, _quotes, _brackets, _glued, _without_colon, _dash, _two_colons, _first_letter, _levels, _beginning,
)  # fmt: skip

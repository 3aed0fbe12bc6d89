"""The block `find` of a variant: a question asked backwards."""

import re
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal, TypedDict

from pydantic import Field

from tmm_report.chapters.find.given import Demand, Given, Kind, Unknown
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.leaves import Leaf, leaves
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import Reads, whole
from tmm_report.yamlread import Path

NAMED_BY = ("name", "at", "on", "link", "point", "slider", "guide", "pivot", "of", "kind")
"""Keys by which an item of a list is called."""
MOST = 2  # unknowns
NO_NUMBERS = ("integer", "boolean", "string")
BLOCKS = ("find", "title", "language", "decimal_sign")  # in which nothing is sought
PATH: Path = ("find", "unknown")
_ENDS = re.compile(r"\s*(?:\.\.\.?|…)\s*")
_BOUND = re.compile(
    r"(?P<most>at most|no more than|не более|не больше|<=|≤)?"
    r"(?P<least>at least|no less than|не менее|не меньше|>=|≥)?\s*(?P<rest>.*)"
)


@dataclass(frozen=True)
class Span:
    """A range as it is written: both ends in one unit."""

    low: float
    high: float
    unit: str


@dataclass(frozen=True)
class Level:
    """A wanted number as it is written."""

    kind: Kind
    number: float
    unit: str


def _span(value: object) -> Span:
    ends = _ENDS.split(value.strip()) if isinstance(value, str) else value
    if not isinstance(ends, list) or len(ends) != 2:
        wrong = Message(N_("%(value)s is not a range"), {"value": shown(value)})
        raise WrongValue(wrong, Message(N_("write both ends, for example 0.01 .. 0.1 or 100 mm .. 250 mm")))
    (low, own), (high, other) = (units.measured(end) for end in ends)
    unit = own or other
    if own and other and own != other:
        high *= units.between(other, own)
    if low == high:
        raise WrongValue(
            Message(N_("the range %(value)s is empty: both ends are equal"), {"value": shown(value)})
        )
    if low > high:
        right = Message(N_("write the smaller number first"))
        raise WrongValue(Message(N_("the range %(value)s goes backwards"), {"value": shown(value)}), right)
    return Span(low, high, unit)


def _level(value: object) -> Level:
    if not isinstance(value, str):
        return Level("equal", *units.measured(value))
    match = _BOUND.fullmatch(" ".join(value.split()))
    assert match is not None  # it fits any text
    kind: Kind = "most" if match["most"] else "least_allowed" if match["least"] else "equal"
    return Level(kind, *units.measured(match["rest"]))


_EITHER = {"anyOf": [{"type": "string"}, {"type": "array"}], "examples": ["0.01 .. 0.1", "100 mm .. 250 mm"]}
_WANTED = {"anyOf": [{"type": "number"}, {"type": "string"}], "examples": ["0.8 m", "at most 35 m/s"]}
NameOf = Annotated[str, Field(max_length=200)]


class FindModel(Model):
    """One number of the file is unknown and one of the results is demanded, or two of each."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("minimum", "min", "minimize"), N_("the key for the smallest value is least")),
        **dict.fromkeys(("maximum", "max", "maximize"), N_("the key for the largest value is greatest")),
        **dict.fromkeys(("unknowns", "also"), N_("the key for one unknown or two is unknown")),
    }

    unknown: dict[NameOf, Annotated[Span, Reads(_span, _EITHER)]] = Field(
        min_length=1,
        description="the path of a number of this file, and the range in which it is sought; or two",
    )
    so_that: dict[NameOf, Annotated[Level, Reads(_level, _WANTED)]] | None = Field(
        default=None, description="a number of the results and what it is to be; two for two unknowns"
    )
    greatest: NameOf | None = Field(
        default=None,
        description="the number of the results that is to be greatest",
        examples=["dynamics_start.epsilon.max"],
    )
    least: NameOf | None = Field(
        default=None, description="the number of the results that is to be least", examples=["M_bal_max"]
    )
    choose: Literal["first", "last"] | Annotated[int, whole(1, 1000)] = Field(
        default="first", description="which of several roots the variant is solved with"
    )


class Block(model.Block):
    """A question asked backwards."""

    find: FindModel | None = Field(
        default=None, description="a number of this file from a demand on the results"
    )


class Taken(TypedDict):
    find: Given | None


def given(read: Read) -> Taken:
    asked = read.block(Block).find
    if asked is None:
        return {"find": None}
    choose = {"first": 1, "last": -1}.get(str(asked.choose), asked.choose)
    unknowns = tuple(
        Unknown(name, path, span.low, span.high, span.unit, dimension)
        for name, span in asked.unknown.items()
        for path, dimension in (_place(name, read),)
    )
    return {"find": Given(unknowns, tuple(_demands(asked)), int(choose))}


def _demands(asked: FindModel) -> list[Demand]:
    found = [
        Demand(name, level.kind, level.number, level.unit, ("find", "so_that", name))
        for name, level in (asked.so_that or {}).items()
    ]
    if asked.greatest is not None:
        found.append(Demand(asked.greatest, "greatest", path=("find", "greatest")))
    if asked.least is not None:
        found.append(Demand(asked.least, "least", path=("find", "least")))
    return found


def mistakes(read: Read) -> Iterator[Problem]:
    asked = read.block(Block).find
    if asked is None:
        return
    count = len(asked.unknown)
    if count > MOST:
        right = Message(N_("leave one or two of them; state the others"))
        yield mistake(N_("%(count)s unknowns at once are not offered"), PATH, right, count=count)
    demands = _demands(asked)
    if demands and len(demands) != count <= MOST:
        right = Message(N_("as many demands as unknowns, each with one number of the results"))
        text = N_("unknowns: %(count)s, demands: %(demands)s")
        yield mistake(text, ("find",), right, count=count, demands=len(demands))
    elif count == MOST:
        for one in demands:
            if one.kind != "equal":
                right = Message(N_("so_that with both numbers as they are to be: {key: value, key: value}"))
                yield mistake(N_("of two unknowns both demands are equalities"), one.path, right)
        yield from _same_twice(asked, read)
    if not demands and not read.is_broken("find"):
        right = Message(N_("so_that: {key: value}, greatest: key or least: key, keys as in results.json"))
        yield mistake(N_("nothing is demanded of the results"), ("find",), right)
    for name, span in asked.unknown.items():
        yield from _of_unknown(name, span, read)


def _same_twice(asked: FindModel, read: Read) -> Iterator[Problem]:
    """Two names of one number."""
    try:
        places = [_place(name, read)[0] for name in asked.unknown]
    except WrongValue:  # told by `_of_unknown`
        return
    if len(set(places)) < len(places):
        right = Message(N_("name two numbers of the file"))
        yield mistake(N_("both unknowns are the same number"), PATH, right)


def _of_unknown(name: str, span: Span, read: Read) -> Iterator[Problem]:
    """The path leads to a number, and both ends of the range may stand there."""
    try:
        path, dimension = _place(name, read)
        leaf = _leaf(path, read)
        unknown = Unknown(name, path, span.low, span.high, span.unit, dimension)
        for end in (span.low, span.high):
            units.parse(unknown.written(end), dimension)
            assert leaf is not None and isinstance(leaf.reads, Reads)
            leaf.reads.value(unknown.written(end))
    except WrongValue as error:
        yield Problem(error.wrong, error.right, (*PATH, name))


def _place(name: str, read: Read) -> tuple[Path, str]:
    """Path and dimension of the number that a name of the file leads to. Raises WrongValue."""
    inside: Any = read.data
    path: Path = ()
    for part in name.split("."):
        key = _key(part, inside, path)
        inside, path = inside[key], (*path, key)
    leaf = _leaf(path, read)
    if path[0] in BLOCKS or leaf is None or not _is_number(leaf):
        wrong = Message(N_("what stands at %(name)s is no number"), {"name": shown(name, 80)})
        inner = [str(key) for key in inside] if isinstance(inside, dict) else []
        right = Message(N_("go on to one of %(words)s"), {"words": shown(", ".join(inner), 120)})
        raise WrongValue(wrong, right if inner else Message(N_("name a number that the file states")))
    if isinstance(leaf.reads, Reads) and leaf.reads.schema.get("type") == "integer":
        wrong = Message(N_("%(name)s is a whole number: it is not sought"), {"name": shown(name, 80)})
        raise WrongValue(wrong, Message(N_("name a number that may have any value of a range")))
    return path, leaf.dimension or "number"


def _key(part: str, inside: Any, path: Path) -> str | int:
    """The key of a mapping, or the number of an item of a list, that a part of a name means. Raises WrongValue."""
    if isinstance(inside, dict):
        if part in inside:
            return part
        known = [str(key) for key in inside if path or key not in BLOCKS]
        right = near(part, known) or Message(N_("name a number that the file states"))
    elif isinstance(inside, list):
        if part.isdecimal() and int(part) < len(inside):
            return int(part)
        called = [_called(item) for item in inside]
        if len(found := [k for k, names in enumerate(called) if part in names]) == 1:
            return found[0]
        right = Message(N_("the items are numbered 0 … %(last)s"), {"last": len(inside) - 1})
        if len(found) > 1:
            text = N_("%(count)s items of %(key)s are called %(part)s")
            told = {"count": len(found), "key": ".".join(map(str, path)), "part": shown(part)}
            raise WrongValue(Message(text, told), right)
    else:
        right = Message(N_("a number has no parts: leave out what follows it"))
    text = N_("there is no %(part)s in %(key)s") if path else N_("there is no %(part)s in the file")
    raise WrongValue(Message(text, {"part": shown(part), "key": ".".join(map(str, path))}), right)


def _called(item: Any) -> list[str]:
    """By what an item of a list is called."""
    return [str(item[key]) for key in NAMED_BY if key in item] if isinstance(item, dict) else [str(item)]


def _leaf(path: Path, read: Read) -> Leaf | None:
    found = leaves(read.blocks, read.data)
    return next((leaf for leaf in found if leaf.path == path and not leaf.is_key), None)


def _is_number(leaf: Leaf) -> bool:
    """Whether what is written there is a number, and the format wants one."""
    if leaf.names or not isinstance(leaf.reads, Reads) or isinstance(leaf.written, bool):
        return False
    if leaf.reads.schema.get("type") in NO_NUMBERS[1:]:
        return False
    try:
        units.measured(leaf.written)
    except WrongValue:
        return False
    return True

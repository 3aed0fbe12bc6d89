"""A key that is unknown where it stands and known elsewhere: in another form of its block, or at another level."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any, Literal, get_args, get_origin

from tmm_report.problems import N_, Message, shown
from tmm_report.variant.forms import Models, fields_at, fields_of, forms_at, homes, own_keys
from tmm_report.yamlread import Path

FEW = 3  # blocks that are named as those that know a key
_TOP = Message(N_("it stands at the top of the file, without any indent"))


def right(
    path: Path, data: Any, own: Sequence[str], roots: Models, stated: Collection[str]
) -> Message | None:
    """Where the key at the path is known; `own`: the keys that are known beside it; `stated`: those at the top of the
    file. None if nowhere near."""
    roots = list(roots)
    around, key = path[:-1], str(path[-1])
    beside = at(data, around)
    if not isinstance(beside, dict):
        return None
    return (
        _other_form(around, key, {name: beside[name] for name in beside if name in own}, roots)
        or _deeper(around, key, beside, roots)
        or _higher(around, key, data, roots)
        or anywhere(key, beside.get(key), stated, roots)
    )


def at(data: Any, path: Path) -> Any:
    for part in path:
        data = data[part]
    return data


def _other_form(around: Path, key: str, beside: Mapping[str, Any], roots: Models) -> Message | None:
    """Another form of the block has the key: what stands beside it does not go with it."""
    found: list[list[str]] = []
    for model in forms_at(around, roots):
        fields = dict(fields_of(model))
        if key in fields and (others := _excluding(fields, beside)):
            found.append(others)
    if not found:
        return None
    fewest = sorted(found, key=len)[0]
    values = {"key": key, "others": ", ".join(fewest)}
    return Message(N_("%(key)s does not go together with %(others)s"), values)


def _excluding(fields: Mapping[str, Any], beside: Mapping[str, Any]) -> list[str]:
    """What stands beside a key and does not go with it: a word that its form has otherwise, else the keys that it has
    not."""
    words = {name: _words(fields[name].annotation) for name in beside if name in fields}
    others = [
        f"{name}: {shown(beside[name])}"
        for name, known in words.items()
        if known and beside[name] not in known
    ]
    return others or [name for name in beside if name not in fields]


def _words(annotation: Any) -> tuple[Any, ...]:
    return get_args(annotation) if get_origin(annotation) is Literal else ()


def _deeper(around: Path, key: str, beside: Mapping[str, Any], roots: Models) -> Message | None:
    """A block beside the key has it: the nearest one before it, else one after it."""
    blocks = fields_at(around, roots)
    having = [name for name in beside if name in blocks and name != key and key in own_keys(blocks[name])]
    if not having:
        return None
    order = list(beside)
    place = order.index(key) if key in order else len(order)
    nearest = min(having, key=lambda name: (order.index(name) > place, abs(order.index(name) - place)))
    return Message(N_("it belongs into %(block)s: indent it further"), {"block": nearest})


def _higher(around: Path, key: str, data: Any, roots: Models) -> Message | None:
    """A block around the key has it, or a block that stands beside one of those around."""
    for n in range(len(around) - 1, -1, -1):
        if isinstance(around[n], int):
            continue
        known = fields_at(around[:n], roots)
        if key in known:
            where = Message(
                N_("it belongs into %(block)s: indent it less"), {"block": ".".join(map(str, around[:n]))}
            )
            return where if n else _TOP
        having = [name for name in known if name != around[n] and key in own_keys(known[name])] if n else []
        if len(having) == 1:
            return Message(
                N_("it belongs into %(block)s"), {"block": ".".join(map(str, (*around[:n], having[0])))}
            )
    return None


def anywhere(key: str, value: Any, stated: Collection[str], roots: Models) -> Message | None:
    """The blocks of the format that know the key: those that the file has, else all; None if there are many."""
    blocks = _blocks(list(dict.fromkeys(homes(key, roots))), stated)
    if not 0 < len(blocks) <= FEW:
        return None
    place = ".".join(blocks[0])
    if len(blocks) > 1:
        text = N_("it is a key of one of these blocks: %(blocks)s")
        return Message(text, {"blocks": ", ".join(map(".".join, blocks))})
    if len(blocks[0]) > 1 or place in stated or isinstance(value, dict | list):
        return Message(N_("it belongs into %(block)s"), {"block": place})
    text = N_("it belongs into %(block)s, a block of its own at the top of the file: %(example)s")
    return Message(text, {"block": place, "example": f"{place}: {{{key}: {shown(value)}}}"})


def _blocks(found: list[tuple[str, ...]], stated: Collection[str]) -> list[tuple[str, ...]]:
    """Of the blocks that know a key those that may be meant: of many the first, if the others lie deeper."""
    blocks = [path for path in found if path[0] in stated] or found
    if len(blocks) > FEW and all(len(path) > len(blocks[0]) for path in blocks[1:]):
        return blocks[:1]
    return blocks

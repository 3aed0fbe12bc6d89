"""pydantic's errors -> Problems: the path in the file's own words, what is wrong, what would be right."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import Any

from pydantic import BaseModel, ValidationError

from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.quantity.text import for_example
from tmm_report.quantity.typed.alike import difference, skeleton
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.forms import fields_at, fields_of, forms_at
from tmm_report.variant.leaves import leaves
from tmm_report.variant.russian import english_key, twin
from tmm_report.variant.slips import elsewhere, synonyms, textbook
from tmm_report.yamlread import Path

_TEXTS = {
    "dict_type": N_("keys with values are expected here"),
    "model_type": N_("keys with values are expected here"),
    "model_attributes_type": N_("keys with values are expected here"),
    "list_type": N_("a list in square brackets is expected here"),
    "tuple_type": N_("a list in square brackets is expected here"),
    "string_type": N_("a word is expected here"),
    "too_short": N_("too few values: %(min_length)s expected, %(actual_length)s found"),
    "too_long": N_("too many values: %(max_length)s expected"),
    "string_too_long": N_("the key is longer than %(max_length)s characters"),
    "string_pattern_mismatch": N_("a number of a position is expected as the key"),
    "shape": N_("this has another form than expected here"),
}


COMPARED = 40  # words among which the nearest is looked for letter by letter
CLOSE = 0.8  # likeness of a word that is misspelt and not another one
WORDED = 200  # mistakes of a block for which suggestions are looked for

Roots = Callable[[], Iterable[type[BaseModel]]]
"""The blocks of the format, all of them: asked for only where a message names known keys, as some are slow to load."""


def problems(
    error: ValidationError, kind: type[BaseModel], data: Any, roots: Roots, stated: Collection[str] = ()
) -> list[Problem]:
    """One Problem for each of the errors that validating `data` by the block `kind` gave; `stated`: the keys at the
    top of the file."""
    found = error.errors(include_url=False)
    owned: Mapping[Path, Sequence[str]] = {}
    if any(one["type"] == "extra_forbidden" for one in found):
        owned = {leaf.path: leaf.known for leaf in leaves([kind], data) if leaf.known}
    found = [one for one in found if not (_is_misspelt(one, found) or _is_long_enough(one))]
    # nobody reads a thousand suggestions, and each takes time to find
    return [_problem(one, data, owned if n < WORDED else {}, roots, stated) for n, one in enumerate(found)]


def _is_misspelt(error: Any, found: Sequence[Any]) -> bool:
    """Whether what is missing stands there: a key under a name that comes near, a value behind a semicolon."""
    around, key = error["loc"][:-1], error["loc"][-1]
    if error["type"] != "missing":
        return False
    beside = [one for one in found[:WORDED] if one["loc"][:-1] == around and one is not error]
    if isinstance(key, int):
        return any(isinstance(one["input"], str) and ";" in one["input"] for one in beside)
    return by_another_name(key, [str(one["loc"][-1]) for one in beside if one["type"] == "extra_forbidden"])


def by_another_name(key: str, unknown: Collection[str]) -> bool:
    """Whether one of the unknown keys is the one that is missing: in Russian, as textbooks call it, misspelt."""
    named = any(key in (english_key(one, [key]), synonyms.meant(one, [key])) for one in unknown)
    return named or bool(difflib.get_close_matches(key, unknown, 1, CLOSE))


def _is_long_enough(error: Any) -> bool:
    """Whether a list falls short by items alone that are wrong themselves."""
    return error["type"] == "too_short" and len(error["input"]) >= error["ctx"]["min_length"]


def near(word: str, known: Sequence[str]) -> Message | None:
    """`did you mean ...?` with the nearest known word, or the list of known words, or nothing.

    Of a word that only looks like a known one, which character is another. Never the word itself.
    """
    others = [one for one in known if one != word]
    if alike := next((one for one in others if skeleton(one) == skeleton(word)), None):
        return difference(word, alike)
    if nearest := difflib.get_close_matches(word, _likely(word, others), 1, 0.6):
        return Message(N_("did you mean %(near)s?"), {"near": shown(nearest[0])})
    return Message(N_("known: %(words)s"), {"words": shown(", ".join(others), 200)}) if others else None


def _likely(word: str, known: Sequence[str]) -> Sequence[str]:
    """Of many words those that may be near, by what is seen at a glance: comparing each with each takes minutes."""
    if len(known) <= COMPARED:
        return known
    start = word[:1].casefold()
    return sorted(known, key=lambda one: (abs(len(one) - len(word)), one[:1].casefold() != start))[:COMPARED]


def _problem(
    error: Any, data: Any, owned: Mapping[Path, Sequence[str]], roots: Roots, stated: Collection[str]
) -> Problem:
    path = data_path(error["loc"], data, error["type"] == "missing")
    kind, context = error["type"], error.get("ctx", {})
    cause = context.get("error")
    if isinstance(cause, WrongValue):
        return Problem(cause.wrong, cause.right, path if cause.inner is None else (*path, cause.inner))
    if kind == "missing":
        return _missing(path, roots)
    if kind == "extra_forbidden":
        right = unknown(path, data, owned.get(path), roots, stated) if owned else None
        return mistake(N_("unknown key %(key)s"), path, right, key=shown(path[-1]))
    if kind == "literal_error":
        return _not_a_word(error, path)
    right = Message(error["msg"]) if kind == "shape" else None
    if kind == "shape" and isinstance(error["input"], dict) and (named := error["input"].get("kind")):
        if (near_by := textbook.nearest(str(named))) is not None:
            return mistake(N_("there is no kind: %(value)s"), path, near_by, value=shown(named))
        return mistake(N_("kind: %(value)s is not offered"), path, right, value=shown(named))
    if kind in ("list_type", "tuple_type") and (listed := _as_list(error["input"])):
        return mistake(_TEXTS[kind], path, Message(N_("write %(text)s"), {"text": listed}))
    if kind == "list_type" and isinstance(error["input"], dict):
        return mistake(N_("a list is expected here"), path, Message(N_("begin each item with - and a space")))
    if kind in _TEXTS:
        return mistake(_TEXTS[kind], path, right or _example(path, roots), **context)
    return mistake(N_("the value does not fit: %(reason)s"), path, reason=shown(error["msg"], 120))


def _as_list(value: Any) -> str | None:
    """Values parted by commas without square brackets, as a list; None of another text."""
    if not isinstance(value, str):
        return None
    inner = value.strip().strip("()").strip()
    return f"[{shown(inner)}]" if "," in inner and not set(inner) & set("[](){}") else None


def _missing(path: Path, roots: Roots) -> Problem:
    if isinstance(path[-1], int):
        return mistake(N_("a value of the list is missing"), path[:-1], _example(path[:-1], roots))
    return mistake(N_("the key %(key)s is missing"), path, _example(path, roots), key=path[-1])


def _example(path: Path, roots: Roots) -> Message | None:
    """Of the key at a path, or of the list around it, where the format has one."""
    while path and isinstance(path[-1], int):
        path = path[:-1]
    forms = forms_at(path[:-1], roots()) if path else []
    fields = (dict(fields_of(form)).get(str(path[-1])) for form in forms)
    examples = next((field.examples for field in fields if field is not None and field.examples), None)
    if examples is None:
        return None
    first = examples[0]
    shown_as = f"[{', '.join(map(str, first))}]" if isinstance(first, list) else first
    return for_example(f"{path[-1]}: {shown_as}")


def _not_a_word(error: Any, path: Path) -> Problem:
    words = re.findall(r"'([^']*)'", error["ctx"]["expected"])
    given = error["input"]
    quoted = shown(given) if isinstance(given, str | int | float) else "[…]"
    cyrillic = isinstance(given, str) and re.search("[а-яё]", given.casefold())
    right = Message(N_("one of: %(words)s"), {"words": ", ".join(words)})
    if cyrillic:
        twins = {"words": ", ".join(words), "twins": ", ".join(map(twin, words))}
        right = Message(N_("one of: %(words)s (%(twins)s)"), twins)
    if alike := next((one for one in words if one != given and skeleton(one) == skeleton(quoted)), None):
        right = difference(quoted, alike)
    elif (known_by_name := textbook.nearest(quoted)) is not None:
        right = known_by_name
    return mistake(N_("%(value)s is not a word known here"), path, right, value=quoted)


def data_path(loc: Sequence[str | int], data: Any, missing: bool = False) -> Path:
    """pydantic's location without its own marks (tags of unions, "[key]"): the path in the data."""
    path: list[str | int] = []
    for index, part in enumerate(loc):
        found = isinstance(part, str) and isinstance(data, dict) and part in data
        found |= isinstance(part, int) and isinstance(data, list) and part < len(data)
        if found:
            data = data[part]
        if found or (missing and index == len(loc) - 1):
            path.append(part)
    return tuple(path)


def unknown(
    path: Path, data: Any, own: Sequence[str] | None, roots: Roots, stated: Collection[str] = ()
) -> Message | None:
    """What would be right where a key is unknown. `own`: the keys that are known there."""
    key = str(path[-1])
    if key == "kind" and (named := textbook.nearest(str(elsewhere.at(data, path)))) is not None:
        return named
    if (refused := _not_offered(key, path, roots)) is not None:
        return refused
    if own is None:
        return near(key, sorted(fields_at(path[:-1], roots())))
    if (meant := english_key(key, own)) is not None:
        return Message(N_("keys are English words: %(key)s"), {"key": meant})
    if (meant := synonyms.meant(key, own)) is not None:
        return Message(N_("did you mean %(near)s?"), {"near": meant})
    if (known_by_name := _textbook(key, own)) is not None:
        return known_by_name
    alike = any(skeleton(one) == skeleton(key) for one in own)
    return (None if alike else elsewhere.right(path, data, own, roots(), stated)) or near(key, sorted(own))


def _textbook(key: str, own: Collection[str]) -> Message | None:
    """Of a thing that textbooks have and the program lacks; of a word that is only misspelt nothing."""
    return None if _is_slip_of(key, own) and not textbook.known(key) else textbook.nearest(key)


def _is_slip_of(key: str, known: Collection[str]) -> bool:
    """Whether a key is one of those that are known, but for a letter or the look of one."""
    return bool(difflib.get_close_matches(key, known, 1, CLOSE)) or any(
        skeleton(one) == skeleton(key) for one in known
    )


def _not_offered(key: str, path: Path, roots: Roots) -> Message | None:
    """What a block says of a key that other programs, or assignments, have there."""
    models = forms_at(path[:-1], roots()) if len(path) > 1 else []
    return next((Message(text[key]) for text in _refusals(models) if key in text), None)


def _refusals(models: Iterable[object]) -> list[Mapping[str, str]]:
    return [getattr(model, "NOT_OFFERED", {}) for model in models]


def unknown_block(key: str, data: Any, known: Sequence[str], roots: Roots) -> Message | None:
    """What would be right where a key at the top of the file is unknown."""
    if (refused := next((texts[key] for texts in _refusals(roots()) if key in texts), "")) != "":
        return Message(refused)
    everywhere = {name for block in roots() for name in block.model_fields}
    if (meant := english_key(key, known) or english_key(key, everywhere)) is not None:
        return Message(N_("keys are English words: %(key)s"), {"key": meant})
    if (known_by_name := _textbook(key, known)) is not None:
        return known_by_name
    slip = _is_slip_of(key, known)
    return (None if slip else elsewhere.anywhere(key, data[key], data, roots())) or near(key, sorted(known))

"""Names and keys of one file that look alike and are written with letters of different scripts.

They are told with both places and read as one, so that what follows from them (a link that hangs free, a missing
point) is not told besides.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from difflib import get_close_matches
from typing import Any

from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.quantity.typed.alike import difference, latin, script, skeleton
from tmm_report.records import dataclass
from tmm_report.variant.leaves import Leaf, leaves
from tmm_report.variant.model import Block
from tmm_report.variant.slips import textbook
from tmm_report.yamlread import Document, Path

SOME = 40  # blocks of unknown names that are held against the known ones
CLOSE = 0.75  # likeness of a block's name that is misspelt
_WORD = re.compile(r"[^\W_]+['’]?")


@dataclass(frozen=True, eq=False)
class _Changes:
    """What is read otherwise than it is written: keys by their paths, and single values."""

    keys: Mapping[Path, str]
    values: Mapping[Path, str]


def top_keys(document: Document, known: Collection[str]) -> tuple[Document, list[Problem]]:
    """The keys at the top of the file that look like known ones."""
    unknown = [Leaf((key,), key, None, is_key=True, known=tuple(known)) for key in document.data]
    document, problems = _of_keys(document, [leaf for leaf in unknown if leaf.written not in known])
    blocks = [key for key, value in document.data.items() if isinstance(value, dict) and key not in known]
    document, more = _misspelt(document, blocks[:SOME], [key for key in known if key not in document.data])
    return document, [*problems, *more]


def _misspelt(
    document: Document, unknown: Iterable[str], known: Sequence[str]
) -> tuple[Document, list[Problem]]:
    """Blocks whose names are misspelt: read as what is meant, as the others could not do without them."""
    keys: dict[Path, str] = {}
    problems: list[Problem] = []
    for key in (one for one in unknown if not textbook.known(one)):
        free = [one for one in known if one not in keys.values()]
        if found := get_close_matches(key.casefold(), free, 1, CLOSE):
            keys[(key,)] = found[0]
            right = Message(N_("did you mean %(near)s?"), {"near": found[0]})
            problem = mistake(N_("unknown key %(key)s"), (key,), right, key=shown(key))
            problems.append(_at(problem, document, (key,)))
    return _read_as(document, _Changes(keys, {})) if keys else document, problems


def mended(document: Document, blocks: Sequence[type[Block]]) -> tuple[Document, list[Problem]]:
    """The document with names and keys of the blocks that look like others made those others; what was wrong."""
    found = list(leaves(blocks, document.data))
    document, problems = _of_keys(document, [leaf for leaf in found if leaf.known])
    found = list(leaves(blocks, document.data)) if problems else found
    document, more = _of_points(document, [leaf for leaf in found if leaf.names])
    problems += more
    named = [leaf for leaf in (leaves(blocks, document.data) if more else found) if leaf.names]
    spelled = _spellings(named)
    alike = [words for words in spelled.values() if len(words) > 1]
    meant = {word: _most(words) for words in alike for word in words}
    problems += [problem for words in alike for problem in _told(words, document)]
    return _read_as(document, _renamed(named, meant)) if alike else document, problems


def _of_keys(document: Document, unknown: Iterable[Leaf]) -> tuple[Document, list[Problem]]:
    """Unknown keys that look like known ones, which are not there themselves."""
    keys: dict[Path, str] = {}
    problems: list[Problem] = []
    for leaf in unknown:
        key = next((one for one in leaf.known if one.isascii() and latin(leaf.written) == one), None)
        if key is None or (*leaf.path[:-1], key) in document.places:
            continue
        keys[leaf.path] = key
        right = difference(leaf.written, key)
        problem = mistake(N_("unknown key %(key)s"), leaf.path, right, key=shown(leaf.written))
        problems.append(_at(problem, document, leaf.path))
    return _read_as(document, _Changes(keys, {})) if keys else document, problems


# ---------------------------------------------------------------- names


def _spellings(named: Iterable[Leaf]) -> Mapping[str, dict[str, list[Path]]]:
    """Of all names that look alike: each spelling with the places where it stands."""
    found: dict[str, dict[str, list[Path]]] = defaultdict(dict)
    for leaf in named:
        for word in _WORD.findall(str(leaf.written)):
            found[latin(word)].setdefault(word, []).append(leaf.path)
    return found


def _most(words: Mapping[str, Sequence[Path]]) -> str:
    """The spelling that is meant: the most frequent one, of equals that in Latin letters."""
    return max(words, key=lambda word: (len(words[word]), word.isascii()))


def _told(words: Mapping[str, Sequence[Path]], document: Document) -> Iterator[Problem]:
    """A mistake for each spelling beside the one that is meant, where it first stands."""
    meant = _most(words)
    for word, places in words.items():
        if word != meant:
            text = N_("%(one)s (%(script)s) and %(other)s (%(its)s) on line %(line)s look alike: two names")
            right = Message(N_("write one of them everywhere, best in Latin letters"))
            line, _ = document.places.get(words[meant][0], (0, 0))
            told = {"one": word, "script": script(word), "other": meant, "its": script(meant)}
            yield _at(mistake(text, places[0], right, **told, line=line), document, places[0])


def _of_points(document: Document, named: Sequence[Leaf]) -> tuple[Document, list[Problem]]:
    """Points of one name but for a digit that looks like its letter: O and 0, S3 and SЗ. Links have digits for names,
    so that only points are held against points."""
    points = [leaf for leaf in named if _is_point(leaf)]
    spelled: dict[str, dict[str, list[Path]]] = defaultdict(dict)
    for leaf in points:
        word = latin(str(leaf.written))
        spelled[skeleton(word)].setdefault(word, []).append(leaf.path)
    keys: dict[Path, str] = {}
    problems: list[Problem] = []
    for words in (words for words in spelled.values() if len(words) > 1):
        meant = max(words, key=lambda word: (len(words[word]), not word.isdigit()))
        for word, places in words.items():
            if word != meant:
                keys |= dict.fromkeys(places, meant)
                problems.append(_other_point(word, places[0], meant, words[meant][0], document))
    return _read_as(document, _Changes(keys, {})) if keys else document, problems


def _is_point(leaf: Leaf) -> bool:
    """Whether it is the name of a point where that is given its place."""
    path = leaf.path
    framed = path[:2] == ("mechanism", "frame") and len(path) == 3
    return leaf.is_key and (
        framed or (path[:2] == ("mechanism", "links") and len(path) == 5 and path[3] == "points")
    )


def _other_point(word: str, path: Path, meant: str, its: Path, document: Document) -> Problem:
    text = N_("the point %(one)s looks like the point %(other)s on line %(line)s")
    line, _ = document.places.get(its, (0, 0))
    problem = mistake(text, path, difference(word, meant), one=word, other=meant, line=line)
    return _at(problem, document, path)


def _renamed(named: Iterable[Leaf], meant: Mapping[str, str]) -> _Changes:
    keys: dict[Path, str] = {}
    values: dict[Path, str] = {}
    for leaf in named:
        new = _WORD.sub(lambda found: meant.get(found[0], found[0]), str(leaf.written))
        if new != str(leaf.written):
            (keys if leaf.is_key else values)[leaf.path] = new
    return _Changes(keys, values)


# ---------------------------------------------------------------- the document read so


def _at(problem: Problem, document: Document, path: Path) -> Problem:
    """With its place, as the path is read otherwise afterwards."""
    line, column = document.places.get(path, (None, None))
    return replace(problem, line=line, column=column)


def _read_as(document: Document, changes: _Changes) -> Document:
    """The document with other keys and values; places follow. A key that its mapping has already stays."""
    keys = {path: key for path, key in changes.keys.items() if _free(path, key, document)}
    changes = _Changes(keys, changes.values)
    return Document(
        _changed(document.data, (), changes),
        {_new(path, changes): place for path, place in document.places.items()},
        {_new(path, changes): changes.values.get(path, text) for path, text in document.raw.items()},
        {_new(path, changes): text for path, text in document.commas.items()},
    )


def _free(path: Path, key: str, document: Document) -> bool:
    return (*path[:-1], key) not in document.places


def _new(path: Path, changes: _Changes) -> Path:
    return tuple(changes.keys.get(path[: n + 1], part) for n, part in enumerate(path))


def _changed(value: Any, path: Path, changes: _Changes) -> Any:
    if isinstance(value, dict):
        return {
            changes.keys.get((*path, key), key): _changed(item, (*path, key), changes)
            for key, item in value.items()
        }
    if isinstance(value, list):
        return [_changed(item, (*path, index), changes) for index, item in enumerate(value)]
    return changes.values.get(path, value)

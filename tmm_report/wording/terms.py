"""A department's own words: each in place of the word that the glossary of the language has for its term.

    rewording = Rewording("kk", (("slider", "тиек"),))
    rewording("сырғыманың жылдамдығы")      # "тиектің жылдамдығы"

A glossary (`templates/locale/<code>/glossary.yaml`) has each term's word in the dictionary's form, with "|" before an
ending that is inflected. What stands behind the word in a text, its ending, goes to the own word: in Kazakh by harmony
(`kazakh`), in other languages as it is, so that the own word should be declined alike; else each form is stated.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import cache, lru_cache
from typing import NamedTuple

from tmm_report import yamlread
from tmm_report.languages import DEFAULT, language
from tmm_report.resources import data_root
from tmm_report.wording import kazakh

VALUES = re.compile(r"(%\(\w+\)[^a-zA-Z%]*[a-zA-Z])")
Swap = tuple[re.Pattern[str], Callable[[re.Match[str]], str]]
POSSESSIVE = ("ы", "і", "сы", "сі")
Own = str | tuple[tuple[str, str], ...]
"""A word, or forms of the note's word, each with the own one."""


class Rewording(NamedTuple):
    """`words`: the terms, by their English, with the department's own words. Hashable, as a Translator is."""

    language: str
    words: tuple[tuple[str, Own], ...]

    def __call__(self, text: str) -> str:
        """A text of a note with the own words; names of its values stay."""
        return _reworded(self, text)


@cache
def usual(code: str) -> Mapping[str, str]:
    """Term -> its usual word in a language, with "|" before an ending that is inflected."""
    own = language(code)
    path = data_root() / "templates" / "locale" / (DEFAULT if own.ids else code) / "glossary.yaml"
    found = yamlread.loads(path.read_bytes(), path.name).data
    if own.ids:
        return {term: f"{term}|" for term in found}
    return {term: said if isinstance(said, str) else said[0] for term, said in found.items()}


def plain(word: str) -> str:
    """The dictionary's form."""
    return word.replace("|", "")


@lru_cache(maxsize=20_000)
def _reworded(rewording: Rewording, text: str) -> str:
    swaps = _swaps(rewording)
    pieces = VALUES.split(text)
    for pattern, swap in swaps:
        pieces[::2] = [pattern.sub(swap, piece) for piece in pieces[::2]]
    return "".join(pieces)


@cache
def _swaps(rewording: Rewording) -> list[Swap]:
    """The longer terms first: "slide block" before "block"."""
    found: list[Swap] = []
    for term, own in sorted(rewording.words, key=lambda one: -len(one[0])):
        if not isinstance(own, str):
            found.append(_stated(dict(own)))
        elif word := usual(rewording.language).get(term):
            found.append(_inflected(word, own, rewording.language))
    return found


def _stated(forms: Mapping[str, str]) -> Swap:
    """Each form as it is stated."""
    own = {form.lower(): said for form, said in forms.items()}
    pattern = "|".join(map(re.escape, sorted(own, key=len, reverse=True)))
    whole = re.compile(rf"(?<!\w)(?:{pattern})(?!\w)", re.I)
    return whole, lambda match: _as_large(match[0], own[match[0].lower()])


def _inflected(word: str, own: str, language: str) -> Swap:
    """A word of one or several parts, each with any ending. As many own parts take the ending of each, of another
    number the last takes that of the last."""
    noun = _Kazakh if language == "kk" else _Noun
    parts, owned = [noun(*_parted(part)) for part in word.split()], own.split()
    pairs = [*zip(range(len(parts)), range(len(owned)), strict=False)][: len(owned)]
    if len(parts) != len(owned):
        pairs = [(len(parts) - 1, len(owned) - 1)]

    def swapped(match: re.Match[str]) -> str:
        said = [plain(part) for part in owned]
        for k, at in pairs:
            said[at] = parts[k].other(match[k + 1], owned[at])
        return _as_large(match[0], " ".join(said))

    pattern = r"\s+".join(f"({part.pattern})" for part in parts)
    return re.compile(rf"(?<!\w){pattern}(?!\w)", re.I), swapped


def _parted(word: str) -> tuple[str, str, bool]:
    """Stem, ending, whether it is inflected."""
    stem, bar, ending = word.partition("|")
    return stem, ending, bool(bar)


class _Noun(NamedTuple):
    """A part of a term's word, in the dictionary's form stem and ending."""

    stem: str
    ending: str
    inflected: bool

    @property
    def pattern(self) -> str:
        return re.escape(self.stem) + r"\w*" if self.inflected else re.escape(self.stem + self.ending)

    def other(self, found: str, own: str) -> str:
        """The own word as that of the note is found in a text; a bar in it stands before its own ending."""
        if found.lower() == (self.stem + self.ending).lower():
            return plain(own)
        stem, _, _ = _parted(own)
        if "|" not in own and self.ending and own.endswith(self.ending):
            stem = own.removesuffix(self.ending)
        return stem + found[len(self.stem) :]


class _Kazakh(_Noun):
    """One whose last sound may be softened, and whose dictionary's form may be of its third person."""

    @property
    def base(self) -> str:
        return self.stem if self.ending in POSSESSIVE else self.stem + self.ending

    @property
    def pattern(self) -> str:
        last = self.base[-1:]
        soft = f"[{last}{kazakh.SOFTENED[last]}]" if last in kazakh.SOFTENED else re.escape(last)
        return re.escape(self.base[:-1]) + soft + (r"\w*" if self.inflected else "")

    def other(self, found: str, own: str) -> str:
        own = plain(own)
        if found.lower() == (self.stem + self.ending).lower():
            return own
        if self.ending in POSSESSIVE:
            own = re.sub(r"(?<=[аәеоөуүю])с[ыі]$|[ыі]$", "", own)
        base = self.base[:-1] + found[len(self.base) - 1]
        softened = base[-1].lower() != self.base[-1].lower()
        return kazakh.other(self.base, (base[-1] if softened else "") + found[len(base) :], own)


def _as_large(found: str, own: str) -> str:
    """With the first letter large, or all of them, where the note's word has it so."""
    if found.isupper() and len(found) > 1:
        return own.upper()
    return own[:1].upper() + own[1:] if found[:1].isupper() else own

"""Which quantity a name means that a person wrote: v_B, vB, ω2, w_2, R₁₂, M_ур.

    resolve("ω2", quantities)      # [the angular velocity w_2]
    one("ω2", quantities)          # the same alone; raises ProblemError where it is none or more than one

Letters that look alike in Latin, Greek and Cyrillic are one letter; Greek letters go by their names, too; underscores
and braces do not count. Case decides only where there is a choice: v_B and V_B are two quantities.
"""

from __future__ import annotations

import difflib
import re
import unicodedata
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache, lru_cache

from tmm_report.i18n import Translator
from tmm_report.languages import LANGUAGES
from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import GREEK, INDEX_WORDS, Symbol

Quantities = Iterable[Quantity] | Mapping[str, Quantity]
"""What a name may mean; by their keys where many names are asked for."""

LONGEST = 60  # characters: a longer text is no name of a quantity
NEAREST = 6  # names that a message offers

_LOOKS = str.maketrans(
    "АВЕКМНОРСТХУаекмортсхуіјѕΑΒΕΗΙΚΜΝΟΡΤΥΧΖονϕϵϑ",
    "ABEKMHOPCTXYaekmoptcxyijsABEHIKMNOPTYXZovφεθ",
)
_SIGNS = {"∆": "Δ", "∑": "Σ", "′": "'", "’": "'", "ʹ": "'", "−": "-", "–": "-", "τ": "t"}
_LETTERS = str.maketrans(_SIGNS | {letter: name for name, letter in GREEK.items() if letter not in "το"})
_IGNORED = str.maketrans("", "", "_^{}\\,; \t\N{NO-BREAK SPACE}")


def resolve(text: str, quantities: Quantities) -> list[Quantity]:
    """The quantities that a text names, each key once; none where it names nothing, several where it may mean several.

    The first of these that finds any decides: the key itself; the key written loosely; the symbol; the key and then
    the symbol in whatever case.
    """
    known = _by_key(quantities)
    name = text.strip()
    if len(name) > LONGEST:
        return []
    if name in known:
        return [known[name]]
    loose = fold(name)
    small = loose.lower()
    every = [(quantity, *_spelled(quantity.key, quantity.symbol)) for quantity in known.values()]
    levels = (
        [quantity for quantity, keys, _, _, _ in every if loose in keys],
        [quantity for quantity, _, symbols, _, _ in every if loose in symbols],
        [quantity for quantity, _, _, keys, _ in every if small in keys],
        [quantity for quantity, _, _, _, symbols in every if small in symbols],
    )
    return next((found for found in levels if found), []) if loose else []


def one(text: str, quantities: Quantities, path: tuple[str | int, ...] = ()) -> Quantity:
    """The quantity that a text names. Raises ProblemError with the nearest names where it is none or not one."""
    known = _by_key(quantities)
    found = resolve(text, known)
    if len(found) == 1:
        return found[0]
    raise ProblemError([ambiguous(text, found, path) if found else unknown(text, known, path)])


def unknown(text: str, quantities: Quantities, path: tuple[str | int, ...] = ()) -> Problem:
    """No quantity is called so: the nearest ones, and where the list of all is."""
    wrong = Message(N_("no quantity is called %(name)s"), {"name": shown(text)})
    near = nearest(text, quantities)
    names = {"names": ", ".join(map(shown, near))}
    right = Message(N_("the nearest: %(names)s; %(list)s"), {**names, "list": LIST}) if near else LIST
    return Problem(wrong, right, path)


def ambiguous(text: str, found: Sequence[Quantity], path: tuple[str | int, ...] = ()) -> Problem:
    """Several quantities may be meant."""
    wrong = Message(N_("%(name)s may mean several quantities"), {"name": shown(text)})
    names = ", ".join(shown(quantity.key) for quantity in found[:NEAREST])
    return Problem(wrong, Message(N_("write one of %(names)s"), {"names": names}), path)


LIST = Message(
    N_('every quantity stands with its key ("key") in results.json: tmm-report solve --format json')
)


def nearest(text: str, quantities: Quantities) -> list[str]:
    """Keys that a text is most like, the likest first."""
    known, spelled = _by_key(quantities), dict[str, list[str]]()
    for part in (0, 1):  # what is like a key goes before what is like a symbol
        for key, quantity in known.items():
            for name in sorted(_spelled(key, quantity.symbol)[part]):
                spelled.setdefault(name, []).append(key)
    near = difflib.get_close_matches(fold(text[:LONGEST]), spelled, 2 * NEAREST, 0.5)
    return list(dict.fromkeys(key for name in near for key in spelled[name]))[:NEAREST]


@lru_cache(maxsize=4096)
def fold(text: str) -> str:
    """A name without what does not tell names apart: ω₂, omega_2 and omega2 are one."""
    plain = unicodedata.normalize("NFKC", text.translate({ord("′"): "'"})).translate(_LOOKS)
    return unicodedata.normalize("NFC", plain.translate(_LETTERS).translate(_IGNORED))


def _by_key(quantities: Quantities) -> Mapping[str, Quantity]:
    """Each key once: the same quantity stands in several tables."""
    if isinstance(quantities, Mapping):
        return quantities
    known: dict[str, Quantity] = {}
    for quantity in quantities:
        known.setdefault(quantity.key, quantity)
    return known


_Names = frozenset[str]


@lru_cache(maxsize=4096)
def _spelled(key: str, symbol: Symbol | None) -> tuple[_Names, _Names, _Names, _Names]:
    """All that key and symbol are written as, folded; then both again in small letters."""
    keys = frozenset(map(fold, _in_words(key)))
    symbols = frozenset(map(fold, _in_words(str(symbol)))) if symbol is not None else frozenset()
    return keys, symbols, frozenset(map(str.lower, keys)), frozenset(map(str.lower, symbols))


def _in_words(name: str) -> Iterator[str]:
    """The name, and with its index words in every language: M_bal, M_ур."""
    yield name
    for words in _words():
        yield "".join(words.get(part, part) for part in _PARTS.split(name))


_PARTS = re.compile(r"([a-z]+)")


@cache
def _words() -> list[dict[str, str]]:
    """The index words in each language that has its own."""
    codes = [code for code, language in LANGUAGES.items() if not language.ids]
    return [
        {word: Translator(code).pgettext("index", word) for word in (*INDEX_WORDS, *OTHERS)} for code in codes
    ]


OTHERS = ("in", "red")  # index words that one chapter alone has

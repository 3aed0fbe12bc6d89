"""The small closed grammar of masses and moments of inertia: `30 kg/m`, `0.3*m2`, `m*l^2/12`, `0,17 m l_AB²`.

Numbers, lengths and masses with their units (`m*(90 mm)^2/2`), `m` and `l` of the link itself, `m2` (or m_2) of another
link, `l2` of its length, `l_AB` of a segment, `synthesis.crank` of what the synthesis finds; sums, products, quotients,
whole powers, brackets, a minus before the first; a product's sign may be left out. Nothing else is read, nothing is
run.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tmm_report.mechanics.lever.stated_masses import (
    Combined,
    LengthOf,
    MassOf,
    Negative,
    Number,
    PerLength,
    Power,
    Statement,
    Synthesised,
    dimension,
    letters,
)
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity.units import WrongValue

LONGEST = 60
_CYRILLIC = re.compile("[\u0400-\u052f]")
MOST = 6  # exponent
_NAME = r"[0-9A-Za-z\u0400-\u0481\u048a-\u052f'’]"
_TOKEN = re.compile(
    rf"""\s*(?:
    synthesis\.(?P<found>[a-z_]+)
    |(?P<per>[0-9]+(?:[.,][0-9]+)?\s*(?:kg|кг|g|г|t|т)\s*/\s*(?:mm|мм|cm|см|m|м)(?!{_NAME}|[_^]))
    |(?P<measured>[0-9]+(?:[.,][0-9]+)?\s*(?:mm|мм|cm|см|in)(?!{_NAME}|_)
        |\(\s*[0-9]+(?:[.,][0-9]+)?\s*[mм]\s*\)(?=\s*\^))
    |(?P<heavy>[0-9]+(?:[.,][0-9]+)?\s*(?:kg|кг)(?!{_NAME}|_))
    |(?P<number>[0-9]+(?:[.,][0-9]+)?(?:[eE][-+]?[0-9]+)?)
    |(?P<own>ml(?!{_NAME}|_))
    |(?P<letter>[mlмl](?:_?{_NAME}+)?)
    |(?P<sign>[-+*/^()])
    )""",
    re.VERBOSE,
)
_MEANT = re.compile("l|[mм](_|[0-9])")
_PLAIN = str.maketrans(
    {
        **dict(zip("−·⋅∙•×₀₁₂₃₄₅₆₇₈₉", "-*****0123456789", strict=True)),
        "²": "^2",
        "³": "^3",
        "\N{NO-BREAK SPACE}": " ",
    }
)
_UNIT = re.compile("(kg|кг|g|г|t|т)[ ]*/[ ]*(mm|мм|cm|см|m|м)")
_SIZES = {"kg": 1.0, "кг": 1.0, "g": 1e-3, "г": 1e-3, "t": 1e3, "т": 1e3}
_METRES = {"m": 1.0, "м": 1.0, "cm": 1e-2, "см": 1e-2, "mm": 1e-3, "мм": 1e-3, "in": 0.0254}
MASS, INERTIA, LENGTH = (1, 0), (1, 2), (0, 1)


class Unread(ValueError):
    """A text that is not of this grammar."""


def looks_closed(text: str) -> bool:
    """Whether a text is meant to be of this grammar: all of it is known, and a letter of it is none of a unit, as the
    m of 5 m and the мм of 1 400 мм are."""
    try:
        tokens = _tokens(text)
    except Unread:
        return False
    kinds = {kind for kind, _ in tokens}
    if {"measured", "letter"} <= kinds:
        return True
    return any(
        kind in ("per", "own", "found") or (kind == "letter" and _MEANT.match(letter))
        for kind, letter in tokens
    )


def mass(text: str) -> Statement:
    """The mass of a link; of kilograms a metre alone, times the link's length. Raises WrongValue."""
    found = _read(text)
    of = list(letters(found))
    if dimension(found) == (1, -1):
        found = Combined("*", found, LengthOf())
    if sum(isinstance(letter, PerLength) for letter in of) > 1:
        wrong = Message(N_("%(text)s has two masses of a metre"), {"text": shown(text)})
        raise WrongValue(wrong, Message(N_("one of them, such as 30 kg/m * (l_AB + l_BC)")))
    if MassOf() in of:
        wrong = Message(N_("%(text)s: the mass of a link is stated by itself"), {"text": shown(text)})
        raise WrongValue(
            wrong, Message(N_("a mass, 30 kg/m of its length, or the mass of another link: 0.3*m2"))
        )
    return _measuring(found, MASS, text)


def inertia(text: str) -> Statement:
    """The moment of inertia of a link. Raises WrongValue."""
    found = _read(text)
    if any(isinstance(letter, PerLength) for letter in letters(found)):
        wrong = Message(N_("%(text)s: the mass of a metre belongs to the mass"), {"text": shown(text)})
        raise WrongValue(
            wrong, Message(N_("a mass times a length squared, such as m*l^2/12 or 0.17*m*l_AB^2"))
        )
    return _measuring(found, INERTIA, text)


def length(text: str) -> Statement:
    """A length that follows from others. Raises WrongValue."""
    found = _read(text)
    if all(isinstance(letter, LengthOf | Synthesised) for letter in letters(found)):
        return _measuring(found, LENGTH, text)
    wrong = Message(N_("%(text)s: a length follows from lengths alone"), {"text": shown(text)})
    raise WrongValue(wrong, Message(N_("a number of other lengths, such as 0.4*l_AB")))


def _measuring(found: Statement, wanted: tuple[int, int], text: str) -> Statement:
    if dimension(found) == wanted:
        return found
    wrong = N_("%(text)s is no mass: its letters multiply to something else")
    right = N_("a mass, 30 kg/m of its length, or the mass of another link: 0.3*m2")
    if wanted == INERTIA:
        wrong = N_("%(text)s is no moment of inertia: its letters multiply to something else")
        right = N_("a mass times a length squared, such as m*l^2/12 or 0.17*m*l_AB^2")
    elif wanted == LENGTH:
        wrong = N_("%(text)s is no length: its letters multiply to something else")
        right = N_("a number of other lengths, such as 0.4*l_AB")
    raise WrongValue(Message(wrong, {"text": shown(text)}), Message(right))


def _read(text: str) -> Statement:
    try:
        return _Reader(_tokens(text)).whole()
    except Unread:
        wrong = Message(N_("%(text)s cannot be worked out"), {"text": shown(text)})
        right = Message(N_("numbers, m, l, m2, l_AB with + - * / ^ and brackets, such as m*l^2/12"))
        raise WrongValue(wrong, right) from None


def _tokens(text: str) -> list[tuple[str, str]]:
    plain = text.translate(_PLAIN).replace("**", "^").strip()
    if len(plain) > LONGEST:
        raise Unread
    found, at = list[tuple[str, str]](), 0
    while at < len(plain):
        match = _TOKEN.match(plain, at)
        if match is None or match.lastgroup is None:
            raise Unread
        found.append((match.lastgroup, match[match.lastgroup]))
        at = match.end()
    return found


class _Reader:
    """Descends from sums to atoms; every step takes a token, so that its depth is that of the brackets."""

    def __init__(self, tokens: list[tuple[str, str]]):
        self.tokens, self.at = tokens, 0

    def whole(self) -> Statement:
        found = self.sum()
        if self.at < len(self.tokens):
            raise Unread
        return found

    def next(self, signs: str) -> str:
        """The sign that comes, if it is one of these, and is taken."""
        if self.at < len(self.tokens):
            kind, text = self.tokens[self.at]
            if kind == "sign" and text in signs:
                self.at += 1
                return text
        return ""

    def sum(self) -> Statement:
        found: Statement
        found = Negative(self.product()) if self.next("-") else self.product()
        while sign := self.next("+-"):
            found = Combined(sign, found, self.product())
        return found

    def product(self) -> Statement:
        found = self.power()
        while True:
            if sign := self.next("*/"):
                found = Combined(sign, found, self.power())
            elif self.at < len(self.tokens) and (
                self.tokens[self.at][0] in ("letter", "own", "per", "found", "measured")
                or self.tokens[self.at][1] == "("
            ):
                found = Combined("*", found, self.power())  # m l², with its sign left out
            else:
                return found

    def power(self) -> Statement:
        base = self.atom()
        if not self.next("^"):
            return base
        kind, text = self.take()
        if kind != "number" or not text.isdigit() or not 1 <= int(text) <= MOST:
            raise Unread
        return Power(base, int(text))

    def take(self) -> tuple[str, str]:
        if self.at >= len(self.tokens):
            raise Unread
        self.at += 1
        return self.tokens[self.at - 1]

    def atom(self) -> Statement:
        kind, text = self.take()
        if kind == "number":
            return Number(_number(text))
        if kind in ("measured", "heavy"):
            return _measured(text)
        if kind == "per":
            return _per_length(text)
        if kind == "found":
            return Synthesised(text)
        if kind == "own":
            # ml², as it is printed: the square is that of the length alone
            self.at -= 1
            self.tokens[self.at : self.at + 1] = [("letter", "m"), ("letter", "l")]
            return self.atom()
        if kind == "letter":
            name = text[1:].lstrip("_")
            return MassOf(name) if text[0] in "mм" else LengthOf(name)
        if text == "(":
            inner = self.sum()
            if self.next(")"):
                return inner
        raise Unread


def _number(text: str) -> float:
    return float(text.replace(",", "."))


def _measured(text: str) -> Number:
    """A length or a mass with its unit."""
    match = re.fullmatch(r"\(?\s*([0-9.,]+)\s*(\w+)\s*\)?", text)
    assert match is not None
    if match[2] in _METRES:
        return Number(_number(match[1]) * _METRES[match[2]], LENGTH)
    return Number(_number(match[1]) * _SIZES[match[2]], MASS)


def in_other_units(text: str) -> Iterator[tuple[str, float]]:
    """A text with its mass of a metre in another usual unit, and by how many times that is the one stated."""
    stated = _UNIT.search(text)
    if stated is None:
        return
    own = _SIZES[stated[1]] / _METRES[stated[2]]
    for unit in ("кг/м", "г/м") if _CYRILLIC.search(stated[0]) else ("kg/m", "g/m"):
        mass, length = unit.split("/")
        if (size := _SIZES[mass] / _METRES[length]) != own:
            yield text[: stated.start()] + unit + text[stated.end() :], size / own


def _per_length(text: str) -> PerLength:
    match = re.fullmatch(r"([0-9.,]+)\s*(\w+?)\s*/\s*(\w+)", text)
    assert match is not None
    return PerLength(_number(match[1]) * _SIZES[match[2]] / _METRES[match[3]])

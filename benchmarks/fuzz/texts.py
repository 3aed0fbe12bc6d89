"""Mutations of the text of a variant: lines, indentation, letters, numbers, units, pieces of other files."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from random import Random

from benchmarks.fuzz.words import ALIKE, HOSTILE, MARKS, NUMBERS, UNITS

NUMBER = re.compile(r"(?<![\w.])-?\d+(?:[.,]\d+)?(?:e-?\d+)?")
WORD = re.compile(r"[^\W\d_][\w']*")
UNIT = re.compile(r"(?<=\d )(?:[^\W\d_]|°|[*^/·]|(?<=\^)\d)+")
LONGEST = 260_000  # characters: a little more than a file may have bytes

Mutation = Callable[[str, Random, Sequence[str]], str]


def _at(found: Sequence[re.Match[str]], text: str, random: Random, new: Callable[[str], str]) -> str:
    """One of what was found, put otherwise."""
    if not found:
        return text
    one = random.choice(found)
    return text[: one.start()] + new(one.group()) + text[one.end() :]


def number(text: str, random: Random, others: Sequence[str]) -> str:
    """Another number, the number with another sign or of another order."""

    def new(old: str) -> str:
        kind = random.randrange(4)
        if kind == 0:
            return random.choice(NUMBERS)
        if kind == 1:
            return f"{old}e{random.choice((-9, -6, -3, -2, -1, 1, 2, 3, 6, 9, 12))}"
        if kind == 2:
            return old[1:] if old.startswith("-") else f"-{old}"
        return f"{float(old.replace(',', '.')) * random.uniform(0.3, 3):.6g}" if "e" not in old else "1"

    return _at(list(NUMBER.finditer(text)), text, random, new)


def unit(text: str, random: Random, others: Sequence[str]) -> str:
    return _at(list(UNIT.finditer(text)), text, random, lambda _: random.choice(UNITS))


def without_unit(text: str, random: Random, others: Sequence[str]) -> str:
    return _at(list(UNIT.finditer(text)), text, random, lambda _: "")


def word(text: str, random: Random, others: Sequence[str]) -> str:
    """A word of this file or of another, or a hostile one, in the place of a word."""
    known = WORD.findall(text if random.random() < 0.5 else random.choice(others)) or ["x"]

    def new(old: str) -> str:
        if random.random() < 0.3:
            hostile = random.choice(HOSTILE)
            return hostile if random.random() < 0.5 else "'" + hostile.replace("'", "''") + "'"
        return random.choice(known)

    return _at(list(WORD.finditer(text)), text, random, new)


def misspelt(text: str, random: Random, others: Sequence[str]) -> str:
    """A letter of a word lost, doubled or exchanged with the next."""

    def new(old: str) -> str:
        k = random.randrange(len(old))
        return random.choice(
            (
                old[:k] + old[k + 1 :],
                old[: k + 1] + old[k:],
                old[:k] + old[k + 1 : k + 2] + old[k] + old[k + 2 :],
            )
        )

    return _at(list(WORD.finditer(text)), text, random, new)


def alike(text: str, random: Random, others: Sequence[str]) -> str:
    """A letter, everywhere or once, replaced by one that looks like it."""
    places = [k for k, letter in enumerate(text) if letter in ALIKE]
    if not places:
        return text
    k = random.choice(places)
    if random.random() < 0.2:
        return text.replace(text[k], ALIKE[text[k]])
    return text[:k] + ALIKE[text[k]] + text[k + 1 :]


def mark(text: str, random: Random, others: Sequence[str]) -> str:
    """A mark put in, taken out or exchanged."""
    k, kind = random.randrange(len(text) + 1), random.randrange(3)
    if kind == 0:
        return text[:k] + random.choice(MARKS) + text[k:]
    marks = [j for j, letter in enumerate(text) if letter in MARKS and letter != " "]
    if not marks:
        return text
    k = random.choice(marks)
    return text[:k] + (random.choice(MARKS) if kind == 1 else "") + text[k + 1 :]


def decimal_comma(text: str, random: Random, others: Sequence[str]) -> str:
    return _at(list(re.finditer(r"\d\.\d", text)), text, random, lambda old: old.replace(".", ","))


def indentation(text: str, random: Random, others: Sequence[str]) -> str:
    """A line, or all from it on, moved by some blanks or by a tab."""
    lines = text.split("\n")
    k = random.randrange(len(lines))
    last = k + 1 if random.random() < 0.7 else min(len(lines), k + random.randrange(1, 9))
    blanks = random.choice((-4, -2, -1, 1, 2, 4))
    for j in range(k, last):
        lines[j] = lines[j][-blanks:] if blanks < 0 else random.choice((" ", " ", "\t")) * blanks + lines[j]
    return "\n".join(lines)


def lines(text: str, random: Random, others: Sequence[str]) -> str:
    """A line dropped, doubled, exchanged with another, joined to the next, cut off."""
    parts = text.split("\n")
    k, j, kind = random.randrange(len(parts)), random.randrange(len(parts)), random.randrange(6)
    if kind == 0:
        del parts[k]
    elif kind == 1:
        parts.insert(j, parts[k])
    elif kind == 2:
        parts[k], parts[j] = parts[j], parts[k]
    elif kind == 3 and k + 1 < len(parts):
        parts[k : k + 2] = [parts[k] + random.choice(("", " ", ", ")) + parts[k + 1].strip()]
    elif kind == 4:
        parts[k] = parts[k][: random.randrange(len(parts[k]) + 1)]
    else:
        del parts[k : k + random.randrange(1, 6)]
    return "\n".join(parts)


def truncated(text: str, random: Random, others: Sequence[str]) -> str:
    return text[: random.randrange(len(text) + 1)]


def spliced(text: str, random: Random, others: Sequence[str]) -> str:
    """A piece of another file put between the lines."""
    parts, other = text.split("\n"), random.choice(others).split("\n")
    start, k = random.randrange(len(other)), random.randrange(len(parts) + 1)
    parts[k:k] = other[start : start + random.randrange(1, 20)]
    return "\n".join(parts)


def block_of_another(text: str, random: Random, others: Sequence[str]) -> str:
    """A whole block of another file added, or in the place of the one of its name."""
    blocks = re.split(r"(?m)^(?=\w)", random.choice(others))
    block = random.choice(blocks)
    own = re.split(r"(?m)^(?=\w)", text)
    key = block.split(":")[0]
    if random.random() < 0.7:
        own = [part for part in own if part.split(":")[0] != key]
    return "".join([*own, "\n", block])


def repeated(text: str, random: Random, others: Sequence[str]) -> str:
    """Some lines many times."""
    parts = text.split("\n")
    k = random.randrange(len(parts))
    piece = parts[k : k + random.randrange(1, 4)]
    return "\n".join([*parts[:k], *piece * random.choice((2, 30, 400)), *parts[k:]])


def encoding(text: str, random: Random, others: Sequence[str]) -> str:
    """Line ends of other systems, a mark of byte order, blanks at the ends of lines."""
    return random.choice(
        (
            text.replace("\n", "\r\n"),
            "\ufeff" + text,
            text.replace("\n", "  \n"),
            text.replace("\n", "\r"),
            text + "\n---\n",
        )
    )


MUTATIONS: tuple[Mutation, ...] = (
    number, number, number, unit, without_unit, word, word, misspelt, alike, mark, decimal_comma, indentation, lines,
    truncated, spliced, block_of_another, block_of_another, repeated, encoding,
)  # fmt: skip


def mutated(text: str, random: Random, others: Sequence[str]) -> tuple[str, str]:
    """One to three mutations on one another, and their names."""
    chosen = [random.choice(MUTATIONS) for _ in range(random.choice((1, 1, 1, 2, 3)))]
    for mutation in chosen:
        text = mutation(text, random, others)[:LONGEST]
    return text, " ".join(mutation.__name__ for mutation in chosen)

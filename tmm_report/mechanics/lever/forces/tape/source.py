"""The lines of a tape as functions of plain numpy, one a stage: motion, points, forces ...

Lengths are parameters `p`, so mechanisms of one topology have one text, which is compiled once. Only numbers made here
name anything in it: no name of a variant does. What a stage hands on stands in a list `v`, by places.

    def motion(v, x0):
        x1 = np.exp(1j * x0) * p0
        ...
        v[0:2] = x1, x7
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from types import CodeType
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.forces.tape.tape import Line, Mark
from tmm_report.records import dataclass

LONGEST = 80  # letters of an expression that is written into another one
ARITHMETIC = {"+", "-", "*", "/", "np.divide"}


@dataclass(frozen=True, eq=False)
class Stage:
    """A part of the tape: what it is given when it is run, its lines in order, and the lines wanted of it."""

    name: str
    given: Sequence[Line]
    lines: Sequence[Line]
    results: Sequence[Line]


@dataclass(frozen=True, eq=False)
class Written:
    """The text of all functions and its parameters; where in `v` a line's result stands, and how many there are."""

    text: str
    numbers: list[Any]
    places: dict[Line, int]
    stages: tuple[str, ...]

    def functions(self) -> dict[str, Callable[..., None]]:
        """The functions by the names of their stages."""
        room: dict[str, Any] = {"np": np, "p": self.numbers}
        exec(
            _code(self.text), room
        )  # its names are x0, p0, v and numpy's own: see `_Names` and `_expression`
        return {name: room[name] for name in self.stages}


def written(stages: Sequence[Stage]) -> Written:
    """The functions of all stages of a tape."""
    wanted = _wanted([line for stage in stages for line in stage.results])
    of = {line: stage.name for stage in stages for line in (*stage.given, *stage.lines)}
    handed = {line for stage in stages for line in stage.results}
    handed |= {x for line in wanted for x in _operands(line) if of[x] != of[line]}
    ordered = [line for stage in stages for line in (*stage.given, *stage.lines) if line in handed]
    places = {line: n for n, line in enumerate(ordered)}
    names = _Names()
    body = [text for stage in stages for text in _function(stage, wanted, places, names)]
    head = [f"({', '.join(f'p{n}' for n in range(len(names.numbers)))},) = p"] if names.numbers else []
    return Written("\n".join([*head, *body, ""]), names.numbers, places, tuple(x.name for x in stages))


@lru_cache(maxsize=64)
def _code(text: str) -> CodeType:
    return compile(text, "<straight lines>", "exec")


class _Names:
    """Names of lines, and of the numbers among their operands."""

    def __init__(self) -> None:
        self.lines: dict[Line, str] = {}
        self.numbers: list[Any] = []
        self._of: dict[Any, str] = {}

    def line(self, line: Line) -> str:
        return self.lines.setdefault(line, f"x{len(self.lines)}")

    def number(self, x: Any, kind: type | None) -> str:
        """A plain number beside an array of this kind: as an array without axes, which numpy takes at half the cost.
        It would make the same of it, a complex number of a real one beside vectors."""
        if kind is not None and not isinstance(x, np.ndarray):
            x = np.array(x, dtype=complex if isinstance(x, complex) else kind)
        elif type(x) is int:
            return repr(x)
        key = id(x) if np.ndim(x) else (type(x), np.asarray(x).dtype, np.asarray(x).tobytes())
        if key not in self._of:
            self._of[key] = f"p{len(self.numbers)}"
            self.numbers.append(x)
        return self._of[key]


def _operands(line: Line) -> Iterator[Line]:
    return (x for x in line.args if isinstance(x, Line))


def _wanted(results: Sequence[Line]) -> set[Line]:
    """All lines on which the results rest."""
    found: set[Line] = set()
    open_ = list(results)
    while open_:
        line = open_.pop()
        if line not in found:
            found.add(line)
            open_ += _operands(line)
    return found


def _from_before(stage: Stage, wanted: set[Line]) -> list[Line]:
    """Lines of stages before this one that its lines take, in the order in which they are taken."""
    within = {*stage.given, *stage.lines}
    taken = (x for line in stage.lines if line in wanted for x in _operands(line))
    return list(dict.fromkeys(x for x in taken if x not in within))


def _function(stage: Stage, wanted: set[Line], places: dict[Line, int], names: _Names) -> Iterator[str]:
    """The text of a stage, by lines. An operand that is used once is written where it is used: numpy then keeps its
    memory for the result."""
    own = [line for line in stage.lines if line in wanted]
    uses = Counter(x for line in own for x in _operands(line))
    before = _from_before(stage, wanted)
    yield f"def {stage.name}({', '.join(['v', *map(names.line, stage.given)])}):"
    if before:
        yield f"    ({', '.join(map(names.line, before))},) = ({', '.join(f'v[{places[x]}]' for x in before)},)"
    texts: dict[Line, str] = {}
    named: dict[Line, set[Line]] = {}  # of a text not written yet, the names in it
    left = Counter(uses)
    for line in own:
        text = _expression(line, texts, names)
        inside = set().union(*(named.pop(x, {x}) for x in _operands(line)))
        left.subtract(_operands(line))
        if uses[line] == 1 and line not in places and len(text) <= LONGEST:
            texts[line] = text if line.op.startswith((".", "np.")) else f"({text})"
            named[line] = inside
            continue
        yield f"    {names.line(line)} = {text}"
        waiting = set().union(*named.values())
        done = sorted(names.line(x) for x in inside - waiting if not left[x] and x not in places)
        if done:
            yield f"    del {', '.join(done)}"
    handed = [line for line in (*stage.given, *own) if line in places]
    if handed:
        first = places[handed[0]]
        yield f"    v[{first}:{first + len(handed)}] = {', '.join(map(names.line, handed))},"
    else:  # plain numbers all
        yield "    pass"


def _expression(line: Line, texts: dict[Line, str], names: _Names) -> str:
    kind = None
    if line.op in ARITHMETIC:
        kind = next((complex if x.vector else float for x in _operands(line) if x.vector or x.real), None)
    args = [
        texts.get(x) or names.line(x) if isinstance(x, Line) else names.number(x, kind) for x in line.args
    ]
    if line.op == "neg":
        return f"-{args[0]}"
    if line.op.startswith("."):
        return args[0] + line.op
    if line.op.startswith("np."):
        return f"{line.op}({', '.join(args)})"
    return f" {line.op} ".join(args)


def line_of(x: Any) -> Line | None:
    """The line of a mark; None for what is a plain number already."""
    return x.line if isinstance(x, Mark) else None

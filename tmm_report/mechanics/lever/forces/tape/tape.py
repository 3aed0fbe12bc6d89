"""Arithmetic written down while it is done: the general solver, given marks for arrays, leaves a list of operations.

What is made of plain numbers alone is reckoned at once, as the general solver reckons it; what a mark takes part in
becomes a line of the tape. An operation that is there already is not written again, so equal lines are reckoned once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

REAL = {".real", ".imag", "np.absolute", "np.maximum", "np.mod", "np.searchsorted"}


class Untraceable(Exception):
    """What is solved depends on the values themselves, so it is no straight line."""


class Line:
    """One operation of a tape: `op` and what it takes, lines and plain numbers. `real`: surely of real numbers;
    `vector`: surely of complex ones."""

    __slots__ = ("args", "op", "real", "vector")

    def __init__(self, op: str, args: tuple[Any, ...]):
        self.op, self.args = op, args
        reals, vectors = [_is_real(x) for x in args], [_is_vector(x) for x in args]
        self.real = op in REAL or (op != "given" and bool(args) and all(reals))
        self.vector = op not in REAL and any(vectors)


def _is_real(x: Any) -> bool:
    return x.real if isinstance(x, Line) else not np.iscomplexobj(x)


def _is_vector(x: Any) -> bool:
    return x.vector if isinstance(x, Line) else np.iscomplexobj(x)


class Tape:
    """Lines in the order in which they were first asked for; `known`: what finds an equal line again."""

    def __init__(self) -> None:
        self.lines: list[Line] = []
        self.known: dict[tuple[Any, ...], Line] = {}

    def given(self, real: bool = False) -> Mark:
        """A mark for what is given when the lines are run; `real`: surely no vector."""
        line = Line("given", ())
        line.real = real
        self.lines.append(line)
        return Mark(self, line)

    def put(self, op: str, *args: Any) -> Mark:
        """A mark for the result of an operation on marks and plain numbers."""
        own = tuple(x.line if isinstance(x, Mark) else x for x in args)
        if (same := _same(op, own)) is not None:
            return Mark(self, same)
        key = op, *(id(x) if isinstance(x, Line | np.ndarray) else (type(x), repr(x)) for x in own)
        if key not in self.known:
            self.known[key] = Line(op, own)
            self.lines.append(self.known[key])
        return Mark(self, self.known[key])


def _same(op: str, args: tuple[Any, ...]) -> Line | None:
    """The line that has the result already, to the last bit: −(−x), 1·x of real numbers, x − 0 of a vector."""
    first = args[0]
    if op == "neg" and first.op == "neg":
        return first.args[0]
    if op == "*" and type(first) is int and first == 1 and args[1].real:
        return args[1]
    if op == "-" and isinstance(first, Line) and type(args[1]) in (float, complex) and first.vector:
        return first if repr(args[1]) in ("0.0", "0j") else None
    return None


def _binary(op: str) -> tuple[Callable[[Mark, Any], Mark], Callable[[Mark, Any], Mark]]:
    return (lambda self, other: self.tape.put(op, self, other)), (
        lambda self, other: self.tape.put(op, other, self)
    )


class Mark:
    """Stands for an array that is known only when the lines are run."""

    __slots__ = ("line", "tape")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, tape: Tape, line: Line):
        self.tape, self.line = tape, line

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Mark:
        if method != "__call__" or options:
            raise Untraceable(ufunc.__name__)
        op = _OPERATORS.get(ufunc.__name__, f"np.{ufunc.__name__}")  # a number of numpy's before a mark
        return self.tape.put(op, *inputs)

    def __array_function__(self, function: Any, types: Iterable[type], args: Any, options: Any) -> Mark:
        if function.__name__ not in ("where", "searchsorted") or options:
            raise Untraceable(function.__name__)
        return self.tape.put(f"np.{function.__name__}", *args)

    def __bool__(self) -> bool:
        raise Untraceable("bool")

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        raise Untraceable("array")

    def __float__(self) -> float:
        raise Untraceable("float")

    def __invert__(self) -> Mark:
        raise Untraceable("invert")

    def conjugate(self) -> Mark:
        return self.tape.put(".conjugate()", self)

    @property
    def real(self) -> Mark:
        return self.tape.put(".real", self)

    @property
    def imag(self) -> Mark:
        return self.tape.put(".imag", self)

    def __neg__(self) -> Mark:
        return self.tape.put("neg", self)

    __add__, __radd__ = _binary("+")
    __sub__, __rsub__ = _binary("-")
    __mul__, __rmul__ = _binary("*")
    __truediv__, __rtruediv__ = _binary("/")
    __mod__, __rmod__ = _binary("%")
    __pow__, __rpow__ = _binary("**")
    __and__, __rand__ = _binary("&")
    __lt__, __gt__ = _binary("<")[0], _binary(">")[0]
    __le__, __ge__ = _binary("<=")[0], _binary(">=")[0]
    __eq__ = _binary("==")[0]  # type: ignore[assignment]


_OPERATORS = {"add": "+", "subtract": "-", "multiply": "*"}

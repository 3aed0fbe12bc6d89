"""Which formulas of a note lead to a number: a walk from its own formula back to what is given.

A formula's variables say by their `Ref` which formulas define them. What is read off a plan comes from the vector
equation in front, and that from the vectors known in it.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterator
from dataclasses import field, replace
from functools import cached_property

from tmm_report.quantity.formula import Formula, Var, VectorEquation, at
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation, Unknown, variables
from tmm_report.records import dataclass
from tmm_report.report.heard import Heard, Spoken

LAID = "laid_"  # begins the key of a segment that is laid off


@dataclass(frozen=True, eq=False)
class Derivation:
    """The formulas that lead to a number, in the order of the note, and the variables with which they begin."""

    spoken: list[Spoken]
    begins: list[Var]


def derive(walk: Walk, start: Callable[[Formula], bool]) -> Derivation:
    """What leads to the formulas that `start` chooses."""
    formulas = walk.heard.formulas
    waiting = [k for k, spoken in enumerate(formulas) if _chosen(spoken, start)]
    found: set[int] = set()
    while waiting:
        k = waiting.pop()
        if k not in found:
            found.add(k)
            waiting += walk.before(k)
    order = sorted(found)
    begins: dict[tuple[Symbol, str, float], Var] = {}
    for var in (var for k in order for var in walk.leaves(k)):
        begins.setdefault((var.sign, var.unit, at(var.number, None)), var)
    return Derivation([formulas[k] for k in order], list(begins.values()))


def _chosen(spoken: Spoken, start: Callable[[Formula], bool]) -> bool:
    return isinstance(spoken.item, Formula) and start(spoken.item)


def _place(ref: Ref) -> tuple[str, str, int | None]:
    return ref.table, ref.key, ref.row


@dataclass(frozen=True, eq=False)
class Walk:
    """From one formula of the note to those that it stands upon; what was found once is kept."""

    heard: Heard
    _found: dict[int, tuple[int, ...]] = field(default_factory=dict)

    @cached_property
    def defining(self) -> dict[tuple[str, str, int | None], int]:
        """Place of a number in the results -> the formula that defines it."""
        items = ((k, spoken.item) for k, spoken in enumerate(self.heard.formulas))
        return {
            _place(item.ref): k for k, item in items if isinstance(item, Formula) and item.ref is not None
        }

    @cached_property
    def by_hand(self) -> dict[tuple[str, int | None, str], list[int]]:
        """What a formula is of, at which position and by what -> those formulas, in the order of the note."""
        found: dict[tuple[str, int | None, str], list[int]] = {}
        for k, spoken in enumerate(self.heard.formulas):
            if isinstance(spoken.item, Formula) and spoken.item.ref is not None:
                found.setdefault(_by_hand(spoken.item.ref), []).append(k)
        return found

    def before(self, k: int) -> tuple[int, ...]:
        """The formulas upon which formula `k` stands."""
        if k not in self._found:
            self._found[k] = tuple(self._before(k))
        return self._found[k]

    def _before(self, k: int) -> Iterator[int]:
        item = self.heard.formulas[k].item
        if isinstance(item, VectorEquation):
            yield from self._known(item, k)
            return
        if isinstance(item, Formula | Equation):
            yield from (of for var in variables(item.expression) if (of := self.of(var, k)) is not None)
        if isinstance(item, Formula) and self._measured(k):
            yield from self._equations(k)
            yield from self._laid(k - 1)

    def leaves(self, k: int) -> Iterator[Var]:
        """The variables of formula `k` that nothing in the note defines, with their numbers at its position."""
        item = self.heard.formulas[k].item
        if isinstance(item, Formula):
            for var in variables(item.expression):
                if var.meaning is not None and not isinstance(var, Unknown) and self.of(var, k) is None:
                    yield replace(var, number=at(var.number, item.index))

    def of(self, var: Var, k: int) -> int | None:
        """The formula that defines a variable of formula `k`: that of its very number, or in a calculation by hand
        the last before it at the same position."""
        if var.ref is None:
            return None
        own = self.defining.get(_place(var.ref))
        if own is not None or var.ref.by != "value":
            return own if own != k else None
        same = self.by_hand.get(_by_hand(var.ref), [])
        before = bisect_left(same, k)
        return same[before - 1] if before else self._reaction(var, k)

    def _reaction(self, var: Var, k: int) -> int | None:
        """The formula of the same reaction turned round: R_21 of R_12."""
        if var.unit != "N" or var.ref is None:
            return None
        row, turned = var.ref.row, _turned(var.sign)
        return self._last(
            k, lambda item: item.ref is not None and item.ref.row == row and _symbol(item) == turned
        )

    def _last(self, k: int, wanted: Callable[[Formula], bool]) -> int | None:
        """The last formula before `k` that is wanted."""
        items = ((i, self.heard.formulas[i].item) for i in range(k - 1, -1, -1))
        return next((i for i, item in items if isinstance(item, Formula) and wanted(item)), None)

    def _measured(self, k: int) -> bool:
        """Whether a formula begins with a length that is read off a plan."""
        return any(var.unit == "mm" for var in self._free(k) if var.ref is not None and var.ref.by == "value")

    def _free(self, k: int) -> Iterator[Var]:
        item = self.heard.formulas[k].item
        assert isinstance(item, Formula)
        return (var for var in variables(item.expression) if self.of(var, k) is None)

    def _equations(self, k: int) -> Iterator[int]:
        """The equations from which the plan in front of formula `k` is drawn: those last printed in its section, or
        all of the section where they are solved together."""
        here = [i for i in range(k) if self.heard.formulas[i].section == self.heard.formulas[k].section]
        equations = [i for i in here if isinstance(self.heard.formulas[i].item, VectorEquation | Equation)]
        if any(isinstance(self.heard.formulas[i].item, Equation) for i in equations):
            yield from equations
        else:
            yield from _last_run(equations)

    def _known(self, equation: VectorEquation, k: int) -> Iterator[int]:
        """The formulas of the vectors that a vector equation takes as known, and of the segments laid off for them."""
        for sign in (
            Var(term.symbol, 0.0).sign for side in equation.sides for term in side if term.known == 2
        ):
            names = (sign, _turned(sign))
            of = self._behind(k, sign)
            if of is None:
                of = self._last(k, lambda item, names=names: _symbol(item) in names)  # type: ignore[misc]
            if of is not None:
                yield of
                yield from self._laid(of + 1)

    def _behind(self, k: int, sign: Symbol) -> int | None:
        """The formula of a normal or Coriolis part that stands behind equation `k` in its section."""
        section = self.heard.formulas[k].section
        for i, spoken in enumerate(self.heard.formulas[k + 1 :], k + 1) if sign.sup else ():
            if spoken.section != section:
                return None
            if isinstance(spoken.item, Formula) and _symbol(spoken.item) == sign:
                return i
        return None

    def _laid(self, k: int) -> Iterator[int]:
        """Formula `k`, if it is of a segment to be laid off."""
        if 0 <= k < len(self.heard.formulas):
            item = self.heard.formulas[k].item
            if isinstance(item, Formula) and item.ref is not None and item.ref.key.startswith(LAID):
                yield k


def _turned(sign: Symbol) -> Symbol:
    """The reaction of the other link: R_24 of R_42, R_10,9 of R_9,10."""
    ends = sign.sub.split(",") if "," in sign.sub else list(sign.sub)
    return replace(sign, sub=("," if "," in sign.sub else "").join(reversed(ends)))


def _symbol(item: Formula) -> Symbol:
    return Var(item.result, 0.0).sign


def _by_hand(ref: Ref) -> tuple[str, int | None, str]:
    return ref.key, ref.row, ref.by


def _last_run(numbers: list[int]) -> list[int]:
    """The numbers at the end that follow one another."""
    run = numbers[-1:]
    for number in reversed(numbers[:-1]):
        if number != run[0] - 1:
            break
        run.insert(0, number)
    return run

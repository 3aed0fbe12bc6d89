"""Chapter of the efficiency of machines joined in a tree: the whole, the power through every part, which to improve.

Every part is found from its own parts; the derivative of the whole by a module is the product of the derivatives on
the way to it. The power balance over all the modules is the second way to the whole.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from tmm_report.chapters.machine.efficiency import steps
from tmm_report.chapters.machine.efficiency.given import Given, Joined, Module, Node
from tmm_report.chapters.machine.efficiency.values import Values
from tmm_report.mechanics.pairs import efficiency_chains
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Table
from tmm_report.quantity.text import Amount
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "Part", "solve"]

EQUAL = 1e-12  # relative: what differs by less is equal


@dataclass(frozen=True, eq=False)
class Part:
    """A part of the tree.

    `row`: of the table of all parts, 0 of the whole; `index`: 1, 2, … of modules, A, B, … of groups, "" of the whole;
    `share`: of the power that goes into the parallel parts it stands among, 1 elsewhere; `slope`: ∂η/∂η_i of the whole
    by it; `power`: at its input and output, W, or in parts of the input of the whole; `parts`: of a group.
    """

    node: Node
    row: int
    index: str
    efficiency: float
    share: float
    slope: float
    power: tuple[float, float]
    parts: tuple[Part, ...] = ()

    @property
    def name(self) -> str:
        return self.node.name

    @property
    def loss(self) -> float:
        """ψ = 1 − η."""
        return 1 - self.efficiency

    @property
    def lost(self) -> float:
        """Power that is lost in it."""
        return self.power[0] - self.power[1]

    def within(self) -> Iterator[Part]:
        """It and all its parts, in their order."""
        yield self
        for part in self.parts:
            yield from part.within()


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `whole`: the tree; `table`: its parts; `s`: the single numbers; powers are parts of the input
    where no power is stated."""

    given: Given
    whole: Part
    table: Table
    s: Values

    @cached_property
    def modules(self) -> tuple[Part, ...]:
        return tuple(part for part in self.whole.within() if isinstance(part.node, Module))

    @cached_property
    def groups(self) -> tuple[Part, ...]:
        """Groups from the innermost outwards, the whole last."""
        found = [part for part in self.whole.within() if isinstance(part.node, Joined)]
        return tuple(reversed(found))

    @property
    def worst(self) -> Part:
        """The module with the least efficiency."""
        return min(self.modules, key=lambda part: part.efficiency)

    @property
    def first(self) -> Part:
        """The module to improve first: that with the greatest ∂η/∂η_i, of equal ones the first."""
        return _greatest(self.modules, [part.slope for part in self.modules])

    @property
    def greatest(self) -> Part:
        """The module in which most power is lost, of equal ones the first."""
        return _greatest(self.modules, [part.lost for part in self.modules])

    @property
    def chain(self) -> bool:
        """Whether all modules are in series."""
        return all(part.node.kind == "series" for part in self.groups if isinstance(part.node, Joined))

    def summary(self) -> Iterator[Message]:
        """The main numbers in a sentence."""
        text = N_("efficiency of the machines joined: %(eta)s; the module to improve first: %(first)s")
        values = {"eta": Amount(self.whole.efficiency), "first": self.first.name or self.first.index}
        yield Message(text, values)


def _greatest(parts: Sequence[Part], of: Sequence[float]) -> Part:
    """Of parts that differ by rounding alone the first one."""
    most = max(of)
    return next(part for part, one in zip(parts, of, strict=True) if one >= most * (1 - EQUAL))


def solve(given: Given, moving: Moving | None) -> Found:
    """A lever mechanism has no part in it."""
    eta = efficiency(given.tree)
    power = given.input
    if power is None:
        power = 1.0 if given.output is None else given.output / eta
    whole = _part(given.tree, power, 1.0, 1.0, _Names())
    table = steps.parts(whole, given.stated)
    found = Found(given, whole, table, steps.whole(given, whole, table))
    found.s.efficiency_imbalance = _imbalance(found)
    return found


def _imbalance(found: Found) -> float:
    """Input less output less what the modules lose, by the input."""
    into, out = found.whole.power
    return abs(into - out - math.fsum(part.lost for part in found.modules)) / into


def efficiency(node: Node) -> float:
    """Of a tree from those of its modules."""
    if isinstance(node, Module):
        return node.efficiency
    parts = [efficiency(part) for part in node.parts]
    if node.kind == "series":
        return efficiency_chains.in_series(parts)
    shares = _shares(node)
    return (
        efficiency_chains.by_input(shares, parts)
        if node.by == "input"
        else efficiency_chains.by_output(shares, parts)
    )


def _shares(node: Joined) -> list[float]:
    return [float(part.share or 0.0) for part in node.parts]


class _Names:
    """Rows of the parts, numbers of modules and letters of groups, in the order in which they are met."""

    def __init__(self) -> None:
        self.modules = self.groups = 0

    def next(self, node: Node, outer: bool) -> tuple[int, str]:
        if outer:
            return 0, "" if isinstance(node, Joined) else "1"
        if isinstance(node, Module):
            self.modules += 1
            return self.modules + self.groups, str(self.modules)
        self.groups += 1
        return self.modules + self.groups, chr(ord("A") + self.groups - 1)


def _part(node: Node, power: float, share: float, slope: float, names: _Names, outer: bool = True) -> Part:
    """A part with its parts; `power`: at its input; `slope`: of the whole by it."""
    (row, index), eta = names.next(node, outer), efficiency(node)
    if isinstance(node, Module):
        return Part(node, row, index, eta, share, slope, (power, power * eta))
    etas = [efficiency(part) for part in node.parts]
    inner = [slope * one for one in _slopes(node, etas)]
    if node.kind == "series":
        inputs, shares = [power * math.prod(etas[:k]) for k in range(len(etas))], [1.0] * len(etas)
    else:
        shares = _shares(node) if node.by == "input" else efficiency_chains.input_shares(_shares(node), etas)
        inputs = [power * one for one in shares]
    parts = tuple(
        _part(part, inputs[k], shares[k], inner[k], names, outer=False) for k, part in enumerate(node.parts)
    )
    return Part(node, row, index, eta, share, slope, (power, power * eta), parts)


def _slopes(node: Joined, etas: list[float]) -> list[float]:
    if node.kind == "series":
        return efficiency_chains.slopes_in_series(etas)
    return _shares(node) if node.by == "input" else efficiency_chains.slopes_by_output(_shares(node), etas)

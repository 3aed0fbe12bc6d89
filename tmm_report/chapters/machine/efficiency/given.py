"""What is given of machines joined in a tree."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from tmm_report.records import dataclass


@dataclass(frozen=True)
class Module:
    """A machine with its efficiency. `share`: of the power of the parallel parts it stands among."""

    efficiency: float
    name: str = ""
    share: float | None = None


@dataclass(frozen=True)
class Joined:
    """Parts in series or in parallel. `by`: of parallel parts, whether the shares are of the input or the output."""

    kind: Literal["series", "parallel"]
    parts: tuple[Node, ...]
    name: str = ""
    share: float | None = None
    by: Literal["input", "output"] = "input"


Node = Module | Joined


@dataclass(frozen=True, eq=False)
class Given:
    """The tree, and the power at its input or at its output, W, where one of them is stated."""

    tree: Node
    input: float | None = None
    output: float | None = None

    @property
    def stated(self) -> bool:
        """Whether a power is."""
        return self.input is not None or self.output is not None


def modules(node: Node) -> Iterator[Module]:
    """The machines of a tree in their order."""
    if isinstance(node, Module):
        yield node
        return
    for part in node.parts:
        yield from modules(part)

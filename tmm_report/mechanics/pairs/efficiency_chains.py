"""Efficiency of machines joined in series, in parallel and in any tree of both.

In series all the power goes through each: η = Π η_i, less than the least of them. In parallel it is shared out: by the
shares of the input s_i, η = Σ s_i η_i, or by the shares of the output q_i, η = 1/Σ(q_i/η_i), between the least and the
greatest. (Artobolevsky, Theory of mechanisms and machines, ch. 14)
"""

from __future__ import annotations

import math
from collections.abc import Sequence


def in_series(parts: Sequence[float]) -> float:
    return math.prod(parts)


def by_input(shares: Sequence[float], parts: Sequence[float]) -> float:
    """`shares`: of the input power, their sum is 1."""
    return math.fsum(s * eta for s, eta in zip(shares, parts, strict=True))


def by_output(shares: Sequence[float], parts: Sequence[float]) -> float:
    """`shares`: of the useful power, their sum is 1."""
    return 1 / math.fsum(q / eta for q, eta in zip(shares, parts, strict=True))


def input_shares(outputs: Sequence[float], parts: Sequence[float]) -> list[float]:
    """The shares of the input power that give these shares of the output: s_i = η q_i/η_i."""
    whole = by_output(outputs, parts)
    return [whole * q / eta for q, eta in zip(outputs, parts, strict=True)]


def slopes_in_series(parts: Sequence[float]) -> list[float]:
    """∂η/∂η_i of a chain: the product of the others."""
    return [math.prod(parts[:k]) * math.prod(parts[k + 1 :]) for k in range(len(parts))]


def slopes_by_output(shares: Sequence[float], parts: Sequence[float]) -> list[float]:
    """∂η/∂η_i of what is joined in parallel by shares of the output: η² q_i/η_i²."""
    whole = by_output(shares, parts)
    return [whole**2 * q / eta**2 for q, eta in zip(shares, parts, strict=True)]

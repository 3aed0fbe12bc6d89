"""The forces of a cam that stands alone have no block of their own: the block `cam` states them."""

from collections.abc import Iterator
from typing import TypedDict

from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read


class Block(model.Block):
    """Nothing."""


class Given(TypedDict):
    pass


def given(read: Read) -> Given:
    return {}


def mistakes(read: Read) -> Iterator[Problem]:
    return iter(())

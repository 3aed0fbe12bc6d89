"""No block of its own: where force plans are drawn and how stands in `positions` and `drawing`."""

from collections.abc import Iterator, Mapping

from tmm_report.chapters.lever.kinematics import block as kinematics
from tmm_report.chapters.lever.structure.block import in_vain, stated
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read


class Block(model.Block):
    """Nothing."""


def given(read: Read) -> Mapping[str, object]:
    return {}


def mistakes(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from kinematics.undrawn("force_plan", read)


def doubts(read: Read) -> Iterator[Problem]:
    if stated(read):
        for path in (("positions", "force_plan"), ("drawing", "scales", "force"), ("drawing", "force")):
            yield from in_vain(read, path)

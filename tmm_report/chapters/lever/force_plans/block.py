"""No block of its own: where force plans are drawn and how stands in `positions` and `drawing`."""

from collections.abc import Iterator, Mapping

from tmm_report.chapters.lever.force_plans.solve import offered
from tmm_report.chapters.lever.kinematics import block as kinematics
from tmm_report.chapters.lever.structure import block as structure
from tmm_report.chapters.lever.structure.block import driven_by_stroke, in_vain, stated
from tmm_report.problems import N_, Message, Problem, doubt
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
        asked = "force_plan" in (read.data.get("positions") or {})
        if asked and driven_by_stroke(read) and not offered(structure.given(read)["mechanism"].driver):
            text = N_("no force polygon is drawn: no link of a triangle follows the stroke")
            right = Message(
                N_("leave the key out: the reactions and the force along the stroke stand in tables")
            )
            yield doubt(text, ("positions", "force_plan"), right)
        for path in (("positions", "force_plan"), ("drawing", "scales", "force"), ("drawing", "force")):
            yield from in_vain(read, path)

"""The key `reduction` of a variant: whether the masses and forces are reduced to the driving link."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import stated, without
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.values import Flag


class Block(model.Block):
    """Reduced moments."""

    reduction: Flag = Field(
        default=False, description="true: reduced moment of inertia and reduced moment of the forces"
    )


class Given(TypedDict):
    reduction: bool


def given(read: Read) -> Given:
    return {"reduction": read.block(Block).reduction}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "reduction")
    elif read.block(Block).reduction and not _heavy(read.data):
        right = Message(N_("give the links their mass, mass_centre and inertia"))
        yield mistake(N_("there is nothing to reduce: no link has a mass"), ("reduction",), right)


def _heavy(data: object) -> bool:
    """Whether a link has a mass or a moment of inertia."""
    mechanism = data.get("mechanism") if isinstance(data, dict) else None
    links = mechanism.get("links") if isinstance(mechanism, dict) else None
    written = links.values() if isinstance(links, dict) else ()
    return any(isinstance(link, dict) and (link.get("mass") or link.get("inertia")) for link in written)

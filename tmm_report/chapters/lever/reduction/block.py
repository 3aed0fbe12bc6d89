"""The key `reduction` of a variant: whether the masses and forces are reduced to the driving link, and to a slider."""

from collections.abc import Iterator
from typing import Annotated, Any, TypedDict

from pydantic import Field, Tag

from tmm_report.chapters.lever.structure.block import driven_by_stroke, names, stated, without
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import MAP, SCALAR, Flag, Name, by_shape


class ToModel(Model):
    """Reduction to a link that slides, too."""

    link: Name = Field(description="a link that slides along a guide", examples=["5"])


Asked = Annotated[
    Annotated[Flag, Tag(SCALAR)] | Annotated[ToModel, Tag(MAP)],
    by_shape(N_("true, or a link that slides along a guide: {link: 5}")),
]


class Block(model.Block):
    """Reduced moments; reduced mass and force of a link that slides."""

    reduction: Asked = Field(
        default=False,
        description="true: reduced moment of inertia and reduced moment of the forces; {link: 5}: reduced mass and "
        "force of a link that slides, too",
    )


class Given(TypedDict):
    reduction: bool


def given(read: Read) -> Given:
    """What drives by its stroke has a mass reduced to it in place of a moment of inertia."""
    return {"reduction": bool(read.block(Block).reduction) and not driven_by_stroke(read)}


def mistakes(read: Read) -> Iterator[Problem]:
    asked = read.block(Block).reduction
    if not stated(read):
        yield from without(read, "reduction")
        return
    if asked and not _heavy(read.data):
        right = Message(N_("give the links their mass, mass_centre and inertia"))
        yield mistake(N_("there is nothing to reduce: no link has a mass"), ("reduction",), right)
    if isinstance(asked, ToModel):
        yield from _not_sliding(read, asked.link)


def _not_sliding(read: Read, link: str) -> Iterator[Problem]:
    """A link that slides along no guide has no stroke."""
    links, path = names(read.data).points, ("reduction", "link")
    written = _links(read.data)
    sliding = [name for name in links if written.get(name, {}).get("slides")]
    if link in sliding:
        return
    right = Message(N_("a link that slides: %(links)s"), {"links": ", ".join(sliding)})
    if not sliding:
        right = Message(N_("reduction: true, to the driving link"))
    wrong = N_("link %(name)s slides along no guide") if link in links else N_("there is no link %(name)s")
    yield mistake(wrong, path, right, name=link)


def _heavy(data: object) -> bool:
    """Whether a link has a mass or a moment of inertia."""
    return any(link.get("mass") or link.get("inertia") for link in _links(data).values())


def _links(data: object) -> dict[str, dict[str, Any]]:
    """As they are written, those that are described."""
    mechanism = data.get("mechanism") if isinstance(data, dict) else None
    links = mechanism.get("links") if isinstance(mechanism, dict) else None
    written = links.items() if isinstance(links, dict) else ()
    return {name: link for name, link in written if isinstance(link, dict)}

"""The block `efficiency` of a variant."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, Any, TypedDict

from pydantic import Discriminator, Field, Tag, model_validator

from tmm_report.chapters.machine.efficiency.given import Given as Stated
from tmm_report.chapters.machine.efficiency.given import Joined, Module, Node, modules
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.language import CalledBy
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import Number, quantity

Share = Annotated[float, quantity("number", 1e-9, 1.0, "0 … 1")]
Watts = Annotated[float, quantity("power", 1e-9)]
MODULES, GROUPS = 24, 26  # that one scheme shows; the groups have letters
EXACT = 1e-9  # of the sum of the shares


class ModuleModel(Model):
    """A machine with its efficiency."""

    name: CalledBy | None = None
    efficiency: Number = Field(description="between 0 and 1", examples=[0.95])
    share: Share | None = Field(default=None, description="of the input power, among parallel parts")
    output_share: Share | None = Field(default=None, description="of the output power, among parallel parts")

    @model_validator(mode="after")
    def within(self) -> "ModuleModel":
        """Friction is in every machine, so it gives less than it takes; what gives nothing has no efficiency."""
        if not 0 < self.efficiency < 1:
            text = N_("an efficiency of %(value)s is none: every machine loses some power and gives some")
            raise WrongValue(
                Message(text, {"value": f"{self.efficiency:g}"}),
                Message(N_("more than 0 and less than 1, for example 0.95")),
            )
        return self


class SeriesModel(Model):
    """Parts one behind the other."""

    name: CalledBy | None = None
    series: list["NodeModel"] = Field(min_length=1, max_length=30)
    share: Share | None = None
    output_share: Share | None = None


class ParallelModel(Model):
    """Parts side by side, each with its share of the power."""

    name: CalledBy | None = None
    parallel: list["NodeModel"] = Field(min_length=2, max_length=12)
    share: Share | None = None
    output_share: Share | None = None


def _kind(value: Any) -> str:
    names = value.keys() if isinstance(value, dict) else getattr(type(value), "model_fields", ())
    return next((f"<{key}>" for key in ("series", "parallel") if key in names), "<module>")


NodeModel = Annotated[
    Annotated[ModuleModel, Tag("<module>")]
    | Annotated[SeriesModel, Tag("<series>")]
    | Annotated[ParallelModel, Tag("<parallel>")],
    Discriminator(_kind),
]


class EfficiencyModel(Model):
    """Machines joined in series, in parallel, or in a tree of both."""

    series: list[NodeModel] | None = Field(default=None, min_length=1, max_length=30)
    parallel: list[NodeModel] | None = Field(default=None, min_length=2, max_length=12)
    input: Watts | None = Field(default=None, description="power at the input", examples=["11 kW"])
    output: Watts | None = Field(default=None, description="useful power, in place of the input")

    @model_validator(mode="after")
    def one_way(self) -> "EfficiencyModel":
        if (self.series is None) == (self.parallel is None):
            wrong = Message(N_("the machines must be joined in series or in parallel"))
            raise WrongValue(wrong, Message(N_("exactly one of: %(words)s"), {"words": "series, parallel"}))
        if self.input is not None and self.output is not None:
            wrong = Message(N_("both the power of the input and that of the output are stated"))
            raise WrongValue(wrong, Message(N_("one of them: the other follows from the efficiency")))
        return self


class Block(model.Block):
    """Efficiency of machines joined in a tree."""

    ALONE = True

    efficiency: EfficiencyModel | None = Field(
        default=None, description="efficiency of machines joined in a tree"
    )


class Given(TypedDict):
    efficiency: Stated | None


def given(read: Read) -> Given:
    written = read.block(Block).efficiency
    if written is None:
        return {"efficiency": None}
    return {"efficiency": Stated(tree=_tree(written), input=written.input, output=written.output)}


def _tree(written: Any) -> Joined:
    """A node is read by its shape, and holds nodes, which no plain record says: so it is made of its model."""
    series, parallel = (getattr(written, key, None) for key in ("series", "parallel"))
    shares = [_share(part) for part in parallel or ()]
    rest = 1 - sum(one for one in shares if one is not None)
    return Joined(
        kind="parallel" if series is None else "series",
        parts=tuple(
            _node(part, rest if shares.count(None) == 1 else None) for part in series or parallel or ()
        ),
        by="output" if any(part.output_share is not None for part in parallel or ()) else "input",
    )


def _share(written: Any) -> float | None:
    """Of the input or of the output."""
    share: float | None = written.share if written.output_share is None else written.output_share
    return share


def _node(written: Any, rest: float | None) -> Node:
    """`rest`: the share of the one part of those beside it that states none."""
    share = _share(written)
    own: Any = {"name": written.name or "", "share": rest if share is None else share}
    if isinstance(written, ModuleModel):
        return Module(efficiency=written.efficiency, **own)
    return replace(_tree(written), **own)


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).efficiency
    if written is None:
        return
    kind = "series" if written.series is not None else "parallel"
    yield from _shared(kind, written.series or written.parallel or [], ("efficiency", kind))
    tree = _tree(written)
    if len(list(modules(tree))) > MODULES or _groups(tree) > GROUPS:
        right = Message(N_("%(count)s machines at most"), {"count": MODULES})
        yield mistake(N_("too many machines for one scheme"), ("efficiency",), right)


def _groups(node: Node) -> int:
    return 0 if isinstance(node, Module) else 1 + sum(_groups(part) for part in node.parts)


def _shared(kind: str, parts: list[Any], path: tuple[str | int, ...]) -> Iterator[Problem]:
    """Shares of what stands side by side, and nowhere else."""
    if kind == "parallel":
        yield from _sum(parts, path)
    else:
        for k, part in enumerate(parts):
            if part.share is not None or part.output_share is not None:
                text = N_("all the power goes through what stands in series: it has no share")
                yield mistake(text, (*path, k), Message(N_("a share is stated of parallel parts")))
    for k, part in enumerate(parts):
        inner = next((one for one in ("series", "parallel") if hasattr(part, one)), None)
        if inner is not None:
            yield from _shared(inner, getattr(part, inner), (*path, k, inner))


def _sum(parts: list[Any], path: tuple[str | int, ...]) -> Iterator[Problem]:
    inputs, outputs = [part.share for part in parts], [part.output_share for part in parts]
    left = sum(_share(part) is None for part in parts)
    if any(one is not None for one in inputs) and any(one is not None for one in outputs):
        text = N_("shares of the input and of the output are mixed")
        yield mistake(text, path, Message(N_("share of each part, or output_share of each part")))
    elif left > 1:
        text = N_(
            "each of the parallel parts has a share of the power, all of the input or all of the output"
        )
        yield mistake(text, path, Message(N_("share: 0.6 of each part, or output_share: 0.6 of each part")))
    else:
        total = sum(one for one in (*inputs, *outputs) if one is not None)
        if left and total > 1 - EXACT:
            text = N_("the shares of the parallel parts leave nothing to the one without a share: %(sum)s")
            yield mistake(text, path, Message(N_("shares that add up to less than 1")), sum=f"{total:.6g}")
        elif not left and abs(total - 1) > EXACT:
            text = N_("the shares of the parallel parts add up to %(sum)s")
            yield mistake(text, path, Message(N_("shares that add up to 1")), sum=f"{total:.6g}")

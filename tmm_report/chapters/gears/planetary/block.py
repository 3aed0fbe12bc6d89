"""The block of a planetary stage in the list of a drive's stages."""

import math
from functools import partial
from typing import Annotated, Literal

from pydantic import Field, Tag, model_validator

from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.chapters.gears.spur.given import Rack, signed_ratio
from tmm_report.mechanics.gears.planetary.search import LARGEST_SHIFTED, Task
from tmm_report.mechanics.gears.planetary.stage import SCHEMES, Member
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import for_example
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.language import CalledBy
from tmm_report.variant.model import Model
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import (
    LIST,
    SCALAR,
    Efficiency,
    Helix,
    Module,
    Reads,
    Shift,
    Span,
    Tooth,
    by_shape,
    quantity,
    whole,
)

RATIOS = (1e-4, 1e4)
WORDS: dict[str, Member] = {
    "sun": "wheel1",
    "ring": "wheel3",
    "wheel1": "wheel1",
    "wheel3": "wheel3",
    "carrier": "carrier",
}


_ratio = partial(
    signed_ratio,
    limits=RATIOS,
    wrong=N_("no planetary stage has the ratio %(value)s"),
    right=N_("from %(low)s to %(high)s, with a minus where input and output turn in opposite senses"),
)
Ratio = Annotated[float, Reads(_ratio, {"type": "number", "description": "plus: in the same sense"})]
Tolerance = Annotated[float, quantity("number", 1e-6, 0.25, "0.0001 … 25 %")]
Share = Annotated[float, quantity("number", 0.0, 1.0, "0 … 100 %")]
Count = Annotated[int, whole(2, 12)]
External = Annotated[int, whole(6, 120)]
Ring = Annotated[int, whole(10, 250)]
TurningSpeed = Annotated[float, quantity("speed")]
Word = Literal["sun", "ring", "wheel1", "wheel3", "carrier"]
Modules = Annotated[
    Annotated[Module, Tag(SCALAR)] | Annotated[tuple[Module, Module], Tag(LIST)],
    by_shape(N_("a module, or two of the rows: [4 mm, 5 mm]")),
]
Satellites = Annotated[
    Annotated[Count, Tag(SCALAR)] | Annotated[tuple[Count, Count], Tag(LIST)],
    by_shape(N_("a number of planet gears, or the least and the largest: [2, 5]")),
]
Shifts = Annotated[
    Annotated[Shift, Tag(SCALAR)] | Annotated[list[Shift], Tag(LIST)],
    by_shape(N_("a profile shift coefficient of the planet gears, or those of all wheels: [0.2, 0.1, 0.3]")),
]
Teeth = Annotated[list[Tooth], Field(min_length=3, max_length=4)]


class SecondModel(Model):
    """The second input of a differential: a member that is neither `input` nor `output`."""

    member: Word = Field(description="which member it turns")
    speed: TurningSpeed = Field(description="minus: against the input shaft", examples=["500 rpm"])


class PlanetaryModel(Model):
    """A planetary stage: two central wheels, a carrier and planet gears."""

    kind: Literal["planetary"]
    name: CalledBy | None = Field(
        default=None, description="in the headings; left out, the numbers of the wheels"
    )
    scheme: Literal["sun-ring", "external-external", "external-internal", "internal-internal", "any"] = Field(
        default="sun-ring",
        description="one row with a ring, or two rows by the kinds of their meshes; any: the four are compared",
    )
    ratio: Ratio = Field(description="input to output, with the third member at rest", examples=[6.56])
    tolerance: Tolerance | None = Field(
        default=None, description="allowed deviation of the ratio; left out, that of the drive, 4 % at most"
    )
    ratio_weight: Share = Field(
        default=0.0,
        description="what the nearness of the ratio counts beside the size in the ranking: 0 compact, 1 near",
        examples=["50 %"],
    )
    module: Modules = Field(examples=["5 mm"])
    satellites: Satellites = Field(default=(2, 6), description="a number, or the least and the largest")
    teeth: Teeth | None = Field(
        default=None, description="z1, z2, z3, of two rows z1, z2, z2', z3; left out, the best are found"
    )
    input: Word = Field(examples=["sun"], description="the member that drives")
    output: Word = Field(examples=["carrier"], description="the member that is driven")
    fixed: Word | None = Field(default=None, description="the member at rest; left out, the third one")
    second: SecondModel | None = Field(default=None, description="in place of `fixed`: the second input")
    helix: Helix = Field(
        default=0.0, description="of all the teeth; the module is then that of the normal section"
    )
    centre_distance: Span | None = Field(
        default=None,
        description="a_w of both meshes; left out, it follows from the teeth or the shifts",
        examples=["165 mm"],
    )
    shift: Shifts | None = Field(
        default=None,
        description="x of the planet gears, or x1, x2, x3 (of two rows x1, x2, x2', x3) of the stated teeth",
        examples=["[0.2, 0.1, 0.3]"],
    )
    coaxiality: Literal["teeth", "shift"] = Field(
        default="teeth", description="shift: a difference of up to 2 teeth is made up by profile shift"
    )
    external_teeth: tuple[External, External] = Field(
        default=(12, 100), description="least and largest teeth sought, of wheels with external teeth"
    )
    ring_teeth: tuple[Ring, Ring] = Field(default=(20, 200), description="the same of rings")
    rack: Stated[Rack] = Field(default_factory=Rack)
    efficiency: Efficiency = Field(default=0.98, description="of the stage with its carrier stopped")

    @model_validator(mode="after")
    def members(self) -> "PlanetaryModel":
        """Input, output and the third member are three different ones, named as the scheme has them."""
        third = self.second.member if self.second else self.fixed
        written = [self.input, self.output, *([third] if third else [])]
        strange = [word for word in written if word in ("sun", "ring") and self.scheme != "sun-ring"]
        if strange:
            wrong = Message(N_("a stage of two rows has no %(member)s"), {"member": strange[0]})
            raise WrongValue(wrong, Message(N_("write wheel1, wheel3 or carrier")))
        if self.second is not None and self.fixed is not None:
            raise WrongValue(
                Message(N_("a member is both fixed and driven")),
                Message(N_("write either fixed or second, not both")),
            )
        if len({WORDS[word] for word in written}) < len(written):
            raise WrongValue(
                Message(N_("one member has two parts in the stage")),
                Message(N_("input, output and the fixed member must be three different ones")),
            )
        return self

    @model_validator(mode="after")
    def chosen(self) -> "PlanetaryModel":
        """Teeth belong to a scheme."""
        if self.scheme == "any" and self.teeth is not None:
            wrong = Message(N_("teeth are stated, but of which scheme is not"))
            raise WrongValue(wrong, Message(N_("state the scheme, or leave out the teeth")))
        return self

    @model_validator(mode="after")
    def shifts(self) -> "PlanetaryModel":
        """As many shifts as wheels, of stated teeth; a centre distance or shifts are of one scheme."""
        wanted = 3 if self.scheme == "sun-ring" else 4
        if self.scheme == "any" and (self.shift is not None or self.centre_distance is not None):
            wrong = Message(N_("shifts or a centre distance are stated, but of which scheme is not"))
            raise WrongValue(wrong, Message(N_("state the scheme, or leave them out")))
        if isinstance(self.shift, list) and len(self.shift) != wanted:
            text = N_("this scheme has %(wanted)s profile shift coefficients, not %(found)s")
            right = Message(N_("[x1, x2, x3]") if wanted == 3 else N_("[x1, x2, x2', x3]"))
            raise WrongValue(Message(text, {"wanted": wanted, "found": len(self.shift)}), right)
        if isinstance(self.shift, list) and self.teeth is None:
            wrong = Message(
                N_("the profile shift coefficients of all wheels are stated, but their teeth are not")
            )
            right = Message(N_("state the teeth, or the one coefficient of the planet gears"))
            raise WrongValue(wrong, right)
        return self

    @model_validator(mode="after")
    def numbers(self) -> "PlanetaryModel":
        """As many teeth and modules as the scheme has wheels and rows; ranges that ascend."""
        wanted = 3 if self.scheme == "sun-ring" else 4
        if self.teeth is not None and len(self.teeth) != wanted:
            wrong = N_("this scheme has %(wanted)s numbers of teeth, not %(found)s")
            right = Message(N_("[z1, z2, z3]") if wanted == 3 else N_("[z1, z2, z2', z3]"))
            raise WrongValue(Message(wrong, {"wanted": wanted, "found": len(self.teeth)}), right)
        if wanted == 3 and isinstance(self.module, tuple) and self.module[0] != self.module[1]:
            raise WrongValue(
                Message(N_("a single row has one module")),
                for_example("5 mm"),
            )
        for low, high in (self.external_teeth, self.ring_teeth, self.counts):
            if low > high:
                wrong = N_("the range from %(low)s to %(high)s is empty")
                raise WrongValue(
                    Message(wrong, {"low": low, "high": high}), Message(N_("write the least first"))
                )
        return self

    @property
    def counts(self) -> tuple[int, int]:
        """The least and the largest number of satellites."""
        return self.satellites if isinstance(self.satellites, tuple) else (self.satellites, self.satellites)


USUAL = 0.04  # deviation of a ratio


def build(model: PlanetaryModel, wheels: tuple[str, ...], allowed: float = USUAL) -> planetary.Given:
    """The stage with its members named: wheel 1, the satellite (each crown of two rows), wheel 3, the carrier.

    `allowed`: deviation of the ratio of the drive, which a stage that states none does not exceed.
    """
    modules = model.module if isinstance(model.module, tuple) else (model.module, model.module)
    low, high = model.counts
    normal, turn = model.rack, math.cos(model.helix)
    across = normal.transverse(model.helix) if model.helix else normal
    task = Task(
        scheme=SCHEMES["sun-ring" if model.scheme == "any" else model.scheme],
        ratio=model.ratio,
        modules=(modules[0] / turn, modules[1] / turn),
        input=WORDS[model.input],
        output=WORDS[model.output],
        tolerance=_tolerance(model, allowed),
        weight=model.ratio_weight,
        satellites=tuple(range(low, high + 1)),
        rack=across,
        external=model.external_teeth,
        rings=model.ring_teeth,
        shifted=LARGEST_SHIFTED if model.coaxiality == "shift" or _displaced(model) else 0,
        distance=model.centre_distance,
        shifts=_shifts(model, turn),
    )
    return planetary.Given(
        task=task,
        names=wheels,
        efficiency=model.efficiency,
        teeth=_teeth(model),
        driven=model.second.speed if model.second else None,
        title=model.name or "",
        any_scheme=model.scheme == "any",
        helix=model.helix,
        module_n=modules if model.helix else None,
        rack_n=normal if model.helix else None,
    )


def _tolerance(model: PlanetaryModel, allowed: float) -> float:
    """As stated; of stated teeth the usual one, for the drive judges them; of teeth sought no more than the drive's."""
    if model.tolerance is not None:
        return model.tolerance
    return USUAL if model.teeth is not None else min(allowed or USUAL, USUAL)


def _displaced(model: PlanetaryModel) -> bool:
    """Whether the statement asks for profile shift."""
    return model.centre_distance is not None or isinstance(model.shift, list)


def _shifts(model: PlanetaryModel, turn: float) -> tuple[float, float, float, float] | None:
    """x1, x2, x2', x3 in transverse modules; nan of the central wheels where only that of the satellites is stated."""
    if model.shift is None:
        return None
    if not isinstance(model.shift, list):
        return math.nan, model.shift * turn, model.shift * turn, math.nan
    x = [one * turn for one in model.shift]
    return (x[0], x[1], x[1], x[2]) if len(x) == 3 else (x[0], x[1], x[2], x[3])


def _teeth(model: PlanetaryModel) -> tuple[int, int, int, int] | None:
    if model.teeth is None:
        return None
    z = model.teeth
    return (z[0], z[1], z[1], z[2]) if len(z) == 3 else (z[0], z[1], z[2], z[3])

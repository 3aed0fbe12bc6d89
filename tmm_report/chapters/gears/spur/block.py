"""The block of a spur stage in the list of a drive's stages."""

import math
from collections.abc import Iterator
from functools import partial
from typing import Annotated, Any, Literal

from pydantic import Field, Tag, model_validator

from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.mechanics.gears.meshing import Cutter, Rack
from tmm_report.problems import N_, Message, Problem, doubt, shown
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import LIST, SCALAR, Flag, Label, Reads, by_shape, quantity, whole
from tmm_report.yamlread import Path

RATIOS = (0.02, 50.0)


def signed_ratio(value: Any, limits: tuple[float, float], wrong: str, right: str) -> float:
    """A ratio of either sign whose magnitude is within the limits; `wrong`, `right`: what to say of another one."""
    number = units.parse(value, "number")
    low, high = limits
    if low <= abs(number) <= high:
        return number
    limited = {"low": f"{low:g}", "high": f"{high:g}"}
    raise WrongValue(Message(wrong, {"value": shown(value)}), Message(right, limited))


_ratio = partial(
    signed_ratio,
    limits=RATIOS,
    wrong=N_("no pair of wheels has the ratio %(value)s"),
    right=N_("from %(low)s to %(high)s, with a minus where the wheels turn in opposite senses"),
)
Ratio = Annotated[
    float, Reads(_ratio, {"type": "number", "description": "minus: an external pair, plus: an internal one"})
]
Module = Annotated[float, quantity("length", 5e-5, 0.1, "0.05 … 100 mm")]
Span = Annotated[float, quantity("length", 1e-3, 20.0, "1 mm … 20 m")]
Helix = Annotated[float, quantity("angle", 0.0, math.radians(45), "0 … 45 deg")]
ProfileAngle = Annotated[float, quantity("angle", math.radians(10), math.radians(35), "10 … 35 deg")]
Height = Annotated[float, quantity("number", 0.2, 2.0, "0.2 … 2")]
Clearance = Annotated[float, quantity("number", 0.0, 1.0, "0 … 1")]
Efficiency = Annotated[float, quantity("number", 0.01, 1.0, "0.01 … 1")]
Sliding = Annotated[float, quantity("number", 0.5, 20.0, "0.5 … 20")]
Tooth = Annotated[int, whole(6, 1000)]
Shift = Annotated[float, quantity("number", -5.0, 5.0, "−5 … 5")]
Shifts = Annotated[
    Annotated[Literal["rule", "limit", "equal sliding"], Tag(SCALAR)]
    | Annotated[tuple[Shift, Shift], Tag(LIST)],
    by_shape(N_("rule, limit, equal sliding or two shifts: [0.2, 0.5]")),
]


class RackModel(Model):
    """The basic rack that cuts the teeth."""

    alpha: ProfileAngle = Field(default=math.radians(20), description="profile angle", examples=["20 deg"])
    ha: Height = Field(default=1.0, alias="ha*", description="height of the head, in modules")
    c: Clearance = Field(default=0.25, alias="c*", description="clearance, in modules")


class CutterModel(Model):
    """A pinion cutter that cuts the ring of an internal pair, or both wheels of an external one."""

    z0: Tooth = Field(description="number of its teeth", examples=[20])
    x0: Shift = Field(
        default=0.0, description="its own shift: above zero new, below zero worn", examples=[0.1]
    )


class SpurModel(Model):
    """A pair of wheels on fixed axes; the driving one is named first."""

    kind: Literal["spur"]
    name: Label | None = Field(
        default=None, description="in the headings; left out, the numbers of the wheels"
    )
    ratio: Ratio = Field(examples=[-2])
    mesh: Literal["external", "internal"] | None = Field(
        default=None,
        description="says the pair in a word; left out, the sign of the ratio says it, and a plus is asked about",
    )
    module: Module = Field(description="of helical teeth, in the normal section", examples=["6 mm"])
    centre_distance: Span | None = Field(
        default=None, description="left out, it follows from the teeth and the shifts", examples=["130 mm"]
    )
    teeth: tuple[Tooth, Tooth] | None = Field(
        default=None, description="left out, they are found from the centre distance", examples=["[14, 28]"]
    )
    helix: Helix = 0.0
    width: Span | None = Field(default=None, description="face width, for the overlap of helical teeth")
    rack: RackModel = Field(default_factory=RackModel)
    shift: Shifts = Field(
        default="rule", description="how the shifts are divided: by (17 − z)/17, by the exact limit, …"
    )
    tip_shortening: Flag = Field(
        default=True,
        description="false: tips of full height whatever the clearance, of a ring whatever fillets they touch",
    )
    cutter: CutterModel | None = Field(
        default=None,
        description="left out, dimensions are those of wheels cut by a rack; a usual cutter of a ring is shown beside",
    )
    efficiency: Efficiency = 0.98
    sliding_limit: Sliding | None = Field(
        default=None,
        description="largest specific sliding; left out, 6 up to 15 m/s at the pitch line, falling to 3 at 20 m/s",
    )

    @model_validator(mode="before")
    @classmethod
    def turned(cls, written: Any) -> Any:
        """An external pair stated in a word has a minus, written or not."""
        ratio = written.get("ratio") if isinstance(written, dict) else None
        if isinstance(ratio, int | float) and ratio > 0 and written.get("mesh") == "external":
            return {**written, "ratio": -ratio}
        return written

    @model_validator(mode="after")
    def one_mesh(self) -> "SpurModel":
        if self.mesh == "internal" and self.ratio < 0:
            wrong = Message(
                N_("the wheels of an internal pair turn in the same sense: its ratio has no minus")
            )
            right = Message(N_("either ratio: %(ratio)s or mesh: external"), {"ratio": f"{-self.ratio:g}"})
            raise WrongValue(wrong, right)
        return self


def doubts(model: SpurModel, path: Path) -> Iterator[Problem]:
    """A ratio without a sign, as collections print it of external pairs too."""
    if model.mesh is None and model.ratio > 0:
        text = N_(
            "is the pair external or internal? A ratio of %(ratio)s without a minus is of an internal one"
        )
        right = Message(
            N_("write ratio: -%(ratio)s for an external pair, or mesh: internal"),
            {"ratio": f"{model.ratio:g}"},
        )
        yield doubt(text, (*path, "ratio"), right, ratio=f"{model.ratio:g}")


def build(model: SpurModel, wheels: tuple[str, ...], accuracy: float) -> spur.Given:
    """The stage with its wheels named, the driving one first; `accuracy`: of the drawing, m of paper."""
    return spur.Given(
        ratio=model.ratio,
        module=model.module,
        centre_distance=model.centre_distance,
        teeth=model.teeth,
        wheels=(wheels[0], wheels[1]),
        rack=Rack(model.rack.alpha, model.rack.ha, model.rack.c),
        helix=model.helix,
        width=model.width,
        shift=model.shift,
        shortened=model.tip_shortening,
        efficiency=model.efficiency,
        name=model.name or "",
        accuracy=accuracy,
        sliding_limit=model.sliding_limit,
        cutter=Cutter(model.cutter.z0, model.cutter.x0) if model.cutter else None,
    )

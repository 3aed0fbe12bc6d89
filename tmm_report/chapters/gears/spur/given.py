"""What a spur stage states, as it stands in the list of a drive's stages; SI."""

from __future__ import annotations

import math
import re
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from tmm_report.mechanics.gears import cutting, rack
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity import units
from tmm_report.quantity.paper import ACCURACY
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field, Tag

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        LIST,
        SCALAR,
        Efficiency,
        Flag,
        Helix,
        Module,
        Pin,
        Reads,
        Shift,
        ShiftOrRest,
        Span,
        Thinning,
        ToothOrRest,
        by_shape,
        quantity,
        whole,
    )

EQUAL = "equal sliding"
LEAST, MOST = 6, 1000  # teeth of a wheel


def signed_ratio(value: Any, limits: tuple[float, float], wrong: str, right: str) -> float:
    """A ratio of either sign whose magnitude is within the limits; `wrong`, `right`: what to say of another one."""
    number = units.parse(value, "number")
    low, high = limits
    if low <= abs(number) <= high:
        return number
    limited = {"low": f"{low:g}", "high": f"{high:g}"}
    raise WrongValue(Message(wrong, {"value": shown(value)}), Message(right, limited))


of_pair = partial(
    signed_ratio,
    limits=(0.02, 50.0),
    wrong=N_("no pair of wheels has the ratio %(value)s"),
    right=N_("from %(low)s to %(high)s, with a minus where the wheels turn in opposite senses"),
)
SIGN = {"type": "number", "description": "minus: an external pair, plus: an internal one"}


def with_rest(teeth: tuple[int, int], ratio: float | None) -> tuple[int, int]:
    """The teeth of both wheels, the rest, 0, by the ratio; without one it waits for the drive to divide its own."""
    one, two = teeth
    if not one + two:
        right = Message(N_("one of both, for example [20, rest]"))
        raise WrongValue(Message(N_("the teeth of both wheels are sought by one ratio")), right)
    if ratio is None or math.isnan(ratio) or one * two:
        return teeth
    found = math.floor((one * abs(ratio) if one else two / abs(ratio)) + 0.5)
    if not LEAST <= found <= MOST:
        wrong = N_("the ratio gives the other wheel %(teeth)s teeth: from %(least)s to %(most)s are possible")
        values = {"teeth": found, "least": LEAST, "most": MOST}
        raise WrongValue(Message(wrong, values), Message(N_("another ratio, or other teeth")))
    return one or found, two or found


@dataclass(frozen=True)
class Rack(rack.Rack):
    """The basic rack that cuts the teeth."""

    alpha: Annotated[
        float,
        quantity("angle", math.radians(10), math.radians(35), "10 … 35 deg"),
        Field(description="profile angle", examples=["20 deg"]),
    ] = math.radians(20)
    ha: Annotated[
        float,
        quantity("number", 0.2, 2.0, "0.2 … 2"),
        Field(alias="ha*", description="addendum, in modules"),
    ] = 1.0
    c: Annotated[
        float, quantity("number", 0.0, 1.0, "0 … 1"), Field(alias="c*", description="clearance, in modules")
    ] = 0.25


@dataclass(frozen=True)
class Cutter(cutting.Cutter):
    """A pinion cutter that cuts the ring of an internal pair, or both wheels of an external one."""

    z: Annotated[int, whole(6, 1000), Field(alias="z0", description="number of its teeth", examples=[20])]
    x: Annotated[
        Shift,
        Field(alias="x0", description="its own shift: above zero new, below zero worn", examples=[0.1]),
    ] = 0.0


@dataclass(frozen=True)
class Inspection:
    """By what the wheels are measured when they are cut, of each wheel in the order of `teeth`."""

    span: Annotated[
        tuple[Annotated[int, whole(1, 501)], Annotated[int, whole(1, 501)]] | None,
        Field(
            description="teeth that the span W holds, of a ring spaces; left out, by the rule",
            examples=["[3, 4]"],
        ),
    ] = None
    pins: Annotated[
        tuple[Pin, Pin] | None,
        Field(
            description="diameters of the pins or balls; left out, 1.7 modules", examples=["[10 mm, 10 mm]"]
        ),
    ] = None
    chords: Annotated[
        tuple[Span, Span] | None,
        Field(
            description="diameters on which the chordal thickness is measured; left out, the pitch circles",
            examples=["[84 mm, 168 mm]"],
        ),
    ] = None
    drawing_tables: Annotated[
        Flag, Field(description="true: the tables of GOST 2.403 for the drawings of both wheels")
    ] = False


GRADE = re.compile(r"(\d{1,2}(?:-\d{1,2}){0,2})-([ABCDEH])([xyzabcdh]?)(?:/(I{1,3}|IV|VI?))?")
LIKE_LATIN = str.maketrans("АВСЕН", "ABCEH")  # as Russian keyboards write the kinds of fit


def _grade(value: Any) -> str:
    """8-B, 8-7-6-Ba: degrees of accuracy and the kind of fit, as GOST 1643 writes them; the norm's numbers are not
    looked up."""
    text = "".join(str(value).split()).replace("–", "-").translate(LIKE_LATIN)
    match = GRADE.fullmatch(text)
    if match and all(1 <= int(degree) <= 12 for degree in match[1].split("-")):
        return text
    wrong = N_("%(value)s is no degree of accuracy with a kind of fit")
    right = Message(N_("degrees from 1 to 12 and a fit A, B, C, D, E or H: 8-B, 8-7-6-Ba"))
    raise WrongValue(Message(wrong, {"value": shown(value)}), right)


@dataclass(frozen=True)
class Backlash:
    """What backlash the pair has: its fit by name, and the numbers of the norm as the assignment states them."""

    grade: Annotated[
        Annotated[str, Reads(_grade, {"type": "string", "maxLength": 20, "examples": ["8-B"]})] | None,
        Field(description="degrees of accuracy and kind of fit by GOST 1643: for the drawings alone"),
    ] = None
    thinning: Annotated[
        Annotated[
            Annotated[Thinning, Tag(SCALAR)] | Annotated[tuple[Thinning, Thinning], Tag(LIST)],
            by_shape(N_("one length, or that of each wheel: [0.06 mm, 0.09 mm]")),
        ]
        | None,
        Field(
            description="least thinning of the teeth, on the pitch circle across them, of both wheels or of each; left "
            "out, what the guaranteed backlash asks for",
        ),
    ] = None
    tolerance: Annotated[
        Annotated[
            Annotated[Thinning, Tag(SCALAR)] | Annotated[tuple[Thinning, Thinning], Tag(LIST)],
            by_shape(N_("one length, or that of each wheel: [0.06 mm, 0.09 mm]")),
        ]
        | None,
        Field(description="by how much the teeth may be thinner still"),
    ] = None
    by: Annotated[
        Literal["thickness", "rack", "span"],
        Field(
            description="what the two lengths are of: the teeth, the shift of the rack E_H, or the span E_W"
        ),
    ] = "thickness"
    guaranteed: Annotated[
        Thinning | None,
        Field(description="least normal backlash that the pair must have", examples=["0.12 mm"]),
    ] = None
    axes: Annotated[
        Thinning | None,
        Field(description="by how much the centre distance may be longer or shorter", examples=["0.04 mm"]),
    ] = None

    def of_both(self, key: str) -> tuple[float, float] | None:
        """`thinning` or `tolerance` of each wheel."""
        stated = getattr(self, key)
        return stated if isinstance(stated, tuple) or stated is None else (stated, stated)


@dataclass(frozen=True)
class Quality:
    """How good the mesh is while the sum of the shifts is divided otherwise, or the centre distance is another."""

    x1: Annotated[
        Annotated[tuple[Shift, ...], Field(min_length=2, max_length=40)] | None,
        Field(
            description="shifts of wheel 1 at the centre distance of the pair, ascending; left out, round ones within "
            "the bounds",
            examples=["[0.3, 0.4, 0.5, 0.6, 0.7]"],
        ),
    ] = None
    centre_distances: Annotated[
        Annotated[tuple[Span, ...], Field(min_length=2, max_length=40)] | None,
        Field(
            description="at which the shifts are chosen anew, as the pair's are; ascending",
            examples=["[76 mm, 77 mm, 78 mm]"],
        ),
    ] = None
    least_tip: Annotated[
        float,
        quantity("number", 0.0, 1.0, "0 … 1"),
        Field(description="least thickness of the tips, in modules, that bounds the shifts"),
    ] = 0.3
    least_contact: Annotated[
        float,
        quantity("number", 1.0, 3.0, "1 … 3"),
        Field(description="least contact ratio that bounds the shifts"),
    ] = 1.05
    sliding: Annotated[
        Literal["own", "mate", "size"],
        Field(
            description="specific sliding by the velocity of the wheel itself, 1 - v_mate/v_own; by that of its mate, "
            "v_own/v_mate - 1; or the size of the first"
        ),
    ] = "own"


@dataclass(frozen=True)
class Spur:
    """A pair of wheels on fixed axes; the driving one is named first."""

    NOT_STATED: ClassVar = ("wheels", "accuracy", "by_teeth")
    LEFT_OUT: ClassVar = ("ratio",)

    kind: Literal["spur"] = field(default="spur", kw_only=True)
    name: Annotated[
        CalledBy | None, Field(description="in the headings; left out, the numbers of the wheels")
    ] = field(default=None, kw_only=True)
    ratio: Annotated[
        float, Reads(of_pair, SIGN), Field(description="left out, it is that of the teeth", examples=[-2])
    ]
    mesh: Annotated[
        Literal["external", "internal"] | None,
        Field(
            description="says the pair in a word; left out, the sign of the ratio says it, and a plus is asked about"
        ),
    ] = field(default=None, kw_only=True)
    module: Annotated[Module, Field(description="of helical teeth, in the normal section", examples=["6 mm"])]
    centre_distance: Annotated[
        Span | None,
        Field(description="left out, it follows from the teeth and the shifts", examples=["130 mm"]),
    ] = None
    teeth: Annotated[
        tuple[ToothOrRest, ToothOrRest] | None,
        Field(
            description="left out, they are found from the centre distance; one of both may be the rest: what the "
            "ratio makes of the other, rounded",
            examples=["[14, 28]", "[20, rest]"],
        ),
    ] = None
    coaxial: Annotated[
        Flag,
        Field(
            description="true: the driven shaft lies on the axis of the driving one of the pair before, whose centre "
            "distance this pair has"
        ),
    ] = False
    helix: Helix = 0.0
    width: Annotated[Span | None, Field(description="face width, for the overlap of helical teeth")] = None
    rack: Rack = field(default_factory=Rack)
    shift: Annotated[
        Annotated[Literal["rule", "limit", "equal sliding"], Tag(SCALAR)]
        | Annotated[tuple[ShiftOrRest, ShiftOrRest], Tag(LIST)],
        by_shape(N_("rule, limit, equal sliding or two shifts: [0.2, 0.5]")),
        Field(
            description="how the shifts are divided: by (17 − z)/17, by the exact limit, …; or both, of which one may "
            "be the rest: [0.42, rest]"
        ),
    ] = "rule"
    tip_shortening: Annotated[
        Flag,
        Field(
            description="false: tips of full height whatever the clearance, of a ring whatever fillets they touch"
        ),
    ] = True
    tip_diameters: Annotated[
        tuple[Span, Span] | None,
        Field(description="left out, they follow from the shifts", examples=["[78.9 mm, 164.8 mm]"]),
    ] = None
    cutter: Annotated[
        Cutter | None,
        Field(
            description="left out, dimensions are those of wheels cut by a rack; "
            "a usual cutter of a ring is shown beside"
        ),
    ] = None
    efficiency: Efficiency = 0.98
    sliding_limit: Annotated[
        Annotated[float, quantity("number", 0.5, 20.0, "0.5 … 20")] | None,
        Field(
            description="largest specific sliding; left out, 6 up to 15 m/s at the pitch line, falling to 3 at 20 m/s"
        ),
    ] = None
    inspection: Annotated[
        Inspection | None,
        Field(
            description="by what the wheels are measured, with the formulas; left out, a table of the usual sizes"
        ),
    ] = None
    backlash: Annotated[
        Backlash | None,
        Field(description="thinning of the teeth for a backlash: limits of the measured sizes"),
    ] = None
    quality: Annotated[
        Quality | None,
        Field(
            description="contact ratio, tips, sliding and pressure over the shifts and the centre distance"
        ),
    ] = None
    wheels: tuple[str, str] = field(default=("1", "2"), kw_only=True)  # their names in the drive
    by_teeth: bool = field(default=False, kw_only=True)  # whether the ratio is not stated
    accuracy: float = field(
        default=ACCURACY, kw_only=True
    )  # to which the drawing of the mesh is read, m of paper

    def __post_init__(self) -> None:
        """An external pair stated in a word has a minus, written or not; a ratio left out is that of the teeth."""
        if self.teeth is not None and 0 in self.teeth:
            object.__setattr__(self, "teeth", with_rest(self.teeth, self.ratio))
        elif math.isnan(self.ratio):
            object.__setattr__(self, "ratio", self._of_teeth())
            object.__setattr__(self, "by_teeth", True)
        if self.mesh == "external":
            object.__setattr__(self, "ratio", -abs(self.ratio))
        if self.mesh == "internal" and self.ratio < 0:
            wrong = N_("the wheels of an internal pair turn in the same sense: its ratio has no minus")
            right = Message(N_("either ratio: %(ratio)s or mesh: external"), {"ratio": f"{-self.ratio:g}"})
            raise WrongValue(Message(wrong), right)

    def _of_teeth(self) -> float:
        """The ratio; where no word says the pair, it is that which the centre distance is nearer to, else external."""
        if self.teeth is None:
            right = Message(N_("state ratio: -2, or teeth: [14, 28]"))
            raise WrongValue(Message(N_("neither the ratio nor the teeth are stated")), right)
        one, two = self.teeth
        internal = self.mesh == "internal"
        if self.mesh is None and self.centre_distance is not None:
            doubled = 2 * self.centre_distance * math.cos(self.helix) / self.module
            internal = one != two and abs(doubled - abs(two - one)) < abs(doubled - one - two)
        return two / one if internal else -two / one

    @property
    def rests(self) -> tuple[int, ...]:
        """Wheels, 0 or 1, whose shift is what the centre distance leaves: none, one, and by mistake both."""
        return tuple(i for i, x in enumerate(self.shift) if x != x) if isinstance(self.shift, tuple) else ()

    @property
    def internal(self) -> bool:
        return self.mesh == "internal" if self.open else self.ratio > 0

    @property
    def open(self) -> bool:
        """Whether its ratio is what the drive leaves it."""
        return math.isnan(self.ratio)

    @property
    def sense(self) -> int:
        """−1 where the wheels turn in opposite senses."""
        return 1 if self.internal else -1


Given = Spur

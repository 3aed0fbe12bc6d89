"""Single values of a variant: names, texts, numbers with units, directions; each reads and describes itself.

Numbers come out in SI, directions as unit complex numbers. A value that does not fit raises WrongValue.
"""

import cmath
import math
import re
from collections.abc import Callable, Mapping
from functools import partial
from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BaseModel, Discriminator, Field
from pydantic_core import core_schema

from tmm_report.mechanics.lever.synthesis import Wanted
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity import units
from tmm_report.quantity.text import Typed
from tmm_report.quantity.typed.alike import difference, readings
from tmm_report.quantity.units import DIMENSIONS, WrongValue
from tmm_report.records import dataclass
from tmm_report.variant.russian import english

NAME = r"[0-9A-Za-z\u0400-\u0481\u048a-\u052f][0-9A-Za-z\u0400-\u0481\u048a-\u052f'’]{0,11}"
_NAMING = r"[0-9A-Za-z\u0400-\u0481\u048a-\u052f'’]"  # what it is made of
LONGEST = 12  # letters of a name
SIDES = {"right": 1 + 0j, "up": 1j, "left": -1 + 0j, "down": -1j}
SENSES = {"counter-clockwise": 1, "clockwise": -1}
SCALAR, LIST, MAP = "<scalar>", "<list>", "<map>"

# What is larger is a slip of the pen, and overflows when it is squared or swallows the rest of the mechanism; SI.
_LARGEST = {"length": (1e6, "−10⁶ … 10⁶ m")}
# in which a bare number is often meant
_USUAL = {"length": ("mm", 1e-3), "angle": ("deg", math.pi / 180), "number": ("%", 1e-2)}
_LARGEST_OTHER = (1e12, "−10¹² … 10¹²")

_BIDI = set(map(chr, [*range(0x202A, 0x202F), *range(0x2066, 0x206A), 0x200E, 0x200F, 0x61C]))


def unit_vector(angle: float) -> complex:
    """cos + i sin of the angle, rad, with the rounding of right angles removed."""
    turned = cmath.rect(1.0, angle)
    return complex(
        *(round(part) if abs(part - round(part)) < 1e-15 else part for part in (turned.real, turned.imag))
    )


def _quantity(value: object, dimension: str, low: float, high: float, limits: str) -> float:
    number = units.parse(value, dimension)
    largest, range_ = _LARGEST.get(dimension, _LARGEST_OTHER)
    if low <= number <= high * (1 + 1e-12) and abs(number) <= largest:
        return number
    limits = range_ if abs(number) > largest else limits
    name = Message(DIMENSIONS[dimension].name)
    if limits:
        text = N_("%(value)s is out of range: %(name)s from %(limits)s is expected")
        wrong = Message(text, {"value": shown(value), "name": name, "limits": Typed(limits)})
        raise WrongValue(wrong, _usual(value, dimension, low, high))
    text = N_("%(value)s is negative: %(name)s cannot be")
    if low > 0:
        text = N_("%(value)s is negative or zero: %(name)s must be greater than zero")
    raise WrongValue(Message(text, {"value": shown(value), "name": name}))


def _usual(value: object, dimension: str, low: float, high: float) -> Message | None:
    """What is meant by a bare length that would do in millimetres, an angle in degrees, a fraction in per cent."""
    unit, size = _USUAL.get(dimension, ("", 0.0))
    if not size or not isinstance(value, int | float) or (unit == "%" and value <= 2):
        return None
    if low <= value * size <= high:
        return Message(N_("did you mean %(near)s?"), {"near": Typed(f"{value} {unit}")})
    return None


@dataclass(frozen=True)
class Named:
    """Marks a text that is made of names: B, 2-3, v_B."""

    names: bool = True


@dataclass(frozen=True, eq=False)
class Reads:
    """The metadata of a field's type: how what is written becomes its value, and what an editor is told."""

    read: Callable[[Any], Any]
    schema: Mapping[str, Any]
    dimension: str = ""  # of a number with a unit
    bounded: bool = False  # whether the number has a range of its own
    names: bool = False  # whether it is a name, or is made of names

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(self.value)

    def value(self, written: Any) -> Any:
        """What is written becomes. Raises WrongValue, with the letter that only looks like the right one."""
        try:
            return self.read(written)
        except WrongValue as error:
            if isinstance(written, str) and len(written) <= 60 and (meant := self._alike(written)):
                raise WrongValue(error.wrong, difference(written, meant)) from None
            raise

    def _alike(self, written: str) -> str | None:
        """What looks like the text and can be read."""
        for text in readings(written):
            try:
                self.read(text)
            except WrongValue:
                continue
            return text
        return None

    def __get_pydantic_json_schema__(self, core: Any, handler: Any) -> dict[str, Any]:
        return dict(self.schema)


@dataclass(frozen=True, eq=False)
class Words:
    """The metadata of a field's type: the words of which one may stand there, and what each of them becomes."""

    become: Mapping[str, Any]

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> core_schema.CoreSchema:
        one_of = core_schema.literal_schema([*self.become])
        return core_schema.no_info_after_validator_function(self.become.__getitem__, one_of)


def quantity(dimension: str, low: float = -math.inf, high: float = math.inf, limits: str = "") -> Reads:
    """A number with a unit: SI after validation; `limits` is the range as text, for messages."""
    about = DIMENSIONS[dimension]
    described = f"{about.name}: SI ({about.unit}) or text with a unit" + (f"; {limits}" if limits else "")
    schema = {
        "anyOf": [{"type": "number"}, {"type": "string", "pattern": r"^\s*[-+−]?[0-9.,]"}],
        "description": described,
        "examples": [about.example],
        "x-unit": about.unit,  # for the reference of the format: a field's own description takes the place of this one
        **({"x-range": limits} if limits else {}),
    }
    read = partial(_quantity, dimension=dimension, low=low, high=high, limits=limits)
    return Reads(read, schema, "" if dimension == "number" else dimension, bool(limits))


def _whole(value: object, low: int, high: int) -> int:
    number = units.parse(value, "number")
    if number != int(number) or not low <= number <= high:
        text = N_("%(value)s is out of range: a whole number from %(low)s to %(high)s is expected")
        raise WrongValue(Message(text, {"value": shown(value), "low": low, "high": high}))
    return int(number)


def whole(low: int, high: int) -> Reads:
    """A whole number in a range."""
    return Reads(partial(_whole, low=low, high=high), {"type": "integer", "minimum": low, "maximum": high})


def _flag(value: object) -> bool:
    if not isinstance(value, bool):
        wrong = Message(N_("%(value)s is neither true nor false"), {"value": _quoted(value)})
        raise WrongValue(wrong, Message(N_("write true or false")))
    return value


def _quoted(value: object) -> str:
    return shown(value) if isinstance(value, str | int | float) else "[…]"


def _is_name(text: str) -> bool:
    """Whether it is a `NAME`; a plain one is told without that, whose letters of two scripts take 5 ms to compile."""
    plain = text.isascii() and text.isalnum()
    return len(text) <= LONGEST if plain else re.fullmatch(NAME, text) is not None


def _name(value: object) -> str:
    text = str(value) if isinstance(value, str | int) and not isinstance(value, bool) else None
    if text is not None and _is_name(text):
        return text
    wrong = Message(N_("%(value)s is not a name"), {"value": _quoted(value)})
    if text and (odd := next((char for char in text if not re.fullmatch(_NAMING, char)), "")):
        told = {"value": _quoted(value), "char": f"«{shown(odd)}»"}
        wrong = Message(N_("%(value)s is not a name: %(char)s may not stand in one"), told)
    elif text and len(text) > LONGEST:
        told = {"value": _quoted(value), "count": str(len(text))}
        wrong = Message(N_("%(value)s is not a name: it has %(count)s letters"), told)
    raise WrongValue(wrong, Message(N_("letters, digits and ', at most 12, for example A or S2")))


def free_text(value: object) -> str:
    if not isinstance(value, str | int | float):
        raise WrongValue(Message(N_("a text is expected here")))
    text = " ".join(str(value).split())
    if len(text) > 200:
        raise WrongValue(Message(N_("the text is longer than %(limit)s characters"), {"limit": 200}))
    if any(ord(char) < 32 or char in _BIDI for char in text):
        raise WrongValue(Message(N_("%(value)s: control characters are not allowed"), {"value": shown(text)}))
    return text


_WAYS = (*SIDES, "along motion", "against motion")
_SIDE_OF = re.compile(r"(слева|справа) от\b")


def _direction(value: object) -> complex | str:
    value = english(value, _WAYS)
    if isinstance(value, str) and value.strip() in SIDES:
        return SIDES[value.strip()]
    if value in ("along motion", "against motion"):
        return str(value).split()[0]
    try:
        return unit_vector(units.parse(value, "angle"))
    except WrongValue as error:
        right = Message(N_("right, left, up, down, an angle (30 deg), along motion or against motion"))
        wrong = Message(N_("%(value)s is not a direction"), {"value": _quoted(value)})
        measured = isinstance(value, str) and value[:1].isdigit()  # say what is wrong with its unit
        raise WrongValue(error.wrong if measured else wrong, right) from None


def _fixed_direction(value: object) -> complex:
    direction = _direction(value)
    if isinstance(direction, str):
        wrong = Message(N_("%(value)s is not a fixed direction"), {"value": _quoted(value)})
        raise WrongValue(wrong, Message(N_("right, left, up, down or an angle (30 deg)")))
    return direction


def _choice(value: object) -> int | complex | tuple[str, str, str]:
    """What `mechanism.Assembly.choice` may be."""
    text = str(english(value, SIDES)).strip()
    text = _SIDE_OF.sub(lambda found: f"{english(found[1], SIDES)} of", text)
    if text in ("+", "+1", "1", "-", "-1"):
        return -1 if text.startswith("-") else 1
    if text in SIDES:
        return SIDES[text]
    if match := re.fullmatch(rf"(left|right) of ({NAME})-({NAME})", text):
        return match[1], match[2], match[3]
    wrong = Message(N_("%(value)s does not say which way the group is assembled"), {"value": _quoted(value)})
    raise WrongValue(wrong, Message(N_("right, left, up, down, +, -, left of A-C or right of A-C")))


def shape(value: object) -> str:
    return MAP if isinstance(value, dict | BaseModel) else LIST if isinstance(value, list | tuple) else SCALAR


def by_shape(right: str) -> Discriminator:
    """Tells a union apart by the shape of what is written. `right`: what to write instead."""
    return Discriminator(shape, custom_error_type="shape", custom_error_message=right)


def _ascending(pairs: Any) -> Any:
    """Pairs in ascending order; two with the same first number are a jump just after it."""
    firsts = [pair[0] for pair in pairs]
    if any(a > b for a, b in pairwise(firsts)) or any(
        a == b for a, b in zip(firsts, firsts[2:], strict=False)
    ):
        right = Message(N_("from the least to the greatest; two pairs at one place are a jump"))
        raise WrongValue(Message(N_("the first numbers of the pairs must ascend")), right)
    jumps = [False, *(a == b for a, b in pairwise(firsts))]
    return [
        (math.nextafter(x, math.inf) if jump else x, y) for (x, y), jump in zip(pairs, jumps, strict=True)
    ]


class Measured(list[tuple[float, float]]):
    """Pairs whose places are lengths of the stroke, m, or angles of the swing, rad, and not parts of it."""


class _Place(float):
    """A place that is written with its unit."""


def _place(value: object, dimension: str) -> float:
    """A part of the stroke, or a length of it, or an angle of a swing."""
    try:
        return _quantity(value, "number", 0.0, 1.0, "0 … 1")
    except WrongValue as error:
        try:
            found = _Place(_quantity(value, dimension, 0.0, math.inf, ""))
            _, unit = units.measured(value)
        except WrongValue:
            raise error from None
        if not unit:
            raise
        return found


def _along_the_stroke(pairs: Any) -> Any:
    """Pairs in ascending order, or in that in which the point comes back."""
    measured = {isinstance(x, _Place) for x, _ in pairs if x}
    if len(measured) > 1:
        right = Message(N_("all of them as parts, 0 … 1, or all with a unit"))
        raise WrongValue(Message(N_("some places are parts of the stroke, others have a unit")), right)
    back = len(pairs) > 1 and pairs[0][0] > pairs[-1][0]
    found = _ascending(pairs[::-1] if back else pairs)
    return Measured(found) if True in measured else found


_NAME = {"type": ["string", "integer"], "pattern": f"^{NAME}$", "examples": ["A"]}
_WORDS = {"type": ["string", "number"]}
_CURVE = (Field(min_length=1, max_length=1000), AfterValidator(_ascending))
_STROKE = (Field(min_length=1, max_length=1000), AfterValidator(_along_the_stroke))

_CALLED = re.compile(r"(log10|lg|ln|exp|sqrt|sin|cos|tan|tg)\s*(?:x|\(\s*x\s*\))")
_OTHERWISE = {"lg": "log10", "tg": "tan"}
_POWER = re.compile(r"x\s*(?:\^|\*\*)\s*\(?\s*([-+]?[0-9]+(?:[.,][0-9]+)?)\s*\)?")
_SHORT = {"x": 1.0, "x²": 2.0, "x³": 3.0, "1/x": -1.0, "1/x²": -2.0}


def _function(value: object) -> Wanted:
    """log10 x, x^1.5, 1/x: a small closed list, nothing is run."""
    text = " ".join(str(value).replace("−", "-").split())
    if match := _CALLED.fullmatch(text):
        return Wanted(_OTHERWISE.get(match[1], match[1]))
    if (short := _SHORT.get(text.replace(" ", ""))) is not None:
        return Wanted(power=short)
    if (match := _POWER.fullmatch(text)) and abs(power := float(match[1].replace(",", "."))) <= 20:
        return Wanted(power=power)
    wrong = Message(N_("%(value)s is not a function that is known here"), {"value": _quoted(value)})
    right = N_("log10 x, ln x, exp x, sqrt x, sin x, cos x, tan x, 1/x or a power such as x^1.5")
    raise WrongValue(wrong, Message(right))


def _plain_or_angle(value: object) -> float:
    try:
        return units.parse(value, "number")
    except WrongValue:
        return units.parse(value, "angle")


FunctionOfX = Annotated[
    Wanted, Reads(_function, {"type": "string", "maxLength": 40, "examples": ["log10 x"]})
]
_END = Reads(_plain_or_angle, {"anyOf": [{"type": "number"}, {"type": "string"}], "examples": [1]})
Within = tuple[Annotated[float, _END], Annotated[float, _END]]

Name = Annotated[str, Reads(_name, _NAME, names=True)]
KeyName = Annotated[str, Reads(_name, {"type": "string", "pattern": f"^{NAME}$"}, names=True)]
GroupName = Annotated[str, Field(max_length=60), Named()]
ReadingKey = Annotated[str, Field(max_length=40), Named()]
Reading = Annotated[
    tuple[float, str], Reads(units.measured, {"type": ["number", "string"], "examples": ["4.44 m/s"]})
]
PositionKey = Annotated[str, Field(pattern=r"^[0-9]{1,3}$")]
Text = Annotated[str, Reads(free_text, {"type": ["string", "number", "boolean", "null"], "maxLength": 200})]
Label = Annotated[str, Reads(free_text, {"type": ["string", "number"], "maxLength": 200})]

Flag = Annotated[bool, Reads(_flag, {"type": "boolean"})]

Length = Annotated[float, quantity("length")]
Positive = Annotated[float, quantity("length", 1e-9)]
Distance = Annotated[float, quantity("length", 0.0)]
Accuracy = Annotated[float, quantity("length", 1e-6, 2e-3, "0.001 … 2 mm")]
Mass = Annotated[float, quantity("mass", 0.0)]
Inertia = Annotated[float, quantity("inertia", 0.0)]
Acceleration = Annotated[float, quantity("acceleration", 0.0)]
Speed = Annotated[float, quantity("speed", 1e-12)]
Period = Annotated[float, quantity("time", 1e-12)]
Angle = Annotated[float, quantity("angle")]
TurnAngle = Annotated[float, quantity("angle", 0.0, 8 * math.pi, "0 … 1440 deg")]
Turned = Annotated[float, quantity("angle", 0.0, 48 * math.pi, "0 … 360 deg of every turn")]
Range = Annotated[float, quantity("angle", 1e-6, 2 * math.pi, "0 … 360 deg")]
Number = Annotated[float, quantity("number")]
Coefficient = Annotated[float, quantity("number", 0.0, 1.0, "0 … 1")]
StrokePlace = Annotated[
    float, Reads(partial(_place, dimension="length"), quantity("number", 0.0, 1.0, "0 … 1").schema)
]
SwingPlace = Annotated[
    float, Reads(partial(_place, dimension="angle"), quantity("number", 0.0, 1.0, "0 … 1").schema)
]
Scale = Annotated[float, quantity("number", 1e-12)]
ForceValue = Annotated[float, quantity("force")]
MomentValue = Annotated[float, quantity("moment")]
Pressure = Annotated[float, quantity("pressure")]
Velocity = Annotated[float, quantity("velocity")]
PositiveVelocity = Annotated[float, quantity("velocity", 1e-9)]
UnsignedVelocity = Annotated[float, quantity("velocity", 0.0)]
Power = Annotated[float, quantity("power", 0.0)]
Work = Annotated[float, quantity("work")]
Stiffness = Annotated[float, quantity("stiffness", 0.0)]
Damping = Annotated[float, quantity("damping", 0.0)]
TorsionalDamping = Annotated[float, quantity("torsional damping", 0.0)]
Density = Annotated[float, quantity("density", 1e-9)]
WearCoefficient = Annotated[float, quantity("wear", 0.0)]
Time = Annotated[float, quantity("time", 0.0)]
Part = Annotated[float, quantity("number", 0.0, 0.49, "0 … 0.49")]
Fraction = Annotated[float, quantity("number", 1e-12, 1.0, "0 … 1")]
PositiveMass = Annotated[float, quantity("mass", 1e-12)]
PositiveInertia = Annotated[float, quantity("inertia", 1e-12)]
SignedSpeed = Annotated[float, quantity("speed")]
Position = Annotated[int, whole(0, 360)]
TableCount = Annotated[int, whole(4, 360)]
DiagramCount = Annotated[int, whole(4, 720)]

TimeRatio = Annotated[float, quantity("number", 1.0, 10.0, "1 … 10")]
Swing = Annotated[float, quantity("angle", 1e-3, 2.9671, "0 … 170 deg")]
PressureAngle = Annotated[float, quantity("angle", 1e-3, 1.5621, "0 … 89.5 deg")]
TransmissionAngle = Annotated[float, quantity("angle", 1e-3, 1.5708, "0 … 90 deg")]

Point = tuple[Length, Length]
Pose = tuple[Length, Length, Angle]
AngleForces = Annotated[list[tuple[TurnAngle, ForceValue]], *_CURVE]
AngleMoments = Annotated[list[tuple[TurnAngle, MomentValue]], *_CURVE]
AnglePressures = Annotated[list[tuple[TurnAngle, Pressure]], *_CURVE]
TimeForces = Annotated[list[tuple[Time, ForceValue]], *_CURVE]
TimeMoments = Annotated[list[tuple[Time, MomentValue]], *_CURVE]
TimePressures = Annotated[list[tuple[Time, Pressure]], *_CURVE]
PlaceForces = Annotated[list[tuple[Length, ForceValue]], *_CURVE]
SpeedForces = Annotated[list[tuple[UnsignedVelocity, ForceValue]], *_CURVE]
StrokeForces = Annotated[list[tuple[StrokePlace, ForceValue]], *_STROKE]
StrokeMoments = Annotated[list[tuple[SwingPlace, MomentValue]], *_STROKE]
StrokeParts = Annotated[list[tuple[StrokePlace, Number]], *_STROKE]
StrokePressures = Annotated[list[tuple[StrokePlace, Pressure]], *_STROKE]

_TO = "right, left, up, down or an angle"
Direction = Annotated[
    complex | Literal["along", "against"],
    Reads(_direction, {**_WORDS, "description": f"{_TO}; along motion or against motion"}),
]
FixedDirection = Annotated[complex, Reads(_fixed_direction, {**_WORDS, "description": _TO})]
Choice = Annotated[
    Any,
    Reads(_choice, {"type": ["string", "integer"], "examples": ["right", "left of A-C", "+"]}, names=True),
]
Side = Annotated[complex, Words({side: SIDES[side] for side in ("right", "left", "up", "down")})]
Turning = Annotated[
    int | Literal["along", "against"],
    Words({"clockwise": -1, "counter-clockwise": 1, "along motion": "along", "against motion": "against"}),
]
Sense = Annotated[int, Words(SENSES)]
Turn = Literal["clockwise", "counter-clockwise"]

# --- of gears
Module = Annotated[float, quantity("length", 5e-5, 0.1, "0.05 … 100 mm")]
Span = Annotated[float, quantity("length", 1e-3, 20.0, "1 mm … 20 m")]
Pin = Annotated[float, quantity("length", 5e-5, 0.5, "0.05 … 500 mm")]
Thinning = Annotated[float, quantity("length", 0.0, 5e-3, "0 … 5 mm")]
Helix = Annotated[float, quantity("angle", 0.0, math.radians(45), "0 … 45 deg")]
Efficiency = Annotated[float, quantity("number", 0.01, 1.0, "0.01 … 1")]
Tooth = Annotated[int, whole(6, 1000)]


def _tooth_or_rest(value: Any) -> int:
    """0 of the rest."""
    return 0 if value in ("rest", "остаток") else _whole(value, 6, 1000)


ToothOrRest = Annotated[
    int, Reads(_tooth_or_rest, {"anyOf": [{"type": "integer"}, {"const": "rest"}]}, bounded=True)
]
Shift = Annotated[float, quantity("number", -5.0, 5.0, "−5 … 5")]


def _shift_or_rest(value: Any) -> float:
    """nan of the rest."""
    if value in ("rest", "остаток"):
        return math.nan
    return _quantity(value, "number", -5.0, 5.0, "−5 … 5")


ShiftOrRest = Annotated[
    float,
    Reads(
        _shift_or_rest,
        {
            "anyOf": [{"type": "number"}, {"const": "rest"}],
            "description": "−5 … 5, or rest: what the centre distance leaves",
        },
        bounded=True,
    ),
]


def _span_or_standard(value: Any) -> float | str:
    """Of a row of preferred numbers, or a stated size."""
    if value in ("standard", "стандартный", "стандартная"):
        return "standard"
    return _quantity(value, "length", 1e-3, 20.0, "1 mm … 20 m")


SpanOrWord = Annotated[
    float | Literal["standard"],
    Reads(
        _span_or_standard,
        {
            "anyOf": [
                {"type": "number"},
                {"type": "string", "pattern": r"^\s*[0-9.,]"},
                {"const": "standard"},
            ],
            "description": "a length, 1 mm … 20 m, or standard: the nearest of the row",
            "x-unit": "m",
        },
        bounded=True,
    ),
]
LinearMass = Annotated[float, quantity("linear mass", 1e-6, 100.0, "0.000001 … 100 kg/m")]

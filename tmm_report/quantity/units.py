"""Numbers with units, as a person writes them, to SI: `300 mm`, `1200 об/мин`, `0,0135 кг·м²`.

A bare number is in SI already; a fraction (2/3) is one, a moment of inertia may be a product
of a mass and the square of a radius of gyration."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from functools import lru_cache
from typing import NamedTuple

from tmm_report.problems import N_, Message, shown
from tmm_report.quantity.typed import alike

Exponents = tuple[int, int, int, int]  # of metre, kilogram, second, radian


class WrongValue(ValueError):
    """A value that cannot be what its place wants: what is wrong, what would be right; `inner`: at which key in it."""

    def __init__(self, wrong: Message, right: Message | None = None, inner: str | None = None):
        super().__init__(str(wrong))
        self.wrong, self.right, self.inner = wrong, right, inner


class Dimension(NamedTuple):
    """What a number measures: its name, exponents, SI unit and an example for messages."""

    name: str
    exponents: Exponents
    unit: str
    example: str


DIMENSIONS = {
    "length": Dimension(N_("a length"), (1, 0, 0, 0), N_("m"), N_("300 mm")),
    "mass": Dimension(N_("a mass"), (0, 1, 0, 0), N_("kg"), N_("1.5 kg")),
    "time": Dimension(N_("a time"), (0, 0, 1, 0), N_("s"), N_("0.05 s")),
    "angle": Dimension(N_("an angle"), (0, 0, 0, 1), N_("rad"), N_("20 deg")),
    "speed": Dimension(N_("an angular velocity"), (0, 0, -1, 1), N_("rad/s"), N_("1200 rpm")),
    "acceleration": Dimension(N_("an acceleration"), (1, 0, -2, 0), N_("m/s^2"), N_("9.81 m/s^2")),
    "angular acceleration": Dimension(
        N_("an angular acceleration"), (0, 0, -2, 1), N_("rad/s^2"), N_("5 rad/s^2")
    ),
    "force": Dimension(N_("a force"), (1, 1, -2, 0), N_("N"), N_("2 kN")),
    "moment": Dimension(N_("a moment of force"), (2, 1, -2, 0), N_("N*m"), N_("50 N*m")),
    "pressure": Dimension(N_("a pressure"), (-1, 1, -2, 0), N_("Pa"), N_("1.2 MPa")),
    "inertia": Dimension(N_("a moment of inertia"), (2, 1, 0, 0), N_("kg*m^2"), N_("0.0135 kg*m^2")),
    "velocity": Dimension(N_("a velocity"), (1, 0, -1, 0), N_("m/s"), N_("1.5 m/s")),
    "power": Dimension(N_("a power"), (2, 1, -3, 0), N_("W"), N_("5.5 kW")),
    "work": Dimension(N_("a work"), (2, 1, -2, 0), N_("J"), N_("400 J")),
    "stiffness": Dimension(N_("a stiffness"), (0, 1, -2, 0), N_("N/m"), N_("20 kN/m")),
    "damping": Dimension(N_("a damping"), (0, 1, -1, 0), N_("N*s/m"), N_("400 N*s/m")),
    "torsional stiffness": Dimension(
        N_("a torsional stiffness"), (2, 1, -2, -1), N_("N*m/rad"), N_("500 N*m/rad")
    ),
    "torsional damping": Dimension(
        N_("a torsional damping"), (2, 1, -1, -1), N_("N*m*s/rad"), N_("2 N*m*s/rad")
    ),
    "density": Dimension(N_("a density"), (-3, 1, 0, 0), N_("kg/m^3"), N_("7850 kg/m^3")),
    "linear mass": Dimension(N_("a mass by a length"), (-1, 1, 0, 0), N_("kg/m"), N_("0.18 kg/m")),
    "wear": Dimension(N_("a wear coefficient"), (1, -1, 2, 0), N_("1/Pa"), N_("1e-15 1/Pa")),
    "slowness": Dimension(N_("a number by a velocity"), (-1, 0, 1, 0), N_("s/m"), N_("0.02 s/m")),
    "number": Dimension(N_("a plain number"), (0, 0, 0, 0), "1", "0.1"),
}

_NONE = (0, 0, 0, 0)
_FORCE, _PRESSURE, _WORK, _POWER = (1, 1, -2, 0), (-1, 1, -2, 0), (2, 1, -2, 0), (2, 1, -3, 0)
_TURN, _TURN_RATE = (0, 0, 0, 1), (0, 0, -1, 1)
_RPM = 2 * math.pi / 60

_TABLE: list[tuple[str, float, Exponents]] = [  # the names of a unit, its factor to SI, its exponents
    ("m м", 1, (1, 0, 0, 0)),
    ("km км", 1e3, (1, 0, 0, 0)),
    ("dm дм", 1e-1, (1, 0, 0, 0)),
    ("cm см", 1e-2, (1, 0, 0, 0)),
    ("mm мм", 1e-3, (1, 0, 0, 0)),
    ("um µm μm мкм", 1e-6, (1, 0, 0, 0)),
    ("kg кг", 1, (0, 1, 0, 0)),
    ("g г", 1e-3, (0, 1, 0, 0)),
    ("t т", 1e3, (0, 1, 0, 0)),
    ("lb", 0.45359237, (0, 1, 0, 0)),
    ("in дюйм", 0.0254, (1, 0, 0, 0)),
    ("ft фут", 0.3048, (1, 0, 0, 0)),
    ("s с sec сек", 1, (0, 0, 1, 0)),
    ("ms мс", 1e-3, (0, 0, 1, 0)),
    ("min мин хв", 60, (0, 0, 1, 0)),
    ("h ч час год сағ", 3600, (0, 0, 1, 0)),
    ("rad рад", 1, _TURN),
    ("deg ° º град", math.pi / 180, _TURN),
    ("rev r turn turns об айн оборот оборота оборотов", 2 * math.pi, _TURN),
    ("rpm", _RPM, _TURN_RATE),
    ("Hz Гц", 2 * math.pi, _TURN_RATE),
    ("N Н", 1, _FORCE),
    ("kN кН", 1e3, _FORCE),
    ("MN МН", 1e6, _FORCE),
    ("kgf кгс", 9.80665, _FORCE),  # exactly: the third CGPM's acceleration of free fall
    ("tf тс", 9806.65, _FORCE),
    ("lbf", 4.4482216152605, _FORCE),
    ("Nm Нм", 1, _WORK),  # a product whose sign was left out
    ("kNm кНм", 1e3, _WORK),
    ("Nmm Нмм", 1e-3, _WORK),
    ("Pa Па", 1, _PRESSURE),
    ("kPa кПа", 1e3, _PRESSURE),
    ("MPa МПа", 1e6, _PRESSURE),
    ("GPa ГПа", 1e9, _PRESSURE),
    ("bar бар", 1e5, _PRESSURE),
    ("psi", 6894.757293168362, _PRESSURE),
    ("J Дж", 1, _WORK),
    ("kJ кДж", 1e3, _WORK),
    ("W Вт", 1, _POWER),
    ("kW кВт", 1e3, _POWER),
    ("%", 1e-2, _NONE),
]
UNITS = {name: (factor, exponents) for names, factor, exponents in _TABLE for name in names.split()}
# "кн", "КВТ", "мпа": no two units of Cyrillic letters differ by capitals alone; of Latin ones mm and Mm do
_ANY_CASE = {name.casefold(): size for name, size in UNITS.items() if re.fullmatch("[А-яЁё]{2,}|[НГ]", name)}
_CUT = re.compile(
    r"(об|мин|хв|сек|рад|град|час|год|ч|кгс)\.(?![^\W\d_])"
)  # words cut short, with their point

_SHOWN = {  # (unit of the results, unit of print) -> factor
    ("m", "mm"): 1e3, ("m²", "mm²"): 1e6, ("rad", "deg"): 180 / math.pi, ("deg", "rad"): math.pi / 180,
    ("W", "kW"): 1e-3, ("Pa", "MPa"): 1e-6, ("rad/s", "rpm"): 30 / math.pi, ("", "%"): 1e2,
    ("m", "µm"): 1e6, ("N", "kN"): 1e-3, ("J", "kJ"): 1e-3, ("N·m", "kN·m"): 1e-3, ("N/m", "kN/m"): 1e-3,
    ("kg·m", "kg·mm"): 1e3, ("m³", "mm³"): 1e9, ("kg", "g"): 1e3, ("s", "ms"): 1e3, ("N/m", "N/mm"): 1e-3,
}  # fmt: skip


def factor(given: str, wanted: str) -> float:
    """By what a number in one unit is multiplied to be in the other. Raises KeyError for a pair not foreseen."""
    return 1.0 if given == wanted else _SHOWN[given, wanted]


_NUMBER = re.compile(r"([-+]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?)\s*(.*)")
_FRACTION = re.compile(r"\s*([-+−]?[0-9][0-9.,]*)\s*/\s*([0-9][0-9.,]*)\s*")
_GYRATION = re.compile(r"\s*([^()*]+?)\s*\*?\s*\(([^()]+)\)\s*(?:\^|\*\*)?\s*2\s*")
_FACTOR = re.compile(r"([^\W\d_]+|[°%])(?:\^?([-+]?[0-9]))?")
_TIMES = re.compile(r"\s*[*.]\s*|\s+|(?<=[^\W\d_])-(?=[^\W\d_])")  # N*m, N.m, N m, N-m
_PLAIN = str.maketrans("−·⋅∙•×⁻⁰¹²³⁴", "-*****-01234", "\N{NO-BREAK SPACE}\N{NARROW NO-BREAK SPACE}")


def parse(value: object, dimension: str) -> float:
    """The value in SI: a number, or a text "number unit" of the dimension, one of `DIMENSIONS`.

    A decimal comma is a decimal point; a bare number may be a quotient: 1/4.5.
    Raises WrongValue for what is no number, is not finite, or has another dimension; the error names both units.
    """
    wanted = DIMENSIONS[dimension]
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise _not_a_number(value, wanted)
    if dimension == "inertia" and (gyration := _of_gyration(value)) is not None:
        return gyration
    number, unit = _split(value, wanted) if isinstance(value, str) else (_float(value), "")
    try:
        factor, exponents = _unit(unit, wanted) if unit else (1.0, wanted.exponents)
    except WrongValue as error:
        raise WrongValue(error.wrong, _cure(str(value), dimension) or error.right) from None
    if not _agree(exponents, wanted.exponents):
        raise _other_dimension(value, unit, exponents, wanted)
    factor = _turning(factor, exponents, wanted.exponents)
    if not math.isfinite(number * factor):
        raise _not_a_number(value, wanted)
    return number * factor


def _cure(text: str, dimension: str) -> Message | None:
    """What to write in place of a text whose unit is unknown."""
    from tmm_report.quantity.typed import mistyped  # only a mistake needs it

    if sign := mistyped.sign(text):
        return sign
    if (near := mistyped.corrected(text, UNITS)) is None:
        return None
    try:
        parse(near, dimension)
    except WrongValue:
        return None
    return Message(N_("write %(text)s"), {"text": shown(near)})


def measured(value: object) -> tuple[float, str]:
    """The number and the unit of a value as it is written, "" for none. Raises WrongValue for what is no number."""
    wanted = DIMENSIONS["number"]
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise _not_a_number(value, wanted)
    number, unit = _split(value, wanted) if isinstance(value, str) else (_float(value), "")
    if not math.isfinite(number):
        raise _not_a_number(value, wanted)
    return number, unit.strip()


def between(given: str, wanted: str) -> float:
    """By what a number in a unit as a person writes it is multiplied to be in the other: ("мм/с", "m/s") -> 0.001.

    Raises WrongValue for an unknown unit, or one that measures something else.
    """
    if given.strip() == wanted:
        return 1.0
    asked = Dimension(N_("a number"), _NONE, wanted, f"12,3 {wanted}".strip())
    (size, exponents), (own, needed) = _spelled(given, asked), _quotients(wanted, asked)
    if not (_agree(exponents, needed) or _agree(needed, exponents)):
        text = N_("%(given)s does not measure what is asked: expected %(unit)s")
        raise WrongValue(Message(text, {"given": shown(given), "unit": wanted or "1"}))
    return _turning(size, exponents, needed) / own


def is_unit(text: str) -> bool:
    """Whether a text is a unit, as `between` takes it."""
    try:
        _spelled(text, DIMENSIONS["number"])
    except WrongValue:
        return False
    return bool(text.strip())


def _spelled(text: str, asked: Dimension) -> tuple[float, Exponents]:
    """A unit as a person spells it: with letters of another alphabet that look the same, too. Raises WrongValue."""
    try:
        return _quotients(text, asked)
    except WrongValue as error:
        for reading in alike.readings(text):
            with suppress(WrongValue):
                return _quotients(reading, asked)
        raise error


def _quotients(text: str, asked: Dimension) -> tuple[float, Exponents]:
    """Factor and exponents of a unit with any number of quotients: `(m/s)/mm`, `N/(N·m)`; "" is a plain number."""
    plain = text.strip().translate(_PLAIN)
    if not plain:
        return 1.0, _NONE
    if len(plain) > 40:
        raise _unknown_unit(text, asked)
    over, *under = _CUT.sub(r"\1", re.sub(r"[()\[\]]", "", plain)).replace("**", "^").split("/")
    factor, total = (1.0, _NONE) if over.strip() in ("", "1") else _product(over, 1, text, asked)
    for part in under:
        size, exponents = _product(part, -1, text, asked)
        factor, total = factor * size, _sum(total, exponents)
    return factor, total


def _float(value: float) -> float:
    try:
        return float(value)
    except OverflowError:  # an int beyond every float
        return math.inf


def _split(text: str, wanted: Dimension) -> tuple[float, str]:
    if (quotient := _fraction(text, wanted)) is not None:
        return quotient, ""
    match = _NUMBER.fullmatch(text.strip().translate(_PLAIN)) if len(text) <= 60 else None
    if match is None:
        raise _not_a_number(text, wanted)
    return float(match[1].replace(",", ".")), match[2]


def _of_gyration(value: object) -> float | None:
    """`60 kg * (200 mm)^2`: mass and radius of gyration; None of anything else. Raises WrongValue."""
    text = value.translate(_PLAIN) if isinstance(value, str) and len(value) <= 60 else ""
    match = _GYRATION.fullmatch(text)
    return parse(match[1], "mass") * parse(match[2], "length") ** 2 if match else None


def _fraction(text: str, wanted: Dimension) -> float | None:
    """2/3, 1/0.2: a quotient of plain numbers; None of anything else. Raises WrongValue for one by zero."""
    if len(text) > 20 or not (match := _FRACTION.fullmatch(text)):
        return None
    over, under = (_split(part, wanted) for part in match.groups())
    if over[1] or under[1]:
        return None
    if not under[0]:
        wrong = Message(N_("%(value)s: nothing can be divided by zero"), {"value": shown(text)})
        raise WrongValue(wrong, _example(wanted))
    return over[0] / under[0]


@lru_cache(maxsize=1000)  # a file has many numbers of few units
def _unit(text: str, wanted: Dimension) -> tuple[float, Exponents]:
    """Factor and exponents of products and powers with at most one quotient: `kg*m^2`, `об/мин`, `м/с2`."""
    over, *under = _CUT.sub(r"\1", text).replace("**", "^").split("/")
    if len(under) > 1:
        raise _unknown_unit(text, wanted)
    reciprocal = bool(under) and over.strip() == "1"
    factor, total = (1.0, _NONE) if reciprocal else _product(over, 1, text, wanted)
    if under:
        divisor, below = _product(under[0], -1, text, wanted)
        factor, total = factor * divisor, _sum(total, below)
    return factor, total


def _product(text: str, sign: int, whole: str, wanted: Dimension) -> tuple[float, Exponents]:
    factor, total = 1.0, _NONE
    for part in _TIMES.split(text.strip()):
        match = _FACTOR.fullmatch(part)
        known = match and (UNITS.get(match[1]) or _ANY_CASE.get(match[1].casefold()))
        if match is None or known is None:
            raise _unknown_unit(whole, wanted)
        power = sign * int(match[2] or 1)
        size, exponents = known
        factor, total = factor * size**power, _sum(total, exponents, power)
    return factor, total


def _turning(size: float, given: Exponents, wanted: Exponents) -> float:
    """The size of a unit of speed, where minutes alone mean turns: 1/min and мин⁻¹ are rpm, as 1/s is rad/s."""
    per_minute = given == (0, 0, -1, 0) and wanted == _TURN_RATE and math.isclose(size, 1 / 60)
    return _RPM if per_minute else size


def _sum(a: Exponents, b: Exponents, times: int = 1) -> Exponents:
    return (a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2], a[3] + times * b[3])


def _agree(given: Exponents, wanted: Exponents) -> bool:
    """Equal, or equal but for a radian left out of a compound unit: `1/s` is `rad/s`."""
    return given == wanted or (given[:3] == wanted[:3] and any(given[:3]) and given[3] == 0)


def _not_a_number(value: object, wanted: Dimension) -> WrongValue:
    quoted = shown(value) if isinstance(value, int | float | str) else "[…]"
    wrong = Message(N_("%(value)s is not a number; expected: %(name)s (%(unit)s)"), _naming(wanted, quoted))
    return WrongValue(wrong, _example(wanted))


def _unknown_unit(text: str, wanted: Dimension) -> WrongValue:
    wrong = Message(N_("unknown unit %(value)s; expected: %(name)s (%(unit)s)"), _naming(wanted, shown(text)))
    return WrongValue(wrong, _example(wanted))


def _other_dimension(value: object, unit: str, exponents: Exponents, wanted: Dimension) -> WrongValue:
    names = [dimension.name for dimension in DIMENSIONS.values() if dimension.exponents == exponents]
    values = {**_naming(wanted, shown(value)), "given": shown(unit)}
    if not names:
        wrong = Message(N_("%(value)s is in %(given)s; expected: %(name)s (%(unit)s)"), values)
    else:
        text = N_("%(value)s is %(is)s (%(given)s); expected: %(name)s (%(unit)s)")
        wrong = Message(text, {**values, "is": Message(names[0])})
    return WrongValue(wrong, _weight(str(value), unit, exponents, wanted.exponents) or _example(wanted))


def _weight(text: str, unit: str, given: Exponents, wanted: Exponents) -> Message | None:
    """What is meant by kilograms in place of a force, as old collections print it, or by the weight of a mass."""
    from tmm_report.quantity.text import Amount  # with numpy: only what is told wrong needs it

    free_fall = (1, 0, -2, 0)
    if given == _FORCE and wanted == (0, 1, 0, 0):
        mass = parse(text, "force") / UNITS["kgf"][0]
        return Message(
            N_("%(weight)s is the weight of a mass of %(mass)s"),
            {"weight": shown(text), "mass": Amount(mass, 9, "kg")},
        )
    if _sum(given, free_fall) == wanted and (kilogram := re.search("kg|к[гГ]", unit)):
        force = unit.replace(kilogram[0], "kgf" if kilogram[0] == "kg" else "кгс", 1)
        return Message(N_("did you mean %(near)s?"), {"near": shown(f"{measured(text)[0]:.15g} {force}")})
    return None


def _naming(wanted: Dimension, value: str) -> dict[str, object]:
    return {"value": value, "name": Message(wanted.name), "unit": Message(wanted.unit)}


def _example(wanted: Dimension) -> Message:
    return Message(N_("for example, %(example)s"), {"example": Message(wanted.example)})

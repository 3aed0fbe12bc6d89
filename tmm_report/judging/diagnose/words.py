"""What a mistake is called before the student and the teacher."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tmm_report.judging.diagnose.candidates import Mistake
from tmm_report.judging.diagnose.single import ROTATION
from tmm_report.judging.model import Asked, Cause, Expected, Name
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity.symbols import GREEK

MOST = 8  # columns named in a sentence

_SENTENCES = {
    "sign": N_("%(columns)s: the opposite sign all along"),
    "modulus": N_("%(columns)s: magnitudes given where the sign is asked too"),
    "scale": N_("%(columns)s: all numbers are %(factor)s times the right ones: the scale of the polygon"),
    "mass for weight": N_("%(columns)s: mass given for weight"),
    "weight for mass": N_(
        "%(columns)s: the numbers are g = 9.81 times the right ones: weight taken for mass"
    ),
    "coriolis": N_("%(columns)s: half the right ones: the Coriolis acceleration without its 2"),
    "rows": N_("%(columns)s: the rows of positions %(rows)s stand in each other's place"),
    "reversed": N_("%(columns)s: positions counted the other way round"),
    "variant": N_("%(columns)s: the numbers of variant %(id)s"),
}
_UNITS = {
    ("mm for m", True): N_("%(columns)s: millimetres given for metres"),
    ("mm for m", False): N_("%(columns)s: taken from millimetres to metres once too often"),
    ("rpm for rad/s", True): N_("%(columns)s: rpm given for rad/s"),
    ("rpm for rad/s", False): N_("%(columns)s: rad/s given for rpm"),
    ("turns for radians", False): N_("%(columns)s: revolutions a second given for rad/s"),
    ("radius for diameter", False): N_("%(columns)s: radii given for diameters"),
    ("radius for diameter", True): N_("%(columns)s: diameters given for radii"),
    ("degrees for radians", True): N_("%(columns)s: degrees given for radians"),
    ("degrees for radians", False): N_("%(columns)s: radians given for degrees"),
    ("power of ten", True): N_("%(columns)s: the numbers are %(factor)s times too great: a decimal place or a unit"),
    ("power of ten", False): N_("%(columns)s: the numbers are %(factor)s times too small: a decimal place or a unit"),
    ("factor", True): N_("%(columns)s: the numbers are twice the right ones: a factor of 2"),
    ("factor", False): N_("%(columns)s: the numbers are half the right ones: a factor of 2"),
}  # fmt: skip
_SPEEDS = {
    "9.549": N_("%(columns)s: as if n in rpm were ω in rad/s, 9.55 times as much"),
    "0.1592": N_("%(columns)s: as if revolutions a second were ω in rad/s"),
    "60": N_("%(columns)s: as if ω were 2πn, not divided by 60"),
}
AHEAD = N_(
    "%(columns)s: positions counted %(steps)s further than they are: in row 0 stands what belongs to position %(steps)s"
)
BEHIND = N_(
    "%(columns)s: positions counted %(steps)s short: in row %(steps)s stands what belongs to position 0"
)
TURNED = N_("%(columns)s: the driving link was turned in the opposite sense")
SWAPPED = N_("the columns %(one)s and %(other)s are swapped")
COMPONENTS = N_("%(one)s and %(other)s: normal and tangential component are swapped")
NORMAL = N_("%(columns)s: normal component given for the tangential one")
TANGENTIAL = N_("%(columns)s: tangential component given for the normal one")
MORE = N_("%(columns)s and %(count)s more")


def sentence(mistake: Mistake, names: Sequence[Name], expected: Expected) -> Message:
    """The likely mistake, with the columns that it explains named by their symbols."""
    columns = named(names, expected)
    if mistake.kind in ("swapped", "component"):
        return _pair(mistake, names, expected)
    if mistake.kind == "shifted":
        text = AHEAD if mistake.by > 0 else BEHIND
        return Message(text, {"columns": columns, "steps": f"{abs(mistake.by):.0f}"})
    if mistake.kind == "variant":
        return Message(_SENTENCES["variant"], {"columns": columns, "id": shown(mistake.detail)})
    if mistake.kind == "scale":
        return Message(_SENTENCES["scale"], {"columns": columns, "factor": mistake.detail})
    if mistake == ROTATION:
        return Message(TURNED, {"columns": columns})
    if mistake.kind == "speed":
        return Message(_SPEEDS[mistake.detail.rstrip("²")], {"columns": columns})
    if mistake.kind == "rows":
        return Message(_SENTENCES["rows"], {"columns": columns, "rows": mistake.detail})
    if mistake.kind in _SENTENCES:
        return Message(_SENTENCES[mistake.kind], {"columns": columns})
    by = abs(mistake.by)
    text = _UNITS[mistake.kind, by > 1]
    factor = {"factor": f"{max(by, 1 / by):.0f}"} if mistake.kind == "power of ten" else {}
    return Message(text, {"columns": columns, **factor})


def of_some(cause: Cause, names: Sequence[Name], expected: Expected) -> Cause | None:
    """A cause said of some of its columns alone; None where there are none, or where it is of two together."""
    if not names or "columns" not in cause.what.values:
        return None
    columns = named(names, expected)
    mended = {name: cause.mended[name] for name in names if name in cause.mended}
    what = Message(cause.what.text, {**cause.what.values, "columns": columns})
    return replace(cause, names=tuple(names), what=what, mended=mended)


def _pair(mistake: Mistake, names: Sequence[Name], expected: Expected) -> Message:
    one, other = (_symbol(expected[name]) if name in expected else name[1] for name in mistake.names)
    if mistake.kind == "swapped":
        return Message(SWAPPED, {"one": one, "other": other})
    if len(names) == 2:
        return Message(COMPONENTS, {"one": one, "other": other})
    tangential = "_t" in names[0][1][-4:]
    return Message(NORMAL if tangential else TANGENTIAL, {"columns": _symbol(expected[names[0]])})


def named(names: Sequence[Name], expected: Expected) -> str | Message:
    """Columns by their symbols, the first of many."""
    symbols = list(dict.fromkeys(_symbol(expected[name]) for name in names))
    text = ", ".join(symbols[:MOST])
    return text if len(symbols) <= MOST else Message(MORE, {"columns": text, "count": len(symbols) - MOST})


def _symbol(asked: Asked) -> str:
    """A column's symbol in plain text: ω_2, a_BA_t; its key where it is never written as one."""
    symbol = asked.quantity.symbol
    if symbol is None:
        return shown(asked.key)
    return shown(
        "_".join(part for part in (GREEK.get(symbol.base, symbol.base), symbol.sub, symbol.sup) if part)
    )

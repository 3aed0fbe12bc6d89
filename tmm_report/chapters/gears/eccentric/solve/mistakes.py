"""What may be wrong with the data of an eccentric epicyclic mechanism, each in one sentence with what would work."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from tmm_report.chapters.gears.eccentric.given import Given
from tmm_report.mechanics.gears.eccentric import mechanism as ecc
from tmm_report.mechanics.gears.rack_mistakes import of_rack
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

PATH = ("eccentric",)
FEWEST = 6  # teeth
PLAY = 0.2  # modules: the largest backlash
ROUNDING = 1e-6  # in halves of a module: what writing a length with units may leave


def _at(key: str) -> tuple[str, ...]:
    return (*PATH, key)


def halves(given: Given) -> float:
    """2e/m as it was written."""
    return 2 * (given.eccentricity or 0.0) / given.module


def _mm(length: float) -> str:
    return f"{1e3 * length:.6g}"


# --- what is given


def check(given: Given) -> None:
    """Mistakes seen before anything is solved. Raises ProblemError with all of them."""
    teeth = list(_teeth(given)) if given.teeth else list(_missing(given))
    problems = [*teeth, *_eccentricity(given), *_ratio(given), *_cut(given)]
    if problems:
        raise ProblemError(problems)


def _missing(given: Given) -> Iterator[Problem]:
    if given.ratio is None:
        right = Message(N_("write it, for example ratio: 4, or the teeth: [34, 60, 136]"))
        yield mistake(N_("the ratio of ring and sun is not stated"), _at("ratio"), right)
    if given.eccentricity is None:
        right = Message(N_("write it, for example eccentricity: 18 mm, or the teeth: [34, 60, 136]"))
        yield mistake(N_("the eccentricity is not stated"), _at("eccentricity"), right)


def _ratio(given: Given) -> Iterator[Problem]:
    if given.ratio is not None and given.ratio <= 1:
        right = Message(N_("the ring has more teeth than the sun: a ratio above 1, for example 4"))
        wrong = N_("the ratio z3/z1 = %(ratio)s leaves no room between sun and ring")
        yield mistake(wrong, _at("ratio"), right, ratio=str(given.ratio))


def _eccentricity(given: Given) -> Iterator[Problem]:
    if given.eccentricity is None:
        return
    E = halves(given)
    low = max(1, math.floor(E))
    if round(E) < 1 or abs(E - round(E)) > ROUNDING:
        lengths = [_mm(n * given.module / 2) for n in (low, low + 1)]
        wrong = N_(
            "the eccentricity %(e)s mm is not a whole number of half modules, so no teeth can be whole"
        )
        right = Message(
            N_("with the module %(m)s mm it may be %(low)s mm or %(high)s mm"),
            {"m": _mm(given.module), "low": lengths[0], "high": lengths[1]},
        )
        yield mistake(wrong, _at("eccentricity"), right, e=_mm(given.eccentricity))


def _cut(given: Given) -> Iterator[Problem]:
    """The rack and the backlash."""
    yield from of_rack(given.rack, _at("rack"))
    if given.backlash > PLAY * given.module:
        right = Message(N_("a backlash up to %(most)s mm"), {"most": _mm(PLAY * given.module)})
        wrong = N_("a backlash of %(backlash)s mm leaves too little of the teeth")
        yield mistake(wrong, _at("backlash"), right, backlash=_mm(given.backlash))


def _teeth(given: Given) -> Iterator[Problem]:
    sun, *largest, ring = given.teeth or []
    if ring <= sun:
        right = Message(N_("sun, largest planet gear, ring, for example [34, 60, 136]"))
        wrong = N_("the ring of %(ring)s teeth cannot go round the sun of %(sun)s")
        yield mistake(wrong, _at("teeth"), right, sun=sun, ring=ring)
    elif largest:
        yield from _three(given, sun, largest[0], ring)
    elif given.eccentricity is None:
        right = Message(N_("add the largest planet gear in the middle, [34, 60, 136], or the eccentricity"))
        yield mistake(N_("sun and ring alone do not give the eccentricity"), _at("teeth"), right)
    else:
        yield from _two(given, sun, ring)
    if ring > sun:
        yield from _other_ratio(given, sun, ring)


def _two(given: Given, sun: int, ring: int) -> Iterator[Problem]:
    """Sun and ring with a stated eccentricity: the satellites follow, and some of them are whole."""
    E = round(halves(given))
    if (ring - sun) % 2 and E % 2 == 0:
        right = Message(
            N_("an eccentricity of %(low)s mm or %(high)s mm would work"),
            {key: _mm(n * given.module / 2) for key, n in (("low", max(E - 1, 2 - E % 2)), ("high", E + 1))},
        )
        wrong = N_(
            "with %(sun)s and %(ring)s teeth the largest planet gear and the middle ones would have half a tooth"
        )
        yield mistake(wrong, _at("teeth"), right, sun=sun, ring=ring)
    if ring - sun - E < 2 * FEWEST:
        most = ring - sun - 2 * FEWEST
        right = (
            Message(
                N_("an eccentricity up to %(most)s mm would work"), {"most": _mm(most * given.module / 2)}
            )
            if most > 0
            else Message(N_("a larger ring would work"))
        )
        wrong = N_(
            "at the eccentricity %(e)s mm the wheels of %(sun)s and %(ring)s teeth leave no room for the smallest "
            "planet gear"
        )
        shown = {"e": _mm(given.eccentricity or 0.0), "sun": sun, "ring": ring}
        yield mistake(wrong, _at("eccentricity"), right, **shown)


def _three(given: Given, sun: int, largest: int, ring: int) -> Iterator[Problem]:
    E, middle = 2 * largest + sun - ring, (ring - sun) / 2
    if E < 1 or largest - E < FEWEST:
        low, high = math.floor(middle) + 1, math.floor(2 * middle - FEWEST)
        values = {"low": low, "high": high}
        right = (
            Message(N_("with this sun and ring from %(low)s to %(high)s teeth"), values)
            if low <= high
            else Message(N_("a larger ring would work"))
        )
        wrong = N_("a largest planet gear of %(z)s teeth leaves no room for the smallest or no eccentricity")
        yield mistake(wrong, _at("teeth"), right, z=largest)
    elif given.eccentricity is not None and abs(halves(given) - E) > ROUNDING:
        right = Message(N_("leave one of them out"))
        wrong = N_("the teeth give the eccentricity %(own)s mm, but %(e)s mm is stated")
        own = _mm(E * given.module / 2)
        yield mistake(wrong, _at("eccentricity"), right, own=own, e=_mm(given.eccentricity))


def _other_ratio(given: Given, sun: int, ring: int) -> Iterator[Problem]:
    """A stated ratio that is not that of the stated teeth."""
    if given.ratio is not None and not _near(given, given.ratio, Fraction(ring, sun)):
        right = Message(N_("leave one of them out"))
        wrong = N_("the teeth give the ratio %(own)s, but %(ratio)s is stated")
        yield mistake(
            wrong,
            _at("ratio"),
            right,
            own=f"{ring / sun:.6g}",
            ratio=str(given.ratio),
        )


def _near(given: Given, wanted: Fraction, own: Fraction) -> bool:
    """Whether the ratio of the teeth is the stated one, or within its tolerance."""
    return wanted == own or abs(own / wanted - 1) <= (given.tolerance or 0.0) * (1 + 1e-9)


# --- what comes out


def no_solution(u: Fraction, E: int, module: float) -> ProblemError:
    """No whole teeth for this ratio and eccentricity: the nearest eccentricities that have them."""
    works = [n for n in range(1, 2 * E + 3) if ecc.general_solution(ecc.equation(u, n))]
    near = sorted(works, key=lambda n: abs(n - E))[:2]
    values = {"e": _mm(E * module / 2), "ratio": str(u)}
    right = Message(
        N_(
            "an eccentricity of %(low)s mm or %(high)s mm would work, or satellites: [middle], which go together at "
            "this one without the largest and the smallest"
        ),
        {"low": _mm(min(near) * module / 2), "high": _mm(max(near) * module / 2)},
    )
    wrong = Message(N_("no whole numbers of teeth give the ratio %(ratio)s at %(e)s mm"), values)
    return ProblemError([Problem(wrong, right, _at("eccentricity"))])


def not_in_family(t: int, known: Any) -> ProblemError:
    wrong = N_("the family has no usable set at t = %(t)s")
    values = {"low": int(known[0]), "high": int(known[-1])}
    return ProblemError([mistake(wrong, _at("t"), Message(N_("t from %(low)s to %(high)s"), values), t=t)])


def too_wide(given: Given, widest: float) -> ProblemError:
    """The clearance is more than any two satellites leave, `widest`, m."""
    wrong = N_("no two planet gears of a set leave a clearance of %(delta)s mm")
    right = Message(N_("a clearance under %(most)s mm would work"), {"most": f"{1e3 * widest:.4g}"})
    return ProblemError([mistake(wrong, _at("clearance"), right, delta=_mm(given.clearance))])


def nothing_fits(given: Given, E: int, most: int, smaller: int | None, ring: int | None) -> ProblemError:
    """No set holds two satellites. `smaller`: 2e/m with which one does; `ring`: the least ring that helps."""
    values = {"e": _mm((smaller or 0) * given.module / 2), "ring": ring}
    text = N_("an eccentricity of %(e)s mm, or ring_up_to: %(ring)s would work")
    if ring is None:
        text = N_("an eccentricity of %(e)s mm would work")
    elif smaller is None:
        text = N_("ring_up_to: %(ring)s would work")
    right = Message(text, values) if smaller or ring else Message(N_("a larger ratio would work"))
    wrong = N_(
        "at the eccentricity %(e)s mm no set with a ring of at most %(most)s teeth holds two planet gears"
    )
    shown = {"e": _mm(E * given.module / 2), "most": most}
    return ProblemError([mistake(wrong, _at("eccentricity"), right, **shown)])


def no_satellite(given: Given, family: ecc.Family, sound: int | None, kinds: set[str]) -> ProblemError:
    """The set has none of the satellites asked for, or none that keeps the conditions; `sound`: a set that has some."""
    if given.satellites is not None:
        known = ", ".join(kind for kind in ("largest", "middle", "smallest") if kind in kinds)
        wrong = N_("the set has no planet gear of this kind with a whole number of teeth")
        right = Message(N_("one of: %(words)s"), {"words": known})
        return ProblemError([mistake(wrong, _at("satellites"), right)])
    right = Message(N_("more teeth on the sun would work"))
    if sound is not None:
        largest = float(family.satellites[sound, 0])
        between = [int(largest)] if largest.is_integer() else []
        teeth = [int(family.sun[sound]), *between, int(family.ring[sound])]
        right = Message(N_("the teeth %(teeth)s would work"), {"teeth": str(teeth)})
    wrong = N_("in this set the ring cuts into the teeth of every planet gear, or all of them are undercut")
    return ProblemError([mistake(wrong, _at("teeth" if given.teeth else "t"), right)])

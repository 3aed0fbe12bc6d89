"""What lowers the shaking moment that a balance of the force leaves: wheels geared to links, weights in antiphase."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmm_report.chapters.machine.balancing.given import COUPLES, INERTIA, NONE, Given, order_of
from tmm_report.chapters.machine.balancing.solve.cases import CLOSED, ORIGINAL, Case, Ground
from tmm_report.chapters.machine.balancing.solve.substituted_masses import turning
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.masses.counterweights import pivoted
from tmm_report.mechanics.masses.shaking_moment import Couple, couple, least_square, uneven
from tmm_report.problems import N_, Message, ProblemError, mistake

NOTHING = 1e-10  # of the greatest moment: a harmonic that is rounding


def cases(ground: Ground, given: Given, before: Sequence[Case]) -> Iterator[Case]:
    """The methods against the moment, each on what the one before leaves. `before`: the mechanism as it is, and the
    ways of balancing its force."""
    if not {INERTIA, COUPLES} & set(given.ways):
        return
    base = chosen(given, before)
    if INERTIA in given.ways:
        ratios = _ratios(ground, given)
        wheels = least_square(ground.motions[2], ratios, base.cycle.moment)
        base = ground.with_moment(INERTIA, base, wheels=tuple(wheels))
        yield base
    if COUPLES in given.ways and given.couples:
        yield ground.with_moment(COUPLES, base, couples=tuple(_couples(ground, given, base)))


def chosen(given: Given, before: Sequence[Case]) -> Case:
    """The case to which wheels and weights are added: stated, or the one that leaves least of the force; of those that
    leave nothing of it the one with the least moment. Raises ProblemError for one that is not there."""
    after = ORIGINAL if given.after == NONE else given.after
    found = [case for case in before if after is None or case.name.split("_")[0] == after]
    if not found:
        text = N_(
            "the way of balancing %(way)s, after which the moment is to be balanced, is not among those found"
        )
        ways = dict.fromkeys(case.name.split("_")[0] for case in before)
        words = ", ".join(NONE if way == ORIGINAL else way for way in ways)
        right = Message(N_("one of: %(words)s"), {"words": words})
        raise ProblemError([mistake(text, ("balancing", "after"), right, way=given.after)])
    nothing = CLOSED * before[0].force_max.value

    def left(case: Case) -> tuple[float, float]:
        force = case.force_max.value
        return force if force > nothing else 0.0, case.moment_max.value

    return min(found, key=left)


def _ratios(ground: Ground, given: Given) -> dict[str, float]:
    """By link that turns unevenly. Raises ProblemError for stated ones that do not."""
    fixed, motion = pivoted(ground.linkage.structure.pairs), ground.motions[2]
    turn = [link for link in ground.linkage.mechanism.moving if link in turning(ground.linkage)]
    found = uneven(motion, turn)
    if not given.wheels:
        return {link: -1.0 if link in fixed else 1.0 for link in found}
    right = Message(N_("one of: %(words)s"), {"words": ", ".join(found)})
    text = N_("link %(link)s does not turn unevenly: a wheel geared to it gives no moment")
    problems = [
        mistake(text, ("balancing", "wheels", link), right, link=link)
        for link in given.wheels
        if link not in found
    ]
    if problems:
        raise ProblemError(problems)
    return dict(given.wheels)


def _couples(ground: Ground, given: Given, base: Case) -> Iterator[Couple]:
    """A pair of weights against every stated order of the moment."""
    orders = {order_of(key): one for key, one in given.couples.items()}
    moment, sense = base.cycle.moment, ground.cycle.sense
    spectrum = fourier.series(moment, max(orders))
    for order, one in sorted(orders.items()):
        harmonic = complex(spectrum.cosine[order], -spectrum.sine[order])
        kept = harmonic if abs(harmonic) > NOTHING * base.moment_max.value else 0j
        yield couple(kept, order, sense, ground.omega, one.radius, one.distance)

"""The fewest mistakes that explain the wrong columns best."""

from __future__ import annotations

from collections.abc import Iterable

from tmm_report.judging.diagnose.candidates import Candidate, Claim
from tmm_report.judging.model import Name

CLEARLY = (
    0.12  # of the answered cells: a mistake that explains a column worse by more than that has no claim to it
)


def chosen(candidates: Iterable[Candidate]) -> list[Candidate]:
    """One mistake after another, each the one that explains most of what is left; each column goes to one mistake."""
    all_of_them = sorted(candidates, key=_order)
    best = _best(all_of_them)
    left = {name for one in all_of_them for name, claim in one.claims.items() if claim.firm}
    taken: set[Name] = set()
    found: list[Candidate] = []
    while left:
        worth = [(_worth(one, left, best), one) for one in all_of_them]
        most, one = max(worth, key=lambda pair: pair[0])  # of equal ones the first
        if most <= 0:
            break
        claims = _claims(one, left, best) | _followers(one, taken | left, best)
        found.append(Candidate(one.mistake, claims))
        left -= claims.keys()
        taken |= claims.keys()
    return found


def _order(candidate: Candidate) -> tuple[float, str, str, tuple[Name, ...]]:
    mistake = candidate.mistake
    return mistake.cost, mistake.kind, mistake.detail, mistake.names


def _best(candidates: list[Candidate]) -> dict[Name, float]:
    """The best score that any mistake gives each column."""
    best: dict[Name, float] = {}
    for candidate in candidates:
        for name, claim in candidate.claims.items():
            best[name] = max(best.get(name, 0.0), claim.score)
    return best


def _claims(one: Candidate, left: set[Name], best: dict[Name, float]) -> dict[Name, Claim]:
    """The columns still unexplained that are as well explained by this mistake as by any, or nearly."""
    claims = {
        name: claim
        for name, claim in one.claims.items()
        if claim.firm and name in left and claim.score >= best[name] - CLEARLY * claim.answered
    }
    whole = one.mistake.kind != "swapped" or len(claims) == 2
    return claims if whole else {}


def _followers(one: Candidate, known: set[Name], best: dict[Name, float]) -> dict[Name, Claim]:
    """Columns with too few wrong cells to be accused alone, mended by a mistake made in the whole work."""
    return {
        name: claim
        for name, claim in one.claims.items()
        if not claim.firm and name not in known and claim.score >= best[name] - CLEARLY * claim.answered
    }


def _worth(one: Candidate, left: set[Name], best: dict[Name, float]) -> float:
    claims = _claims(one, left, best)
    return sum(claim.gain for claim in claims.values()) - one.mistake.cost if claims else 0.0

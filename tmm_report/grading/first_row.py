"""Position 0 of a closed cycle is the last one again, and may be answered there."""

from __future__ import annotations

from dataclasses import replace

from tmm_report.judging.model import Answered, Answers, Expected


def full_turn(answers: Answers, asked: Expected) -> Answers:
    """The same where position 0 is answered by the last one alone, which it is: who numbers from 1 to 12 says 12."""
    columns = {name: _begun(one) if asked[name].by_position else one for name, one in answers.columns.items()}
    return replace(answers, columns=columns)


def _begun(one: Answered) -> Answered:
    if one.given[0] or not one.given[-1]:
        return one
    values, given = one.values.copy(), one.given.copy()
    values[0], given[0] = values[-1], True
    texts, places = (one.texts[-1], *one.texts[1:]), (one.places[-1], *one.places[1:])
    return replace(one, values=values, given=given, texts=texts, places=places)

"""What the mechanism takes of the synthesis: `A: synthesis.crank`, `angle: synthesis.guide_angle`."""

from __future__ import annotations

from collections.abc import Mapping

from tmm_report.mechanics.lever.stated_masses import Letter, Statement, Synthesised, lettered, worked
from tmm_report.problems import N_, Message
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Read

Taken = Mapping[str, Synthesised] | None
"""What the synthesis offers, by its keys; None where the file has none, nothing where it has mistakes."""


def offered(read: Read) -> Taken:
    if "synthesis" not in read.data:
        return None
    from tmm_report.chapters.lever.synthesis.block import numbers  # only such a file needs it

    return numbers(read)


class Elsewhere(WrongValue):
    """What is wrong of another link, and is told there."""


OTHERS = {"guide_angle": "angle", "crank_angle": "angle", "crank_way": "angle", "speed": "speed"}
"""What the synthesis offers that is no length, by what it measures."""


def taken(letter: Synthesised, offered: Taken, measures: str = "length") -> Synthesised:
    """The number of the synthesis that a letter names. Raises WrongValue."""
    if offered is None:
        wrong = Message(N_("there is no synthesis whose number could be taken"))
        raise WrongValue(wrong, Message(N_("state the block synthesis, or the length: 120 mm")))
    if not offered:
        raise Elsewhere(Message(N_("the synthesis has a mistake")))
    if letter.key not in offered:
        wrong = Message(N_("the synthesis finds no %(key)s"), {"key": letter.key})
        raise WrongValue(wrong, _offer(offered, measures))
    if (own := OTHERS.get(letter.key, "length")) != measures:
        names = (Message(units.DIMENSIONS[one].name) for one in (own, measures))
        wrong = Message(
            N_("synthesis.%(key)s is %(is)s; expected: %(name)s"),
            {"key": letter.key, **dict(zip(("is", "name"), names, strict=True))},
        )
        raise WrongValue(wrong, _offer(offered, measures))
    return offered[letter.key]


def _offer(offered: Mapping[str, Synthesised], measures: str) -> Message | None:
    """What of the synthesis measures that."""
    words = [f"synthesis.{key}" for key in offered if OTHERS.get(key, "length") == measures]
    return one_of(words) if words else None


def coordinate(stated: float | Statement, offered: Taken) -> float:
    """Of a fixed point, m. Raises WrongValue."""
    if isinstance(stated, float):
        return stated

    def length(letter: Letter) -> float:
        if isinstance(letter, Synthesised):
            return taken(letter, offered).number
        wrong = Message(N_("places in the frame follow from no links"))
        raise WrongValue(wrong, Message(N_("a number, or one of the synthesis: synthesis.frame")))

    return float(worked(stated, length))


def placed(stated: Statement, offered: Taken) -> Statement:
    """The statement of a coordinate with the numbers that it takes. Raises WrongValue."""
    return lettered(
        stated, lambda letter: taken(letter, offered) if isinstance(letter, Synthesised) else letter
    )


def direction(stated: float | Synthesised, offered: Taken) -> float:
    """Of a guide or of the driving link, or its turn, rad. Raises WrongValue."""
    return taken(stated, offered, "angle").number if isinstance(stated, Synthesised) else stated


def turning(stated: float | Synthesised, offered: Taken) -> float:
    """Angular velocity of the driving link, rad/s. Raises WrongValue."""
    return taken(stated, offered, "speed").number if isinstance(stated, Synthesised) else stated


def one_of(words: list[str]) -> Message:
    return Message(N_("one of %(words)s"), {"words": ", ".join(words[:6])})

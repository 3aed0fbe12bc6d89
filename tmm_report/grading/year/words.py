"""Kinds of mistakes in words, for lists in which each has a few words: gradebook, statistics."""

from __future__ import annotations

from tmm_report.grading.model import ABSENT, HELD, UNREAD, Digest, Override
from tmm_report.problems import N_, Message, shown

KEYS = 6  # so many columns of one cause are named
_SAID = {
    "sign": N_("opposite sign"),
    "modulus": N_("magnitudes in place of signed values"),
    "mm for m": N_("millimetres in place of metres"),
    "rpm for rad/s": N_("revolutions per minute in place of rad/s"),
    "turns for radians": N_("revolutions per second in place of rad/s"),
    "speed": N_("n in place of ω"),
    "degrees for radians": N_("degrees in place of radians"),
    "power of ten": N_("a power of ten"),
    "factor": N_("twice or half"),
    "scale": N_("scale of the polygon"),
    "mass for weight": N_("mass in place of weight"),
    "weight for mass": N_("weight in place of mass"),
    "coriolis": N_("Coriolis acceleration without its 2"),
    "radius for diameter": N_("radii in place of diameters"),
    "rows": N_("rows in each other's place"),
    "shifted": N_("positions shifted"),
    "reversed": N_("positions counted the other way round"),
    "swapped": N_("columns in each other's place"),
    "component": N_("normal and tangential components confused"),
    "variant": N_("numbers of another variant"),
    "sense": N_("another positive sense"),
    "assembly": N_("the other assembly"),
    "datum": N_("another number than the assignment's"),
}


_STATES = {
    ABSENT: N_("not handed in"),
    UNREAD: N_("could not be read"),
    HELD: N_("not marked: the mark set by hand is none"),
    "": N_("not marked"),
}


def state_text(digest: Digest) -> Message | None:
    """Why a work was not marked, in a few words; None of one that was."""
    return None if digest.judged else Message(_STATES.get(digest.state, _STATES[""]))


def attempt_text(digest: Digest) -> Message | None:
    """Which attempt counts, where there were several."""
    values = {"attempt": digest.attempt, "attempts": digest.attempts}
    return Message(N_("attempt %(attempt)s of %(attempts)s"), values) if digest.attempts > 1 else None


def override_text(override: Override) -> Message:
    """That a mark was set by hand, and why."""
    if not override.reason:
        return Message(N_("set by hand"))
    return Message(N_("set by hand: %(reason)s"), {"reason": shown(override.reason, 200)})


def kind_text(kind: str) -> Message:
    """A kind of mistake; one without words of its own is said as it is."""
    return Message(_SAID[kind]) if kind in _SAID else Message("%(kind)s", {"kind": shown(kind)})


def cause_text(cause: tuple[str, str, tuple[str, ...]], private: bool = False) -> Message:
    """A cause of a digest: what, and in which columns. `private`: for the teacher, whose variant it is, too."""
    kind, detail, keys = cause
    what: Message = kind_text(kind)
    if (kind, detail) == ("reversed", "rotation"):
        what = Message(N_("the driving link turned in the opposite sense"))
    if kind == "datum":
        what = Message(N_("another number than the assignment's (%(datum)s)"), {"datum": shown(detail, 80)})
    if kind == "variant" and detail and private:
        what = Message(N_("numbers of the variant of %(other)s"), {"other": shown(detail, 80)})
    more = ", …" if len(keys) > KEYS else ""
    names = ", ".join(shown(key) for key in keys[:KEYS]) + more
    return Message(N_("%(what)s: %(names)s"), {"what": what, "names": names}) if keys else what

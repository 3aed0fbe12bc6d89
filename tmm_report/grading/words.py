"""Kinds of mistakes in words, for lists in which each has a few words: gradebook, statistics."""

from __future__ import annotations

from tmm_report.problems import N_, Message, shown

KEYS = 6  # so many columns of one cause are named
_SAID = {
    "sign": N_("opposite sign"),
    "modulus": N_("magnitudes in place of signed values"),
    "mm for m": N_("millimetres in place of metres"),
    "rpm for rad/s": N_("revolutions per minute in place of rad/s"),
    "degrees for radians": N_("degrees in place of radians"),
    "power of ten": N_("a power of ten"),
    "factor": N_("twice or half"),
    "scale": N_("scale of the plan"),
    "mass for weight": N_("mass in place of weight"),
    "shifted": N_("positions shifted"),
    "reversed": N_("positions counted the other way round"),
    "swapped": N_("columns in each other's place"),
    "component": N_("normal and tangential components confused"),
    "variant": N_("numbers of another variant"),
}


def kind_text(kind: str) -> Message:
    """A kind of mistake; one without words of its own is said as it is."""
    return Message(_SAID[kind]) if kind in _SAID else Message("%(kind)s", {"kind": shown(kind)})


def cause_text(cause: tuple[str, str, tuple[str, ...]], private: bool = False) -> Message:
    """A cause of a digest: what, and in which columns. `private`: for the teacher, whose variant it is, too."""
    kind, detail, keys = cause
    what: Message = kind_text(kind)
    if kind == "variant" and detail and private:
        what = Message(N_("numbers of the variant of %(other)s"), {"other": shown(detail, 80)})
    more = ", …" if len(keys) > KEYS else ""
    names = ", ".join(shown(key) for key in keys[:KEYS]) + more
    return Message(N_("%(what)s: %(names)s"), {"what": what, "names": names}) if keys else what

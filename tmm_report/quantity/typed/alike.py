"""Letters of different scripts, and letters and digits, that look alike on the screen and are other characters."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from tmm_report.problems import N_, Message, shown

_CYRILLIC = "АВЕКМНОРСТХУІЈЅаеоркстхуіјѕԛԝһӏ"
_ITS_LATIN = "ABEKMHOPCTXYIJSaeopkctxyijsqwhl"
_GREEK = "ΑΒΕΖΗΙΚΜΝΟΡΤΥΧοινκρυ"
_THEIR_LATIN = "ABEZHIKMNOPTYXoivkpu"
_LATIN = str.maketrans(_CYRILLIC + _GREEK + "З", _ITS_LATIN + _THEIR_LATIN + "3")
# "т" is no "t" and "к" is a smaller "k": taken for one in a word of other look-alikes all the same
_UNIT = {**dict(zip(_ITS_LATIN, _CYRILLIC, strict=True)), "m": "м", "b": "б", "n": "п", "r": "г", "u": "и"}
_TO_CYRILLIC = str.maketrans(_UNIT)
_DIGITS = str.maketrans("OoОоΟlIІӏЗб", "00000" + "1111" + "36")
_NUMBER = re.compile(r"\s*[-+−]?[0-9OoОоΟlIІӏЗб.,]*[0-9][0-9OoОоΟlIІӏЗб.,]*|\s*[OoОоΟ][.,][0-9OoОо]+")
_SCRIPTS = {
    "LATIN": N_("the Latin letter %(char)s"),
    "CYRILLIC": N_("the Cyrillic letter %(char)s"),
    "GREEK": N_("the Greek letter %(char)s"),
    "FULLWIDTH": N_("the full-width %(char)s"),
    "DIGIT": N_("the digit %(char)s"),
}


def latin(text: str) -> str:
    """The text with what looks like a Latin letter or an ordinary digit made one."""
    return text if text.isascii() else unicodedata.normalize("NFKC", text).translate(_LATIN)


def skeleton(text: str) -> str:
    """Equal of all texts that look alike, letters and digits too: O and 0; l, I and 1."""
    return latin(text).translate(_DIGITS)


def readings(text: str) -> Iterator[str]:
    """What a text may have been meant to be: in Latin letters, its unit in Cyrillic ones, its number in digits."""
    number = _NUMBER.match(text)
    end = number.end() if number else 0
    digits = text[:end].translate(_DIGITS)
    rest = text[end:]
    tried = {text}
    for other in (latin(text), digits + rest, text[:end] + rest.translate(_TO_CYRILLIC)):
        if other not in tried:
            tried.add(other)
            yield other


def difference(wrong: str, right: str) -> Message:
    """What tells two texts that look alike, by their first difference."""
    if len(wrong) != len(right):  # a character that stands for two
        return Message(N_("write %(right)s with other letters"), {"right": shown(right)})
    one, other = next((a, b) for a, b in zip(wrong, right, strict=True) if a != b)
    text = N_("write %(right)s, with %(other)s and not %(one)s")
    return Message(text, {"right": shown(right), "one": described(one), "other": described(other)})


def described(char: str) -> Message:
    """A character by its script: "the Cyrillic letter А"."""
    script = unicodedata.name(char, "").split(" ")[0]
    text = _SCRIPTS.get(script, N_("the character %(char)s"))
    return Message(text, {"char": shown(char)})


def script(text: str) -> Message:
    """The script of a name in a word: Latin, Cyrillic, Greek, or letters and digits of several."""
    found = {unicodedata.name(char, "?").split(" ")[0] for char in text if char.isalpha()}
    words = {"LATIN": N_("Latin"), "CYRILLIC": N_("Cyrillic"), "GREEK": N_("Greek")}
    if not found:
        return Message(N_("digits"))
    return Message(words.get(found.pop(), N_("other letters")) if len(found) == 1 else N_("mixed letters"))

"""Endings of Kazakh nouns: what a word of the note has behind it, put behind another by harmony and by its last sound.

    other("айналшақ", "ғының", "иінді")      # "иіндісінің": of the crank, its third person

A noun takes the plural, the ending of possession and a case, in this order; each is chosen by the last vowel (back or
front) and by the last sound. Source: the usual school grammar; what is not such a chain stays as it is.
"""

from __future__ import annotations

import re

BACK, FRONT = "аоұыуяёю", "әеөүіиэ"
VOWELS = "аәеёоөұүыіэюя"  # у and и behind them end a word as й does
SOFTENED = {"қ": "ғ", "к": "г", "п": "б"}  # before a vowel
CLASSES = {"glide": "рйуи", "l": "л", "nasal": "мнң", "hum": "жз"}  # all other consonants are voiceless here
FIRST = {  # of each ending its first letter, by the last sound
    "plural": {"vowel": "л", "glide": "л", "l": "д", "nasal": "д", "hum": "д", "voiceless": "т"},
    "of": {"vowel": "н", "glide": "д", "l": "д", "nasal": "н", "hum": "д", "voiceless": "т"},
    "object": {"vowel": "н", "glide": "д", "l": "д", "nasal": "д", "hum": "д", "voiceless": "т"},
    "in": {"vowel": "д", "glide": "д", "l": "д", "nasal": "д", "hum": "д", "voiceless": "т"},
    "from": {"vowel": "д", "glide": "д", "l": "д", "nasal": "н", "hum": "д", "voiceless": "т"},
    "by": {"vowel": "м", "glide": "м", "l": "м", "nasal": "м", "hum": "б", "voiceless": "п"},
    "having": {"vowel": "л", "glide": "л", "l": "д", "nasal": "д", "hum": "д", "voiceless": "т"},
}
CHAIN = re.compile(
    r"(?P<plural>[лдт][ае]р)?(?P<its>с?[ыі])?"
    r"(?:(?P<being>н?[дт][ае]ғы|н?[дт][ае]гі)|(?P<of>[ндт][ыі]ң)|(?P<from>[ндт][ае]н)|(?P<in>н?[дт][ае])"
    r"|(?P<to>[ғгқкн][ае])|(?P<object>[ндт][ыі]|(?<=[ыі])н)|(?P<by>[мбп]ен)|(?P<having>л[ыі])|(?P<without>с[ыі]з))?"
)


def other(word: str, ending: str, own: str) -> str:
    """`own` with the ending that the note's word has."""
    if word[-1:] in SOFTENED and ending[:1] == SOFTENED[word[-1]]:
        ending = ending[1:]
    found = CHAIN.fullmatch(ending)
    if found is None:
        return own + ending
    said = own
    if found["plural"]:
        said += FIRST["plural"][_sound(said)] + ("ар" if _is_back(said) else "ер")
    if found["its"]:
        said = _its(said)
    case = next((name for name in (*FIRST, "being", "to", "without") if name != "plural" and found[name]), "")
    return said + _case(case, said, bool(found["its"])) if case else said


def _its(said: str) -> str:
    narrow = "ы" if _is_back(said) else "і"
    if _sound(said) == "vowel":
        return said + "с" + narrow
    return said[:-1] + SOFTENED.get(said[-1], said[-1]) + narrow


def _case(case: str, said: str, possessed: bool) -> str:
    back = _is_back(said)
    broad, narrow = ("а", "ы") if back else ("е", "і")
    first = FIRST.get(case, {}).get(_sound(said), "")
    if possessed:
        first = {"in": "нд", "from": "н"}.get(case, first)
    if case == "being":
        first = "нд" if possessed else FIRST["in"][_sound(said)]
        return first + broad + ("ғы" if back else "гі")
    if case == "to":
        return ("н" if possessed else _to(_sound(said) == "voiceless", back)) + broad
    if case == "object" and possessed:
        return "н"
    if case == "without":
        return f"с{narrow}з"
    return first + {"of": f"{narrow}ң", "object": narrow, "in": broad, "from": f"{broad}н", "by": "ен"}.get(
        case, narrow
    )


def _to(hard: bool, back: bool) -> str:
    return {(True, True): "қ", (True, False): "к", (False, True): "ғ", (False, False): "г"}[hard, back]


def _is_back(said: str) -> bool:
    """By the last vowel; у says nothing of its own where another stands before it, and behind ь all is front."""
    if said[-1:].lower() == "ь":
        return False
    vowels = [char for char in said.lower() if char in BACK + FRONT]
    if vowels[-1:] == ["у"] and len(vowels) > 1:
        vowels.pop()
    return not vowels or vowels[-1] in BACK


def _sound(said: str) -> str:
    last = said.lower().removesuffix("ь")[-1:]
    if last in VOWELS:
        return "vowel"
    return next((name for name, letters in CLASSES.items() if last in letters), "voiceless")

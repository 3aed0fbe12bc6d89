"""Wrong words to be planted beside right numbers, in every chapter by the same kinds, found in its texts as they are.

Captions exchanged, another source, a word turned into its opposite, in the text or in its translation alone; nouns,
letters and units of declared numbers exchanged; definitions and axes. Each is looked for in an approved note that says
it (tests/golden); a text that none says, or that stands twice, is passed over.
"""

from __future__ import annotations

import gettext
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import islice
from pathlib import Path

from faults import Fault

EACH = 1  # of a kind in a file
OPPOSITE = {
    "greatest": "least", "least": "greatest", "less": "more", "above": "below", "below": "above", "before": "after",
    "after": "before", "inner": "outer", "lower": "upper", "upper": "lower", "driving": "driven", "larger": "smaller",
    "sum": "difference", "input": "output", "same": "other", "stable": "unstable", "first": "last", "with": "without",
}  # fmt: skip
TURNED = {  # of as many letters, so that the compiled catalogue stays in order
    "больше": "меньше", "меньше": "больше", "наибольш": "наименьш", "наименьш": "наибольш", "выше": "ниже",
    "ниже": "выше", "начал": "конец", "левая": "права", "перед": "после", "после": "перед", "сумма": "длина",
    "силы": "пути", "угла": "пути", "длина": "сумма", "масс": "длин", "момент": "размер", "скорост": "ускорен",
    "звена": "точки", "точки": "звена", "плана": "графа", "силой": "парой",
}  # fmt: skip
UNITS = {
    "m": "m/s", "m/s": "m/s²", "m/s²": "m/s", "rad/s": "rad/s²", "rad/s²": "rad/s", "N": "N·m", "N·m": "N",
    "kg": "kg·m²", "kg·m²": "kg", "W": "J", "J": "W", "N/m": "N", "mm": "m", "rad": "rad/s", "kg·m": "kg", "s": "m",
}  # fmt: skip
CATALOGUE = "templates/locale/ru/LC_MESSAGES/note.mo"
TEXT = re.compile(r't\("((?:[^"\\]|\\.)+)"')
CAPTION = re.compile(r'm\.(?:table|figure)\(.*?t\("([^"%\\]+)"')
SOURCE = re.compile(r'm\.by\("(\w+)"[^)]*\)')
NOUN = re.compile(r'N_\("([a-z][^"%\\]+)"\)')
LETTER = re.compile(r'(?:Q\(|Symbol\()"(\w+)"')
KEY = re.compile(r'Quantity\("(\w+)"|^\s*(\w+?)_? = Q\(')
UNIT = re.compile(r'"(' + "|".join(re.escape(unit) for unit in UNITS) + r')"')

KEYS = {"friction", "reduction", "transmission", "press", "balancing", "harmonics", "dynamics", "flywheel", "governor",
        "rotor", "engine", "vibration", "contacts", "efficiency", "wear", "drive", "spur", "planetary", "eccentric",
        "readings", "methods", "travel"}  # fmt: skip
"""Chapters that a variant's file asks for by name."""
STATED_BY = {"sliding_quantities": "coefficient: {"}  # a file that only variants with these words are for

CHAPTERS = "tmm_report/chapters/"
STATED = [  # definitions and axes, by their own texts: what, file, old, new, variant
    ("work taken from the energy at the start", "machine/dynamics/equations.py", 'Definition("T", start + self',
     'Definition("T", start - self', "tram_start"),
    ("unevenness by the sum of the speeds", "machine/flywheel/equations.py", "(s.omega_max - s.omega_min)",
     "(s.omega_max + s.omega_min)", "compressor"),
    ("one point of the guide less", "machine/wear/equations.py", "s.slider / s.step + 1", "s.slider / s.step - 1",
     "forging_machine_wear"),
    ("half the pressure of the couple", "machine/wear/equations.py", '2 * Var("F_M", found.couple, "N") / area',
     'Var("F_M", found.couple, "N") / area', "forging_machine_wear"),
    ("inertia force by the speed", "machine/engine/equations.py", "s.m * s.r * s.omega**2 * series",
     "s.m * s.r * s.omega * series", "engine_balance"),
    ("lag ahead of the force", "machine/vibration/equations.py", "sin(_turned(found) - s.lag)",
     "sin(_turned(found) + s.lag)", "locomotive_diesel"),
    ("free motion that grows", "machine/vibration/equations.py", "exp(-(s.decay * t))", "exp(s.decay * t)",
     "locomotive_diesel"),
    ("sum of both in place of their difference", "lever/plans/view.py", "(_GRAPH - _ANALYTIC) /",
     "(_GRAPH + _ANALYTIC) /", "compressor"),
    ("power added to the energy's growth", "lever/kinetostatics/view/checks.py", 'Var("dt", 0.0) - Var("N", 0.0)',
     'Var("dt", 0.0) + Var("N", 0.0)', "compressor"),
    ("weight without its g", "lever/kinetostatics/view/positions.py", 'Definition("G", Var("m", 0.0) * Var("g", 0.0))',
     'Definition("G", Var("m", 0.0))', "compressor"),
    ("arm as the force by the moment", "lever/force_plans/view.py", 'abs(Var("M_I", 0.0)) / Var("F_I", 0.0)',
     'Var("F_I", 0.0) / abs(Var("M_I", 0.0))', "compressor"),
    ("axis of the motion from the start", "machine/vibration/view.py", 'self.of("motion", "t")',
     'self.of("motion", "x_steady")', "locomotive_diesel"),
    ("axis of the absorbers", "machine/vibration/view.py", '[self.s.quantity("beta")]', '[self.s.quantity("zeta")]',
     "locomotive_diesel"),
    ("axis of the governor's response", "machine/governor/view/in_loop.py", 'self.of("response", "t")',
     'self.of("response", "z")', "governor_servo"),
    ("axis of the brake's start", "machine/governor/view/brake.py", 'self.of("start", "t")',
     'self.of("start", "omega")', "governor_porter"),
    ("axis of the moments over the speed", "machine/dynamics/draw.py", "[Motion.M.quantity]", "[Motion.J.quantity]",
     "tram_start"),
    ("axes of the speed and the moment", "machine/dynamics/draw.py", '[table["omega"].quantity, Motion.M.quantity]',
     '[Motion.M.quantity, table["omega"].quantity]', "tram_start"),
    ("axis of the balancing moment", "lever/kinetostatics/view/diagrams.py", "[graphs.axis(q.BALANCING_MOMENT)]",
     '[graphs.axis(q.weight("1"))]', "compressor"),
    ("panels of the losses", "lever/friction/view.py", '("P_fr", "eta"), numbered', '("eta", "P_fr"), numbered',
     "compressor"),
]  # fmt: skip

Edit = tuple[str, str, str | re.Pattern[str]]  # old, new, by what an approved text is known that says it
Found = Iterator[Edit]


def faults(root: Path) -> Iterator[Fault]:
    for what, own_file, old, new, variant in STATED:
        yield Fault(f"words: {what}", CHAPTERS + own_file, old, new, variant, words=True)
    texts = {kind: dict(_approved(root, kind)) for kind in (".en.txt", ".ru.txt", ".numbers")}
    for file, kind, where, edits in _of_all(root):
        own = [name for name in texts[where] if _has(root, name, file)]
        said = ((old, new, _saying(texts[where], own, words)) for old, new, words in edits)
        for number, (old, new, variant) in enumerate(islice((one for one in said if one[2]), EACH), 1):
            name = f"words: {kind} {number} in {file.relative_to(root).as_posix()}"
            yield Fault(name, file.relative_to(root).as_posix(), old, new, variant, words=True)


def _approved(root: Path, kind: str) -> Iterator[tuple[str, str]]:
    for path in sorted((root / "tests" / "golden").glob(f"*{kind}")):
        yield path.name.removesuffix(kind), path.read_text("utf-8")


def _has(root: Path, variant: str, file: Path) -> bool:
    """Whether a variant states what a chapter's file is for; one without a key of its own goes with any mechanism."""
    parts = {part.removesuffix(".j2") for part in file.parts}
    keys = parts & KEYS
    keys = {"drive" if key in ("spur", "planetary") else key for key in keys}
    text = (root / "variants" / f"{variant}.yaml").read_text("utf-8")
    if STATED_BY.get(file.stem, "") not in text:
        return False
    return all(f"\n{key}:" in text for key in keys or {"mechanism"}) and (
        "cam" not in parts or "\n  cams:" in text
    )


def _saying(texts: Mapping[str, str], own: list[str], words: str | re.Pattern[str]) -> str:
    """Of its own variants the one with the shortest approved text that says this, with any numbers in it."""
    if isinstance(words, str):
        pieces = (re.escape(piece.strip()) for piece in re.split(r"%\(\w+\)s", words))
        words = re.compile(".*?".join(pieces))
    saying = [name for name in own if words.pattern and words.search(texts[name])]
    return min(saying, key=lambda name: len(texts[name]), default="")


def _of_all(root: Path) -> Iterator[tuple[Path, str, str, Found]]:
    """File, kind of the fault, kind of the text in which it is looked for, the edits."""
    catalogue = root / CATALOGUE
    pages = {
        page: page.read_text("utf-8") for page in sorted((root / "templates" / "chapters").rglob("*.j2"))
    }
    said = Counter(words for text in pages.values() for words in {m[1] for m in TEXT.finditer(text)})
    for page, text in pages.items():
        own = {words for words, times in said.items() if times == 1}  # what two pages say tells neither
        yield page, "another caption", ".en.txt", (one for one in _exchanged(text, CAPTION) if one[2] in own)
        yield page, "another source", ".en.txt", (one for one in _sources(text) if one[2] in own)
        yield page, "the opposite", ".en.txt", (one for one in _opposite(text) if one[2] in own)
        kind = f"the opposite in the translation of {page.stem}, {page.parent.name}"
        yield catalogue, kind, ".ru.txt", _translated(text, catalogue)
    for file in sorted((root / "tmm_report" / "chapters").rglob("*.py")):
        if file.name == "ways.py":
            continue  # what it declares only `explain` says
        code = file.read_text("utf-8")
        declared = [line for line in code.splitlines() if re.search(r"\b(?:Q|Quantity)\(.*N_\(", line)]
        yield file, "another noun", ".numbers", _lines(code, declared, NOUN, _rotated(declared, NOUN))
        yield file, "another letter", ".numbers", _lines(code, declared, LETTER, _rotated(declared, LETTER))
        yield file, "another unit", ".numbers", _lines(code, declared, UNIT, UNITS.__getitem__)


def _once(text: str, edits: Iterable[Edit]) -> Found:
    """Those that find their text once and change it."""
    return (edit for edit in edits if edit[0] != edit[1] and text.count(edit[0]) == 1)


def _exchanged(text: str, pattern: re.Pattern[str]) -> Found:
    """Each by the next one."""
    found = list(dict.fromkeys(pattern.findall(text)))
    pairs = zip(found, [*found[1:], *found[:1]], strict=True)
    return _once(text, ((f'"{one}"', f'"{other}"', one) for one, other in pairs))


def _sources(text: str) -> Found:
    """By another author; the note is known by the text before it."""
    for match in SOURCE.finditer(text):
        other = "frolov" if match[1] != "frolov" else "levitsky"
        before = TEXT.findall(text[: match.start()])
        if before:
            yield from _once(text, [(match[0], match[0].replace(f'"{match[1]}"', f'"{other}"'), before[-1])])


def _opposite(text: str) -> Found:
    words = re.compile(r"\b(" + "|".join(OPPOSITE) + r")\b")
    for one in (m[1] for m in TEXT.finditer(text)):
        other = words.sub(lambda m: OPPOSITE[m[1]], one, count=1)
        yield from _once(text, [(f'"{one}"', f'"{other}"', one)])


def _translated(text: str, catalogue: Path) -> Found:
    """In the compiled catalogue, where a message ends with a zero byte and keeps its length."""
    with catalogue.open("rb") as file:
        say = gettext.GNUTranslations(file).gettext
    words, data = re.compile("|".join(TURNED)), catalogue.read_bytes()
    for one in (say(m[1].replace('\\"', '"')) for m in TEXT.finditer(text)):
        other = words.sub(lambda m: TURNED[m[0]], one, count=1)
        if one != other and "%(" not in one and data.count(f"\0{one}\0".encode()) == 1:
            yield f"\0{one}\0", f"\0{other}\0", one


def _rotated(lines: list[str], pattern: re.Pattern[str]) -> Callable[[str], str]:
    """Another letter of the same file."""
    found = list(dict.fromkeys(pattern.findall("\n".join(lines))))
    return dict(zip(found, [*found[1:], *found[:1]], strict=True)).__getitem__


def _lines(text: str, lines: list[str], pattern: re.Pattern[str], other: Callable[[str], str]) -> Found:
    """The first that a line says, by another: the whole line is the text, its key and noun say where it is read."""
    for line in lines:
        found, noun, key = pattern.search(line), NOUN.search(line), KEY.search(line)
        if found is not None and noun is not None and key is not None:
            start, end = found.span(1)
            letter = found[1] if pattern is LETTER else ".*"  # one that a variant letters anew is not read
            called = rf"^(?:\S*[._])?{key[1] or key[2]} \| {letter} \|.*\| {re.escape(noun[1])}$"
            yield from _once(
                text, [(line, line[:start] + other(found[1]) + line[end:], re.compile(called, re.M))]
            )

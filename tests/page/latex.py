"""A note of LaTeX as plain text: its tables and formulas, letter by letter what a reader of the HTML sees."""

from __future__ import annotations

import re
from collections.abc import Iterator
from xml.etree.ElementTree import Element

NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi "
    "omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega varphi varepsilon"
)
GREEK = dict(zip(NAMES.split(), "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩφε", strict=True))
SIGNS = GREEK | {
    "cdot": "·", "to": "→", "times": "×", "leqslant": "≤", "geqslant": "≥", "pm": "±", "approx": "≈", "infty": "∞",
    "parallel": "∥", "perp": "⟂", "neq": "≠", "prime": "′", "circ": "°", "ge": "≥", "le": "≤", "sum": "Σ", "int": "∫",
    "NoteTimes": "·", "textbackslash": "\\", "textasciitilde": "~", "textasciicircum": "^", "gg": "≫", "ll": "≪",
    "circlearrowright": "↻", "circlearrowleft": "↺",
}  # fmt: skip
_COMMAND = re.compile(r"\\([A-Za-z]+) ?")


def plain(latex: str) -> str:
    """The letters, digits and signs of LaTeX text, without spaces, indices on the line."""
    text = re.sub(r"\\underset\{((?:[^{}]|\{[^{}]*\})*)\}", r"\1", latex)  # the note comes first
    text = text.replace("\\left", "").replace("\\right", "").replace("---", "—").replace("--", "–")
    text = _COMMAND.sub(lambda match: SIGNS.get(match[1], ""), text)
    text = re.sub(r"\\([{}$&#%_])", lambda match: chr(0xE000 + ord(match[1])), text)
    text = re.sub(r"\\[;,:! ]", "", text)
    text = re.sub(r"[{}$^_\s~]", "", text)
    text = re.sub("[\ue000-\ue0ff]", lambda match: chr(ord(match[0]) - 0xE000), text)
    return alike(text)


RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉", "-01234567890123456789")
# ~ and the signs of powers have no other writing in LaTeX; a reader cannot tell these apart
ALIKE = str.maketrans(
    {"−": "-", "-": "-", "–": "-", "⊥": "⟂", "‖": "∥", "'": "′", "’": "′", "|": "|", "⩽": "≤"}
)


def alike(text: str) -> str:
    """Without spaces and with one sign for what looks the same."""
    return re.sub(
        r"[\s\N{NO-BREAK SPACE}\N{NARROW NO-BREAK SPACE}^_~]", "", text.translate(RAISED)
    ).translate(ALIKE)


def seen(node: Element) -> str:
    """The same of an element of HTML."""
    return alike(_seen(node))


def _seen(node: Element) -> str:
    own = "" if node.tag == "mo" and node.text == "‾" else node.text or ""
    parts = list(node)
    if node.tag == "munder":
        parts.reverse()
    return own + "".join(_seen(child) + (child.tail or "") for child in parts)


def argument(text: str, at: int) -> tuple[str, int]:
    """The text between the brace at a place and its closing one, and where that ends."""
    depth = 0
    for match in re.compile(r"\\.|[{}]").finditer(text, at):
        depth += {"{": 1, "}": -1}.get(match[0], 0)
        if depth == 0:
            return text[at + 1 : match.start()], match.end()
    raise ValueError(text[at : at + 40])


def commands(text: str, name: str, count: int) -> Iterator[list[str]]:
    """The arguments of every use of a command."""
    for match in re.finditer(rf"(?<!newcommand\{{)\\{name}(?=\{{)", text):
        found, at = [], match.end()
        for _ in range(count):
            one, at = argument(text, at)
            found.append(one)
        yield found


def formulas(text: str) -> list[str]:
    """The displayed formulas in order."""
    found = re.finditer(r"\\(NoteFormula|NoteDisplay|NoteBeside)(?=\{)", text)
    places = [
        (m.start(), m[1]) for m in found if not text[max(0, m.start() - 12) : m.start()].endswith("command{")
    ]
    return [
        plain(next(commands(text[at:], name, 3 if name == "NoteFormula" else 1))[-1]) for at, name in places
    ]


_TABLE = re.compile(r"\\begin\{(NoteTable|NoteLongTable)\}(.*?)\\end\{\1\}", re.S)


def tables(text: str) -> list[list[list[str]]]:
    """The rows of every table in order, the head first."""
    found = []
    for match in _TABLE.finditer(text[text.index("\\begin{document}") :]):
        body = match[2]
        if match[1] == "NoteLongTable":
            body = body[: body.index("\\endfirsthead")] + body[body.index("\\endhead") + len("\\endhead") :]
        rows = [line.removesuffix("\\\\ \\hline ").removesuffix("\\\\ \\hline") for line in body.split("\n")]
        kept = [row for row in rows[1:] if row.strip() and not row.lstrip().startswith("\\NoteLongCaption")]
        found.append([[plain(cell) for cell in re.split(r"(?<!\\)&", row)] for row in kept])
    return found

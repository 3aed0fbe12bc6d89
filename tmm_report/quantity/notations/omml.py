"""Formulas in Office Math (OMML), as word processors edit them.

A formula is a row of elements; pieces, between which a line may break, are parted by NEXT and wrapped by who asks for
them. Numbers are runs like letters, which stand upright of themselves: LibreOffice sets what begins with normal text
to the left of its fraction. Source: ECMA-376, part 1, 22.1.
"""

from __future__ import annotations

from functools import cache

from tmm_report.i18n import Translator
from tmm_report.quantity.symbols import GREEK, Notation, xml_escape
from tmm_report.quantity.text import MINUS, Parts, unit_text
from tmm_report.records import dataclass

NEXT = "\N{INFORMATION SEPARATOR ONE}"  # between pieces of a formula; in no text
_PRIMES = {2: "″", 3: "‴"}  # side by side they would be drawn apart
_LOWER = frozenset(letter for letter in GREEK.values() if letter.islower())
_BESIDE = '</m:t></m:r><m:r><m:t xml:space="preserve">'  # between letters of a segment, which are one run
THIN = "\N{THIN SPACE}"


def upright(text: str) -> str:
    """Words: as normal text, for what has but an upright style LibreOffice slants."""
    return f'<m:r><m:rPr><m:nor/></m:rPr><m:t xml:space="preserve">{xml_escape(text)}</m:t></m:r>'


def leaning(text: str) -> str:
    return f'<m:r><m:t xml:space="preserve">{xml_escape(text)}</m:t></m:r>'


def _of(tag: str, **parts: str) -> str:
    return f"<m:{tag}>{_parts(**parts)}</m:{tag}>"


def _parts(**parts: str) -> str:
    return "".join(f"<m:{name}>{part}</m:{name}>" for name, part in parts.items())


def _bar(text: str, place: str) -> str:
    return f'<m:bar><m:barPr><m:pos m:val="{place}"/></m:barPr><m:e>{text}</m:e></m:bar>'


@dataclass(frozen=True, eq=False)
class Omml(Notation):
    """Each shape is one element, or some side by side."""

    def parts(self, parts: Parts) -> str:
        text = leaning(parts.digits.replace(".", self.tr.decimal))
        if parts.power is not None:
            power = self.parts(Parts(parts.power < 0, str(abs(parts.power))))
            text += leaning("·") + self.power(leaning("10"), power)
        return self.negative(text) if parts.negative else text

    def indexed(self, base: str, sub: str, sup: str) -> str:
        if sub and sup:
            return _of("sSubSup", e=base, sub=sub, sup=sup)
        return _of("sSub", e=base, sub=sub) if sub else _of("sSup", e=base, sup=sup) if sup else base

    def run(self, run: str) -> str:
        if run[0] in "'′":
            return leaning(_PRIMES.get(len(run), "′" * len(run)))
        letter = len(run) == 1 and run.isalpha() and (run.isascii() or run in _LOWER)
        if letter or (run.isascii() and (run.isupper() or run.isdigit())):
            return leaning(run)
        return upright(self.word(run))

    def unit(self, unit: str) -> str:
        text = unit_text(unit, self.tr.language)
        return upright(text if text == "°" else THIN + text) if text else ""

    def operator(self, sign: str) -> str:
        return leaning(sign)

    def negative(self, text: str) -> str:
        return leaning(MINUS) + text

    def brackets(self, text: str, marks: str = "()") -> str:
        ends = f'<m:begChr m:val="{marks[0]}"/><m:endChr m:val="{marks[1]}"/>'
        return f"<m:d><m:dPr>{ends}</m:dPr><m:e>{text}</m:e></m:d>"

    def fraction(self, above: str, below: str) -> str:
        return _of("f", num=above, den=below)

    def root(self, text: str) -> str:
        return f'<m:rad><m:radPr><m:degHide m:val="1"/></m:radPr><m:deg/><m:e>{text}</m:e></m:rad>'

    def power(self, base: str, exponent: str) -> str:
        return _of("sSup", e=base, sup=exponent)

    def function(self, name: str, argument: str) -> str:
        return _of("func", fName=upright(name), e=argument)

    def integral(self, body: str, along: str, lower: str, upper: str) -> str:
        inner = _parts(sub=lower, sup=upper, e=body + leaning("d") + along)
        sign = '<m:naryPr><m:chr m:val="∫"/><m:limLoc m:val="subSup"/></m:naryPr>'
        return f"<m:nary>{sign}{inner}</m:nary>"

    def bar(self, text: str) -> str:
        return _bar(text.replace(_BESIDE, ""), "top")

    def underlined(self, text: str, lines: int) -> str:
        for _ in range(lines):
            text = _bar(text, "bot")
        return text

    def under(self, text: str, note: str) -> str:
        return _of("limLow", e=text, lim=note)

    def formula(self, pieces: list[str]) -> str:
        return NEXT.join(pieces)


@cache
def notation(tr: Translator) -> Omml:
    return Omml(tr)

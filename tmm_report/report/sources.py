"""The books and standards that notes cite, by the names by which templates call them.

Their Russian form is that of GOST R 7.0.5: with its signs, spaces around them, a full stop and a dash between areas;
standards with their full designation.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from secrets import token_hex

from markupsafe import Markup

from tmm_report.problems import N_

SOURCES = {
    "artobolevsky": N_(
        "Artobolevsky I. I. Theory of Mechanisms and Machines. Moscow: Nauka, 1988. 640 p. (in Russian)."
    ),
    "frolov": N_(
        "Frolov K. V. (ed.), Popov S. A., Musatov A. K. et al. Theory of Mechanisms and Machines. Moscow: "
        "Vysshaya Shkola, 1987. 496 p. (in Russian)."
    ),
    "berkof": N_(
        "Berkof R. S. Complete Force and Moment Balancing of Inline Four-Bar Linkages. Mechanism and Machine Theory 8 "
        "(1973), pp. 397–410."
    ),
    "freudenstein": N_(
        "Freudenstein F. Approximate Synthesis of Four-Bar Linkages. Transactions of the ASME 77 (1955), pp. 853–861."
    ),
    "levitsky": N_(
        "Levitsky N. I. Theory of Mechanisms and Machines. Moscow: Nauka, 1990. 592 p. (in Russian)."
    ),
    "korenyako": N_(
        "Korenyako A. S. (ed.). Course Design in the Theory of Mechanisms and Machines. Kyiv: Vyshcha Shkola, "
        "1970. 332 p. (in Russian)."
    ),
    "rack": N_(
        "GOST 13755–2015 (ISO 53:1998). Basic norms of interchangeability. Cylindrical involute gears. Basic racks "
        "(in Russian)."
    ),
    "external": N_(
        "GOST 16532–70. Cylindrical involute gear pairs of external mesh. Calculation of geometry (in Russian)."
    ),
    "internal": N_(
        "GOST 19274–73. Cylindrical involute gear pairs of internal mesh. Calculation of geometry (in Russian)."
    ),
    "bolotovsky": N_(
        "Bolotovsky I. A. (ed.). Handbook of Geometrical Calculation of Involute and Worm Gears. Moscow: "
        "Mashinostroenie, 1986. 448 p. (in Russian)."
    ),
    "kudryavtsev": N_(
        "Kudryavtsev V. N. Planetary Gears. Moscow, Leningrad: Mashinostroenie, 1966. 307 p. (in Russian)."
    ),
    "dunaev": N_(
        "Dunaev P. F., Lelikov O. P. Design of Units and Machine Parts. Moscow: Academia, 2004. 496 p. (in Russian)."
    ),
    "balancing": N_(
        "ISO 21940-11:2016. Mechanical vibration. Rotor balancing. Part 11: Procedures and tolerances for rotors "
        "with rigid behaviour."
    ),
    "vibration": N_("Den Hartog J. P. Mechanical Vibrations. Moscow: Fizmatgiz, 1960. 580 p. (in Russian)."),
    "wear": N_("Kragelsky I. V. Friction and Wear. Moscow: Mashinostroenie, 1968. 480 p. (in Russian)."),
}


class Cited:
    """The sources of a note, numbered in the order in which its text cites them: that order is known when all of it
    stands, since what is put off into an appendix is rendered where it was called for. Till then a mark stands for
    those that are cited together. `between`: what separates these."""

    def __init__(self, between: str):
        self._between, self._secret = between, f"cited{token_hex(16)}x"
        self._together: list[tuple[Sequence[str], Callable[[int], Markup]]] = []
        self._order: list[str] = []

    def mark(self, names: Sequence[str], link: Callable[[int], Markup]) -> Markup:
        """Stands for the numbers of sources; `link`: how one is printed."""
        self._together.append((names, link))
        return Markup(f"{self._secret}{len(self._together) - 1}x")

    def order(self, body: str) -> list[str]:
        """The names as the body cites them, then those of the appendices alone; they have numbers from now on."""
        first = map(int, re.findall(rf"{self._secret}(\d+)x", body))
        every = (self._together[k] for k in [*first, *range(len(self._together))])
        self._order = list(dict.fromkeys(name for names, _ in every for name in names))
        return self._order

    def resolved(self, text: str) -> str:
        """The text with numbers in place of the marks."""

        def numbers(mark: re.Match[str]) -> str:
            names, link = self._together[int(mark[1])]
            return self._between.join(map(link, sorted(self._order.index(name) + 1 for name in names)))

        return re.sub(rf"{self._secret}(\d+)x", numbers, text)

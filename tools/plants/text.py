"""Wrong outputs of how a note reads: one quantity in two ways, lines that end at the wrong place."""

from __future__ import annotations

from faults import Fault

ALIKE = ("tests/chapters/lever/force_plans/test_said_alike.py",)
TEXTS = ("tests/report/test_good_text.py",)
ZONES = "tmm_report/chapters/gears/spur/draw/zones.py"
GEARING = ("tests/figures/gears/test_gearing.py",)
FAULTS = (
    # --- one quantity reads the same everywhere ---
    Fault("an inertia couple by its size", "tmm_report/chapters/lever/force_plans/drafting/sheet.py",
          "product if sense > 0 else -product", "product", tests=ALIKE),
    Fault("a segment named either way", "tmm_report/chapters/lever/initial_data/quantities/__init__.py",
          "return length(one + other if order(one) < order(other) else other + one)", "return length(one + other)",
          tests=ALIKE),
    Fault("lengths of seven digits by hand", "tmm_report/chapters/lever/plans/drafting/sheet.py",
          "return self.worked.number(of, float(round_significant(metres, DIGITS)))",
          "return self.worked.number(of, metres)", tests=ALIKE),
    Fault("a centre of percussion with the letter of a point",
          "tmm_report/chapters/lever/force_plans/quantities.py",
          'for letter in "KTNLQUVW" if letter not in taken', 'for letter in "KTNLQUVW"', tests=ALIKE),
    # --- good text ---
    Fault("sources numbered as they were rendered", "tmm_report/report/sources.py",
          "for k in [*first, *range(len(self._together))]", "for k in range(len(self._together))", tests=TEXTS),
    Fault("sources cited together in any order", "tmm_report/report/sources.py",
          "sorted(self._order.index(name) + 1 for name in names)", "[self._order.index(name) + 1 for name in names]",
          tests=TEXTS),
    Fault("lines that end within a unit", "tmm_report/report/paper/punctuation.py",
          "text = _SLASH.sub(", "text = text or _SLASH.sub(", tests=TEXTS),
    Fault("lines that begin with the stop behind a formula", "tmm_report/report/paper/punctuation.py",
          '"<nobr>\\\\1\\N{WORD JOINER}\\\\2</nobr>"', '"\\\\1\\N{WORD JOINER}\\\\2"',
          tests=("tests/report/test_note_html.py",)),
    Fault("zones of contact at any scale", ZONES,
          "k = 1 / round_scale(active, WIDE)", "k = WIDE / active", tests=GEARING),
    Fault("letters of zones upon one another", ZONES,
          "align=1 if at < near else -1 if at > near else 0", "align=0",
          tests=GEARING),
)  # fmt: skip

"""Faults of how much a note says: its pieces, appendices, depths."""

from faults import Fault

DEPTH = ("tests/report/test_depth.py",)
FAULTS = (
    # --- pieces of the note ---
    Fault("what an appendix explains taken for explained", "tmm_report/report/numbering.py",
          "self._appendix, self._explained = None, explained", "self._appendix = None",
          tests=DEPTH),
    Fault("appendices numbered as the text is", "tmm_report/report/numbering.py",
          "        if self._appendix:\n            letter =", "        if False:\n            letter =",
          tests=DEPTH),
    Fault("sentences of what is left out stay", "tmm_report/report/numbering.py",
          '"" if not whole and refers(one[1]) else one[1]', "one[1]", tests=DEPTH),
    Fault("the chapter goes before the piece", "tmm_report/chapters/title/given.py",
          'for name in (piece, piece.split(".")[0]):', 'for name in (piece.split(".")[0], piece):',
          tests=DEPTH),
    Fault("an appendix of nothing", "tmm_report/report/page.py", "if text.strip():", "if True:", tests=DEPTH),
    Fault("a piece cut out keeps its rank", "tmm_report/report/numbering.py", "level = max(2, level - self._raised)",
          "level = max(2, level)", tests=DEPTH),
)  # fmt: skip

"""Faults of how much a note says: its pieces, appendices, depths."""

from faults import Fault

DEPTH = ("tests/report/test_depth.py",)
FAULTS = (
    # --- pieces of the note ---
    Fault("what an appendix explains taken for explained", "tmm_report/report/numbering.py",
          "self._letter, self._explained = None, explained", "self._letter = None",
          tests=DEPTH),
    Fault("appendices numbered as the text is", "tmm_report/report/numbering.py",
          "        if self._letter:\n            number =", "        if False:\n            number =",
          tests=DEPTH),
    Fault("sentences of what is left out stay", "tmm_report/report/numbering.py",
          'return "" if gone else sentence[1]', "return sentence[1]", tests=DEPTH),
    Fault("the chapter goes before the piece", "tmm_report/chapters/title/given.py",
          'for name in (piece, piece.split(".")[0]):', 'for name in (piece.split(".")[0], piece):',
          tests=DEPTH),
)  # fmt: skip

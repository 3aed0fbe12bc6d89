"""Faults of how much a note says: its pieces, appendices, depths."""

from faults import Fault

DEPTH = ("tests/report/test_depth.py",)
ALIKE = ("tests/page/tables/test_alike.py",)
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
    # --- digits ---
    Fault("whole numbers rounded to tens", "tmm_report/quantity/text.py",
          "    if 10 ** (digits - 1) <= size and whole < RAISED:\n        return str(whole), None",
          "    if 10 ** (digits - 1) <= size and whole < RAISED:\n"
          "        return str(int(float(f\"{size:.{digits - 1}e}\"))), None",
          variants="compressor", tests=ALIKE),
    Fault("each number of a column by itself", "tmm_report/report/paper/layout.py",
          "return self._replace(cells=padded(self.cells))", "return self", tests=ALIKE),
    Fault("columns of noughts stay", "tmm_report/report/paper/layout.py",
          'all(cell == "0" for cell in self.cells)', "False", tests=ALIKE),
    Fault("noise of a uniform turning is its acceleration", "tmm_report/chapters/lever/kinematics/view/motion.py",
          "if order and self._nought(order, (low, high)):", "if False:", variants="parallelogram_drive",
          tests=ALIKE),
    Fault("works beside their own size", "tmm_report/chapters/lever/kinetostatics/view/cycle.py",
          "self.page.cell(table, key, row, scale=max(scale, 1e-300))",
          "self.page.cell(table, key, row, scale=1e-300)", variants="slot_by_slider", tests=ALIKE),
)  # fmt: skip

"""Faults of how much a note says: its pieces, appendices, depths."""

from faults import Fault

DEPTH = ("tests/report/test_depth.py",)
CALLED = ("tests/variant/words/test_names_by_language.py",)
ALIKE = ("tests/page/tables/test_alike.py",)
KINDS = ("tests/quantity/test_kinds.py",)
TRANSLATE = ("tests/chapters/lever/test_translating_links.py",)
SHEETS = ("tests/report/test_sheets.py",)
ORDER = ("tests/chapters/lever/force_plans/test_order_of_forces.py",)
VECTORS = ("tests/page/drawings/test_vectors.py",)
READ = ("tests/chapters/lever/test_lengths_read.py",)
FORCES = "tmm_report/chapters/lever/force_plans/"
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
    Fault("plans of one position whatever is asked for", "tmm_report/chapters/lever/plans/view.py",
          "ranked[: page.note.plans or 1]", "ranked[:1]", tests=DEPTH),
    Fault("plans of other positions though they are not asked for", "tmm_report/chapters/title/given.py",
          'if piece == "plans.others" and self.plans is not None:', 'if False:', tests=DEPTH),
    # --- one formula of each kind ---
    Fault("the value of a formula left out with another sign", "tmm_report/quantity/terms/kinds.py",
          "formula.written, formula.unit", "-formula.written, formula.unit", "compressor",
          ("tests/report/test_shorter_notes.py", *KINDS)),
    Fault("formulas of other operations taken for one kind", "tmm_report/quantity/terms/kinds.py",
          "own: list[Hashable] = [type(node).__name__]", "own: list[Hashable] = []", tests=KINDS),
    Fault("other quantities taken for one kind", "tmm_report/quantity/terms/kinds.py",
          "(sign.base, sign.sup, var.unit)", '("", sign.sup, var.unit)', tests=KINDS),
    Fault("one of a kind left out within its own group", "tmm_report/quantity/terms/kinds.py",
          "here) != here:", 'here) != "":', tests=KINDS),
    Fault("what is nought stands for its kind", "tmm_report/quantity/terms/kinds.py",
          "if formula.written and not leader.written:", "if False:", tests=ORDER),
    # --- one table a position compares ---
    Fault("lengths rounded to fewer decimals than they are read to", "tmm_report/quantity/paper.py",
          '{step:.9f}"', '{step:.1g}"', tests=READ),
    Fault("vectors of a plan beside the forces of another", FORCES + "view.py",
          "for worked in drawn.worked:", "for worked in self.found.drawn[0].worked:", tests=READ),
    Fault("segments of another position beside the values of a plan", "tmm_report/chapters/lever/plans/view.py",
          "self.page.cell(read, ends, row,", "self.page.cell(read, ends, row - 1,"),
    Fault("an own value in the row of another quantity", "tmm_report/report/comparison.py",
          "row = keys.index(key)", "row = keys.index(key) - 1", "compressor",
          ("tests/chapters/lever/test_readings.py",)),
    Fault("numbers of the plans listed among the others, too", "tmm_report/chapters/lever/readings/view.py",
          "if one.key not in known", "if True", tests=("tests/chapters/lever/test_readings.py",)),
    Fault("links that turn said to translate", "tmm_report/chapters/lever/kinematics/solve/strokes.py",
          "initial=0.0) <= least)", "initial=0.0) >= least)", tests=TRANSLATE),
    Fault("links that turn said to translate by the plans", "tmm_report/chapters/lever/plans/view.py",
          "translating(lever.kinematics.diagram)", "lever.given.mechanism.real.moving", tests=TRANSLATE),
    Fault("groups with higher pairs told as those without", "tmm_report/chapters/lever/structure/view.py",
          'return same and not any(table["higher"].values)', "return same",
          tests=("tests/chapters/lever/kinematics/test_determinate_groups.py",)),
    Fault("the scheme in the text at a coarser scale than is said", "tmm_report/report/schemes.py",
          "self._drawn(position, mu)", "self._drawn(position, 2 * mu)", "compressor"),
    # --- figures that share the paper ---
    Fault("a plan made smaller under the scale of its construction", "tmm_report/chapters/lever/plans/view.py",
          'scale_of(f"mu_{plan.kind}", mu, own.unit)', 'scale_of(f"mu_{plan.kind}", plan.scale, own.unit)',
          "compressor", VECTORS),
    Fault("a force plan made smaller under the scale of its construction", FORCES + "view.py",
          'scale_of("mu_F", mu, "N/mm")', 'scale_of("mu_F", plan.scale, "N/mm")', "compressor", VECTORS),
    Fault("a scheme of loading made smaller under the scale of its construction", FORCES + "view.py",
          'scale_of("mu_l", self.scheme_scale(drawn, plan), "m/mm")', 'scale_of("mu_l", self.length_scale, "m/mm")',
          "compressor", ("tests/page/drawings/test_loading_schemes.py",)),
    Fault("figures side by side wider than the page", "tmm_report/report/paper/rows.py",
          "wider.wide <= paper.width", "wider.wide <= 2 * paper.width", tests=SHEETS),
    Fault("figures of a sheet higher than it", "tmm_report/report/paper/rows.py",
          "for one in (*rows, row)) > sheet.field[1]", "for one in rows) > sheet.field[1]", tests=SHEETS),
    Fault("sources cited together as in English", "tmm_report/languages.py", 'cited="; "', 'cited=", "',
          tests=("tests/report/test_good_text.py",)),
    Fault("gathered figures of LaTeX lost", "tmm_report/report/formats.py",
          "_tex_row(row, self.paper) for row in rows)", "_tex_row(row, self.paper) for row in rows[:0])",
          tests=SHEETS),
    # --- force plans as a person draws them ---
    Fault("unknowns of a force equation both at its end", FORCES + "drafting/dyad.py",
          "[[*reversed(on_b), *loads, *on_a], []]", "[[*loads, *on_a, *reversed(on_b)], []]", tests=ORDER),
    Fault("the tangential component outside the normal one", FORCES + "drafting/dyad.py",
          "[[*reversed(on_b), *loads, *on_a], []]", "[[*on_b, *loads, *on_a], []]", tests=ORDER),
    Fault("lengths of vectors beside other forces", FORCES + "view.py",
          "short_and_full(worked.rows[key][1], 7,", "short_and_full(2 * worked.rows[key][1], 7,", "compressor"),
    Fault("every reaction explained again", "tmm_report/report/numbering.py",
          'item.get("kind", item["id"]), {item["id"]', 'item["id"], {item["id"]', tests=ORDER),
    # --- names by languages ---
    Fault("a name is said as it is given first", "tmm_report/problems.py",
          "name.render(translate) if isinstance(name, Called) else str(name)", "str(name)", tests=CALLED),
    Fault("a name within a meaning is said as it is given first", "tmm_report/problems.py",
          "if isinstance(v, Message | Called) else v for k", "if isinstance(v, Message) else v for k", tests=CALLED),
    Fault("names that begin alike taken for one", "tmm_report/problems.py", "return self.by == other.by",
          "return str(self) == str(other)", tests=CALLED),
)  # fmt: skip

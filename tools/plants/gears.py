"""Wrong pages of compound trains, of the backlash and of the quality of a pair, to be planted."""

from __future__ import annotations

from faults import SPUR, Fault

TRAIN, HOIST = "tmm_report/chapters/gears/train/", "hoist_differential"
OF_TRAINS = (
    "tests/chapters/gears/train/test_train.py",
    "tests/chapters/gears/train/test_train_page.py",
)
FITTED = ("tests/chapters/gears/spur/test_gear_backlash.py",)
SHORTER = ("tests/chapters/gears/notes/test_shorter_gear_notes.py",)
SHIFTED = ("tests/chapters/gears/spur/test_gear_quality.py",)

FAULTS = tuple(
    Fault(f"gears' page: {name}", file, old, new, HOIST, by)
    for by, name, file, old, new in (
        (OF_TRAINS, "letters of the speeds exchanged", TRAIN + "view/tables.py",
         '"omega": Symbol("omega"),\n            "n": Symbol("n")', '"n": Symbol("omega"),\n           '
                                                                    ' "omega": Symbol("n")'),
        (OF_TRAINS, "the driving wheel is the driven one", TRAIN + "quantities.py",
         "mesh.i if x > 0 else mesh.j if x < 0", "mesh.j if x > 0 else mesh.i if x < 0"),
        (OF_TRAINS, "centre distances exchanged", TRAIN + "steps.py",
         "row.a, row.a_other, row.gap = one.one, one.other", "row.a, row.a_other, row.gap = one.other, one.one"),
        (OF_TRAINS, "what is whole is called broken", TRAIN + "view/tables.py",
         'self.t("whole") if one.met', 'self.t("whole") if not one.met'),
        (OF_TRAINS, "those that touch are called free", TRAIN + "view/tables.py",
         'self.t("free") if one.met', 'self.t("free") if not one.met'),
        (OF_TRAINS, "heads of torque and power exchanged", TRAIN + "view/tables.py",
         '"T": N_("Torque of the meshes, N·m"), "N": N_("Power from the meshes, W")',
         '"N": N_("Torque of the meshes, N·m"), "T": N_("Power from the meshes, W")'),
        (OF_TRAINS, "heads of torques with and without losses exchanged", TRAIN + "view/tables.py",
         '"T_0": N_("Torque without losses, N·m"), "N_0": N_("Power without',
         '"N_0": N_("Torque without losses, N·m"), "T_0": N_("Power without'),
        (OF_TRAINS, "shares with losses under those without", TRAIN + "view/tables.py",
         'page.cell(table, "share_0", k),', 'page.cell(table, "share", k),'),
        (OF_TRAINS, "the first motion's numbers in every row", TRAIN + "view/tables.py",
         'page.cell(table, "omega", row),\n                page.cell(table, "n", row),\n            ]\n        '
         '    for row, name in',
         'page.cell(table, "omega", 0),\n                page.cell(table, "n", 0),\n            ]\n           '
         ' for row, name in'),
        (OF_TRAINS, "speeds of a motion as of the first", TRAIN + "steps.py",
         "row.omega, row.n = speed[m.name], speed[m.name]", "row.omega, row.n = self.found.speed[m.name],"
                                                            " speed[m.name]"),
        (OF_TRAINS, "a case's known speed of the motion before", TRAIN + "view/train.py",
         "for number, case in enumerate(self.found.given.cases, 1)", "for number, case in"
                                                                     " enumerate(self.found.given.cases, 0)"),
        (OF_TRAINS, "the held are called driven", "templates/chapters/gears/train.j2",
         't("Held: %(fixed)s.", fixed=view.names(g.fixed))', 't("Held: %(fixed)s.", fixed=view.names(g.input))'),
        (OF_TRAINS, "solutions' ratio under their deviation", TRAIN + "quantities.py",
         "miss = 100 * (np.asarray(of.ratio) / task.ratio - 1)", "miss = 100 * (task.ratio /"
                                                                 " np.asarray(of.ratio) - 1)"),
        (OF_TRAINS, "rejected sets by another reason", TRAIN + "quantities.py",
         'column(list(counts.values()))', 'column(list(reversed(counts.values())))'),
        (OF_TRAINS, "velocities of the diagram the other way", TRAIN + "draw/diagrams.py",
         "self.zero + v / self.plans.velocity", "self.zero - v / self.plans.velocity"),
        (OF_TRAINS, "segments of the plan the other way", TRAIN + "draw/diagrams.py",
         "omega / plans.angular for body, (_, omega, _, _)", "-omega / plans.angular for body, (_, omega, _, _)"),
        (OF_TRAINS, "the plan's pole not at its distance", TRAIN + "draw/diagrams.py",
         "pole = origin - 1j * plans.pole", "pole = origin - 0.5j * plans.pole"),
        (OF_TRAINS, "arrows of what is driven point out", TRAIN + "draw/scheme.py",
         "Arrow(tip, at + way, THIN) if into", "Arrow(tip, at + way, THIN) if not into"),
        (OF_TRAINS, "the frame holds what turns", TRAIN + "draw/scheme.py",
         "if body in self.held and not"
         " self._only_ground(body):\n                ends = [end", "if body not in self.held:\n               "
                                                                   " ends = [end"),
        (OF_TRAINS, "assembly of a row that turns otherwise", TRAIN + "view/train.py",
         "number = below - above if sign > 0", "number = below - above if sign < 0"),
        (OF_TRAINS, "distance of a ring by the sum", TRAIN + "view/train.py",
         "j - i if mesh.internal else i + j", "i + j if mesh.internal else i + j"),
        (OF_TRAINS, "Willis without the carrier below", TRAIN + "view/train.py",
         "above, below = one - moving, other - moving", "above, below = one - moving, other"),
        (OF_TRAINS, "forces of a mesh by its other wheel", TRAIN + "steps.py",
         "found.places.radius[mesh.i] * sharing", "found.places.radius[mesh.j] * sharing"),
        (OF_TRAINS, "power of a mesh under its loss", "tmm_report/chapters/gears/power_flow.py",
         'for key in ("N", "N_fr", "eta")', 'for key in ("N_fr", "N", "eta")'),
        (OF_TRAINS, "what circulates told of no ends", TRAIN + "steps.py",
         "ends = (*found.given.input,"
         " *found.given.output)\n        s.P_circ", "ends = found.given.output\n        s.P_circ"),
        (OF_TRAINS, "a member's mates on its shaft left out", TRAIN + "steps.py",
         'm.body == body and m.name != name)', 'm.body == body and m.name == name)'),
        (FITTED, "least and greatest limit exchanged", SPUR + "loosening.py",
         '"first": [row.least for row in rows],', '"first": [row.most for row in rows],'),
        (FITTED, "deviations of the other sense", SPUR + "loosening.py",
         "[row.most - row.nominal for row in rows]", "[row.nominal - row.most for row in rows]"),
        (FITTED, "primes exchanged", SPUR + "loosening.py",
         'if key.startswith("first") else', 'if not key.startswith("first") else'),
        (FITTED, "letters of the sizes exchanged", SPUR + "loosening.py",
         '"W": Symbol("W"), "s_c": Symbol("s", "c", bar=True)', '"W": Symbol("M"), "s_c": Symbol("s", "c", bar=True)'),
        (FITTED, "thinning under its tolerance", SPUR + "view/backlash.py",
         '("thin", N_("least thinning', '("field", N_("least thinning'),
        (FITTED, "the other wheel's deviations", SPUR + "view/backlash.py",
         "(self.names[i], size)", "(self.names[1 - i], size)"),
        (FITTED, "the angle of one wheel for the other", SPUR + "loosening.py",
         "cos(alpha_w) / st.wheels[i].d_b", "cos(alpha_w) / st.wheels[1 - i].d_b"),
        (FITTED, "the greatest called the least", "templates/chapters/gears/spur/backlash.j2",
         '{% elif end == "least" %}', '{% elif end == "most" %}'),
        (FITTED, "what is stated of the rack said of the span", SPUR + "words.py",
         '"rack": N_("It is stated as the additional', '"span": N_("It is stated as the additional'),
        (FITTED, "a span that falls by the thinning itself", SPUR + "loosening.py",
         's.var(f"thin_{place}") * cos(g.alpha)', 's.var(f"thin_{place}") / cos(g.alpha)'),
        (SHIFTED, "pressure at the tip for that at the root", SPUR + "qualities.py",
         "pair.rho_p[0], _at_end(stage, 0)", "pair.rho_p[0], _at_end(stage, 1)"),
        (SHIFTED, "the pressures' columns exchanged", SPUR + "qualities.py",
         "pole, low, high = of.pressures", "pole, high, low = of.pressures"),
        (SHIFTED, "roots and tips slide exchanged", SPUR + "qualities.py",
         "(Along.lambda_p, of.root_sliding)", "(Along.lambda_p, of.tip_sliding)"),
        (SHIFTED, "a bound's side exchanged", SPUR + "qualities.py",
         '(("from", one.low), ("to", one.high))', '(("to", one.low), ("from", one.high))'),
        (SHIFTED, "words of the sides exchanged", SPUR + "words.py",
         '{"from": N_("no less than"), "to": N_("no greater than")}', '{"to": N_("no less than"), "from":'
                                                                      ' N_("no greater than")}'),
        (SHIFTED, "contact ratios of the ends exchanged", SPUR + "qualities.py",
         "s.eps_least, s.eps_most = (float", "s.eps_most, s.eps_least = (float"),
        (SHIFTED, "another wheel's curve", SPUR + "view/quality.py",
         '("eps", -99.0, 99.0),\n                ("tip"', '("tip", -99.0, 99.0),\n                ("tip"'),
        (SHIFTED, "captions of the tables exchanged", "templates/chapters/gears/spur/quality.j2",
         'v.lengths(t("Contact ratio, tips and clearance of the fillets of pair %(name)s over the shift',
         'v.contacts(t("Contact ratio, tips and clearance of the fillets of pair %(name)s over the shift'),
        (SHIFTED, "the counting of sliding said otherwise", SPUR + "words.py",
         '"own": N_(\n        "Specific sliding'
         ' is counted by the velocity of the wheel', '"size": N_(\n        "Specific sliding is counted by the'
                                                     ' velocity of the wheel'),
    )
)  # fmt: skip

FAULTS += (
    Fault(
        "letters: those of the mate named as the wheel's own",
        "tmm_report/chapters/gears/spur/view/pair.py",
        'for wheel, index in ((i, "i"), (1 - i, "k"))',
        'for wheel, index in ((i, "i"), (1 - i, "i"))',
        "compressor",
        ("tests/chapters/gears/spur/test_letters.py",),
    ),
    Fault(
        "letters: a formula that one wheel has told of both",
        "tmm_report/chapters/gears/spur/view/pair.py",
        "if len(has) < 2:",
        "if len(has) < 1:",
        "compressor",
        ("tests/chapters/gears/spur/test_letters.py",),
    ),
    Fault(
        "letters: unlike wheels have the formula of the first",
        "tmm_report/quantity/definition.py",
        "[*alike.values()] if len(alike) < 2 else",
        "[*alike.values()][:1] if alike else",
        "compressor",
        ("tests/quantity/test_definition.py", "tests/chapters/gears/spur/test_letters.py"),
    ),
    Fault(
        "letters: another's number told as a formula of its own kind",
        "tmm_report/quantity/terms/kinds.py",
        "if isinstance(formula.expression, Var):",
        "if False:",
        "compressor",
        ("tests/quantity/test_definition.py",),
    ),
    Fault(
        "planetary: the reasons without the first",
        "tmm_report/chapters/gears/rejected.py",
        'return page.listed(said, "; ")',
        'return page.listed(said[1:], "; ")',
        "compressor",
        ("tests/chapters/gears/test_planetary_stage.py",),
    ),
    Fault(
        "drive: the loads of the members in the rows of others",
        "tmm_report/chapters/gears/drive/view.py",
        "rows = {name: row for row, name in enumerate(loads",
        "rows = {name: -1 - row for row, name in enumerate(loads",
        "compressor",
        SHORTER,
    ),
    Fault(
        "pair: a row of the table lost for good at short and in the appendix",
        "tmm_report/chapters/gears/spur/view/pair.py",
        "return self._of_wheels(caption, FURTHER)",
        "return self._of_wheels(caption, FURTHER[1:])",
        "compressor",
        SHORTER,
    ),
    Fault(
        "stages: millimetres said of formulas in metres",
        "tmm_report/chapters/gears/ordinary/view.py",
        "of, of.quantity.unit) for name",
        "of, of.quantity.printed) for name",
        "winch_drive",
        SHORTER,
    ),
    Fault(
        "letters: neighbours of two meanings explained by the first",
        "tmm_report/report/page.py",
        'return base, str(item["meaning"]), str(item.get("unit", ""))',
        'return base, "", str(item.get("unit", ""))',
        "winch_drive",
        SHORTER,
    ),
)

"""Faults of ordinary stages of a drive and of its power, to be planted: what is refused, drawn, given and told."""

from __future__ import annotations

from faults import DRIVE, MECHANICS, Fault

ORDINARY = "tmm_report/chapters/gears/ordinary/"
POWER = DRIVE + "power/"
STAGES, POWERS = ("tests/chapters/gears/ordinary",), ("tests/chapters/gears/drive_power",)
BELTS = ("tests/mechanics/gears/test_belts.py",)
IDLERS = ("tests/statements/test_statements.py",)
BELT, WINCH, CHAIN = "belt_conveyor", "winch_drive", "conveyor_drive"

FAULTS = (
    # --- ordinary stages ---
    Fault("stages: a belt about pulleys that meet", MECHANICS + "gears/belts.py", "low = (one + other) / 2",
          "low = (one + other) / 2 if crossed else abs(one - other) / 2 + 1e-9", CHAIN, BELTS),
    Fault("stages: a chosen wheel among the given ones", ORDINARY + "view.py",
          'self.wheels[:-1] if "z2" in self.found.given.chosen else self.wheels', "self.wheels", CHAIN, STAGES),
    Fault("stages: the usual distance told as given", ORDINARY + "parallel.py",
          'found["a" if self.length is None else "a_about"] = "by rule"', 'found["a"] = "by rule"', CHAIN, STAGES),
    Fault("stages: a hollow cone passes", ORDINARY + "steps/common.py", "or angle - first >= FLATTEST", "", WINCH,
          STAGES),
    Fault("stages: the search beside an open stage without its bound", DRIVE + "stages.py",
          "    check_search(given)\n", "", BELT, POWERS),
    Fault("stages: the first mistake alone", DRIVE + "stages.py",
          "            found.append(None)\n            problems +=", "            raise\n            problems +=", BELT,
          POWERS),
    Fault("stages: radial and axial force of a bevel wheel exchanged", ORDINARY + "steps/bevel.py",
          "s.F_a1 = s.F_t * tan(s.alpha) * sin(s.delta1)", "s.F_a1 = s.F_t * tan(s.alpha) * cos(s.delta1)", WINCH,
          STAGES),
    Fault("stages: the thread leans the other way", ORDINARY + "draw/worm.py",
          'given.hand == "right"', 'given.hand == "left"', WINCH, STAGES),
    Fault("stages: the wheel of a worm drawn turning the other way", ORDINARY + "draw/worm.py",
          "math.radians(100 * given.sense), math.radians(-200 * given.sense)",
          "math.radians(-100 * given.sense), math.radians(200 * given.sense)", WINCH, STAGES),
    Fault("stages: the wheel of a worm turning the other way in the scheme", DRIVE + "draw/crossing.py",
          "turns = -stage.given.sense if sketch.speed[entry.name] > 0 else stage.given.sense",
          "turns = stage.given.sense if sketch.speed[entry.name] > 0 else -stage.given.sense", WINCH, STAGES),
    Fault("stages: the driven pulley drawn turning the other way", ORDINARY + "draw/belt.py",
          "*turns(centre, two, sense)", "*turns(centre, two, -sense)", CHAIN, STAGES),
    Fault("stages: a crossed belt drawn open", ORDINARY + "draw/belt.py",
          "meet = -leave if crossed else leave", "meet = leave", CHAIN, STAGES),
    Fault("stages: the strands drawn leaning the other way", ORDINARY + "draw/belt.py",
          "math.pi / 2 - theta if crossed else", "math.pi / 2 + theta if crossed else", CHAIN, STAGES),
    Fault("stages: angles of the cones exchanged in the drawing", ORDINARY + "draw/cones.py",
          'math.radians(n("delta1")), math.radians(n("delta2"))', 'math.radians(n("delta2")),'
                                                                  ' math.radians(n("delta1"))',
          WINCH, STAGES),
    Fault("stages: cones exchanged in the scheme", DRIVE + "draw/crossing.py",
          'for key in ("delta1", "delta2"))', 'for key in ("delta2", "delta1"))', WINCH, STAGES),
    Fault("stages: idlers drawn turning as the driving wheel", ORDINARY + "draw/wheels.py",
          "sense *= 1 if found.meshes[k - 1].internal else -1", "sense *= 1", CHAIN, STAGES),
    Fault("stages: senses of a worm exchanged in words", ORDINARY + "view.py", "WAY[given.sense]",
          "WAY[-given.sense]", WINCH, STAGES),
    Fault("stages: place and hand of a worm exchanged in words", ORDINARY + "words.py",
          '"right above": N_("The thread is'
          ' right-handed, the worm lies above', '"right above": N_("The thread'
                                                ' is left-handed, the worm lies above', WINCH, STAGES),
    Fault("stages: a worm that locks told to run back", ORDINARY + "view.py", "if self.found.locks:",
          "if not self.found.locks:", WINCH, STAGES),
    Fault("stages: the wrap told of the pulley that is wrapped more", ORDINARY + "view.py",
          'key = "alpha1" if self.s.number("alpha1") <= self.s.number("alpha2") else "alpha2"',
          'key = "alpha2" if self.s.number("alpha1") <= self.s.number("alpha2") else "alpha1"', CHAIN, STAGES),
    Fault("stages: too small a wrap praised", ORDINARY + "view.py",
          "enough = math.degrees(self.s.number(key)) >= least", "enough = True", CHAIN, STAGES),
    Fault("stages: the least wrap of V-belts that of flat ones", ORDINARY + "view.py", '"belt V": 120',
          '"belt V": 150', CHAIN, STAGES),
    Fault("stages: outer and inner pairs exchanged in words", ORDINARY + "quantities.py",
          '"pair external": N_("pair of wheels, outer mesh")', '"pair external": N_("pair of wheels, inner mesh")',
          BELT,
          STAGES),
    Fault("stages: outer and inner friction exchanged in words", ORDINARY + "words.py",
          '"Friction wheels %(one)s and %(two)s are pressed together, one within the other; wheel %(one)s'
          ' drives, "\n        "and both turn in the same sense."',
          '"Friction wheels %(one)s and %(two)s are pressed together; wheel %(one)s drives, and wheel %(two)s'
          ' turns "\n        "in the opposite sense."', CHAIN,
          STAGES),
    Fault("stages: an even number of links told as of the row", ORDINARY + "parallel.py",
          'found["links"] = "even"', 'found["links"] = "row"', CHAIN, STAGES),
    # --- power ---
    Fault("power: the first shaft's formulas under the second's name", "templates/chapters/gears/drive/power.j2",
          "group(w.shaft_formulas(1), t", "group(w.shaft_formulas(0), t", BELT, POWERS),
    Fault("power: a motor's verdict of its neighbour", POWER + "view.py",
          'page.word(self.t(VERDICTS[table'
          '["verdict"].values[row]]), table', 'page.word(self.t(VERDICTS[table["'
                                              'verdict"].values[row - 1]]), table', BELT, POWERS),
    Fault("power: the load of a motor of its neighbour", POWER + "view.py",
          'page.cell(table, key, row,'
          ' digits=4) for key in ("P", "n", "u", "load")', 'page.cell(table, key, max(row - 1, 0), digits=4)'
                                                           ' for key in ("P", "n", "u", "load")', BELT, POWERS),
    Fault("power: parts of the losses by their neighbours' names", POWER + "view.py",
          'PARTS[table["part"].values[row]]', 'PARTS[table["part"].values[row - 1]]', BELT, POWERS),
    Fault("power: a stage of the losses by another stage's wheels", POWER + "view.py",
          'wheels=table["wheels"].values[row])', 'wheels=table["wheels"].values[0])', BELT, POWERS),
    Fault("power: slow and fast exchanged in words", POWER + "view.py",
          'key = "equal" if split is None else "slow" if split.slow else "fast" if split.fast else "step"',
          'key = "equal" if split is None else "fast" if'
          ' split.slow else "slow" if split.fast else "step"', BELT, POWERS),
    Fault("power: before and after the bearings exchanged in words", "templates/chapters/gears/drive/power.j2",
          'if w.power.given.shafts.at == "after bearings" else', 'if w.power.given.shafts.at != "after bearings" else',
          BELT,
          POWERS),
    Fault("power: rated and needed power exchanged in words", "templates/chapters/gears/drive/power.j2",
          "if w.power.rated else", "if not w.power.rated else", BELT, POWERS),
    Fault("power: stated and sought teeth exchanged in words", POWER + "view.py",
          'if not row.has_formula("z_exact"))', 'if row.has_formula("z_exact"))', BELT, POWERS),
    Fault("power: the sprocket's diameter by its pitches alone", POWER + "steps.py",
          "s.z_out * s.t_out / PI", "s.z_out * s.t_out", BELT, POWERS),
    Fault("power: the usual range told where one is stated", POWER + "plan.py",
          "return given.range, False", "return given.range, True", BELT, POWERS),
    Fault("power: the overload told as a fraction", POWER + "steps.py",
          "100 * self.found.given.overload", "self.found.given.overload", BELT, POWERS),
    Fault("power: forces of teeth in the other mesh's row", POWER + "quantities.py",
          'rows.append((f"{mesh.i}-{mesh.j}",', 'rows.append((f"{mesh.j}-{mesh.i}",', BELT, POWERS),
    Fault("power: the worm stage may be driven back without a word", DRIVE + "solve.py",
          'getattr(stage, "kind", "") == "worm" and power < 0', "False", WINCH, STAGES),
)  # fmt: skip

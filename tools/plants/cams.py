"""Wrong sizes of cams and cams of arcs, to be planted."""

from __future__ import annotations

from faults import MECHANICS, Fault

OF_CAMS, CAM_PRESS = MECHANICS + "cams/", "cam_press"
SIZED_BY, BY_ARCS = ("tests/mechanics/cams/test_centres.py",), ("tests/mechanics/cams/test_arcs.py",)
BY_RULES = ("tests/mechanics/cams/test_curvature_and_rules.py",)

FACED, DREW = (
    ("tests/chapters/cams/test_faces_and_rules.py",),
    ("tests/chapters/cams/test_centres_drawing.py",),
)
DRIVE = "tmm_report/chapters/gears/drive/block.py"
LINKED = ("tests/chapters/cams/test_cam_on_a_drive.py",)
NOTED = ("tests/chapters/cams/test_cam_note.py",)
STATED = ("tests/statements/test_statements.py",)
BLOCK, DRAWN = "tmm_report/chapters/cams/cam/block/", "tmm_report/chapters/cams/cam/draw/"

FAULTS = (
    # --- sizes of cams, cams of arcs ---
    Fault("cam sizes: the derivative laid off the wrong way along the arm", OF_CAMS + "sizes/centres.py",
          "1 - slope if self.alike else 1 + slope", "1 + slope if self.alike else 1 - slope", CAM_PRESS, SIZED_BY),
    Fault("cam sizes: a zone held by one side of the arm", OF_CAMS + "sizes/centres.py", "for side in (1, -1):",
          "for side in (1, 1):", CAM_PRESS, SIZED_BY),
    Fault("cam sizes: the return asks of the rise", OF_CAMS + "sizes/centres.py",
          'slope >= 0 if way == "rise" else slope <= 0', 'slope <= 0 if way == "rise" else slope >= 0', CAM_PRESS,
          SIZED_BY),
    Fault("cam sizes: three conditions kept by two", OF_CAMS + "sizes/centres.py",
          "all(c.excess(one.p) <= slack for c in others if c not in one.by)", "True", CAM_PRESS, SIZED_BY),
    Fault("cam sizes: the zone's outside is drawn", OF_CAMS + "sizes/centres.py", "        if b <= 0:",
          "        if b >= 0:", CAM_PRESS, SIZED_BY),
    Fault("cam sizes: one peak of a law is enough", OF_CAMS + "sizes/searched.py", "[:, -PEAKS:]", "[:, -1:]",
          CAM_PRESS,
          ("tests/mechanics/cams/test_centres.py", "tests/mechanics/cams/test_least_size.py")),
    Fault("cam sizes: curvature under a swinging face without its acceleration", OF_CAMS + "sizes/least_face.py",
          "bend / rate**3", "0 * bend", CAM_PRESS, SIZED_BY),
    Fault("cam sizes: curvature under a swinging face with one turn of its rate", OF_CAMS + "sizes/least_face.py",
          "(2 * rate - 1) / rate**2", "1 / rate", CAM_PRESS, SIZED_BY),
    Fault("cam sizes: the contact on a swinging face without its swing", OF_CAMS + "sizes/least_face.py",
          "self.apart * np.cos(lowest + S) / self._rate(slope)", "self.apart * np.cos(lowest + S)", CAM_PRESS,
          SIZED_BY),
    Fault("cam sizes: the least cam under a swinging face passed over", OF_CAMS + "sizes/least_face.py",
          "ceil((lowest - least) / (2 * pi))", "(1 + ceil((lowest - least) / (2 * pi)))", CAM_PRESS, SIZED_BY),
    Fault("cam sizes: the far side of an arm that leans too much", OF_CAMS + "sizes/least_size.py",
          "np.minimum(steep, 2 * pi - steep)", "steep", CAM_PRESS, ("tests/mechanics/cams/test_least_size.py",)),
    Fault("cam sizes: flank radius of a cam of arcs", OF_CAMS + "arcs.py", "over = distance**2 + base**2 - nose**2",
          "over = distance**2 + base**2 + nose**2", CAM_PRESS, BY_ARCS),
    Fault("cam sizes: the nose's place by the flank", OF_CAMS + "arcs.py", "return sqrt(square) - away * a",
          "return sqrt(square) + away * a", CAM_PRESS, BY_ARCS),
    Fault("cam sizes: the lift at the change without the roller", OF_CAMS + "arcs.py", "far = away + one.roller",
          "far = away", CAM_PRESS, BY_ARCS),
    Fault("cam sizes: acceleration over an arc without the rod's turn", OF_CAMS + "arcs.py",
          "(x.d**2 + x.z * x.dd + d**2) / root", "(x.d**2 + x.z * x.dd) / root", CAM_PRESS, BY_ARCS),
    Fault("cam sizes: acceleration of an arm over an arc", OF_CAMS + "arcs.py", "dot(gone, gone) + dot(",
          "dot(", CAM_PRESS, BY_ARCS),
    Fault("cam sizes: acceleration of a face over an arc", OF_CAMS + "arcs.py",
          " - 2 * d * dot(1j * n, w.d)) / ahead", ") / ahead", CAM_PRESS, BY_ARCS),
    Fault("cam sizes: acceleration of an arm over a straight flank", OF_CAMS + "arcs.py", "-(bend + g * d**2)",
          "-bend", CAM_PRESS, BY_ARCS),
    Fault("cam sizes: acceleration of a slider on a straight flank", OF_CAMS + "arcs.py", " - 2 * d * n.d.imag",
          " - d * n.d.imag", CAM_PRESS, BY_ARCS),
    Fault("cam sizes: curvature of the pitch curve without the acceleration", OF_CAMS + "sizes/curvature.py",
          " - Y * bend)", ")", CAM_PRESS, BY_RULES),
    Fault("cam sizes: curvature of a lever's pitch curve the wrong way", OF_CAMS + "sizes/curvature.py",
          "(1j * side * bend - slope**2) * w", "(1j * side * bend + slope**2) * w", CAM_PRESS, BY_RULES),
    Fault("cam sizes: a groove's hollow parts taken for convex",
          OF_CAMS + "sizes/curvature.py", "_least(law, place, -1)",
          "_least(law, place, 1)", CAM_PRESS, BY_RULES),
    Fault("cam sizes: a roller rounded up", OF_CAMS + "sizes/rules.py", "floor(most / step + 1e-9)",
          "floor(most / step + 1)", CAM_PRESS, BY_RULES),
    Fault("cam sizes: jerk of a slanting piece", OF_CAMS + "shapes.py", "(one.end - one.start) / one.width)",
          "(one.end - one.start))", CAM_PRESS, BY_RULES),
    Fault("cam sizes: jerk of a table", OF_CAMS + "follower_laws.py", "(self._bends[k + 1] - self._bends[k])",
          "(self._bends[k] - self._bends[k + 1])", CAM_PRESS, BY_RULES),
    Fault("cam sizes: a chosen roller by half of the radius", OF_CAMS + "sizes/rules.py", "OF_RADIUS = 0.4",
          "OF_RADIUS = 0.5",
          CAM_PRESS, BY_RULES),
    Fault("cam sizes: a shaft without the roller", OF_CAMS + "sizes/rules.py", "return OF_SHAFT * diameter + roller",
          "return OF_SHAFT * diameter", CAM_PRESS, FACED),
    Fault("cam sizes: the distance of a face on the other side", BLOCK + "sizes.py",
          "return float((normal * motion.arm.conjugate()).real)",
          "return -float((normal * motion.arm.conjugate()).real)",
          CAM_PRESS, FACED),
    Fault("cam sizes: the tangent at 45 degrees from the wrong place", DRAWN + "face.py",
          "foot = touch.real + touch.imag",
          "foot = touch.imag - touch.real", CAM_PRESS, FACED),
    Fault("cam sizes: what is laid off along the arm the wrong way in the drawing", DRAWN + "centres.py",
          "yield polyline(page(*(arms * (1 + k * slope))), THICK)",
          "yield polyline(page(*(arms * (1 - k * slope))), THICK)",
          CAM_PRESS, DREW),
    Fault("cam sizes: the velocity at the change without the speed", "tmm_report/chapters/cams/cam/quantities/arcs.py",
          "fast.unit, text).value(omega * end.first)", "fast.unit, text).value(end.first)", CAM_PRESS, STATED),
    Fault("cam sizes: both sides of the change exchanged", "tmm_report/chapters/cams/cam/quantities/arcs.py",
          "start, end, nose, tip = rows[:4]", "start, nose, end, tip = rows[:4]", CAM_PRESS, STATED),
    # --- a phase by a table ---
    Fault("cam table: the curve begins with any velocity", OF_CAMS + "shapes.py", "A[0, 0] = A[-1, -1] = 2.0",
          "A[0, 0] = A[-1, -1] = 4.0", CAM_PRESS, ("tests/mechanics/cams/test_shapes.py",)),
    Fault("cam table: a return by a table of a rise", "tmm_report/chapters/cams/cam/block/models.py",
          "way = -1.0 if self.return_ is not None else 1.0", "way = 1.0", CAM_PRESS, NOTED),
    Fault("cam table: what swings back is taken", OF_CAMS + "shapes.py", "if np.min(steps) < 0:",
          "if np.min(steps) < -9e9:", CAM_PRESS, ("tests/mechanics/cams/test_shapes.py",)),
    # --- a cam on a drive ---
    Fault("cam drive: the cam turns the other way", DRIVE, '"counter-clockwise" if output > 0',
          '"counter-clockwise" if output < 0', CAM_PRESS, LINKED),
    Fault("cam drive: the speed of the input", DRIVE, "output = drive.output_speed(found)", "output = found.speed",
          CAM_PRESS, LINKED),
    Fault("cam drive: any stated speed is called the drive's", "tmm_report/variant/model.py",
          "return isinstance(found, str) and found.strip() == word", "return found is not None", CAM_PRESS, LINKED),
    # --- the note of a cam ---
    Fault("cam note: rows alike that do not follow one another stand together", "tmm_report/report/paper/layout.py",
          "alike = [list(run) for _, run in groupby(range(len(rows)), key=rows.__getitem__)]",
          "alike = [list(run) for _, run in groupby(sorted(range(len(rows)), key=rows.__getitem__), "
          "key=rows.__getitem__)]", "valve_cam", NOTED),
    Fault("cam note: a run ends a row too early", "tmm_report/report/paper/layout.py",
          "first.cells[run[-1]]", "first.cells[run[-2]]", "valve_cam", NOTED),
    Fault("cam note: the limit of the rise is told for the return", "templates/chapters/cams/pair.j2",
          'back_limit=cam.number("cam_alpha_back")', 'back_limit=cam.number("cam_alpha_limit")', "valve_cam", NOTED),
    Fault("cam note: a stated offset is called the best", "tmm_report/chapters/cams/cam/view.py",
          "abs(self.found.offset - zone.best.e) < ALIKE", "abs(self.found.offset - zone.best.e) < 1e9", "valve_cam",
          NOTED),
    Fault("cam note: parts of the forces twice", "tmm_report/chapters/cams/cam_forces/view.py",
          '*(self._parts if self.apart else ())', "*()", "valve_cam", NOTED),
    Fault("cam note: a pressure angle is called none", "tmm_report/chapters/cams/cam/view.py",
          "np.max(np.abs(self.found.drawn.alpha), initial=0.0) < ALIKE",
          "np.min(np.abs(self.found.drawn.alpha), initial=1.0) < 0.1", "valve_cam", NOTED),
)  # fmt: skip

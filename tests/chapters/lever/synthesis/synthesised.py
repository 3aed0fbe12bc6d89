"""Mechanisms that take their lengths of a synthesis, by its kind."""

MECHANISMS = {
    "slider_crank": """
mechanism:
  frame: {{O: [0, 0], P: [0, synthesis.offset]}}
  guides: {{x: {{through: P}}}}
  links: {{1: {{points: {{O: 0, A: synthesis.crank}}}}, 2: {{points: {{A: 0, B: synthesis.rod}}}},
    3: {{points: [B], slides: x}}}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{B: right}}
transmission: 5 deg
""",
    "crank_rocker": """
mechanism:
  frame: {{O: [0, 0], C: [synthesis.frame_x, synthesis.frame_y]}}
  links: {{1: {{points: {{O: 0, A: synthesis.crank}}}}, 2: {{points: {{A: 0, B: synthesis.rod}}}},
    3: {{points: {{C: 0, B: synthesis.rocker}}}}}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{B: {side} of A-C}}
transmission: 5 deg
""",
    "slotted_link": """
mechanism:
  frame: {{O: [0, synthesis.frame], C: [0, 0], P: [0, synthesis.slide_line]}}
  guides: {{x: {{through: P}}, k: {{link: "3", through: C}}}}
  links: {{1: {{points: {{O: 0, A: synthesis.crank}}}}, 2: {{points: [A], slides: k}},
    3: {{points: {{C: 0, B: synthesis.link}}}}, 4: {{points: {{B: 0, D: synthesis.rod}}}},
    5: {{points: [D], slides: x}}}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{2-3: "+", D: right}}
""",
    "turning_guide": """
mechanism:
  frame: {{O: [0, 0], C: [0, synthesis.frame]}}
  guides: {{x: {{through: C}}, k: {{link: "3", through: C}}}}
  links: {{1: {{points: {{O: 0, A: synthesis.crank}}}}, 2: {{points: [A], slides: k}},
    3: {{points: {{C: 0, B: synthesis.arm}}}}, 4: {{points: {{B: 0, D: synthesis.rod}}}},
    5: {{points: [D], slides: x}}}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{2-3: "-", D: right}}
""",
}

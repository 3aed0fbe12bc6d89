"""Faults of the note that Typst sets."""

from faults import Fault

NOTATION = ("tests/quantity/test_typst_notation.py",)
PDF = ("tests/report/typst/test_pdf_of_typst.py",)
PROFILES = ("tests/report/test_profiles.py",)
FRAMES = ("tests/report/paper/test_frames.py",)
MEASURED = ("tests/page/drawings/test_measured_on_paper.py",)
COMMAND = ("tests/commands/test_pdf.py",)
FORM = "tmm_report/report/formats/typst.py"
FORMULAS = "tmm_report/quantity/notations/typst.py"
MACROS, NOTE = "templates/macros.typst.j2", "templates/report.typst.j2"
FAULTS = (
    Fault("typst: fractions upside down", FORMULAS, "frac({above}, {below})",
          "frac({below}, {above})", tests=NOTATION),
    Fault("typst: brackets lost", FORMULAS, 'f"lr(\\\\{marks[0]} {text}\\\\{marks[1]})"', 'f"lr({text})"',
          tests=NOTATION),
    Fault("typst: a negative number loses its sign", FORMULAS, 'return f"{MINUS}{text}" if parts.negative else text',
          "return text", tests=NOTATION),
    Fault("typst: blanks of strings lost", FORMULAS, 'lambda one: one[1] or ""',
          'lambda one: (one[1] or "").replace(" ", "")', tests=NOTATION),
    Fault("typst: quotation marks end their string", FORMULAS, """'"': '\\\\"', """, "", tests=NOTATION),
    Fault("typst: pictures nine tenths as large", FORM, 'size = self.percent(picture) / 100',
          'size = self.percent(picture) / 111', variants="compressor", tests=MEASURED),
    Fault("typst: a chart in a place of another size", FORM, "wide, tall = drawing.size", "wide, tall = picture.size",
          tests=PDF),
    Fault("typst: a product cut from its formula", FORM, "start = mark.start()\n    return",
          "start = mark.end()\n    return", tests=PDF),
    Fault("typst: text is read as markup", FORM, 'else f"\\\\{sign}"', "else sign", tests=PDF),
    Fault("typst: a text begins a line", MACROS, '#"";{{ said }}', "{{ said }}", tests=PDF),
    Fault("typst: the last row of tables lost", MACROS, "{% for row in part.rows %}", "{% for row in part.rows[:-1] %}",
          tests=PDF),
    Fault("typst: sections have no bookmarks", NOTE, "bookmarked: level < 3", "bookmarked: level < 2", tests=PDF),
    Fault("typst: dated by the year alone", "tmm_report/report/__init__.py",
          "[sheet.issued, sheet.due] if sheet else []", "[]", tests=PDF),
    Fault("typst: no standard of the PDF", "tmm_report/commands/by_typst.py", "pdf_standards=[STANDARD], ", "",
          tests=PDF),
    Fault("typst: the bar is ninety millimetres", NOTE, "end: (100mm, 2mm)", "end: (90mm, 2mm)", tests=PROFILES),
    Fault("typst: margins exchanged", "templates/profile.typst.j2",
          "left: {{ p.margins.left }}mm, right: {{ p.margins.right }}mm",
          "left: {{ p.margins.right }}mm, right: {{ p.margins.left }}mm", tests=PROFILES),
    Fault("typst: the block of the first sheet on all", "templates/frames.typst.j2", "corner(block-next)",
          "corner(block-first)", tests=FRAMES),
    Fault("typst: --pdf takes the variant for a program", "tmm_report/terminal.py", 'named[-1] = "--pdf=any"',
          'named[-1] = f"--pdf={one}"', tests=COMMAND),
    Fault("typst: files beside the working folder are read", "tmm_report/commands/by_typst.py",
          "root=empty", 'root="/"', tests=COMMAND),
)  # fmt: skip

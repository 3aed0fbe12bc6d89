"""Faults of how the note looks on paper: its profile."""

from faults import Fault

PROFILES = ("tests/report/test_profiles.py",)
PRINT = ("tests/commands/test_printing.py",)
FRONT = ("tests/report/test_front_matter.py",)
DEPARTMENT = ("tests/batches/test_department.py",)
OWN = ("tests/report/test_own_template.py",)
FAULTS = (
    Fault("a binding margin of the print that is not the profile's", "templates/profile.css.j2",
          "{{ p.margins.bottom }}mm {{ p.margins.left }}mm", "{{ p.margins.bottom }}mm {{ p.margins.left - 5 }}mm",
          tests=PROFILES),
    Fault("room for pictures that does not follow the margins", "tmm_report/report/page.py",
          "self.form.paper = Paper(self.profile.margins, self.profile.text)", "pass", tests=PROFILES),
    Fault("a base that goes before what is stated over it", "tmm_report/profiles.py",
          "return {**under, **over, **inner}", "return {**over, **under, **inner}", tests=PROFILES),
    Fault("figures numbered through where they begin with the section", "tmm_report/report/numbering.py",
          "elif self.scheme.through(kind):", 'elif kind != "formula":', tests=PROFILES),
    Fault("one dash in the text, another in the captions", "tmm_report/report/paper/punctuation.py",
          'return re.sub(r"(?<=\\s)–(?=\\s)", dash, text)', "return text", tests=PROFILES),
    Fault("a page's number in the middle where it stands aside", "templates/profile.css.j2",
          '("right" if p.aside else "center")', '"center"', tests=PROFILES),
    Fault("a printed note whose contents name the page before", "tmm_report/commands/printing.py",
          'enumerate(_leaves(pdf, _reference(root, b"Pages")), 1)',
          'enumerate(_leaves(pdf, _reference(root, b"Pages")))',
          tests=PRINT),
    Fault("references of a printed note beside their objects", "tmm_report/commands/printing.py",
          "at + longer if at > start else at", "at", tests=PRINT),
    Fault("joined rows that do not tell their noughts", "tmm_report/report/paper/layout.py",
          "one._replace(cells=[one.cells[k] for k in kept])", "Column(one.head, [one.cells[k] for k in kept])",
          tests=FRONT),
    Fault("signs of a profile's word read as a pattern", "tmm_report/report/paper/punctuation.py",
          'here.replace("\\\\", r"\\\\")', "here", tests=PROFILES),
    Fault("an assignment sheet without its dates", "templates/chapters/assignment.j2",
          "{% if assignment.due %}", "{% if assignment.issued %}", tests=FRONT),
    Fault("who signs is left out of the title page", "templates/chapters/title.j2",
          "{% for one in title.signed %}", "{% for one in title.signed[1:] %}", tests=FRONT),
    Fault("a department that goes before its variant", "tmm_report/variant/department.py",
          "merged(own, theirs),", "merged(theirs, own),", tests=DEPARTMENT),
    Fault("a department's mistake told of the variant", "tmm_report/yamlread/__init__.py",
          "file = place.file if isinstance(place, OfFile) else file", "pass", tests=DEPARTMENT),
    Fault("a department's file solved as a variant", "tmm_report/commands/batch/inputs.py",
          "found = [source for source in found if source not in stated.values()]", "pass", tests=DEPARTMENT),
    Fault("a batch that leaves its department out", "tmm_report/commands/batch/work.py",
          "loads(task.content, task.label, task.department)", "loads(task.content, task.label)", tests=DEPARTMENT),
    Fault("markup of a department's template in the note", "tmm_report/report/own/shut.py",
          "if isinstance(one, nodes.TemplateData) else one", "if False else one", tests=OWN),
    Fault("loops of a department's template without an end", "tmm_report/report/own/shut.py",
          'loop.iter = _called("counted", [loop.iter], loop.lineno)', "pass", tests=OWN),
    Fault("the inside of a text for a department's template", "tmm_report/report/own/shut.py",
          "return attr in OF_TEXT", "return True", tests=OWN),
    Fault("a department's block that is left out", "tmm_report/report/__init__.py",
          "own.written(name, given, ours) if own and own.states(name) else ours()", "ours()", tests=OWN),
    Fault("figures that wait behind a department's block", "tmm_report/report/__init__.py",
          "page.form.due() + own.written(", "own.written(", tests=OWN),
    Fault("a mistake of a department's template without its line", "tmm_report/report/own/__init__.py",
          "line = self.template.get_corresponding_lineno(trace.tb_lineno)", "line = 1", tests=OWN),
)  # fmt: skip

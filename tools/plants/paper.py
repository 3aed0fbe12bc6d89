"""Faults of how the note looks on paper: its profile."""

from faults import Fault

PROFILES = ("tests/report/test_profiles.py",)
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
)  # fmt: skip

"""Faults of the documentation site and of the reference of the format."""

from faults import Fault

ROOM = "tools/docsite/"
KEYS, SITE = ("tests/docsite/test_format_reference.py",), ("tests/docsite/test_site.py",)
FAULTS = (
    Fault("the documentation: maps under names are not walked", ROOM + "format_reference.py",
          "yield from self._maps(one, (*path, ANY))", "pass", tests=KEYS),
    Fault("the documentation: examples of another kind of map", ROOM + "format_reference.py",
          "if isinstance(around, dict) and (table is None or table.holds(around)):",
          "if isinstance(around, dict):", tests=KEYS),
    Fault("the documentation: the numbers of a formula are printed", ROOM + "theory_formulas.py",
          '"".join(pieces[:end])', '"".join(pieces)', tests=SITE),
    Fault("the documentation: Russian theory has English letters", ROOM + "theory_formulas.py",
          "formula(found[1], found[2], language)", 'formula(found[1], found[2], "en")', tests=SITE),
    Fault("the documentation: Russian theory has another formula", "docs/ru/theory/forces.md",
          "formula: compressor M_I2", "formula: compressor F_I2", tests=SITE),
    Fault("the documentation: links keep their place in the repository", ROOM + "site_pages.py",
          "way = os.path.relpath(target, PurePosixPath(page).parent)", "way = to", tests=SITE),
)  # fmt: skip

"""Faults of the note for word processors."""

from faults import Fault

NOTATION = ("tests/quantity/test_omml_notation.py",)
DOCX = ("tests/report/word/test_docx.py",)
EMF = ("tests/figures/test_emf.py",)
FORM = "tmm_report/report/formats/docx.py"
FORMULAS = "tmm_report/quantity/notations/omml.py"
LINES = "tmm_report/report/paper/office_math.py"
TREE = "tmm_report/report/word/tree.py"
SECTIONS = "tmm_report/report/word/sections.py"
PACKAGE = "tmm_report/report/word/package.py"
DRAWN = "tmm_report/figures/emf.py"
MACROS = "templates/macros.docx.j2"
FRAMED = "tmm_report/report/word/frames.py"
FAULTS = (
    Fault("word: frames in the middle of their line's thickness", FRAMED, "EMU * (one - THICK.width / 2)", "EMU * one",
          tests=DOCX),
    Fault("word: sheets of all sizes have the frame of A4", FRAMED, 'papers = {name: ("following", size)',
          'papers = {name: ("following", A4)', tests=DOCX),
    Fault("word: the block of the first sheet on those after it", FRAMED, '"": ("following", A4)}',
          '"": ("first", A4)}', tests=DOCX),
    Fault("word: the larger block on no sheet", SECTIONS, 'kind == "opening" and', 'kind == "closing" and', tests=DOCX),
    Fault("word: fractions upside down", FORMULAS, "num=above, den=below", "num=below, den=above", tests=NOTATION),
    Fault("word: a negative number loses its sign", FORMULAS, "self.negative(text) if parts.negative else text", "text",
          tests=NOTATION),
    Fault("word: bars of vectors lie below", FORMULAS, '_bar(text.replace(_BESIDE, ""), "top")',
          '_bar(text.replace(_BESIDE, ""), "bot")', tests=NOTATION),
    Fault("word: a sign is not repeated on the next line", LINES, "leaning(NOTHING) + leaning(before) if before",
          "leaning(NOTHING) if before", tests=NOTATION),
    Fault("word: lines longer than their room", LINES, "if _all(piece) <= line - 1.0:", "if _all(piece) <= 3 * line:",
          tests=NOTATION),
    Fault("word: markup of a name is markup", FORMULAS, "{xml_escape(text)}</m:t></m:r>'\n\n\ndef leaning",
          "{text}</m:t></m:r>'\n\n\ndef leaning", tests=NOTATION),
    Fault("word: pictures nine tenths as large", FORM, "EMU = 36_000", "EMU = 32_400", tests=DOCX),
    Fault("word: numbers of sections begin with another", FORM, 'Field("STYLEREF 1 \\\\s", before)',
          'Field("STYLEREF 2 \\\\s", last)', tests=DOCX),
    Fault("word: all formulas are counted through", FORM, "ARABIC \\\\s 1{again}", "ARABIC", tests=DOCX),
    Fault("word: a heading that is not counted is numbered", FORM, "return False\n        self.counts",
          "self.counts = counts\n            return True\n        self.counts", tests=DOCX),
    Fault("word: references lead to no bookmark", TREE, 'element("bookmarkStart", id=number, name=name)',
          'element("bookmarkStart", id=number, name=name + "x")', tests=DOCX),
    Fault("word: heads of tables are not repeated", TREE, 'if row.get("head") == "yes":', 'if row.get("head") == "no":',
          tests=DOCX),
    Fault("word: the last row of tables lost", MACROS, "{% for row in part.rows %}", "{% for row in part.rows[:-1] %}",
          tests=DOCX),
    Fault("word: tables that touch are one", TREE, 'elif one.tag == f"{W}tbl":', 'elif one.tag == f"{W}sdt":',
          tests=DOCX),
    Fault("word: paper larger than Word takes", FORM, "most = 22 * 25.4", "most = 40 * 25.4", tests=DOCX),
    Fault("word: lines begin with stops", "tmm_report/report/paper/punctuation.py", "([.,;:)»]+)(?!",
          "([!]+)(?!", tests=DOCX),
    Fault("word: stops stand apart from their units", "tmm_report/report/paper/punctuation.py", r'r"\1\2</m:t>"),',
          r'r"\g<0>"),', tests=DOCX),
    Fault("word: brackets part from their formulas", "tmm_report/report/paper/punctuation.py", "([(«]+)<m:oMath>",
          "([!]+)<m:oMath>", tests=DOCX),
    Fault("word: the index before its letter", FORMULAS, '_of("sSub", e=base, sub=sub)', '_of("sSub", sub=sub, e=base)',
          tests=DOCX),
    Fault("word: lying paper stands", SECTIONS, "if wide > tall:", "if wide < tall:",
          tests=DOCX),
    Fault("word: margins exchanged", SECTIONS, '"right": right, "bottom"', '"right": left, "bottom"',
          tests=DOCX),
    Fault("word: the clock in the file", PACKAGE, "ZipInfo(name, (1980, 1, 1, 0, 0, 0))",
          "ZipInfo(name, __import__('time').localtime()[:6])", tests=DOCX),
    Fault("word: pictures upside down", DRAWN, "(self.top - places.imag) * UNITS).astype",
          "(places.imag) * UNITS).astype",
          tests=EMF),
    Fault("word: dashes without gaps", DRAWN, "marks[::2], marks[1::2]", "marks[:-1:2], marks[2::2]", tests=EMF),
)  # fmt: skip

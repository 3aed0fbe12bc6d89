"""Formulas as parts of sentences: what stands behind a formula, and with what word its explanation begins.

A formula that another follows, or its explanation, ends with a comma; so does a sentence that ends with a formula.
Behind one that ends with words, and behind a table, the explanation begins a sentence of its own, behind a
colon it goes on without a word.
"""

from __future__ import annotations

import re

_MATH = r"<math\b[^>]*>[^<]*+(?:<(?!/?math\b)[^<]*+)*+</math>"
_HTML = (
    # formula, then a formula or its explanation
    (r'(</math>(?:</span>)?)(</div>(?:<div class="number">[^<]*</div>)?</div>\s*(?:</div>\s*)?)'
     r'(?=<p class="where">|<div class="formula"|<div class="beside">)', r"\1,\2"),
    (r'(</math>(?:</span>)?)\.(</p>\s*<p class="where">)', r"\1,\2"),
    (r'(\.</p>\s*<p class="where"><span class="item">)WHERE ', r"\1HERE "),
    (r'(</table>\s*</div>\s*</div>\s*<p class="where"><span class="item">)WHERE ', r"\1HERE "),
    (r'(:</p>\s*<p class="where"><span class="item">)WHERE ', r"\1"),
    # a factor stays with its formula, no line begins with a stop: browsers break beside a formula whatever joins it
    (rf"(?<=\s)([\d(«]++)({_MATH})([.,;:)]*+)", "<nobr>\\1\\2\N{WORD JOINER}\\3</nobr>"),
    (rf"({_MATH})([.,;:)]++)(?![^<]*</(?:div|th)>)",
     "<nobr>\\1\N{WORD JOINER}\\2</nobr>"),
    (r"(</math></span>)(?=[.,;:)](?![^<]*</(?:div|th)>))", "\\1\N{WORD JOINER}"),
)  # fmt: skip
_TEX = (
    (
        r"^(\\Note(?:Formula|Display|Beside)\{.*)\}((?:\s|\\NoteEnd)*)"
        r"(?=(?:\\begin\{NoteMany\})?\\NoteWhere WHERE |\\Note(?:Formula|Display|Beside)\{|\\NoteBegin)",
        r"\1,}\2",
    ),
    (r"(?<=\$)\.(\s*(?:\\begin\{NoteMany\})?\\NoteWhere WHERE )", r",\1"),
    (r"(\.\s*(?:\\begin\{NoteMany\})?\\NoteWhere )WHERE ", r"\1HERE "),
    (r"(\\end\{Note(?:Long)?Table\}\s*(?:\\begin\{NoteMany\})?\\NoteWhere )WHERE ", r"\1HERE "),
    (r"(:\s*(?:\\begin\{NoteMany\})?\\NoteWhere )WHERE ", r"\1"),
)
_TYPST = (
    (
        r'tail: ""([^\n]*\s*(?:\)\);\s*)?)'
        r"(?=\(tail: |#note-(?:formula|display|beside)\(|#note-where\(\[WHERE )",
        r'tail: ","\1',
    ),
    (r"(?<=[$/])\.(\s*#note-where\(\[WHERE )", r",\1"),  # behind a formula, or the mark of its width
    (r"(\.\s*#note-where\(\[)WHERE ", r"\1HERE "),
    (r"(/\*table\*/\s*#note-where\(\[)WHERE ", r"\1HERE "),
    (r"(:\s*#note-where\(\[)WHERE ", r"\1"),
    (r'^#"";\s*$', ""),  # a paragraph whose sentences refer to what is left out
)
_DOCX = (
    # the comma stands within the last line of the formula, at its mark
    (r"<!--tail-->([^\n]*\s*)(?=<!--formula-->|<!--where-->[^\n]*?>WHERE )",
     r"<m:r><m:rPr><m:nor/></m:rPr><m:t>,</m:t></m:r>\1"),
    (r"(?<=-->)<!--said-->([^\n]*\s*)(?=<!--formula-->|<!--where-->[^\n]*?>WHERE )", r",\1"),
    (r"(</m:oMath>(?:<!--[\d.]+-->)?)\.(</w:p>\s*<!--where-->[^\n]*?>WHERE )", r"\1,\2"),
    (r"(\.</w:p>\s*<!--where-->[^\n]*?>)WHERE ", r"\1HERE "),
    (r"(<!--/table-->\s*<!--where-->[^\n]*?>)WHERE ", r"\1HERE "),
    (r"(:</w:p>\s*<!--where-->[^\n]*?>)WHERE ", r"\1"),
    # word processors, too, break beside a formula: what clings to it is a part of it
    (r"(?<=[\s>])([(«]+)<m:oMath>", r"<m:oMath><m:r><m:rPr><m:nor/></m:rPr><m:t>\1</m:t></m:r>"),
    (r"</m:oMath>((?:<!--[\d.]+-->)?)([.,;:)»]+)(?![^<]*</w:p></n:cell>)",
     r"<m:r><m:rPr><m:nor/></m:rPr><m:t>\2</m:t></m:r></m:oMath>\1"),
    # and of its unit: LibreOffice sets pieces of text apart
    (r"(<m:nor/></m:rPr><m:t [^<]*)</m:t></m:r><m:r><m:rPr><m:nor/></m:rPr><m:t>([.,;:)»]+)</m:t>", r"\1\2</m:t>"),
)  # fmt: skip
_RULES = {"html": _HTML, "tex": _TEX, "typst": _TYPST, "docx": _DOCX}


def joined(text: str, fmt: str, where: str, here: str, dash: str) -> str:
    """The rendered note with its formulas and explanations joined into sentences, and with one dash between words.
    `where`, `here`: the words."""
    for pattern, put in _RULES.get(fmt, ()):
        pattern = pattern.replace("WHERE", re.escape(where))
        text = re.sub(pattern, put.replace("HERE", here.replace("\\", r"\\")), text, flags=re.M)
    return _dashed(_unbroken(text, fmt), fmt, dash)


_APART = re.compile(
    r"(<(svg|math|table|script|style|h[1-6])\b.*?</\2>)", re.S
)  # where no line breaks, or it must
_SLASH = re.compile(  # units: rad/s, (m/s²)/mm, кг·м²/рад
    r"(?<=[А-Яа-яё²³·)])/(?=[а-яё(])|(?<![\w./\"=-])((?:rad|rev|kg|mm|m|s|N|J|W)(?:·(?:kg|m|s))*[²³]?)/(?=(?:rad|rev|min|kg|mm|m|s)\b)"
)
_HYPHEN = re.compile(r"(?<=\d)(['′]?)-(?=[A-ZА-Я]\b)")  # members of a stage: 1-2-3-H


def _unbroken(text: str, fmt: str) -> str:
    """No line of the text ends within a unit or within a name of members, as it would behind a slash or a hyphen."""
    if fmt == "tex":  # which breaks at hyphens alone, at each
        before, begin, body = text.partition("\\begin{document}")
        named = r"(?<![\w{:./\\-])(\d['′]?(?:-\d['′]?)+(?:-[A-ZА-Я])?)(?![\w}:/-])"
        return before + begin + re.sub(named, r"\\mbox{\1}", body)
    if fmt == "html":
        parts = _APART.split(text)
        return "".join(
            _glued(parts[k]) + (parts[k + 1] if k + 1 < len(parts) else "") for k in range(0, len(parts), 3)
        )
    if fmt != "typst":
        return text
    # headings become bookmarks, which are searched as they are
    parts = re.split(
        r"(#note-picture\(.*?</svg>|^#note-(?:heading|contents-line)\([^\n]*)", text, flags=re.S | re.M
    )
    return "".join(part if k % 2 else _glued(part) for k, part in enumerate(parts))


def _glued(text: str) -> str:
    text = _SLASH.sub(lambda one: f"{one[1] or ''}/\N{WORD JOINER}", text)
    return _HYPHEN.sub("\\1-\N{WORD JOINER}", text)


_PICTURE = re.compile(r"(<svg.*?</svg>)", re.S)
_DRAWN = re.compile(r"(#note-picture\(.*?</svg>)", re.S)


def _dashed(text: str, fmt: str, dash: str) -> str:
    """The dash of the profile in the text, not in pictures: their lettering was laid out as it is."""
    if fmt == "html":
        return "".join(part if k % 2 else _put(part, dash) for k, part in enumerate(_PICTURE.split(text)))
    if fmt == "typst":
        return "".join(part if k % 2 else _put(part, dash) for k, part in enumerate(_DRAWN.split(text)))
    if fmt == "docx":
        return _put(text, dash)
    before, begin, body = text.partition("\\begin{document}")
    body = re.sub(r"(?<=\s)--(?=\s)", {"—": "---", "–": "--"}[dash], body)
    return before + begin + _put(body, dash)


def _put(text: str, dash: str) -> str:
    return re.sub(r"(?<=\s)–(?=\s)", dash, text)

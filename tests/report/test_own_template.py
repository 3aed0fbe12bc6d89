"""A department's own template: what its blocks put into the note, and what a hostile one is told."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from time import process_time

import pytest
from conftest import solved
from notes import VARIANTS, program, static
from typesetting import set_by_tex

from tmm_report import render
from tmm_report.loading import load
from tmm_report.problems import ProblemError
from tmm_report.report.own import names

DOCS = Path(__file__).parents[2] / "docs" / "department.md"
WORKED = re.search(r"```jinja\n(.*?)```", DOCS.read_text("utf-8"), re.S)[1]  # type: ignore[index]


def note(template: str | bytes, fmt: str = "html", name: str = "rotor") -> dict[str, bytes]:
    text = template if isinstance(template, bytes) else template.encode()
    results = solved(name)
    return render(
        replace(results, variant=replace(results.variant, template=(text, "department.j2"))), fmt, "ru"
    )


def html(template: str | bytes) -> str:
    return note(template)["note.html"].decode()


def block(body: str, name: str = "title") -> str:
    return f"{{% block {name} %}}\n{body}\n{{% endblock %}}\n"


def told(template: str | bytes) -> str:
    with pytest.raises(ProblemError) as error:
        note(template)
    return str(error.value)


@pytest.mark.parametrize("fmt", ["html", "tex"])
def test_the_worked_title_page_stands_for_ours(fmt):
    title = solved("rotor").variant.title
    text = note(WORKED, fmt)[f"note.{fmt}"].decode()
    assert (
        "РАСЧЁТНО-ПОЯСНИТЕЛЬНАЯ ЗАПИСКА" in text
        and ">Пояснительная" not in text
        and "big{Пояснительная" not in text
    )
    for said in (
        f"«{title.topic}»",
        f"Студент группы {title.group}",
        title.student,
        f"{title.city} {title.year}",
    ):
        assert said in text
    ours = render(solved("rotor"), fmt, "ru")[f"note.{fmt}"].decode()
    concluded = ours[ours.index("Заключение", ours.index("1.1")) :][:200]
    assert concluded in text and text.index("на трёх листах") > text.index(concluded)


@pytest.mark.exhaustive
def test_the_worked_title_page_is_set_by_latex():
    program("pdflatex")
    log, _ = set_by_tex(note(WORKED, "tex"))
    assert "Error" not in log and "Undefined control" not in log


def test_a_block_of_a_chapter_may_be_left_out_and_the_rest_refers_to_nothing_that_is_not_there():
    text = html(
        block('{{ m.section("Уравновешивание") }}{{ m.p("По заданию кафедры опущено.") }}', "machine_rotor")
    )
    assert "опущено" in text and "Главный вектор" not in text
    assert set(re.findall(r'href="#([^"]+)"', text)) <= set(re.findall(r' id="([^"]+)"', text))


@pytest.mark.parametrize("fmt", ["html", "tex"])
def test_figures_that_wait_stand_before_a_block_without_a_heading(fmt):
    text = note(block("{{ m.p('Выводов нет.') }}", "conclusions"), fmt, "crank_rocker")[
        f"note.{fmt}"
    ].decode()
    figure = {"html": "<figure ", "tex": r"\\begin\{Note(?:Figure|InRow)\}"}[fmt]
    before, _, behind = text.partition("Выводов нет.")
    assert re.search(figure, before)
    assert not re.search(figure, re.split(r'<h1 class="appendix"|\\NoteAppendix\{', behind)[0])


def test_what_stands_in_a_template_is_text():
    text = static(html(block("<b>x</b> & <script>alert(1)</script> {{ '<i>' }} {{ m.p('</p><u>') }}")))
    assert (
        "&lt;b&gt;x&lt;/b&gt; &amp;" in text
        and "<script" not in text
        and "&lt;i&gt;" in text
        and "<u>" not in text
    )
    tex = note(block("\\input{/etc/passwd} \\write18{ls} $x$"), "tex")["note.tex"].decode()
    assert "\\input{/etc" not in tex and "\\write18" not in tex.partition("\\begin{document}")[2]


HOSTILE = {
    "inside of an object": "{{ title.__class__.__mro__ }}",
    "inside of a function": "{{ parent.__globals__ }}",
    "inside of a macro": "{{ m.p._func.__globals__ }}",
    "inside of a method": "{{ t.__self__ }}",
    "inside of the block": "{{ self._TemplateReference__context }}",
    "by a filter": "{{ title|attr('__class__') }}",
    "a format": "{{ '{0.__class__}'.format(title) }}",
    "a file": "{% include '/etc/passwd' %}",
    "a file of ours": "{% import 'macros.html.j2' as x %}",
    "another template": "{% from 'chapters/title.j2' import line %}",
    "a power": "{{ 9 ** 9 ** 9 }}",
    "a long text": "{{ 'x' * 1000000000 }}",
    "a wide format": "{{ '%999999999d' % 1 }}",
    "a long list": "{{ [1] * 1000000000 }}",
    "centred": "{{ 'x'.center(1000000000) }}",
    "doubled": "{% set a = 'x' * 1 %}",
    "joined": "{% set a = 'xxxxxxxx' %}" + "{% set a = a ~ a %}" * 60,
    "joined by calls": "{% macro a(s, n) %}{% if n %}{% set x = a(s ~ s, n - 1) %}{% endif %}{% endmacro %}"
    "{{ a('xx', 99) }}",
    "a loop in a loop": "{% for a in [1]*1 %}{% endfor %}",
    "loops": "{% set l = [1,1,1,1,1,1,1,1,1,1] %}"
    + "{% for a in l %}" * 9
    + "{% set b = 1 %}"
    + "{% endfor %}" * 9,
    "calls": "{% macro a(n) %}{% if n %}{{ a(n - 1) }}{{ a(n - 1) }}{% endif %}{% endmacro %}{{ a(60) }}",
    "itself": "{{ self.title() }}",
    "a loop of itself": "{% macro a() %}{{ a() }}{% endmacro %}{{ a() }}",
    "ours twice": "{{ parent() }}{{ parent() }}",
    "no such name": "{{ page.form.files }}",
    "no such macro": "{{ m.figure(1) }}",
    "no such style": "{{ m.titlepage([{'style': 'x}\\\\input', 'text': 'a'}]) }}",
    "no such filter": "{{ 'a'|replace('a', 'b') }}",
    "a range": "{% for a in range(10) %}{% endfor %}",
    "changed": "{% set l = [1] %}{{ l.append(2) }}",
    "not lines": "{{ m.titlepage(5) }}",
    "a label twice": "{{ m.section('a', label='x') }}{{ m.section('a', label='x') }}",
    "no end": "{% if 1 %}",
    "deep": "{{ " + "(" * 3000 + "1" + ")" * 3000 + " }}",
    "a long number": "{{ " + "9" * 6000 + " }}",
}


@pytest.mark.parametrize("what", HOSTILE)
def test_what_a_template_may_not_do_is_told_with_its_line(what):
    began = process_time()
    said = told("\n" + block(HOSTILE[what]))
    assert re.match(r"department\.j2:[123456]:1: ", said), said
    assert process_time() - began < 5 and len(said) < 600


@pytest.mark.parametrize(
    ("template", "said"),
    [
        (b"\xff\xfe", "UTF-8"),
        (block("x", "titel"), "titel"),
        (block("x", "cams_least"), "cams_least"),
    ],
)
def test_what_is_no_template_of_the_note_is_told(template, said):
    found = told(template)
    assert found.startswith("department.j2:1:1: ") and said in found


def test_every_template_that_the_note_asks_for_has_its_block():
    assert {
        "title",
        "assignment",
        "introduction",
        "conclusions",
        "references",
        "lever_structure",
        "find",
    } <= names()
    assert "cams_least" not in names()


def test_it_stands_beside_the_variant(tmp_path):
    (tmp_path / "a.yaml").write_text((VARIANTS / "rotor.yaml").read_text("utf-8"), encoding="utf-8")
    (tmp_path / "кафедра.j2").write_text(WORKED, encoding="utf-8")
    found = load(tmp_path / "a.yaml")
    assert found.template == (WORKED.encode(), str(tmp_path / "кафедра.j2"))
    (tmp_path / "кафедра.j2").write_bytes(b"x" * 40_000)
    with pytest.raises(ProblemError, match=r"кафедра\.j2"):
        load(tmp_path / "a.yaml")

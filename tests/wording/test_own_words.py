"""A department's own words stand in every text of its notes, with the endings of those in whose place they are."""

from __future__ import annotations

import re

import pytest
from notes import render

from tmm_report import load, solve
from tmm_report.i18n import Translator
from tmm_report.languages import LANGUAGES
from tmm_report.loading import loads
from tmm_report.problems import ProblemError
from tmm_report.variant import new
from tmm_report.wording.kazakh import other
from tmm_report.wording.terms import Rewording, plain, usual

FORMS = """
сырғыма тиек: ның тің, ны ті, ға ке, да те, дан тен, мен пен, лар тер, лы ті, сыз сіз, дағы тегі, ларының терінің,
    ларына теріне, ларын терін
айналшақ иінді: тың нің, ты ні, қа ге, та де, тан ден, пен мен, тар лер, тарында лерінде, тағы дегі
буын мүше: ның нің, ды ні, ға ге, да де, нан ден, мен мен, дар лер, ы сі, ының сінің, ына сіне, ындағы сіндегі, сыз сіз
буын звено: ның ның, ға ға, дар лар, мен мен, ында сында, ынан сынан
бұлғақ шатун: тың ның, ты ды, қа ға, тан нан, пен мен, тар дар, тарын дарын
маховик сермер: тің дің, ке ге, тер лер, пен мен, тегі дегі
саты каскад: ның тың, ны ты, ға қа, лар тар, сы ы, сында ында, мен пен
модуль айырым: дің ның, ді ды, ге ға, де да, ден нан, мен мен, дер дар, дерін дарын
тіс қыл: тің дың, ке ға, тен дан, тер дар, пен мен, і ы, тері дары
"""
"""Word, own word: ending of the one, of the other; by the tables of the school grammar."""


def forms():
    for line in FORMS.replace(",\n   ", ",").strip().splitlines():
        words, _, pairs = line.partition(": ")
        for pair in pairs.split(", "):
            yield (*words.split(), *pair.split())


@pytest.mark.parametrize(("word", "own", "ending", "owns"), [*forms()])
def test_an_ending_goes_to_another_kazakh_word_by_harmony(word, own, ending, owns):
    assert other(word, ending, own) == own + owns
    assert other(word, ending, word) == word + ending, "in its own place a word stays as it is"
    assert other(own, owns, own) == own + owns


@pytest.mark.parametrize(
    ("word", "form", "own", "said"),
    [
        ("айналшақ", "айналшағының", "бұлғақ", "бұлғағының"),
        ("айналшақ", "айналшағы", "кривошип", "кривошибі"),
        ("сырғыма", "сырғымасында", "тиек", "тиегінде"),
        ("тиек", "тиегін", "сырғыма", "сырғымасын"),
    ],
)
def test_the_last_sound_is_softened_before_a_vowel(word, form, own, said):
    soft = form[len(word) - 1] != word[-1]
    assert other(word, form[len(word) - soft :], own) == said


def reworded(code: str, **words) -> Rewording:
    return Rewording(code, tuple(words.items()))


def test_words_of_a_language_whose_nouns_are_declined_keep_the_endings():
    say = reworded("ru", slider="бегун", rocker=(("коромысло", "качалка"), ("коромысла", "качалки")))
    assert say("Скорость ползуна и ползунов, ползуном") == "Скорость бегуна и бегунов, бегуном"
    assert say("Коромысло и длина коромысла") == "Качалка и длина качалки"
    assert say("ПОЛЗУН") == "БЕГУН" and say("подползунный") == "подползунный"


def test_a_term_of_several_words():
    say = Rewording("ru", (("force polygon", "многоугольник сил"), ("planet gear", "спутник")))
    assert (
        say("по плану сил и планам сил сателлитов") == "по многоугольнику сил и многоугольникам сил спутников"
    )


def test_names_of_values_are_no_words():
    say = reworded("en", slider="block")
    assert say("slider %(slider)s of sliders: %(slider)d") == "block %(slider)s of blocks: %(slider)d"


# ---------------------------------------------------------------- in a note

STATED = "words: {slider: бегун, crank: {кривошип: коленце, кривошипа: коленца}}\n"


def stated(words: str, code: str = "ru") -> str:
    return new(code).replace("Кривошипно-ползунный механизм", "Насос") + words


def seen(page: str) -> str:
    return re.sub(r"<script.*?</script>|<style.*?</style>|<[^>]*>", " ", page, flags=re.S)


@pytest.mark.parametrize("fmt", ["html", "tex"])
def test_a_note_has_the_own_words_alone(fmt):
    results = solve(loads(stated(STATED)))
    usually = "\n".join(one.decode() for one in render(solve(loads(stated(""))), fmt).values())
    page = "\n".join(one.decode() for one in render(results, fmt).values())
    assert len(re.findall("ползун", seen(usually), re.I)) > 5
    assert not re.findall(r"ползун|\bкривошипа?\b", seen(page), re.I)
    assert len(re.findall("бегун", seen(page), re.I)) == len(re.findall("ползун", seen(usually), re.I))


def test_numbers_call_things_so_too():
    """Whatever was said before by the same program: a batch has variants of several departments."""
    assert "ползун" in render(solve(loads(stated(""))), "json")["results.json"].decode()
    found = render(solve(loads(stated(STATED))), "json")["results.json"].decode()
    assert "бегун" in found and "ползун" not in found


def test_a_note_in_another_language_has_its_own_words():
    results = solve(loads(stated(STATED)))
    assert "бегун" not in render(results, "html", "en")["note.html"].decode()


def test_a_department_states_them_for_all_its_variants(tmp_path):
    (tmp_path / "department.yaml").write_text(STATED, "utf-8")
    (tmp_path / "my.yaml").write_text(stated("words: {crank: колено}\n"), "utf-8")
    found = load(tmp_path / "my.yaml").words
    assert dict(found.words) == {"slider": "бегун", "crank": "колено"}


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("words: {slidr: бегун}", "words.slidr: the glossary has no term slidr; for example slider"),
        ("words: {slider: ''}", "words.slider: a word of at most 60 letters is expected here"),
        (f"words: {{slider: {'а' * 61}}}", "words.slider: a word of at most 60 letters is expected here"),
        ("words: {slider: '12'}", "words.slider: a word of at most 60 letters is expected here"),
        ("words: {slider: [а, б]}", "words.slider: this has another form than expected here"),
        ('words: {slider: "бе\\u202eгун"}', "words.slider: "),
        ("words: бегун", "words: keys with values are expected here"),
    ],
)
def test_what_is_no_word_is_told(words, said):
    with pytest.raises(ProblemError) as told:
        loads(stated(words + "\n"))
    (problem,) = told.value.problems
    assert said in problem.text() and problem.line


def test_a_term_may_be_named_by_its_word():
    assert dict(loads(stated("words: {ползун: бегун, planet_gear: спутник}\n")).words.words) == {
        "slider": "бегун",
        "planet gear": "спутник",
    }


@pytest.mark.parametrize("code", [row.code for row in LANGUAGES.values() if not row.ids])
def test_each_word_in_its_own_place_changes_nothing(code):
    """Of every text of the catalogue: a second way to all the endings that there are."""
    from catalogues import messages

    tool = messages()
    say = Rewording(code, tuple((term, plain(word)) for term, word in usual(code).items()))
    texts = [
        form
        for entry in tool["messages"](tool["merged"](code, "note"))
        for form in tool["as_forms"](entry.string or "")
        if form
    ]
    assert len(texts) > 5000
    assert [(form, say(form)) for form in texts if say(form) != form] == []


def test_what_is_counted_has_them_too():
    tr = Translator("en", None, reworded("en", slider="block"))
    assert [tr.ngettext("%(n)s slider", "%(n)s sliders", n) for n in (1, 2)] == [
        "%(n)s block",
        "%(n)s blocks",
    ]


def test_a_translator_with_words_is_hashable():
    tr = Translator("ru", None, reworded("ru", slider="бегун"))
    assert {tr: 1}[Translator("ru", None, reworded("ru", slider="бегун"))] == 1
    assert tr.gettext("slider") == "бегун"

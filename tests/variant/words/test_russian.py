"""Value words in Russian are read as their English twins; a Russian key is answered with the English one."""

import pytest

from tmm_report import loading
from tmm_report.languages import LANGUAGES
from tmm_report.problems import ProblemError
from tmm_report.variant import russian
from tmm_report.variant.russian.keys import SYMBOLS

MECHANISM = """language: ru
mechanism:
  frame: {O: [0, 0], C: [0.1, 0.2]}
  guides: {x: {through: O}}
  links: {1: {points: {O: 0, A: 1}}, 2: {points: {A: 0, B: 3}}, 3: {points: [B], slides: x}}
  driver: {link: 1, speed: 60 rpm, rotation: ROTATION, zero: {point: B, extreme: EXTREME}}
  assembly: {B: SIDE}
loads:
  gravity: {value: 9.81, direction: DOWN}
  forces: [{at: B, direction: AGAINST, constant: 10}]
  moments: [{on: 2, direction: SENSE, constant: 1}]
"""
ENGLISH = {
    "ROTATION": "clockwise",
    "EXTREME": "left",
    "SIDE": "right",
    "DOWN": "down",
    "AGAINST": "against motion",
    "SENSE": "counter-clockwise",
}
RUSSIAN = {
    "ROTATION": "по часовой стрелке", "EXTREME": "влево", "SIDE": "справа", "DOWN": "вниз",
    "AGAINST": "Против движения", "SENSE": "против часовой",
}  # fmt: skip


def stated(words):
    text = MECHANISM
    for key, word in words.items():
        text = text.replace(key, word)
    return loading.loads(text).lever


def test_words_in_russian_are_read_as_their_twins():
    one, other = stated(ENGLISH), stated(RUSSIAN)
    assert one.loads == other.loads
    assert one.mechanism.driver == other.mechanism.driver or vars(one.mechanism.driver) == vars(
        other.mechanism.driver
    )
    assert one.mechanism.assembly == other.mechanism.assembly


def test_a_side_of_a_line_in_russian():
    words = RUSSIAN | {"SIDE": "слева от A-C"}
    assert stated(words).mechanism.assembly == stated(ENGLISH | {"SIDE": "left of A-C"}).mechanism.assembly


def test_the_kind_of_a_stage_in_russian():
    stage = "{kind: цилиндрическая, mesh: внешнее, ratio: 3, module: 3 mm}"
    text = f"language: ru\ndrive: {{speed: 1000 rpm, stages: [{stage}]}}\n"
    one, other = (loading.loads(one).drive for one in (text, text.replace("цилиндрическая", "spur")))
    assert [type(stage) for stage in one.stages] == [type(stage) for stage in other.stages]


def enumerated(schema):
    """Every word that stands in an enumeration of the schema."""
    if isinstance(schema, dict):
        found = [word for word in (*schema.get("enum", ()), schema.get("const")) if isinstance(word, str)]
        return {*found, *(word for value in schema.values() for word in enumerated(value))}
    return {word for value in schema for word in enumerated(value)} if isinstance(schema, list) else set()


def test_every_word_of_the_format_has_its_twin():
    assert enumerated(loading.schema()) - russian.words() - set(LANGUAGES) == set()


def test_every_word_is_understood_as_it_may_be_typed():
    """Names of people and of standards have capitals; ё is often left without its dots."""
    for word, twins in russian._TWINS.items():
        for twin in twins.split(", "):
            for typed in (twin, twin.upper(), twin.capitalize(), twin.replace("ё", "е")):
                assert russian.english(typed, [word]) == word


def keys_of(schema):
    """Every key that the schema knows by name."""
    found = set()
    if isinstance(schema, dict):
        properties = schema.get("properties")
        found |= set(properties) if isinstance(properties, dict) else set()
        schema = list(schema.values())
    return found.union(*map(keys_of, schema)) if isinstance(schema, list) else found


def test_every_key_of_the_format_has_its_twin_and_is_answered_by_it():
    keys = keys_of(loading.schema()) - SYMBOLS
    assert keys - russian.keys() == set()
    for key in keys:
        twins = russian._KEYS[key].split(", ")
        assert all(russian.english_key(twin, [key]) == key for twin in twins), key


def test_no_twin_stands_for_two_words_of_one_place():
    def places(schema):
        if isinstance(schema, dict):
            if "enum" in schema:
                yield schema["enum"]
            for value in schema.values():
                yield from places(value)
        elif isinstance(schema, list):
            for value in schema:
                yield from places(value)

    for words in places(loading.schema()):
        for twin, meant in russian._ENGLISH.items():
            assert len(meant & set(map(str, words))) < 2, (twin, words)


@pytest.mark.parametrize(
    ("text", "path", "word"),
    [
        (MECHANISM + "трение: {}\nмаховик: {}\n", "трение", "friction"),
        (MECHANISM.replace("gravity:", "тяжесть:"), "loads.тяжесть", "gravity"),
        (MECHANISM.replace("driver:", "ведущее звено:"), "mechanism.ведущее звено", "driver"),
        (MECHANISM.replace("links:", "Звенья:"), "mechanism.Звенья", "links"),
    ],
)
def test_a_russian_key_is_answered_with_the_english_one(text, path, word):
    for key, one in ENGLISH.items():
        text = text.replace(key, one)
    with pytest.raises(ProblemError) as caught:
        loading.loads(text)
    told = {problem.key: problem.text() for problem in caught.value.problems}
    assert told[path].endswith(f"keys are English words: {word}")


def test_names_and_texts_stay_as_they_are():
    text = MECHANISM.replace("{O: [0, 0], C: [0.1, 0.2]}", "{O: [0, 0], вниз: [0.1, 0.2]}")
    for key, one in RUSSIAN.items():
        text = text.replace(key, one)
    found = loading.loads(text + "title: {topic: насос}\n")
    assert "вниз" in found.lever.mechanism.links["0"].points and found.title.topic == "насос"

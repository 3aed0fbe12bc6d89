"""Names of outputs: legal everywhere, never twice, and nobody's own choice."""

import unicodedata

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tmm_report.intake.ids import LENGTH, safe, unique

NAMES = st.text(max_size=80) | st.sampled_from(
    ["CON", "nul.txt", "..", "a", "A", "\u0130", "ß", "ss", "й", "и\u0306"]
)


@pytest.mark.parametrize(
    ("name", "made"),
    [
        ("ivanov", "ivanov"), ("Иванов Иван_12345", "Иванов_Иван_12345"), ("../../etc/passwd", "_.._etc_passwd"),
        (".hidden", "hidden"), ("--rf", "rf"), ("a.", "a"), ("a ", "a_"), ("CON", "_CON"), ("com1.tar", "_com1.tar"),
        ("lpt¹", "_lpt¹"), ("", "_"), ("...", "_"), ("a\nb\x1b[31m", "a_b__31m"), ("и\u0306", "й"), 
        ("ж" * 200, "ж" * 60),
        ("a:b|c?", "a_b_c_"), ("\u202egpj.exe", "_gpj.exe"),
    ],
)  # fmt: skip
def test_a_name_becomes_a_legal_one(name, made):
    assert safe(name) == made


def legal(name: str) -> bool:
    plain = all(c.isalnum() or c in "._-" for c in name) and unicodedata.normalize("NFC", name) == name
    device = unicodedata.normalize("NFKC", name).split(".")[0].upper() in {
        "CON",
        "PRN",
        "AUX",
        "NUL",
        "COM1",
        "LPT9",
    }
    return plain and not device and 0 < len(name) <= LENGTH and name[0] not in ".-" and name[-1] not in ". "


@given(st.lists(NAMES, max_size=12))
@example(["a", "A", "a-" + "0" * 8])
def test_any_names_become_legal_and_different_ones(names):
    made = unique([(name, f"place {index}") for index, name in enumerate(names)])
    assert all(map(legal, made))
    assert len({name.casefold() for name in made}) == len(made)
    assert len({unicodedata.normalize("NFD", name.upper()) for name in made}) == len(made)


@given(st.lists(NAMES, max_size=8), st.randoms(use_true_random=False))
def test_the_order_changes_nobodys_name(names, shuffling):
    pairs = [(name, f"place {index}") for index, name in enumerate(names)]
    expected = dict(zip(pairs, unique(pairs), strict=True))
    shuffling.shuffle(pairs)
    assert dict(zip(pairs, unique(pairs), strict=True)) == expected


def test_a_name_that_imitates_anothers_hash_is_told_apart():
    first, second = unique([("a", "1"), ("A", "2")])
    imitated = unique([("a", "1"), ("A", "2"), (first, "3"), (second.upper(), "4")])
    assert len({name.casefold() for name in imitated}) == 4


def test_long_twins_stay_short():
    made = unique([("ж" * 70, "1"), ("ж" * 75, "2")])
    assert len(set(made)) == 2 and all(len(name) == LENGTH for name in made)


def test_two_things_that_nothing_tells_apart_are_an_error_and_no_endless_search():
    with pytest.raises(ValueError, match="same second part"):
        unique([("a", "1"), ("a", "1")])

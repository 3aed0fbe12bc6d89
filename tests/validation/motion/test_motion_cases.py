"""Every published worked example of machines in motion is held against the program by one of the files beside this."""

from __future__ import annotations

from pathlib import Path

import pytest
from cases import agrees, every

HERE = Path(__file__)
TEXTS = {file.name: file.read_text("utf-8") for file in HERE.parent.glob("test_motion_*.py") if file != HERE}


@pytest.mark.parametrize("name", sorted(every()))
def test_an_example_is_checked_by_a_test(name):
    assert [file for file, text in TEXTS.items() if f'"{name}"' in text]


def test_there_are_enough_of_them():
    assert len(every()) >= 56 and len(TEXTS) >= 8


def test_a_number_that_is_not_the_published_one_is_told():
    with pytest.raises(AssertionError, match=r"J_kgm2 = 0\.41, recomputed 0\.4017533"):
        agrees("dubey-2-1-two-loads", J_kgm2=0.41)


def test_printed_digits_count_where_the_source_is_right():
    """3.0 is printed for 3.018: another number of these digits is not the recomputed one all the same."""
    with pytest.raises(AssertionError, match="recomputed"):
        agrees("sarkar-7-1-watt", percent=3.02)


def test_where_the_source_errs_its_numbers_are_not_asked_for():
    agrees("khurmi-16-13-third-harmonic", Cs2_percent=0.1678388)
    with pytest.raises(AssertionError):
        agrees("khurmi-16-13-third-harmonic", Cs2_percent=0.020)


def test_an_output_that_an_example_has_not_is_told():
    with pytest.raises(AssertionError, match="is no output of the example"):
        agrees("dubey-2-1-two-loads", J=0.4)

"""A unit is read as it is printed, in every language of the notes."""

from __future__ import annotations

import pytest
from spoken import EVERY

from tmm_report.quantity.text import UNITS, unit_text
from tmm_report.quantity.units import is_unit, parse

READ = [unit for unit in UNITS if is_unit(unit)]  # not volts and amperes, which no variant states


@pytest.mark.parametrize("code", EVERY)
def test_what_is_printed_is_read(code):
    assert len(READ) > 15
    assert [unit for unit in READ if not is_unit(unit_text(unit, code))] == []


@pytest.mark.parametrize("code", EVERY)
def test_units_of_time_and_speed_keep_their_size(code):
    assert parse(f"2 {unit_text('h', code)}", "time") == pytest.approx(7200)
    assert parse(f"3 {unit_text('min', code)}", "time") == pytest.approx(180)
    assert parse(f"30 {unit_text('rpm', code)}", "speed") == pytest.approx(3.14159265)

"""Names with stars in the ways of chapters, against regular expressions."""

from __future__ import annotations

import re

from hypothesis import given
from hypothesis import strategies as st

from tmm_report.quantity.ways import fits


@given(st.text("ab_.*", max_size=7), st.text("ab_.", max_size=8))
def test_a_star_stands_for_any_text_without_a_dot(pattern, name):
    match = re.fullmatch("([^.]*)".join(map(re.escape, pattern.split("*"))), name)
    assert fits(pattern, name) == (match.groups() if match else None)

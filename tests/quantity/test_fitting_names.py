"""Names with stars in the ways of chapters, against regular expressions."""

from __future__ import annotations

import re
from itertools import chain, zip_longest

from hypothesis import example, given
from hypothesis import strategies as st

from tmm_report.quantity.ways import fits

SHORT = st.text("ab_.", max_size=2)


@given(st.lists(SHORT, min_size=1, max_size=4), st.lists(SHORT, max_size=3))
@example(["a", "b"], ["_."])
def test_a_star_stands_for_any_text_without_a_dot(parts, between):
    """Names that are made from the parts of the pattern, so that many of them fit."""
    name = "".join(chain.from_iterable(zip_longest(parts, between, fillvalue="")))
    match = re.fullmatch("([^.]*)".join(map(re.escape, parts)), name)
    assert fits("*".join(parts), name) == (match.groups() if match else None)

"""Numbers, each once."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.distinct import distinct


@given(st.lists(st.floats(allow_nan=False) | st.sampled_from([0.0, -0.0, 1.0])))
def test_as_numpy_finds_them(values):
    assert np.array_equal(distinct(np.array(values)), np.unique(np.array(values)))
    assert np.array_equal(distinct(np.array(values).reshape(-1, 1)), np.unique(np.array(values)))

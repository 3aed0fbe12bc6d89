"""The mechanism plays at 60 frames a second, by Chromium's own trace: what a frame costs the main thread, ms of CPU,
which other processes of the machine hardly change."""

from __future__ import annotations

import pytest
from test_living_data import page
from test_living_page import opened, run

from benchmarks.living import IN_SIGHT, played

FRAME = 1000 / 60  # ms


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["compressor", "hay_press"])  # of six links and of eight
def test_a_frame_is_done_before_the_next(name):
    """With all vectors and numbers shown and loading schemes, plans in sight."""
    with opened(page(name)) as talk:
        run(talk, IN_SIGHT)
        _, busy = played(talk)
    assert 1 < busy < FRAME

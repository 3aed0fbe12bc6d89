"""Ready variants for the tests: `variant` or `results` runs a test once for every lever mechanism of variants/."""

import os
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from hypothesis import settings

from tmm_report import course
from tmm_report.course import load

# in CI the same examples at every run; elsewhere new ones, so that something new is found now and then
settings.register_profile("ci", derandomize=True, deadline=None)
settings.register_profile("dev", deadline=None)
settings.load_profile("ci" if os.environ.get("CI") else "dev")

ALL_FILES = sorted(Path(__file__).parents[1].joinpath("variants").glob("*.yaml"))
FILES = [path for path in ALL_FILES if "\nmechanism:" in path.read_text("utf-8")]  # others have gears alone
every_variant = pytest.fixture(params=[path.stem for path in FILES])


@cache
def read(name: str) -> course.Variant:
    return load(next(path for path in ALL_FILES if path.stem == name))


@cache
def solved(name: str) -> course.Results:
    return course.solve(read(name))


def stating(variant: course.Variant, **changes) -> course.Variant:
    """The variant with something else given of its lever mechanism: `stating(variant, loads=None)`."""
    return replace(variant, lever=replace(variant.lever, **changes))


@every_variant
def variant(request) -> course.Variant:
    return read(request.param)


@every_variant
def results(request) -> course.Results:
    return solved(request.param)


@pytest.fixture(scope="session")
def compressor() -> course.Results:
    return solved("compressor")

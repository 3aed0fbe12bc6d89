"""Ready variants for the tests: `variant` or `results` runs a test once for every lever mechanism of variants/."""

import gc
import os
import signal
from dataclasses import replace
from functools import cache
from pathlib import Path

import once
import pytest
from hypothesis import settings

from tmm_report import backwards, course
from tmm_report.loading import load

pytest_plugins = ["cpu", "exhaustive"]

# what a shell starts in the background ignores Ctrl-C; the programs that tests interrupt would inherit this
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# few examples and new ones, so that something new is found now and then; or more, the same at every run
settings.register_profile("dev", deadline=None, max_examples=15)
settings.register_profile("ci", deadline=None, max_examples=30, derandomize=True)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))


def examples(of_a_hundred: int) -> int:
    """How many examples to try where others try a hundred in a profile of so many; the first is the simplest one."""
    return max(3, round(of_a_hundred * settings.default.max_examples / 100))


ALL_FILES = sorted(Path(__file__).parents[1].joinpath("variants").glob("*.yaml"))
LEVERS = [path for path in ALL_FILES if "\nmechanism:" in path.read_text("utf-8")]  # others have gears alone
# a cam's law is no length, so that it cannot be renamed, scaled or turned as linkages are: it has tests of its own
FILES = [path for path in LEVERS if "\n  cams:" not in path.read_text("utf-8")]
STATEMENTS = [
    Path(__file__).parent / f"{name}.yaml"
    for name in (
        "statements/uneven_crank",
        "cases/explain/law_rocker",
        "cases/explain/law_accelerated",
        "cases/explain/sprung_screen",
        "statements/slider_drives",
        "cases/explain/slot_by_slider",
        "cases/explain/scissor_lift",
        "cases/explain/boom_by_cylinder",
        "statements/cardan_drive",
        "statements/sun_and_planet",
        "statements/roller_on_rail",
    )
]
"""Mechanisms that a slider or a cylinder drives, or whose driving link moves by a law, or with springs and dampers, or
with wheels whose axes move: no ready variant has one, and their notes are read as those are."""
every_variant = pytest.fixture(params=[path.stem for path in FILES])


def path_of(name: str) -> Path:
    """Of a ready variant, one of STATEMENTS, or a file beside this one: "statements/knuckle_press"."""
    if "/" in name:
        return Path(__file__).parent / f"{name}.yaml"
    return next(path for path in (*ALL_FILES, *STATEMENTS) if path.stem == name)


@cache
def read(name: str) -> course.Variant:
    return load(path_of(name))


@cache
def solved(name: str) -> course.Results:
    return backwards.solve(read(name))


def stating(variant: course.Variant, **changes) -> course.Variant:
    """The variant with something else given of its lever mechanism: `stating(variant, loads=None)`."""
    return replace(variant, lever=replace(variant.lever, **changes))


@cache
def unread(variant: course.Variant) -> course.Results:
    """Solved without the readings from paper: they hold for the numbers of that variant alone."""
    return course.solve(stating(variant, readings={}))


@every_variant
def variant(request) -> course.Variant:
    return read(request.param)


@every_variant
def results(request) -> course.Results:
    return solved(request.param)


@pytest.fixture(scope="session")
def compressor() -> course.Results:
    return solved("compressor")


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log):
    """Tests that stand together go to one worker, which makes what they share once; who is done takes from others."""
    if config.getvalue("dist") == "load":
        from xdist.scheduler import WorkStealingScheduling

        return WorkStealingScheduling(config, log)
    return None


@pytest.hookimpl(trylast=True)
def pytest_collection_finish(session: pytest.Session) -> None:
    """Thousands of collected tests and imported modules stay to the end: nothing is gained by looking through them at
    every hundred new objects."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 10, 10)


@pytest.fixture(scope="session", autouse=True)
def shared_folder(tmp_path_factory) -> None:
    """Workers of one run, each with a folder in that of the run, share what is made once."""
    folder = tmp_path_factory.getbasetemp()
    if os.environ.get("PYTEST_XDIST_WORKER"):
        folder = folder.parent
        once.folder = folder / "once"
        once.folder.mkdir(exist_ok=True)
    if os.environ.pop("PYTHONDONTWRITEBYTECODE", ""):  # processes that tests start: none compiles all anew
        os.environ["PYTHONPYCACHEPREFIX"] = str(folder / "compiled")

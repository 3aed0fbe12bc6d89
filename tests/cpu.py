"""What each part of the tests costs: `pytest --cpu-by-room`, CPU seconds with those of the programs a test starts.

With xdist the seconds of the workers are added; what a worker spends outside its tests (imports, collecting)
is a part of its own.
"""

from __future__ import annotations

import os
from collections import Counter

import pytest

OUTSIDE = "imports, collecting"
LEVELS = ("room", "file", "test")


def spent() -> float:
    """CPU seconds of this process and of the programs it started and waited for."""
    return sum(os.times()[:4])


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--cpu-by-room", action="store_const", dest="cpu", const="room", help="CPU by folder")
    parser.addoption("--cpu-by", choices=LEVELS, dest="cpu", help="CPU by room (folder), file or test")


def pytest_configure(config: pytest.Config) -> None:
    if config.getoption("cpu"):
        config.pluginmanager.register(Meter(config), "cpu-meter")


def part(nodeid: str, level: str) -> str:
    """tests/chapters/gears/test_drive.py::test_x[a] → tests/chapters, or its file, or the test without parameters."""
    file = nodeid.split("::")[0]
    if level == "test":
        return nodeid.split("[")[0]
    return file.rpartition("/")[0] if level == "room" else file


class Meter:
    """Adds up what every test took, in this process or told by the workers."""

    def __init__(self, config: pytest.Config) -> None:
        self.level: str = config.getoption("cpu")
        self.seconds: Counter[str] = Counter()
        self.tests: Counter[str] = Counter()
        self.inside = 0.0  # of this process

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item):
        """Report the whole of a test, fixtures made for it included, with its last phase."""
        self.start = spent()
        return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self, item: pytest.Item, call: pytest.CallInfo[None]):
        report = yield
        now = spent()
        report.cpu, self.start = now - self.start, now
        self.inside += report.cpu
        return report

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        name = part(report.nodeid, self.level)
        self.seconds[name] += report.cpu  # type: ignore[attr-defined]
        self.tests[name] += report.when == "call"

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node) -> None:
        self.seconds[OUTSIDE] += node.workeroutput.get("outside", 0.0)

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        outside = spent() - self.inside
        if hasattr(session.config, "workeroutput"):
            session.config.workeroutput["outside"] = outside
        else:
            self.own = outside

    def pytest_terminal_summary(self, terminalreporter) -> None:
        # the children of the process that shares the tests out are the workers, and they have spoken themselves
        shared = terminalreporter.config.pluginmanager.hasplugin("dsession")
        self.seconds[OUTSIDE] += sum(os.times()[:2]) if shared else self.own
        terminalreporter.section(f"CPU seconds by {self.level}")
        for name, seconds in self.seconds.most_common():
            terminalreporter.line(f"{seconds:9.1f} {self.tests[name]:6}  {name}")
        terminalreporter.line(f"{self.seconds.total():9.1f} {self.tests.total():6}  all")

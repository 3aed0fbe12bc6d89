"""How far a batch is: so many of so many, how many a second, how long still."""

from __future__ import annotations

from time import monotonic

from tmm_report.commands.talk import Talk
from tmm_report.problems import N_, Message

OFTEN = 0.2  # s between two lines


class Progress:
    """Tells of itself at most five times a second. `count`: of all tasks, None where it is not known."""

    def __init__(self, talk: Talk, count: int | None):
        self.talk, self.count = talk, count
        self.found = self.made = 0
        self._began = self._told = monotonic()

    def kept(self) -> None:
        """A task was done in an earlier run."""
        self.found += 1
        self._tell()

    def done(self) -> None:
        self.made += 1
        self._tell()

    @property
    def ready(self) -> int:
        return self.found + self.made

    def _tell(self) -> None:
        now = monotonic()
        if now - self._told >= OFTEN:
            self._told = now
            self.talk.stage(self.line(now - self._began))

    def line(self, taken: float) -> Message:
        """What is said when the tasks made so far took so many seconds."""
        rate = self.made / taken if taken > 0 else 0.0
        values = {"done": self.ready, "rate": f"{rate:.3g}"}
        if self.count is None:
            return Message(N_("%(done)s variants, %(rate)s a second"), values)
        left = clock((self.count - self.ready) / rate) if rate else "—"
        text = N_("%(done)s of %(all)s, %(rate)s a second, %(left)s left")
        return Message(text, values | {"all": self.count, "left": left})


def clock(seconds: float) -> str:
    """A time as hours, minutes and seconds, 1:02:03 or 2:03."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"

"""`tmm-report new`: a commented starting variant."""

from __future__ import annotations

from pathlib import Path

from tmm_report.commands.talk import Talk, failure, written
from tmm_report.problems import N_
from tmm_report.variant import new


def run(file: Path, language: str, talk: Talk) -> bool:
    """Write it where there is no file yet. Raises ProblemError."""
    text = new(language)
    try:
        with file.open("x", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
    except FileExistsError:
        raise failure(N_("%(file)s exists already; choose another name"), file=file) from None
    except OSError as error:
        raise failure("%(file)s: %(reason)s", file=file, reason=error.strerror) from None
    talk.tell(written(file))
    return True

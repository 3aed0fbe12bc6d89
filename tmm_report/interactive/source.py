"""A variant as a person at a prompt has it: a file, its text, or a dict."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from typing import Any

from tmm_report import loading
from tmm_report.course import Variant
from tmm_report.problems import N_, Message, ProblemError, mistake, shown
from tmm_report.yamlread import DEPTH, EVENTS, Document, Path

Source = str | bytes | os.PathLike[str] | Mapping[Any, Any]


def load(source: Source) -> Variant:
    """The variant of a file; of a text, which is told from a path by its lines or its braces; of a dict. Raises
    ProblemError."""
    if isinstance(source, Mapping):
        return loading.of_document(Document(_Plain().of(source, ())))
    if isinstance(source, bytes) or (isinstance(source, str) and is_text(source)):
        return loading.loads(source)
    return loading.load(source)


def is_text(source: str) -> bool:
    return "\n" in source or source.lstrip().startswith("{")


class _Plain:
    """Data of Python as those of a file: keys are text, numbers Python's own, as many of them as a file may have."""

    def __init__(self) -> None:
        self.left = EVENTS

    def of(self, value: Any, path: Path) -> Any:
        self.left -= 1
        if self.left < 0:
            raise ProblemError([mistake(N_("more than %(limit)s values"), path[:1], limit=EVENTS)])
        if len(path) > DEPTH:
            raise ProblemError([mistake(N_("deeper than %(limit)s levels"), path[:1], limit=DEPTH)])
        if isinstance(value, Mapping):
            return {str(key): self.of(one, (*path, str(key))) for key, one in value.items()}
        if isinstance(value, list | tuple):
            return [self.of(one, (*path, k)) for k, one in enumerate(value)]
        if hasattr(value, "tolist"):  # an array or a number of numpy
            return self.of(value.tolist(), path)
        if value is None or isinstance(value, bool | int | str):
            return value
        if isinstance(value, float):
            return value if math.isfinite(value) else str(value)
        text = N_("a %(kind)s is no value of a variant")
        right = Message(N_("numbers, texts, lists and dicts are"))
        raise ProblemError([mistake(text, path, right, kind=shown(type(value).__name__))])

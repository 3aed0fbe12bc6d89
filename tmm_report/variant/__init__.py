"""A variant's YAML text -> the chapters' blocks with their places; no chapter is known here by name.

`reading` reads, `model` says what a block is, `values` what a single value may be, `errors` words the mistakes,
`editor` makes the JSON Schema. The blocks come from above: `course` lists the chapters and passes their rooms.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from tmm_report import languages
from tmm_report.problems import Problem, ProblemError
from tmm_report.resources import data_root
from tmm_report.yamlread import Path, Place, located

__all__ = ["failed", "locate", "new"]


class Placed(Protocol):
    """What remembers its file: path -> (line, column) of the file's keys, and the file's name."""

    @property
    def places(self) -> Mapping[Path, Place]: ...
    @property
    def file(self) -> str: ...
    @property
    def doubts(self) -> tuple[Problem, ...]: ...
    @property
    def language(self) -> str: ...


def locate(problem: Problem, variant: Placed) -> Problem:
    """A problem met after reading, with the file, line and column of its key or the nearest key around it."""
    texts = {tuple(map(str, path)): place for path, place in variant.places.items()}
    path = tuple(map(str, problem.path))  # a solver may call link 2 a number
    depth = next(n for n in range(len(path), -1, -1) if path[:n] in texts or not n)
    return located(problem, {problem.path[:depth]: texts.get(path[:depth], (1, 1))}, variant.file)


def failed(error: ProblemError, variant: Placed) -> ProblemError:
    """What stopped the solving of a variant, with its places, and the doubts of its file, which may be the cause."""
    found = [locate(problem, variant) for problem in error.problems]
    return ProblemError([*found, *variant.doubts], variant.language)


def new(language: str, kind: str = "lever") -> str:
    """A commented starting variant of a kind in the language. Raises ProblemError for a language that there is not."""
    code, templates = languages.language(language).code, data_root() / "templates"
    folder = templates / "new" if kind == "lever" else templates / "kinds" / kind
    return (folder / f"{code}.yaml").read_text("utf-8")

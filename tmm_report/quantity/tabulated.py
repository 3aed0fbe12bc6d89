"""A chapter's tables and single values are made once of what it found, whoever asks for them and however often.

    @tabulated
    def tables(found: Found) -> Iterator[Table]: ...

Readings, results.json, CSV, marks and the views of the note then read the same tables. They are made one after another,
each when it is first reached: who looks for an early one pays for no later one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import wraps
from typing import Any, Concatenate, Generic, ParamSpec, TypeVar

Found = TypeVar("Found")
Prefix = ParamSpec("Prefix")
Made = TypeVar("Made")


def tabulated(
    make: Callable[Concatenate[Found, Prefix], Iterator[Made]],
) -> Callable[Concatenate[Found, Prefix], Iterable[Made]]:
    """`make`: of a Found, and of a stage with the prefix of its names; what it makes is kept with the Found."""
    name = f"{make.__module__}.{make.__qualname__}"

    @wraps(make)
    def told(found: Found, *args: Prefix.args, **kwargs: Prefix.kwargs) -> Iterable[Made]:
        prefix: tuple[Any, ...] = args or tuple(kwargs.values()) or make.__defaults__ or ()  # type: ignore[attr-defined]
        key, known = " ".join((name, *prefix)), vars(found)
        if key not in known or known[key].broken:
            known[key] = _Once(make(found, *args, **kwargs))
        made: _Once[Made] = known[key]
        return made

    return told


class _Once(Generic[Made]):
    """What an iterator gives, again and again; `broken`: where it was broken off by an error, which is then told by
    making all of it again."""

    def __init__(self, left: Iterator[Made]):
        self._made: list[Made] = []
        self._left = left
        self.broken = False

    def __iter__(self) -> Iterator[Made]:
        done = 0
        while done < len(self._made) or self._further():
            yield self._made[done]
            done += 1

    def _further(self) -> bool:
        """Whether there is one more: it is made now."""
        try:
            self._made.append(next(self._left))
        except StopIteration:
            return False
        except BaseException:
            self.broken = True
            raise
        return True

    def __reduce__(self) -> tuple[type[_Once[Made]], tuple[Iterator[Made]]]:
        """A copy has all of it: a generator cannot be copied."""
        return _Once, (iter(tuple(self)),)

"""A part of the note: a template and the view of a chapter that it prints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

from markupsafe import Markup


class Failed(Markup):
    """A line of the conclusions that says what failed: such lines come first."""


class View(Protocol):
    """What a chapter's template prints."""

    def conclusions(self) -> Sequence[Markup]:
        """What the conclusions of the note say of the chapter."""


class Signer(Protocol):
    """Who signs, and as what."""

    @property
    def role(self) -> str: ...

    @property
    def name(self) -> str: ...


class Title(Protocol):
    """What the title page says; its template knows the rest."""

    @property
    def topic(self) -> str: ...

    @property
    def designation(self) -> str: ...

    @property
    def institution(self) -> str: ...

    @property
    def student(self) -> str: ...

    @property
    def group(self) -> str: ...

    @property
    def teacher(self) -> str: ...

    @property
    def signed(self) -> Sequence[Signer]: ...


class Note(Protocol):
    """How much the note says: whether letters are `listed` in front, whether nothing is left out, whether `every`
    formula is worked out or one of each kind; of how many positions the plans are, None: of one."""

    @property
    def listed(self) -> bool: ...

    @property
    def whole(self) -> bool: ...

    @property
    def every(self) -> bool: ...

    @property
    def plans(self) -> int | None: ...

    def stand(self, piece: str) -> str:
        """Where a piece stands: `body`, `appendix` or `omit`."""


class Whole:
    """A note that says all."""

    listed = whole = every = True
    plans: int | None = None

    def stand(self, piece: str) -> str:
        return "body"


WHOLE = Whole()


class Part(NamedTuple):
    """`template`: of templates/chapters, without ".j2"; several parts may print one view.

    `concludes`: whether the view speaks in the conclusions on behalf of its chapter.
    """

    template: str
    view: View
    concludes: bool = True


class Inner(NamedTuple):
    """In the place of a part: the parts of a chapter that another has solved within itself, as the drive its stages.

    `label`: with which its sections, and its names in the results, begin.
    """

    chapter: str
    found: Any
    label: str


NEXT_CHAPTER = None  # among the parts of a chapter: here stand those of the next one

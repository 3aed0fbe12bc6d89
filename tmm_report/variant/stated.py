"""Blocks of which the record that validation makes is what the chapter computes with: no function copies its fields.

    @dataclass(frozen=True)                          # in the chapter's given.py, which imports no pydantic
    class Spring:
        \"\"\"The spring that presses the sleeve down.\"\"\"

        stiffness: Stiffness                         # of variant.values, imported for type checkers alone
        force: Annotated[ForceValue, Field(description="at the lower stop", examples=["1200 N"])] = 0.0

    class Block(model.Block):                        # in its block.py
        spring: Stated[Spring] | None = None

The model that reads the mapping is made of the record's annotations, its docstring of the record's; a record within a
record is read likewise. Fields named in `NOT_STATED` the file has not: they say what stands round the record; numbers
named in `LEFT_OUT` it may leave out, the record is then given nan and finds them by the others. What the
parts of one record say wrong of one another its `__post_init__` raises as WrongValue.
"""

import dataclasses
import math
import sys
import types
from collections.abc import Collection
from functools import cache, partial
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Literal,
    TypeVar,
    Union,
    get_args,
    get_origin,
    get_type_hints,
)

from pydantic import AfterValidator, Field, Tag, create_model

from tmm_report.variant import language, values
from tmm_report.variant.model import Model

T = TypeVar("T")

if TYPE_CHECKING:
    Stated = Annotated[T, "a record"]
else:

    class Stated:
        """`Stated[Record]`: a mapping of the file that becomes the record."""

        def __class_getitem__(cls, record: type) -> Any:
            return stated(record)


def stated(record: type) -> Any:
    """The type of a mapping of the file that becomes the record."""
    return Annotated[model_of(record), AfterValidator(partial(_made, record))]


@cache
def model_of(record: type) -> type[Model]:
    """The model that reads a record's mapping."""
    names = {
        **vars(language),
        **vars(values),
        "values": values,
        "Field": Field,
        "Tag": Tag,
        # fields may be inherited of a record in another module
        **{
            name: value
            for of in reversed(record.__mro__)
            for name, value in vars(sys.modules[of.__module__]).items()
        },
    }
    hints = get_type_hints(record, names, include_extras=True)
    not_stated, left_out = (getattr(record, names, ()) for names in ("NOT_STATED", "LEFT_OUT"))
    fields: Any = {
        field.name: (_read(hints[field.name]), ... if _kind(hints[field.name]) else _default(field, left_out))
        for field in dataclasses.fields(record)
        if field.init and field.name not in not_stated
    }
    made = create_model(
        record.__name__, __base__=Model, __doc__=record.__doc__, __module__=record.__module__, **fields
    )
    made.NOT_OFFERED = getattr(record, "NOT_OFFERED", {})
    return made


def _made(record: type, model: Model) -> Any:
    return record(**{name: getattr(model, name) for name in type(model).model_fields})


def _kind(hint: Any) -> bool:
    """Whether it is one word alone: the file writes it, to say of which kind the mapping is."""
    return get_origin(hint) is Literal and len(get_args(hint)) == 1


def _default(field: Any, left_out: Collection[str] = ()) -> Any:
    """What a field of the model is when the file leaves it out. Of a record no editor is told: the file calls its
    fields by other names."""
    if field.name in left_out:
        return Field(default_factory=lambda: math.nan)
    if field.default_factory is not dataclasses.MISSING:
        made = field.default_factory()
    elif field.default is not dataclasses.MISSING:
        made = field.default
    else:
        return ...
    if dataclasses.is_dataclass(made):
        return Field(default_factory=lambda: made)
    return Field(default=made)


def _read(annotation: Any) -> Any:
    """The type with the models of the records in it."""
    origin, arguments = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        inner, *more = arguments
        return Annotated[_read(inner), *more]
    if origin in (Union, types.UnionType):
        return Union[tuple(map(_read, arguments))]  # noqa: UP007
    if origin in (list, tuple, dict):
        return origin[tuple(map(_read, arguments))]
    is_record = isinstance(annotation, type) and dataclasses.is_dataclass(annotation)
    return stated(annotation) if is_record else annotation

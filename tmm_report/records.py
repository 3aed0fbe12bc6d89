"""`dataclass` as the standard library's, but quick to define.

That one compiles four to six functions for every frozen class when its module is imported, 0.35 ms a class and a fifth
of a cold start. Here what all classes can share is shared, and the constructor is compiled for a class that has many
instances; the first few are filled field by field. Type checkers see the standard library's own.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from operator import attrgetter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
else:

    def dataclass(cls: type | None = None, /, *, frozen: bool = False, eq: bool = True, slots: bool = False):
        """See `dataclasses.dataclass`; of its options those that are used here."""
        if slots:
            return dataclasses.dataclass(frozen=frozen, eq=eq, slots=True)
        return _defined(cls, False, True) if cls else lambda cls: _defined(cls, frozen, eq)


def _defined(cls: type, frozen: bool, eq: bool) -> type:
    own = dict(vars(cls))
    cls.__doc__ = cls.__doc__ or cls.__name__  # else its signature would be found, to be written there
    cls = dataclasses.dataclass(init=False, repr=False, eq=False)(cls)
    shared: dict[str, Any] = {"__init__": _first_init(cls), "__repr__": _repr}
    if eq:
        of = _compared([field.name for field in dataclasses.fields(cls) if field.compare])
        shared |= {"__eq__": _eq_by(of), "__hash__": _hash_by(of) if frozen else None}
    if frozen:
        shared |= {"__setattr__": _refuse, "__delattr__": _refuse}
    for name, value in shared.items():
        if name not in own or (name == "__hash__" and own[name] is None):
            setattr(cls, name, value)
    return cls


FEW = 16  # instances that are made sooner than a constructor is compiled


def _first_init(cls: type) -> Callable[..., None]:
    """The constructor of the first instances."""
    left = FEW

    def __init__(self: Any, *values: Any, **named: Any) -> None:
        nonlocal left
        left -= 1
        if left >= 0 and _filled(self, dataclasses.fields(cls), values, named):  # type: ignore[arg-type]
            return
        compiled = _init_of(cls)
        setattr(cls, "__init__", compiled)  # noqa: B010
        compiled(self, *values, **named)

    return __init__


def _filled(self: Any, fields: tuple[Any, ...], values: tuple[Any, ...], named: dict[str, Any]) -> bool:
    """Whether the arguments fit and the instance has its fields; what does not fit is told by the compiled one."""
    plain = [field.name for field in fields if field.init and not field.kw_only]
    given = {**dict(zip(plain, values, strict=False)), **named}
    if len(values) > len(plain) or len(given) < len(values) + len(named):
        return False
    own = {}
    for field in fields:
        if field.init and field.name in given:
            own[field.name] = given.pop(field.name)
        elif field.default_factory is not dataclasses.MISSING:
            own[field.name] = field.default_factory()
        elif field.default is not dataclasses.MISSING:
            own[field.name] = field.default
        elif field.init:
            return False
    if given:
        return False
    self.__dict__.update(own)
    if hasattr(self, "__post_init__"):
        self.__post_init__()
    return True


def _init_of(cls: type) -> Callable[..., None]:
    """The constructor: arguments in the order of the fields, those by keyword alone last; it writes into the instance's
    dict, which a frozen class does not guard."""
    names: dict[str, Any] = {"__missing": dataclasses.MISSING}
    plain, by_keyword, body = ["self"], ["*"], ["__to = self.__dict__"]
    for n, field in enumerate(dataclasses.fields(cls)):  # type: ignore[arg-type]
        default, value = _default(field, f"__default{n}", names)
        if field.init:
            (by_keyword if field.kw_only else plain).append(field.name + default)
        if value:
            body.append(f"__to[{field.name!r}] = {value}")
    if hasattr(cls, "__post_init__"):
        body.append("self.__post_init__()")
    arguments = ", ".join([*plain, *(by_keyword if len(by_keyword) > 1 else ())])
    exec(f"def __init__({arguments}):\n " + "\n ".join(body), names)
    init: Callable[..., None] = names["__init__"]
    return init


def _default(field: dataclasses.Field[Any], key: str, names: dict[str, Any]) -> tuple[str, str]:
    """Of a field: its default as the argument has it, and what is written to the instance."""
    if field.default_factory is not dataclasses.MISSING:
        names[key] = field.default_factory
        made = f"{key}()"
        return "=__missing", f"{made} if {field.name} is __missing else {field.name}" if field.init else made
    if field.default is dataclasses.MISSING:
        return "", field.name if field.init else ""
    names[key] = field.default
    return f"={key}", field.name if field.init else key


Compared = Callable[[Any], Any]


def _compared(names: list[str]) -> Compared:
    """What instances are compared by: the values of some fields, taken in C."""
    return attrgetter(*names) if names else lambda _: ()


def _eq_by(of: Compared) -> Callable[[Any, object], bool]:
    def __eq__(self: Any, other: object) -> bool:
        return of(self) == of(other) if other.__class__ is self.__class__ else NotImplemented

    return __eq__


def _hash_by(of: Compared) -> Callable[[Any], int]:
    def __hash__(self: Any) -> int:
        return hash(of(self))

    return __hash__


def _repr(self: Any) -> str:
    shown = (
        f"{field.name}={getattr(self, field.name)!r}" for field in dataclasses.fields(self) if field.repr
    )
    return f"{self.__class__.__qualname__}({', '.join(shown)})"


def _refuse(self: Any, name: str, *value: Any) -> None:
    raise dataclasses.FrozenInstanceError(f"{self.__class__.__qualname__}.{name} is read only")

"""Records are dataclasses in everything but the time that they take to be defined."""

import copy
import pickle
from dataclasses import FrozenInstanceError, field, fields, replace
from dataclasses import dataclass as usual

import pytest

from tmm_report.records import FEW, dataclass


def make(dataclass):
    @dataclass(frozen=True)
    class Value:
        """A value."""

        to: int
        named: str = "a"
        kept: list = field(default_factory=list, compare=False)
        last: int = field(default=3, kw_only=True)

    @dataclass(frozen=True)
    class More(Value):
        own: float = 1.5

    @dataclass(frozen=True, eq=False)
    class Thing:
        x: int
        made: list = field(init=False, default_factory=lambda: [1])

        def __post_init__(self) -> None:
            object.__setattr__(self, "twice", 2 * self.x)

    @dataclass
    class Loose:
        x: int = 1

    return Value, More, Thing, Loose


def used(kinds):
    """The same after so many instances that their constructors are compiled."""
    for kind in kinds:
        for n in range(FEW + 1):
            kind(n)
    return kinds


OURS, COMPILED, THEIRS = make(dataclass), used(make(dataclass)), make(usual)
EITHER = pytest.mark.parametrize("kinds", [OURS, COMPILED, THEIRS], ids=["ours", "compiled", "the library's"])


@EITHER
def test_values_are_equal_by_their_fields(kinds):
    Value, More, *_ = kinds
    assert Value(1) == Value(1, "a") != Value(2)
    assert Value(1, kept=[1]) == Value(1) and hash(Value(1, last=3)) == hash(Value(1))
    assert More(1) != Value(1) and More(1, "b", [], 2.5).own == 2.5
    assert Value(1).kept is not Value(1).kept


@EITHER
def test_what_is_frozen_cannot_be_set(kinds):
    Value, _, Thing, Loose = kinds
    for one in (Value(1), Thing(1)):
        with pytest.raises(FrozenInstanceError):
            one.x = 5
        with pytest.raises(FrozenInstanceError):
            del one.x
    loose = Loose()
    loose.x = 7
    assert loose == Loose(7)
    with pytest.raises(TypeError):
        hash(loose)


@EITHER
def test_things_are_equal_to_themselves_alone(kinds):
    Thing = kinds[2]
    one = Thing(2)
    assert one == one != Thing(2)
    assert one.twice == 4 and one.made == [1]


@EITHER
def test_arguments_that_are_wrong_are_refused(kinds):
    Value, _, Thing, _ = kinds
    for call in (
        lambda: Value(),
        lambda: Value(1, other=2),
        lambda: Value(1, "a", [], 4),
        lambda: Thing(1, [2]),
    ):
        with pytest.raises(TypeError):
            call()


@EITHER
def test_records_are_replaced_copied_and_shown(kinds):
    Value = kinds[0]
    one = replace(Value(1), named="z", last=9)
    assert (one.to, one.named, one.last) == (1, "z", 9) == (copy.copy(one).to, one.named, one.last)
    assert repr(one).endswith("Value(to=1, named='z', kept=[], last=9)")
    assert [f.name for f in fields(one)] == ["to", "named", "kept", "last"]


def test_a_record_of_a_module_is_pickled():
    from tmm_report.mechanics.lever.mechanism import Guide

    guide = Guide("x", "0", 0j, 1 + 0j)
    assert pickle.loads(pickle.dumps(guide)).name == "x"

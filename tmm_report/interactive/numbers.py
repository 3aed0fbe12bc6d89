"""Numbers of the results as arrays that know what they are."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.quantity.model import Quantity
from tmm_report.quantity.units import WrongValue, between


class Numbers(np.ndarray[Any, Any]):
    """An array (P,), or one number (), with `unit`, `symbol`, `meaning` and `key`.

    A part of it keeps them; what is reckoned with it is a plain array or number, for its unit may be another one.
    """

    quantity: Quantity

    def __new__(cls, values: Any, quantity: Quantity) -> Numbers:
        made: Numbers = np.array(values).view(cls)
        made.quantity = quantity
        made.flags.writeable = False
        return made

    def __array_finalize__(self, obj: Any) -> None:
        if isinstance(obj, Numbers) and hasattr(obj, "quantity"):
            self.quantity = obj.quantity

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        plain = np.asarray(array).view(np.ndarray)
        return plain[()] if plain.ndim == 0 else plain

    def __reduce__(self) -> Any:
        return Numbers, (np.asarray(self), self.quantity)

    @property
    def key(self) -> str:
        return self.quantity.key

    @property
    def unit(self) -> str:
        """In which the numbers are: "m/s", "" of pure numbers."""
        return self.quantity.unit

    @property
    def symbol(self) -> str:
        return str(self.quantity.symbol or self.quantity.key)

    @property
    def meaning(self) -> str:
        return str(self.quantity.meaning)

    def to(self, unit: str) -> np.ndarray[Any, Any]:
        """The numbers in another unit, as a plain array. Raises ValueError for one that does not measure the same."""
        try:
            times = between(self.unit, unit)
        except (KeyError, ValueError, WrongValue):
            raise ValueError(f"{self.key} is in {self.unit or 'no unit'}: not in {unit!r}") from None
        return np.asarray(self) * times

    def __repr__(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        if self.ndim == 0:
            return (
                f"{self.symbol} = {self[()]:.6g}{unit}"
                if self.dtype.kind == "f"
                else f"{self.symbol} = {self[()]}"
            )
        return f"{self.symbol},{unit or ' –'}: {np.array2string(np.asarray(self), precision=5, threshold=20)}"

    __str__ = __repr__

    def __format__(self, spec: str) -> str:
        return format(self[()], spec) if self.ndim == 0 else format(str(self), spec)

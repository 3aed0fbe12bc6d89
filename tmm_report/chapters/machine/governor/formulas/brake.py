"""Formulas of the centrifugal brake."""

from __future__ import annotations

from tmm_report.quantity.formula import Expr, Formula, Number, sqrt
from tmm_report.quantity.model import Book


class BrakeFormulas:
    def __init__(self, book: Book):
        self.book = book

    def var(self, key: str) -> Expr:
        return self.book[f"governor_brake_{key}"].var()

    def _value(self, key: str, expression: Expr) -> Formula:
        return self.book[f"governor_brake_{key}"].formula(expression)

    def contact(self) -> list[Formula]:
        """Speed of contact."""
        return [
            self._value("rho_contact", self.var("rho") + self.var("gap")),
            self._value("F", self.var("F_0") + self.var("c") * self.var("gap")),
            self._value("contact", sqrt(self.var("F") / (self.var("m") * self.var("rho_contact")))),
        ]

    def coefficient(self) -> Formula:
        shoes = self.var("n") * self.var("f") * self.var("m")
        return self._value("K", shoes * self.var("rho_contact") * self.var("R"))

    def moment(self, row: int) -> Formula:
        """At one of the speeds of the table."""
        table = self.book.tables["governor_brake"]
        over = table.var("omega", row) ** 2 - self.var("contact") ** 2
        return table.formula("M_b", row, self.var("K") * over)

    def held(self) -> list[Formula]:
        return [
            self._value("held", sqrt(self.var("contact") ** 2 + self.var("M") / self.var("K"))),
            self._value("spread", self.var("held") / self.var("contact") - Number(1)),
            self._value("pressing", self._pressing()),
            self._value("power", self.var("M") * self.var("held")),
        ]

    def _pressing(self) -> Expr:
        return self.var("m") * self.var("rho_contact") * (self.var("held") ** 2 - self.var("contact") ** 2)

    def start(self) -> Formula:
        return self._value("contact_time", self.var("J") * self.var("contact") / self.var("M"))

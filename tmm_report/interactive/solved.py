"""What `tmm_report.solve` returns: the results, which can be asked for their numbers, tables and figures by name."""

from __future__ import annotations

import difflib
from collections.abc import Iterator
from dataclasses import fields
from typing import TYPE_CHECKING, Any

from tmm_report.course import Results
from tmm_report.records import dataclass

if TYPE_CHECKING:
    import pandas

    from tmm_report.i18n import Translator
    from tmm_report.interactive.figures import Figure
    from tmm_report.interactive.numbers import Numbers
    from tmm_report.quantity.model import Column, Quantity, Table

NO_PANDAS = (
    "r.table() makes a DataFrame and needs pandas: pip install pandas. Without it r[table, key] gives any column as an "
    'array: r["outputs_table", "phi"]'
)


CALLED = {
    "moment": "balancing",
    "plans": "v",
    "velocities": "v",
    "accelerations": "a",
    "force_plans": "force",
}
"""Figures by what they are called in speech."""


class NotFound(KeyError):
    """There is nothing of that name; the text says what is near."""

    def __str__(self) -> str:
        return str(self.args[0])


@dataclass(frozen=True, eq=False)
class Solved(Results):
    """Results by chapters (see `course.Results`), and by name.

    `r["v_B"]` a column by positions or a single number, as `Numbers` with its unit and symbol, in the units of
    results.json; the magnitude of a vector, `r["v_B_x"]` its component; `r["outputs_diagram", "V_B"]` that of a certain
    table. `r.table("outputs")` a DataFrame, `r.figure("scheme")` a picture, `list(r)` and `r.tables`, `r.figures` the
    names.
    """

    @classmethod
    def of(cls, results: Results) -> Solved:
        return cls(**{field.name: getattr(results, field.name) for field in fields(results)})

    def __getitem__(self, name: str | tuple[str, str]) -> Numbers:
        """Raises NotFound, a KeyError, with the nearest names."""
        from tmm_report.interactive.numbers import Numbers

        if isinstance(name, tuple):
            table, key = name
            found = self._table(table)
            if key not in found:
                raise NotFound(
                    _near(f"table {found.name} has no column", key, [c.key for c in found.columns])
                )
            return Numbers(found[key].values, found[key].quantity)
        known = self._known
        quantity = self._meant(name)
        return Numbers(*known[quantity.key])

    def __contains__(self, name: object) -> bool:
        try:
            return isinstance(name, str | tuple) and self[name] is not None
        except KeyError:
            return False

    def __iter__(self) -> Iterator[str]:
        return iter(self._known)

    @property
    def _known(self) -> dict[str, tuple[Any, Quantity]]:
        """Key -> number or column: single ones first, those of the table positions before those of the diagrams."""
        if "_by_key" not in vars(self):
            from tmm_report.results import tables, values

            found: dict[str, tuple[Any, Quantity]] = {}
            for value in values(self):
                found.setdefault(value.key, (value.value, value.quantity))
            for column in _columns(tables(self)):
                found.setdefault(column.key, (column.values, column.quantity))
            vars(self)["_by_key"] = found
        by_key: dict[str, tuple[Any, Quantity]] = vars(self)["_by_key"]
        return by_key

    def _meant(self, name: str) -> Quantity:
        """The quantity that a key or a symbol names, written as in an answer."""
        from tmm_report.problems import ProblemError
        from tmm_report.quantity.naming import one

        try:
            return one(name, {key: quantity for key, (_, quantity) in self._known.items()})
        except ProblemError as error:
            raise NotFound(str(error)) from None

    @property
    def tables(self) -> list[str]:
        """Names of the tables, as in results.json."""
        from tmm_report.results import tables

        return [table.name for table in tables(self)]

    def table(self, name: str) -> pandas.DataFrame:
        """A table of the results: a column a key, the positions as index; `attrs["units"]`, `["symbols"]` and
        `["meanings"]` by key. `name`: as in results.json; "outputs" is "outputs_table". Raises NotFound, ImportError.
        """
        found = self._table(name)
        try:
            import pandas
        except ImportError:
            raise ImportError(NO_PANDAS) from None
        frame = pandas.DataFrame({column.key: list(column.values) for column in found.columns})
        frame = frame.set_index("position") if "position" in found else frame
        frame.attrs = {
            "units": {column.key: column.unit for column in found.columns},
            "symbols": {
                c.key: str(c.quantity.symbol) for c in found.columns if c.quantity.symbol is not None
            },
            "meanings": {column.key: str(column.meaning) for column in found.columns},
        }
        return frame

    def _table(self, name: str) -> Table:
        from tmm_report.results import tables

        known = {table.name: table for table in tables(self)}
        found = known.get(name) or known.get(f"{name}_table")
        if found is None:
            raise NotFound(_near("the results have no table", name, list(known)))
        return found

    @property
    def figures(self) -> list[str]:
        """Names of the figures of the full note."""
        return [figure.name for figure in self._gathered()]

    def figure(self, name: str | int) -> Figure:
        """A figure of the full note by its name, a part of it, its number, or a word of its caption. A notebook shows
        it; `.svg` is its text, `.save(path)` writes SVG or PNG. Raises NotFound."""
        every = self._gathered()
        word = str(name)
        plain = CALLED.get(word, word)
        ways = (
            [one for one in every if one.name == word],
            [one for one in every if one.number == word],
            [one for one in every if one.name == plain or one.name.startswith(f"{plain}:")],
            [one for one in every if plain in one.name.split(":")],
            [one for one in every if word.casefold() in one.caption.casefold()],
        )
        found = next((some for some in ways if some), None)
        if not word or found is None:
            raise NotFound(_near("the note has no figure", word, [one.name for one in every]))
        return found[0]

    def _gathered(self) -> list[Figure]:
        if "_figures" not in vars(self):
            from tmm_report.interactive.figures import gathered

            vars(self)["_figures"] = gathered(self, self._translator())
        figures: list[Figure] = vars(self)["_figures"]
        return figures

    def _translator(self) -> Translator:
        from tmm_report.i18n import Translator

        return Translator(self.variant.language, self.variant.decimal_sign, self.variant.words)

    def __repr__(self) -> str:
        from tmm_report.interactive.brief import heading

        return f"<Results of {heading(self, self._translator())!r}>"

    def _repr_html_(self) -> str:
        from tmm_report.interactive.brief import html

        return html(self, self._translator())


def _columns(tables: list[Table]) -> Iterator[Column]:
    """Those that a name alone tells: tables whose rows are different things have columns of no one's name."""
    own = [table for table in tables if "key" not in table]
    for table in sorted(own, key=lambda one: one.name.endswith("_diagram")):
        yield from table.columns


def _near(wrong: str, name: str, known: list[str]) -> str:
    near = difflib.get_close_matches(name[:60], known, 3, 0.4) or known[:12]
    return f"{wrong} {name[:60]!r}; known: {', '.join(near)}{' …' if len(near) < len(known) else ''}"

"""Every sheet of single numbers has its second ways: a test that names one for each printed formula."""

import importlib
import pkgutil
from pathlib import Path

from twice import disagreements

import tmm_report.chapters
from tmm_report.quantity.sheet import Q, Sheet

TESTS = Path(__file__).parent


def sheets() -> dict[str, type[Sheet]]:
    """Those of which a number is computed by a formula, by the chapter that declares them."""
    for module in pkgutil.walk_packages(tmm_report.chapters.__path__, "tmm_report.chapters."):
        importlib.import_module(module.name)
    every, found = [*Sheet.__subclasses__()], {}
    while every:
        one = every.pop()
        every += one.__subclasses__()
        if one.PREFIX and one.__module__.startswith("tmm_report.chapters."):
            found[one.__module__.split(".")[3]] = one
    return found


def test_every_chapter_with_a_sheet_has_a_test_of_second_ways():
    named = {
        path.stem.removeprefix("test_").removesuffix("_twice") for path in TESTS.rglob("test_*_twice.py")
    }
    assert sheets() and not set(sheets()) - named


def test_such_a_test_asks_for_all_formulas_of_a_sheet():
    """Of a chapter whose numbers are computed by steps; others hold their definitions alone."""
    chapters = Path(tmm_report.chapters.__path__[0])
    stepped = {path.parent.name for path in chapters.rglob("steps.py")}
    texts = {path.stem: path.read_text("utf-8") for path in TESTS.rglob("test_*_twice.py")}
    assert stepped and not [
        name for name in stepped if "disagreements(" not in texts.get(f"test_{name}_twice", "")
    ]


class Shape(Sheet, prefix="shape"):
    side = Q("a", "m", "side")
    area = Q("A", "m²", "area")


def test_a_formula_without_a_second_way_and_a_wrong_one_are_told():
    s = Shape()
    s.side = 3.0
    s.area = s.side**2
    assert disagreements(s, {"area": 9.0}) == []
    assert disagreements(s, {}) == ["area: no second way"]
    assert len(disagreements(s, {"area": 9.1})) == 2  # the number, and its formula

"""A cam of arcs in the note: its formulas, worked again, for every way in which its sizes can be stated."""

import itertools
import math

import pytest

from tmm_report import course, loading
from tmm_report.chapters.cams.cam import quantities as q
from tmm_report.chapters.cams.cam.arcs_written import Written, central
from tmm_report.quantity.model import Book

SIZES = {"nose": "10 mm", "lift": "16 mm", "half_angle": "54.6234598481 deg", "distance": "38 mm"}
ROUND = {
    "nose": "10 mm",
    "lift": "16 mm",
    "half_angle": "62 deg",
    "distance": "38 mm",
    "flank": "126.3306436 mm",
}
ENDS = {"roller": "roller: 18 mm", "edge": "follower: knife", "flat": "follower: flat"}
STATED = [
    *(("tangent", keys, end) for keys in itertools.combinations(SIZES, 2) for end in ("roller", "edge")),
    *(("arcs", keys, end) for keys in itertools.combinations(ROUND, 3) for end in ENDS),
]


def found(kind, keys, end):
    sizes = SIZES if kind == "tangent" else ROUND
    stated = ", ".join(f"{key}: {sizes[key]}" for key in keys)
    text = f"cam: {{{ENDS[end]}, profile: {{{kind}: {{base: 32 mm, {stated}}}}}, speed: 420 rpm}}"
    return course.solve(loading.loads(text)).cam.cams[0], course.solve(loading.loads(text)).cam


@pytest.mark.parametrize(
    ("kind", "keys", "end"), [one for one in STATED if set(one[1]) != {"nose", "lift", "distance"}], ids=str
)
def test_every_formula_gives_the_value_that_was_found(kind, keys, end):
    one, whole = found(kind, keys, end)
    assert central(one)
    book = Book.of(q.tables(whole), q.values(whole))
    written = Written(one, one.pieced, book)
    for formula in (*written.sizes(), *written.change(), *written.rates()):
        assert formula.expression.value == pytest.approx(book[formula.ref.key].value, rel=1e-9), (
            formula.ref.key
        )
    told = {formula.ref.key.removeprefix("cam_") for formula in written.sizes()}
    unknown = (set(SIZES) if kind == "tangent" else set(ROUND)) - set(keys)
    assert told == unknown


def test_an_offset_follower_has_no_formulas_of_textbooks():
    text = "cam: {roller: 18 mm, offset: 4 mm, profile: {tangent: {base: 32 mm, nose: 10 mm, lift: 16 mm}}}"
    (one,) = course.solve(loading.loads(text)).cam.cams
    assert not central(one)
    assert one.pieced.outline.lift == pytest.approx(0.016)
    highest, lowest = (math.sqrt(far**2 - 0.004**2) for far in (0.038 + 0.010 + 0.018, 0.050))
    assert one.lift == pytest.approx(highest - lowest)

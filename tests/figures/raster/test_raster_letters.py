"""Lettering of PNG pictures: within its box, of its size, and letters that are letters."""

import pytest
from pixels import PIXEL, box, inked

from tmm_report.figures.drawing import Drawing, Path, Text
from tmm_report.figures.lettering import Symbol, symbol
from tmm_report.figures.raster import glyph, lettered, png

TEXTS = {
    "number": ("−0,1098",),
    "ones": ("1",),
    "elevens": ("11",),
    "cyrillic": ("рабочий ход ", Symbol("B")),
    "reaction": (symbol("R_12^t"), ", Н"),
    "vector": (symbol("v_BA", bar=True),),
    "words": (Symbol("m", "ЗВ"), " = 4 мм"),
    "greek": (Symbol("ω", "1"), ", ", Symbol("Φ", "max"), " ± ", Symbol("φ", "п", "2")),
    "foreign": ("漢字→☂",),
}


@pytest.mark.parametrize("align", [-1, 0, 1])
@pytest.mark.parametrize("name", TEXTS)
def test_a_text_stays_within_its_estimated_box(name, align):
    text = Text(30 + 20j, TEXTS[name], 3.2, align)
    left, low, right, high = box(inked(text))
    x0, y0, x1, y1 = text.box
    assert x0 - PIXEL <= left and right <= x1 + PIXEL
    assert name == "foreign" or (y0 - 2 * PIXEL <= low and high <= y1 + 2 * PIXEL)
    assert right - left > 0.6 * (x1 - x0)  # and is no smaller than needed
    anchor = (left, (left + right) / 2, right)[align + 1]
    assert anchor == pytest.approx(30, abs=1.5 * PIXEL)


def test_texts_are_as_high_as_their_size_says():
    for size in (2.8, 3.2, 10.0):
        _, low, _, high = box(inked(Text(30 + 20j, ("H",), size, 0)))
        assert high - low == pytest.approx(0.66 * size, abs=1.5 * PIXEL)
        assert low == pytest.approx(Text(30 + 20j, ("H",), size).baseline.imag, abs=PIXEL)


ALPHABETS = {
    "cyrillic": "абвгдежзийклмнопрстуфхцчшщъыьэюяАБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯёЁ№",
    "greek": "αβγδεζηθικλμνξοπρστυφχψωΓΔΘΛΞΠΣΦΨΩϕϑ",
    "signs": "0123456789+−×·=°′″—–→↻↺≤≥±≈∞²³()[]{}/",
    "latin": "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz",
}


@pytest.mark.parametrize("leaning", [False, True])
@pytest.mark.parametrize("name", ALPHABETS)
def test_every_letter_of_an_alphabet_has_a_shape_of_its_own(name, leaning):
    shapes = {glyph(char, leaning)[0].places.tobytes() for char in ALPHABETS[name]}
    nothing = glyph("\U000f0000", leaning)[0].places.tobytes()  # what no font has
    assert len(shapes) == len(ALPHABETS[name]) and nothing not in shapes


def test_letters_lean_as_formulas_set_them():
    for char, leans in (("v", True), ("ω", True), ("Φ", False), ("Ф", False)):
        expected = glyph(char, leans)[0].places
        got = lettered((Symbol(char),))[0].places
        assert got - got[0] == pytest.approx(expected - expected[0])
    assert glyph("v", True)[0].places.shape != glyph("v", False)[0].places.shape


def test_an_upper_index_stands_over_the_lower_and_a_bar_over_the_base():
    def extent(parts):
        outline, wide = lettered(parts)
        return outline.places.imag.min(), outline.places.imag.max(), wide

    base, low, high, both = (extent((symbol(name),)) for name in ("R", "R_12", "R^12", "R_12^12"))
    assert low[0] < base[0] - 0.1 and high[1] > base[1] and both[:2] == (low[0], high[1])
    assert both[2] == pytest.approx(max(low[2], high[2]), abs=0.02)
    assert extent((symbol("R", bar=True),))[1] > base[1] + 0.1


def test_what_follows_a_symbol_stands_behind_both_its_indices():
    for name in ("R_12^t", "R_1^max"):
        alone, wide = lettered((symbol(name),))
        followed, _ = lettered((symbol(name), "H"))
        assert followed.places[len(alone.places) :].real.min() > wide - 0.01


@pytest.mark.parametrize("item", [Text(30 + 20j, ()), Text(30 + 20j, (" ",)), Path(())])
def test_what_is_empty_leaves_nothing(item):
    assert inked(item).max() == 0.0


def test_letters_that_no_file_can_hold_do_not_stop_a_picture():
    drawing = Drawing((Text(0j, ("a\ud800\x00\U0010ffff",)),), "звено \ud800")
    assert b"iTXt" in png(drawing) and png(drawing).startswith(b"\x89PNG")

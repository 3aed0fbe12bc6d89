"""Statistics of a class: points, hard cells, and the two who copied found among those who did not."""

from __future__ import annotations

import csv
import io
import random
import re
from dataclasses import replace

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from payloads import PAYLOADS

from tmm_report.commands.grade.statistics_page import statistics_files
from tmm_report.grading.model import Digest, Rule
from tmm_report.grading.year.copies import limit
from tmm_report.grading.year.statistics import lines, statistics
from tmm_report.i18n import Translator

KEYS = ("S", "V", "A", "M")
POSITIONS = 12


def solutions(rng: np.random.Generator, works: int) -> np.ndarray:
    """(works, 4, 12): displacement, velocity, acceleration and a moment of slider-cranks drawn at random."""
    r, l, speed, force = (
        rng.uniform(low, high, (works, 1))
        for low, high in ((0.08, 0.12), (0.28, 0.36), (100, 150), (1000, 2000))
    )
    phi = np.linspace(0.1, 0.1 + 2 * np.pi, POSITIONS, endpoint=False)
    x = r * np.cos(phi) + np.sqrt(l**2 - (r * np.sin(phi)) ** 2)
    v = -r * speed * (np.sin(phi) + r / l * np.sin(2 * phi) / 2)
    a = -r * speed**2 * (np.cos(phi) + r / l * np.cos(2 * phi))
    return np.stack([x, v, a, -force * v / speed], axis=1)


def read_off(rng: np.random.Generator, right: np.ndarray, mistakes: float = 0.2) -> np.ndarray:
    """As an honest class answers: read off plans of 50 mm to half a millimetre, three digits, columns with the usual
    mistakes."""
    largest = np.abs(right).max(axis=2, keepdims=True)
    said = right + rng.uniform(-0.01, 0.01, right.shape) * largest
    usual = np.array([-1, 10, 1000, 2, 0.5, 9.55])
    factor = np.where(
        rng.random((*right.shape[:2], 1)) < mistakes, rng.choice(usual, (*right.shape[:2], 1)), 1
    )
    digits = np.floor(np.log10(np.abs(said * factor)))
    return np.round(said * factor / 10 ** (digits - 2)) * 10 ** (digits - 2)


def digest(number: int, said: np.ndarray, right: np.ndarray, **more) -> Digest:
    """A marked work: its cells judged as the course does, limit and reading of the plan."""
    largest = np.abs(right).max(axis=1, keepdims=True)
    near = 200 * np.abs(said - right) <= 5 * (np.abs(said) + np.abs(right))
    ok = near | (np.abs(said - right) <= largest / 50)
    names = [("t", key, str(k)) for key in KEYS for k in range(POSITIONS)]
    rules = [Rule.LIMIT if fine else Rule.OFF for fine in ok.ravel()]
    cells = dict(zip(names, zip(said.ravel().tolist(), map(str, rules), strict=True), strict=True))
    name = f"w{number:04}"
    return Digest(
        name,
        f"Student {number}",
        points=float(ok.mean() * 100),
        worth=100.0,
        cells=cells,
        right=dict(zip(names, right.ravel().tolist(), strict=True)),
        **more,
    )


def honest(seed: int, works: int, mistakes: float = 0.2) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    right = solutions(rng, works)
    return right, read_off(rng, right, mistakes)


def digests(right: np.ndarray, said: np.ndarray) -> list[Digest]:
    return [digest(k, said[k], right[k]) for k in range(len(right))]


@pytest.mark.parametrize("seed", range(10))
def test_an_honest_class_gives_no_flag(seed):
    """Ten classes of 60, 17 700 pairs, in which every fifth column has one of the usual mistakes."""
    assert statistics(digests(*honest(seed, 60))).copies == ()


def test_a_class_in_which_everybody_makes_the_same_mistake_gives_no_flag():
    right, said = honest(1, 60, mistakes=0.0)
    assert statistics(digests(right, -said)).copies == ()
    assert statistics(digests(right, 1000 * said)).copies == ()


def test_two_copies_among_sixty_are_found_and_named_and_nobody_else():
    right, said = honest(7, 60)
    said[41] = said[12]  # the whole work
    said[58, 1:3] = said[30, 1:3]  # two columns of four
    found = statistics(digests(right, said)).copies
    assert {(alike.one.id, alike.other.id) for alike in found} == {("w0041", "w0012"), ("w0058", "w0030")}


def test_the_one_whose_variant_the_numbers_do_not_fit_is_named_as_having_the_others():
    for one, other in ((3, 9), (9, 3)):
        right, said = honest(2, 20, mistakes=0.0)
        said[one] = said[other]
        (alike,) = statistics(digests(right, said)).copies
        assert (alike.one.id, alike.other.id) == (f"w{one:04}", f"w{other:04}")
        assert alike.fits == alike.shared > limit(alike.cells)
        assert "of the latter alone" in str(alike.text)


def test_numbers_that_are_wrong_for_both_are_told_so():
    right, said = honest(3, 20, mistakes=0.0)
    said[4] = said[15] = said[15] * 1.37
    (alike,) = statistics(digests(right, said)).copies
    assert alike.fits == 0
    assert "wrong for both" in str(alike.text)


def test_works_of_one_variant_may_agree():
    right, said = honest(4, 20, mistakes=0.0)
    right[5] = right[6]
    said[5] = said[6]
    assert statistics(digests(right, said)).copies == ()


def test_zeros_and_numbers_of_one_digit_say_nothing():
    right, said = honest(5, 40, mistakes=0.0)
    said[:20], said[20:] = 0.0, 2000.0
    assert statistics(digests(right, said)).copies == ()


def test_of_a_ring_each_is_named_with_the_one_whose_numbers_are_right():
    right, said = honest(6, 100, mistakes=0.0)
    ring = [10, 20, 30, 40]
    said[ring] = said[70]
    found = statistics(digests(right, said)).copies
    assert {(alike.one.id, alike.other.id) for alike in found} == {(f"w{k:04}", "w0070") for k in ring}


def test_a_ring_of_a_hundred_is_found_without_setting_each_against_each():
    right, said = honest(6, 120, mistakes=0.0)
    said[:100] = said[110]
    found = statistics(digests(right, said)).copies
    named = {(alike.one.id, alike.other.id) for alike in found}
    assert named <= {(f"w{k:04}", "w0110") for k in range(100)}
    assert len(named) > 95  # a few have variants too near to tell


def test_the_limit_is_thirteen_of_forty_eight_and_grows_with_the_cells():
    assert limit(48) == 13
    assert limit(12) == limit(4) == 5
    limits = [limit(cells) for cells in range(1, 2000)]
    assert limits == sorted(limits)
    assert limit(480) < 13 * 10


@settings(max_examples=examples(20))
@given(st.randoms(use_true_random=False))
def test_the_order_of_the_works_is_nothing_to_it(shuffle: random.Random):
    right, said = honest(8, 30)
    said[3] = said[4]
    works = digests(right, said)
    mixed = works.copy()
    shuffle.shuffle(mixed)
    one, other = statistics(works), statistics(mixed)
    assert one.copies == other.copies and one.columns == other.columns and one.cells == other.cells
    assert np.array_equal(one.parts, other.parts)


def test_points_are_counted_by_tenths_and_full_marks_stand_in_the_last():
    works = [Digest(str(k), points=p, worth=50.0) for k, p in enumerate([0.0, 4.9, 5.0, 25.0, 49.0, 50.0])]
    found = statistics(works)
    assert found.histogram == [2, 1, 0, 0, 0, 1, 0, 0, 0, 2]
    assert found.mean == pytest.approx((0 + 4.9 + 5 + 25 + 49 + 50) / 300)
    assert found.quartiles[1] == pytest.approx(0.3)


def cell(rule: Rule) -> tuple[float, str]:
    return (float("nan") if rule is Rule.NO_ANSWER else 1.0), str(rule)


def test_the_hardest_come_first_with_their_usual_causes():
    works = []
    for k in range(10):
        hard = Rule.OFF if k < 8 else Rule.LIMIT
        easy = Rule.NO_ANSWER if k == 0 else Rule.CARRIED if k == 1 else Rule.FLOOR
        cells = {("t", "v", "0"): cell(hard), ("t", "v", "1"): cell(Rule.EXACT), ("t", "w", "0"): cell(easy)}
        causes = (("sign", "", ("v",)),) if k < 3 else (("scale", "", ("v",)),) if k < 8 else ()
        works.append(Digest(str(k), cells=cells, causes=causes, worth=3.0))
    found = statistics(works)
    assert [(share.key, share.right, share.asked) for share in found.columns] == [("v", 12, 20), ("w", 8, 10)]
    assert found.columns[0].causes == (("scale", 5), ("sign", 3))
    assert (found.columns[1].carried, found.columns[1].missing) == (1, 1)
    assert (found.cells[0].key, found.cells[0].row, found.cells[0].part) == ("v", "0", 0.2)
    assert found.causes == (("scale", 5), ("sign", 3))


def test_what_is_not_asked_counts_for_nothing():
    works = [Digest(str(k), cells={("t", "v", "0"): cell(Rule.NOT_ASKED)}, worth=1.0) for k in range(5)]
    assert statistics(works).cells == ()


def test_a_mixed_up_variant_and_a_work_that_failed_are_told():
    right, said = honest(9, 5, mistakes=0.0)
    works = digests(right, said)
    works[2] = replace(works[2], causes=(("variant", "w0004", KEYS),))
    works.append(Digest("broken", failed=("a.csv:3: no number",)))
    found = statistics(works)
    assert [(mixed.one.id, mixed.other.id) for mixed in found.mixed] == [("w0002", "w0004")]
    assert [one.who.id for one in found.failed] == ["broken"]
    said_lines = [str(line) for line in lines(found)]
    assert any("w0002 → w0004" in line for line in said_lines)
    assert "works marked: 5, not handed in: 0, not marked: 1" in said_lines


def test_five_lines_at_most_and_one_where_there_is_nothing():
    right, said = honest(7, 60)
    said[41] = said[12]
    works = digests(right, said)
    works[2] = replace(works[2], causes=(("variant", "w0004", KEYS),))
    assert len(lines(statistics(works))) == 5
    assert len(lines(statistics([]))) == 1


# ---------------------------------------------------------------- the page


def flagged_class() -> list[Digest]:
    """Sixty works with one that was copied, one mixed up and one that could not be marked."""
    right, said = honest(7, 60)
    said[41] = said[12]
    works = digests(right, said)
    works[2] = replace(works[2], causes=(("variant", "w0004", KEYS),))
    return [*works, Digest("broken", "Sidorov", failed=("a.csv:3: no number",))]


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    return statistics_files(statistics(flagged_class()), Translator("en"))


def test_the_page_shows_points_flags_and_hard_columns_and_needs_no_other_file(files):
    page = files["statistics.html"].decode()
    assert page.count("<rect") >= 10 and "Mean " in page
    assert "Student 41 (w0041)" in page and "Student 12 (w0012)" in page
    assert "Student 2 (w0002): the numbers of the variant of Student 4 (w0004)" in page
    assert "Sidorov (broken)" in page
    assert "http:" not in page and "https:" not in page and "<script" not in page and "<img" not in page


def test_the_bars_are_as_tall_as_the_works_are_many(files):
    heights = [
        float(h)
        for h in re.findall(r'height="([\d.]+)" fill="#3d6f9e"/>\n', files["statistics.html"].decode())
    ]
    counts = statistics(flagged_class()).histogram
    assert len(heights) == len(counts)
    for height, count in zip(heights, counts, strict=True):
        assert height == pytest.approx(max(heights) * count / max(counts), abs=0.1)


def test_the_csv_has_every_column_and_cell_and_every_pair(files):
    shares = list(csv.reader(io.StringIO(files["statistics.csv"].decode("utf-8-sig"))))
    assert len(shares) == 1 + len(KEYS) * (POSITIONS + 1)
    heads, pair = csv.reader(io.StringIO(files["copies.csv"].decode("utf-8-sig")))
    assert (pair[0], pair[3]) == ("w0041", "w0012")
    assert int(pair[heads.index("same numbers")]) > int(pair[heads.index("a flag above")])


def test_a_class_of_nobody_has_a_page():
    made = statistics_files(statistics([]), Translator("en"))
    assert b"works marked: 0" in made["statistics.html"] and b"<svg" not in made["statistics.html"]


def test_hostile_names_are_text_on_the_page_and_in_the_tables():
    works = [
        replace(work, student=text, causes=(("variant", text, KEYS), (text, text, KEYS)))
        for work, text in zip(flagged_class(), [*PAYLOADS.values()] * 4, strict=False)
    ]
    made = statistics_files(statistics(works), Translator("en"))
    page = made["statistics.html"].decode()
    for opening in ("<script", "<img", "<foreignObject", 'onmouseover="'):
        assert opening not in page
    for name in ("statistics.csv", "copies.csv"):
        for row in csv.reader(io.StringIO(made[name].decode("utf-8-sig"), newline="")):
            assert not any(cell.lstrip()[:1] in ("=", "+", "@") for cell in row if cell)


def test_same_works_same_bytes(files):
    assert statistics_files(statistics(reversed(flagged_class())), Translator("en")) == files

"""`--format png`: every figure of the note as a picture, under the name that it has in note.tex."""

import re
import struct

import pytest
from conftest import read, solved
from notes import note, of_depth, render
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.commands.whole import LIST
from tmm_report.figures import raster

COARSE = 40.0  # dots an inch: enough to see that a figure is there
CORNERS = re.compile(r"\\useasboundingbox \(([-\d.e]+),([-\d.e]+)\) rectangle \(([-\d.e]+),([-\d.e]+)\);")


def size(picture: bytes) -> tuple[int, int]:
    """Pixels across and up."""
    assert picture.startswith(b"\x89PNG\r\n\x1a\n")
    return struct.unpack(">II", picture[16:24])


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", ["compressor", "hoist_drive", "eccentric", "governor_servo"])
def test_every_figure_of_the_note_is_a_picture_of_its_size(name, monkeypatch):
    monkeypatch.setattr(raster, "DOTS", COARSE)
    pictures = render(solved(name), "png", read(name).language)
    drawn = {file: text.decode() for file, text in note(name, "tex").items() if file.startswith("figures/")}
    assert list(pictures) == [file.replace(".tex", ".png") for file in drawn] and len(drawn) > 3
    for picture, text in zip(pictures.values(), drawn.values(), strict=True):
        left, bottom, right, top = map(float, CORNERS.search(text).groups())
        expected = ((right - left) * COARSE / 25.4, (top - bottom) * COARSE / 25.4)
        assert size(picture) == pytest.approx(expected, abs=0.51)
        assert len(picture) > 300  # an empty sheet is smaller


@pytest.mark.exhaustive
def test_the_command_writes_them_into_figures_and_nothing_else(tmp_path):
    arguments = ["solve", read("eccentric").file, "-o", str(tmp_path), "--format", "png", "--lang", "en"]
    done = CliRunner().invoke(app, arguments)
    assert f"{tmp_path}/figures" in done.output.replace("\\", "/")
    written = {path.relative_to(tmp_path).as_posix(): path for path in tmp_path.rglob("*.png")}
    assert {path.name for path in tmp_path.iterdir()} == {"figures", LIST}
    drawn = {file for file in of_depth(solved("eccentric"), "tex", "en") if file.startswith("figures/")}
    assert set(written) == {file.replace(".tex", ".png") for file in drawn}
    assert done.exit_code in (0, 1) and len(written) > 1  # 1: a condition of the teeth that the note tells of
    dots = [struct.unpack(">I", path.read_bytes().partition(b"pHYs")[2][:4])[0] for path in written.values()]
    assert dots == [11811] * len(written)  # to a metre: 300 to an inch


def test_an_unknown_format_is_answered_with_png_among_the_known(tmp_path):
    done = CliRunner().invoke(app, ["solve", read("eccentric").file, "-o", str(tmp_path), "--format", "jpg"])
    assert done.exit_code == 2 and "png" in done.output

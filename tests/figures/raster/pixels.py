"""Printed pictures as arrays of pixels, for tests of what stands where."""

import io

import matplotlib.image
import numpy as np

from tmm_report.figures.drawing import Drawing, Pen, polygon
from tmm_report.figures.raster import DOTS, INCH, png

SHEET = polygon((0, 60, 60 + 40j, 40j), Pen(0.1, "white"))  # makes the field of a drawing 60 × 40 mm
PIXEL = INCH / DOTS  # mm


def picture(drawing: Drawing) -> np.ndarray:
    """Pixels (rows, columns, 3) from the top, 0 black and 1 white."""
    pixels = matplotlib.image.imread(io.BytesIO(png(drawing)))
    assert (pixels[..., 3] == 1).all()  # white ground, nothing shows through
    return pixels[..., :3]


def inked(*items, colour: bool = False) -> np.ndarray:
    """Of items within 60 × 40 mm how dark each pixel is, (rows, columns): rows from below, as y goes."""
    pixels = picture(Drawing((SHEET, *items), margin=0.0))
    return pixels[::-1] if colour else 1 - pixels[::-1].mean(axis=2)


def places(ink: np.ndarray, least: float = 0.5) -> np.ndarray:
    """The middles of the pixels that are darker than `least`, x + iy in mm."""
    rows, columns = np.nonzero(ink > least)
    return ((columns + 0.5) + 1j * (rows + 0.5)) * PIXEL


def box(ink: np.ndarray) -> tuple[float, float, float, float]:
    z = places(ink, 0.1)
    return z.real.min(), z.imag.min(), z.real.max(), z.imag.max()

"""The place of a point of a rod, as the note defines it, against the harmonics of the solved motion."""

import numpy as np
import pytest
from conftest import solved

from tmm_report.chapters.lever.moving import Moving
from tmm_report.chapters.machine.harmonics.equations import rod
from tmm_report.chapters.machine.harmonics.given import Given
from tmm_report.chapters.machine.harmonics.quantities import tables
from tmm_report.chapters.machine.harmonics.solve import solve
from tmm_report.mechanics.calculus import harmonics as fourier

RODS = ("compressor", "slider_crank_offset", "v_engine")


@pytest.mark.parametrize("name", RODS)
def test_the_defined_place_has_the_harmonics_of_the_tables(name):
    found = solve(Given(highest=5), Moving(solved(name).lever.kinematics, None))
    rods = [wave for wave in found.waves if wave.check is not None]
    assert rods
    for wave in rods:
        x, y = (one.expression.value for one in rod(found, wave))
        place = wave.crank.along * (x + 1j * found.kinematics.cycle.sense * y)
        told = next(table for table in tables(found) if table.name == f"wave_{wave.link}")
        for axis, part in (("x", place.real), ("y", place.imag)):
            series = fourier.series(np.broadcast_to(part, (len(wave.xi), len(found.turned))), 5)
            for order in range(1, 6):
                size = series.amplitude[:, order]
                assert np.allclose(told[f"A_{axis}{order}"].values, size, rtol=0, atol=1e-12)
                lag = np.radians(told[f"alpha_{axis}{order}"].values)
                turned = size * np.exp(1j * lag) - (series.cosine + 1j * series.sine)[:, order]
                assert np.nanmax(np.abs(turned), initial=0.0) < 1e-12


def test_the_defined_place_lies_on_the_rod():
    """At ξ = 0 the pin, at ξ = 1 the joint, at the pivot's own distance from the guide."""
    found = solve(Given(), Moving(solved("slider_crank_offset").lever.kinematics, None))
    wave = next(wave for wave in found.waves if wave.check is not None)
    x, y = (one.expression.value for one in rod(found, wave))
    assert np.allclose(np.hypot(x, y)[0], wave.crank.r) and np.allclose(y[-1], wave.crank.offset)
    assert np.allclose(np.hypot(x[-1] - x[0], y[-1] - y[0]), wave.crank.l)

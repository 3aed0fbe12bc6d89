"""What a note of vibration says at resonance, of supports and absorbers, and with masses that turn."""

import math
import re

import numpy as np
import pytest
from notes import VARIANTS, static
from test_vibration import MACHINE, complaint, vibration

from tmm_report import course, loading, note
from tmm_report.chapters.machine.vibration import quantities
from tmm_report.i18n import Translator
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.mechanics.masses.vibration import Body
from tmm_report.problems import ProblemError


def page(text: str) -> str:
    """The note without its tags."""
    made = note.render(course.solve(loading.loads(text)), "html", Translator("en"))["note.html"].decode()
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", static(made)))


UNBALANCED = MACHINE.replace("force: 600 N", "unbalance: {mass: 2 kg, radius: 30 mm}")


def test_amplitude_under_an_unbalance_is_greatest_above_the_natural_frequency():
    found = vibration(UNBALANCED + "  damping_ratio: 0.3\n")
    eta = np.linspace(0.5, 3.0, 250001)
    moved = eta**2 * vib.magnification(eta, 0.3)
    assert (
        found.s.get("eta_most") == pytest.approx(eta[np.argmax(moved)], abs=2e-5)
        and found.s.get("eta_most") > 1
    )
    assert vibration(MACHINE + "  damping_ratio: 0.3\n").s.get("eta_most") is None
    assert vibration(UNBALANCED + "  damping_ratio: 0.8\n").s.get("eta_most") is None
    assert "greatest a little above" in page("vibration:\n" + UNBALANCED + "  damping_ratio: 0.3\n")
    assert "greatest a little above" not in page("vibration:\n" + MACHINE + "  damping_ratio: 0.3\n")


def test_only_a_shaft_that_shakes_has_a_speed_of_resonance():
    """A stated force may be of the second order: its frequency says nothing of the shaft."""
    assert "its shaft passes" in page("vibration:\n" + UNBALANCED + "  damping_ratio: 0.1\n")
    plain = page("vibration:\n" + MACHINE + "  damping_ratio: 0.1\n")
    assert "shaft" not in plain and "The excitation is faster than at resonance, 238.73 rpm" in plain
    still = page("vibration:\n" + MACHINE.replace("90 rad/s", "25 rad/s") + "  damping_ratio: 0.1\n")
    assert "This is resonance" in still


@pytest.mark.parametrize(("way", "sags"), [("right", False), ("30 deg", False), ("up", True), ("down", True)])
def test_springs_give_way_under_the_weight_only_where_they_stand_upright(way, sags):
    text = VARIANTS.joinpath("piston_pump.yaml").read_text(encoding="utf-8").split("\ngovernor:")[0]
    own = f"\nvibration: {{mass: 200 kg, stiffness: 90 kN/m, damping_ratio: 0.1, mechanism: {way}}}\n"
    found = vibration(text + own, alone=False)
    assert (found.s.get("sag") is not None) is sags
    values = {value.quantity.key: float(value.value) for value in quantities.values(found)}
    assert np.exp(1j * values["vibration_direction"]) == pytest.approx(found.given.mechanism, abs=1e-12)


def test_a_support_softer_than_any_is_named():
    soft = "  mass: 500 kg\n  transmissibility: 0.1\n  damping_ratio: 8\n  force: 100 N\n  speed: 600 rpm\n"
    assert vibration(soft).s.get("sag") == pytest.approx(62.98, rel=1e-3)
    assert "No spring deflects so far" in page("vibration:\n" + soft)
    assert "No spring deflects so far" not in page("vibration:\n" + MACHINE)


def test_resonance_is_told_though_the_stiffness_is_rounded():
    rounded = "  mass: 100 kg\n  stiffness: 987 kN/m\n  force: 50 N\n  speed: 99.348 rad/s\n"
    assert [place for place, _ in complaint("vibration:\n" + rounded)] == ["vibration"]


def test_a_harmonic_of_rounding_does_not_ring_and_a_high_one_does():
    """Without damping, at the natural frequency itself."""
    turn = np.arange(720) * 2 * math.pi / 720
    body, omega = Body(3.0, 3.0 * (12 * 5.0) ** 2), 5.0
    moved, handed = vib.periodic(body, omega, 70 * np.sin(turn) + 1e-13 * np.sin(12 * turn))
    assert np.allclose(moved, 70 / (body.stiffness - 3 * 25) * np.sin(turn), rtol=0, atol=1e-12)
    assert np.isfinite(handed).all()
    text = VARIANTS.joinpath("piston_pump.yaml").read_text(encoding="utf-8").split("\ngovernor:")[0]
    stiffness = 200 * (10 * 90 * math.pi / 30) ** 2
    own = f"\nvibration: {{mass: 200 kg, stiffness: {stiffness!r}, mechanism: right}}\n"
    ((_, said),) = complaint(text + own)
    assert "harmonic 10" in said


@pytest.mark.exhaustive
def test_the_narrow_peak_of_a_tuned_absorber_is_found_at_its_top():
    """Little damped: half as high a thousandth of the frequency away."""
    body = Body(400.0, 250e3, 2 * 0.001 * math.sqrt(400.0 * 250e3))
    found = vibration(
        MACHINE.replace("90", "27.3") + "  damping_ratio: 0.001\n  absorber: {mass: 33 kg}\n"
    ).absorbed.tuned
    eta = np.linspace(0.5, 1.6, 1100001)
    beta = np.abs(vib.pair(body, found.hung, eta * 25.0, (body.stiffness, 0.0))[0])
    assert found.beta == pytest.approx(beta.max(), rel=0.01)
    assert found.eta == pytest.approx(eta[np.argmax(beta)], rel=1e-4)


def test_table_of_the_absorbers_has_the_machine_and_the_absorber_each_in_its_column():
    found = vibration(MACHINE + "  absorber: {mass: 40 kg}\n")
    table = {one.name: one for one in quantities.tables(found)}["vibration_absorbers"]
    assert table["amplitude"].values[0] == pytest.approx(0, abs=1e-12)
    assert table["absorber_swing"].values[0] == pytest.approx(600 / (40 * 90**2), rel=1e-9)
    for row, one in enumerate(found.absorbed.fitted):
        main, hung = vib.pair(found.body, one.hung, 90.0, (600.0, 0.0))
        assert table["amplitude"].values[row] == pytest.approx(abs(main), abs=1e-12)
        assert table["absorber_swing"].values[row] == pytest.approx(abs(hung), rel=1e-9)


@pytest.mark.parametrize("key", ["damper", "electromagnetic"])
def test_an_electromagnetic_damper_is_told_to_be_a_viscous_one(key):
    with pytest.raises(ProblemError, match="every damper here is a viscous one"):
        loading.loads(
            f"language: en\nvibration: {{mass: 10 kg, stiffness: 1 kN/m, {key}: {{electromagnetic: 3}}}}\n"
        )


def test_a_machine_shaken_by_its_mechanism_concludes_with_all_harmonics():
    """The amplitude of one of them says nothing of how far the machine goes."""
    text = VARIANTS.joinpath("piston_pump.yaml").read_text(encoding="utf-8").split("\ngovernor:")[0]
    own = "\nvibration: {mass: 200 kg, stiffness: 90 kN/m, damping_ratio: 0.1, mechanism: right}\n"
    found = vibration(text + own, alone=False)
    (said,) = re.findall(r"Shaken by its mechanism, .*? to the base\.", page(text + own))
    moved, handed = (float(number) for number in re.findall(r"up to ([\d.]+) (?:mm|N)\b", said))
    assert moved == pytest.approx(1e3 * np.abs(found.shaking.moved).max(), rel=1e-4)
    assert handed == pytest.approx(np.abs(found.shaking.handed).max(), rel=1e-4)

"""Characteristics of motors: through what a name plate says, limits with known answers, closed integrals of Kloss."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tmm_report.mechanics.calculus import laws
from tmm_report.mechanics.machine import characteristics as ch
from tmm_report.mechanics.machine import reduced_train


def test_a_shunt_motor_goes_through_its_nominal_point_and_stands_without_moment_at_its_no_load_speed():
    motor = ch.shunt(60.0, 150.0, 160.0)
    assert motor.at(150.0) == pytest.approx(60.0) and motor.at(160.0) == pytest.approx(0.0, abs=1e-9)


def test_a_shunt_motor_of_its_circuit_obeys_the_law_of_ohm():
    voltage, resistance, constant, omega = 220.0, 0.5, 1.3, 120.0
    current = (voltage - constant * omega) / resistance
    assert ch.shunt_of_circuit(voltage, resistance, constant).at(omega) == pytest.approx(constant * current)


def test_a_series_motor_obeys_the_law_of_ohm_and_goes_through_its_nominal_point():
    voltage, resistance, constant, omega = 500.0, 0.4, 0.02, 70.0
    current = voltage / (resistance + constant * omega)
    motor = ch.series_of_circuit(voltage, resistance, constant)
    assert motor.at(omega) == pytest.approx(constant * current**2)
    plate = ch.series(motor.at(omega), omega, motor.at(0.0))
    assert (plate.a, plate.b) == pytest.approx((motor.a, motor.b))


def test_kloss_has_its_greatest_moment_at_the_critical_slip():
    for a in (0.0, 0.6):
        motor = ch.Kloss(157.0, 200.0, 0.12, a)
        slips = np.linspace(0.001, 1.0, 20001)
        moments = motor.at(157.0 * (1 - slips))
        assert moments.max() == pytest.approx(200.0, rel=1e-7)
        assert slips[np.argmax(moments)] == pytest.approx(0.12, abs=1e-4)
        assert motor.at(157.0) == 0.0


def test_kloss_through_its_name_plate():
    motor = ch.kloss(72.0, 152.4, 157.08, 2.6)
    assert motor.at(152.4) == pytest.approx(72.0) and motor.greatest == pytest.approx(2.6 * 72.0)


def test_exact_kloss_of_a_circuit_is_the_moment_of_the_equivalent_circuit():
    V, synchronous, R1, R2, X = 220.0, 157.08, 0.3, 0.4, 1.1
    impedance = math.hypot(R1, X)
    greatest = 3 * V**2 / (2 * synchronous * (R1 + impedance))
    motor = ch.Kloss(synchronous, greatest, R2 / impedance, R1 / R2)
    for slip in (0.05, 0.3, 1.0, 1.7):
        circuit = 3 * V**2 * R2 / slip / (synchronous * ((R1 + R2 / slip) ** 2 + X**2))
        assert motor.at(synchronous * (1 - slip)) == pytest.approx(circuit)


def test_time_and_heat_of_an_unloaded_induction_motor_by_the_integral_of_their_rates():
    motor, J = ch.Kloss(100.0, 150.0, 0.25), 3.0
    for start, end in ((1.0, 0.05), (2.0, 1.0)):
        x, weights = np.polynomial.legendre.leggauss(60)
        slip = end + (start - end) * (x + 1) / 2
        weights = weights * (start - end) / 2
        rate = motor.at(100.0 * (1 - slip)) / (J * 100.0)  # −ds/dt
        assert np.sum(weights / rate) == pytest.approx(ch.kloss_time(J, motor, start, end))
        lost = np.sum(weights / rate * motor.at(100.0 * (1 - slip)) * 100.0 * slip)
        assert lost == pytest.approx(ch.winding_loss(J, 100.0, start, end))


def test_the_quickest_critical_slip_beats_its_neighbours():
    best = ch.quickest_slip(2.0, 1.0)
    times = [ch.kloss_time(1.0, ch.Kloss(100.0, 50.0, best * k), 2.0, 1.0) for k in (0.98, 1.0, 1.02)]
    assert times[1] < times[0] and times[1] < times[2]


def test_a_reversed_motor_brakes_with_the_moment_that_it_has_at_the_opposite_speed():
    motor = ch.Kloss(100.0, 80.0, 0.2)
    assert ch.Reversed(motor).at(95.0) == -motor.at(-95.0) < 0


def test_a_gear_hands_on_the_power_less_its_losses():
    motor = ch.Linear(20.0, 300.0)
    geared = ch.Geared(motor, 12.0, 0.9)
    assert geared.at(20.0) * 20.0 == pytest.approx(0.9 * motor.at(240.0) * 240.0) and geared.of == "speed"


def test_tables_are_straight_between_their_points_and_repeat_by_angle():
    assert laws.BySpeed((0.0, 10.0), (5.0, 9.0)).at(2.5) == pytest.approx(6.0)
    assert laws.ByTime((0.0, 2.0, 4.0), (0.0, 8.0, 0.0)).at(0.0, 0.0, 3.0) == pytest.approx(4.0)
    by_angle = laws.ByAngle((0.0, 1.0, 2.0), (0.0, 6.0, 0.0), 2.0)
    assert by_angle.at(0.0, np.array([0.5, 2.5, 7.5])) == pytest.approx([3.0, 3.0, 3.0])


def test_a_fan_resists_by_the_square_of_the_speed_and_a_viscous_moment_by_the_speed():
    assert ch.Power(8.0, 100.0, 2).at(50.0) == pytest.approx(2.0)
    assert ch.Power(8.0, 100.0, 2).at(-50.0) == pytest.approx(-2.0)
    assert ch.Power(0.4, 1.0).at(50.0) == pytest.approx(20.0)


# --- reduced to one shaft


def test_what_is_reduced_has_the_kinetic_energy_and_the_power_of_the_part():
    omega, ratio, J, mass, arm = 90.0, 0.07, 4.0, 300.0, 0.02
    energy = J * (ratio * omega) ** 2 / 2 + mass * (arm * omega) ** 2 / 2
    assert (
        reduced_train.inertia(ratio, J) + reduced_train.travelling(mass, arm)
    ) * omega**2 / 2 == pytest.approx(energy)
    assert reduced_train.moment(ratio, 50.0, 0.8) * omega * 0.8 == pytest.approx(50.0 * ratio * omega)
    assert reduced_train.moment(ratio, -50.0, 0.8) * omega == pytest.approx(-0.8 * 50.0 * ratio * omega)


def test_the_best_ratio_beats_its_neighbours():
    best = reduced_train.best_ratio(0.6, 45.0, 30.0, 100.0, 0.95)
    near = [
        reduced_train.geared_acceleration(best * k, 0.6, 45.0, 30.0, 100.0, 0.95) for k in (0.97, 1.0, 1.03)
    ]
    assert near[1] > near[0] and near[1] > near[2]


def test_the_arm_of_a_slider_crank_is_the_slope_of_its_displacement():
    angle, r, rod = np.linspace(0.1, 6.0, 9), 0.1, 0.37

    def place(phi):
        return r * np.cos(phi) + np.sqrt(rod**2 - (r * np.sin(phi)) ** 2)

    slope = (place(angle - 1e-6) - place(angle + 1e-6)) / 2e-6
    assert reduced_train.crank_arm(angle, r, rod) == pytest.approx(slope, abs=1e-9)
    assert reduced_train.crank_arm(angle, r, rod, exact=False) == pytest.approx(slope, abs=0.02 * r)


@pytest.mark.parametrize("a", [0.0, 0.6, 1.5])
def test_kloss_s_full_formula_goes_through_the_name_plate_too(a):
    motor = ch.kloss(100.0, 1450.0, 1500.0, 2.5, a)
    assert motor.at(1450.0) == pytest.approx(100.0) and motor.greatest == pytest.approx(250.0)
    slips = np.linspace(1e-3, 1.0, 20001)
    assert motor.at(1500.0 * (1 - slips)).max() == pytest.approx(250.0, rel=1e-6)


def test_no_motor_with_much_resistance_of_the_stator_has_a_great_overload_at_a_great_slip():
    with pytest.raises(ArithmeticError):
        ch.kloss(100.0, 1200.0, 1500.0, 3.5, 2.0)


def test_a_moment_by_angle_rises_where_it_is_stated_to_rise_and_falls_at_once_at_the_end_of_the_cycle():
    saw = laws.ByAngle((0.0, 2 * math.pi), (0.0, 100.0), 2 * math.pi)
    assert saw.at(0.0, np.array([0.5, 3.0, 6.0, 2 * math.pi + 0.5])) == pytest.approx(
        100 * np.array([0.5, 3.0, 6.0, 0.5]) / (2 * math.pi)
    )


def test_a_moment_by_angle_that_does_not_begin_at_zero_is_joined_through_it():
    law = laws.ByAngle((math.pi / 2, 3 * math.pi / 2), (10.0, 30.0), 2 * math.pi)
    assert law.at(0.0, np.array([0.0, math.pi, math.pi / 4])) == pytest.approx([20.0, 20.0, 15.0])


def test_a_moment_by_angle_jumps_where_two_points_have_one_angle():
    law = laws.ByAngle((0.0, 1.0, 1.0, 2.0, 2.0), (0.0, 0.0, 40.0, 40.0, 0.0), 2 * math.pi)
    assert law.at(0.0, np.array([0.99, 1.01, 1.99, 2.01, 6.0])) == pytest.approx([0.0, 40.0, 40.0, 0.0, 0.0])

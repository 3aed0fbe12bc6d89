"""The block `governor` as what the chapter is given."""

from tmm_report.chapters.machine.governor.block.models import (
    ArmsModel,
    BallsModel,
    BrakeModel,
    ChooseModel,
    GovernorModel,
    MachineModel,
    ServoModel,
)
from tmm_report.chapters.machine.governor.given import Brakes, Choice, Direct, Plant, Throttle
from tmm_report.chapters.machine.governor.given import Given as Stated
from tmm_report.mechanics.machine.governor.brake import Brake
from tmm_report.mechanics.machine.governor.equilibrium import Arms, BellCrank, Weights
from tmm_report.mechanics.machine.governor.stability import Servo


def build(written: GovernorModel) -> Stated:
    servo, brake = written.servo, written.brake
    return Stated(
        direct=_direct(written) if written.arms or written.bell_crank else None,
        plant=_plant(written.machine) if written.machine else None,
        servo=_servo(servo) if servo else None,
        brake=_brake(brake) if brake else None,
        name=written.name or "",
    )


def _direct(written: GovernorModel) -> Direct:
    assert written.radius is not None  # `mistakes`
    lowest = written.radius.lowest
    return Direct(
        _arms(written.arms, written.balls, lowest) if written.arms else _crank(written),
        _weights(written),
        lowest,
        written.radius.highest,
        written.lift,
        written.sleeve.friction,
        written.sleeve.damping,
        _choice(written.choose) if written.choose else None,
        written.effort,
    )


def _arms(arms: ArmsModel, balls: BallsModel, lowest: float) -> Arms:
    return Arms(
        arms.upper, arms.lower, arms.upper_offset, arms.lower_offset, balls.distance, balls.extension, lowest
    )


def _crank(written: GovernorModel) -> BellCrank:
    crank = written.bell_crank
    assert crank is not None  # `_direct`
    return BellCrank(crank.ball_arm, crank.sleeve_arm, crank.fulcrum, crank.level)


def _weights(written: GovernorModel) -> Weights:
    spring, balls = written.spring, written.balls
    return Weights(
        balls.mass or 0.0,
        written.sleeve.mass or 0.0,
        spring.stiffness if spring else 0.0,
        spring.force if spring else 0.0,
        balls.count,
        written.gravity,
    )


def _choice(written: ChooseModel) -> Choice:
    if written.spring is not None:
        return Choice("spring", written.spring)
    if written.balls is not None:
        return Choice("balls", (written.balls,))
    assert written.sleeve is not None  # `one`
    return Choice("sleeve", (written.sleeve,))


def _plant(written: MachineModel) -> Plant:
    throttle = written.throttle
    return Plant(
        written.inertia,
        written.torque.full,
        written.load.before,
        written.load.after,
        written.torque.slope,
        written.load.slope,
        written.ratio,
        throttle.least,
        Throttle(throttle.force, throttle.insensitivity),
        written.time,
    )


def _servo(written: ServoModel) -> Servo:
    back = written.isodrome
    return Servo(written.time, written.dead_zone, back.feedback if back else 0.0, back.time if back else 0.0)


def _brake(written: BrakeModel) -> Brakes:
    shoes = Brake(
        written.mass,
        written.radius,
        written.gap,
        written.drum,
        written.friction,
        written.spring.stiffness,
        written.spring.force,
        written.count,
    )
    return Brakes(shoes, written.moment, written.inertia)

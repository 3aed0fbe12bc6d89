"""What cannot be solved of a governor, each in one sentence with the physics of it and what would work."""

from __future__ import annotations

import math

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

PATH = ("governor",)


def rpm(omega: float) -> str:
    return f"{omega * 30 / math.pi:.5g}"


def mm(length: float) -> str:
    return f"{1e3 * length:.5g}"


def error(problem: Problem) -> ProblemError:
    return ProblemError([problem])


# --- the mechanism


def out_of_reach(key: str, radius: float, least: float, most: float) -> ProblemError:
    text = N_("with the pin at the radius %(r)s mm the arms cannot be joined, or they do not lift the sleeve")
    right = Message(
        N_("a radius between %(least)s mm and %(most)s mm"), {"least": mm(least), "most": mm(most)}
    )
    return error(mistake(text, (*PATH, "radius", key), right, r=mm(radius)))


def too_long_lift(lift: float, most: float) -> ProblemError:
    text = N_("the arms do not let the sleeve rise by %(lift)s mm")
    right = Message(N_("a lift below %(most)s mm"), {"most": mm(most)})
    return error(mistake(text, (*PATH, "lift"), right, lift=mm(lift)))


def crank_over(radius: float, least: float, most: float) -> ProblemError:
    text = N_("the ball arm of the angle lever would lie level before the ball is at the radius %(r)s mm")
    right = Message(N_("radii between %(least)s mm and %(most)s mm"), {"least": mm(least), "most": mm(most)})
    return error(mistake(text, (*PATH, "radius"), right, r=mm(radius)))


# --- the weights


def nothing_holds(z: float, lack: float, key: str) -> ProblemError:
    text = N_(
        "at the lift %(z)s mm nothing holds the sleeve down: weights and spring push it upwards with %(lack)s N, so no "
        "speed is in equilibrium"
    )
    right = Message(N_("a spring with more force at the lower stop, or a heavier sleeve"))
    return error(mistake(text, (*PATH, key), right, z=mm(z), lack=f"{lack:.4g}"))


def stuck(friction: float, least: float) -> ProblemError:
    text = N_(
        "friction of %(friction)s N holds the sleeve up at any speed: the supporting force is %(least)s N only"
    )
    right = Message(N_("less friction than the supporting force"))
    values = {"friction": f"{friction:.4g}", "least": f"{least:.4g}"}
    return error(mistake(text, (*PATH, "sleeve", "friction"), right, **values))


def soft_spring(force: tuple[float, float], speeds: tuple[float, float], most: float) -> ProblemError:
    text = N_(
        "for these speeds the spring would press with %(low)s N at the lower stop and with less, %(high)s N, at the "
        "upper one, which no spring does: the weights alone spread the speeds further"
    )
    if speeds[1] <= speeds[0]:
        text = N_(
            "for these speeds the spring would press with %(low)s N at the lower stop and with less, %(high)s N, at "
            "the upper one, which no spring does: the speed cannot fall so far as the sleeve rises"
        )
    right = Message(
        N_("with %(low)s rpm at the lower stop, more than %(most)s rpm at the upper one"),
        {"low": rpm(speeds[0]), "most": rpm(most)},
    )
    path = (*PATH, "choose", "spring")
    return error(mistake(text, path, right, low=f"{force[0]:.5g}", high=f"{force[1]:.5g}"))


def pulling_spring(force: float, speed: float, least: float) -> ProblemError:
    text = N_(
        "at %(speed)s rpm the balls do not even carry the weights: the spring would have to lift the sleeve with "
        "%(force)s N"
    )
    right = Message(N_("more than %(least)s rpm at the lower stop, or less weight"), {"least": rpm(least)})
    values = {"speed": rpm(speed), "force": f"{force:.5g}"}
    return error(mistake(text, (*PATH, "choose", "spring"), right, **values))


def no_balls(speed: float, least: float) -> ProblemError:
    text = N_("at %(speed)s rpm no balls, however heavy, hold their own weight up and the sleeve with it")
    right = Message(N_("more than %(least)s rpm"), {"least": rpm(least)})
    return error(mistake(text, (*PATH, "choose", "balls"), right, speed=rpm(speed)))


def weightless_balls() -> ProblemError:
    right = Message(N_("state the sleeve's mass or a spring"))
    text = N_("the sleeve weighs nothing and no spring presses it: any balls are in equilibrium, or none")
    return error(mistake(text, (*PATH, "choose", "balls"), right))


def light_sleeve(speed: float, least: float) -> ProblemError:
    text = N_("at %(speed)s rpm the balls do not carry even a sleeve without mass")
    right = Message(N_("more than %(least)s rpm, or less spring"), {"least": rpm(least)})
    return error(mistake(text, (*PATH, "choose", "sleeve"), right, speed=rpm(speed)))


# --- the machine


def no_steady_state(key: str, load: float, least: float, most: float) -> ProblemError:
    text = N_(
        "a load of %(load)s N·m finds no equilibrium within the lift of the sleeve: its lower stop gives the machine "
        "%(most)s N·m, its upper one %(least)s N·m"
    )
    right = Message(N_("a load between them"))
    values = {"load": f"{load:.5g}", "least": f"{least:.5g}", "most": f"{most:.5g}"}
    return error(mistake(text, (*PATH, "machine", "load", key), right, **values))


def no_supply(key: str, load: float, least: float, most: float) -> ProblemError:
    text = N_(
        "a load of %(load)s N·m is beyond the drive, which gives from %(least)s to %(most)s N·m between the least and "
        "the full supply"
    )
    right = Message(N_("a load between them"))
    values = {"load": f"{load:.5g}", "least": f"{least:.5g}", "most": f"{most:.5g}"}
    return error(mistake(text, (*PATH, "machine", "load", key), right, **values))


def stalls(at: float) -> ProblemError:
    text = N_(
        "after the step of the load the machine stops in %(time)s s, before the governor has opened the throttle"
    )
    right = Message(N_("a smaller step, more inertia of the machine, or a faster governor"))
    return error(mistake(text, (*PATH, "machine", "inertia"), right, time=f"{at:.3g}"))


def straight(lowest: float) -> ProblemError:
    text = N_(
        "with the pin at the radius %(r)s mm both arms lie almost in one straight line: there the balls move far while "
        "the sleeve hardly rises, and its motion cannot be followed"
    )
    return error(mistake(text, (*PATH, "radius", "lowest"), Message(N_("a larger radius")), r=mm(lowest)))


def chatters() -> ProblemError:
    text = N_(
        "after the step the sleeve and the throttle move faster than can be followed over the time of the response"
    )
    right = Message(N_("a shorter time, a stronger dashpot, or a slower servomotor"))
    return error(mistake(text, (*PATH, "machine", "time"), right))


# --- the brake


def always_braking() -> ProblemError:
    text = N_("nothing keeps the shoes off the drum: spring and gap are nought, so it brakes from standstill")
    right = Message(N_("a spring with a force at rest, or with a stiffness and a gap"))
    return error(mistake(text, (*PATH, "brake", "spring"), right))


def outside(radius: float, drum: float) -> ProblemError:
    text = N_(
        "the mass centre of a shoe that touches, at %(r)s mm, is not within the drum of the radius %(R)s mm"
    )
    right = Message(N_("a drum larger than that, or shoes nearer to the shaft"))
    return error(mistake(text, (*PATH, "brake", "drum"), right, r=mm(radius), R=mm(drum)))


def no_friction() -> ProblemError:
    text = N_("without friction the shoes brake nothing, and the speed grows without end")
    right = Message(N_("for example, friction: 0.3"))
    return error(mistake(text, (*PATH, "brake", "friction"), right))


def pivot_outside(pivot: float, drum: float) -> ProblemError:
    text = N_("the pivot of an arm, at %(a)s mm from the axis, is not within the drum of the radius %(R)s mm")
    right = Message(N_("a pivot nearer to the axis"))
    return error(mistake(text, (*PATH, "brake", "arm", "pivot"), right, a=mm(pivot), R=mm(drum)))


def swings_far(angle: float, gap: float) -> ProblemError:
    text = N_("an arm swings by %(angle)s° until its shoe touches: too far for the formulas of small swings")
    right = Message(N_("a gap of %(gap)s mm at most"), {"gap": mm(gap)})
    return error(mistake(text, (*PATH, "brake", "gap"), right, angle=f"{math.degrees(angle):.3g}"))


def locks(most: float) -> ProblemError:
    text = N_(
        "the brake locks itself: the shoe goes before its pivot, and its friction draws it on to the drum more than "
        "the drum pushes it off, so that it does not let go at any speed"
    )
    right = Message(
        N_("friction below %(most)s, a pivot farther from the axis, or ahead: pivot"), {"most": f"{most:.4g}"}
    )
    return error(mistake(text, (*PATH, "brake", "arm", "ahead"), right))


def light_shoes(speed: float, least: float) -> ProblemError:
    text = N_("at %(speed)s rpm the shoes do not brake the driving moment even without springs")
    right = Message(N_("shoes of more than %(mass)s kg, or a higher speed"), {"mass": f"{least:.4g}"})
    return error(mistake(text, (*PATH, "brake", "choose", "spring"), right, speed=rpm(speed)))


def slack_spring(force: float, drawn: float) -> ProblemError:
    text = N_(
        "the spring would be slack at rest: at contact it may have %(force)s N only, %(drawn)s mm drawn out"
    )
    right = Message(N_("a stiffness below %(c)s N/mm"), {"c": f"{force / drawn / 1e3:.4g}"})
    values = {"force": f"{force:.4g}", "drawn": mm(drawn)}
    return error(mistake(text, (*PATH, "brake", "spring", "stiffness"), right, **values))

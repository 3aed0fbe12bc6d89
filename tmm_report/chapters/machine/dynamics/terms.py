"""The quantities that several tables and values of the chapter share."""

from __future__ import annotations

from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol

RED, DR, RES, FR = NP_("index", "red"), NP_("index", "dr"), NP_("index", "res"), NP_("index", "fr")
MEAN, CR, OWN = NP_("index", "mean"), NP_("index", "cr"), NP_("index", "own")
LOST_INDEX = NP_("index", "lost")
RUN_UP, RUN_DOWN = NP_("index", "start"), NP_("index", "coast")
BRAKING, BEGIN = NP_("index", "br"), NP_("index", "begin")

TIME = Quantity("t", Symbol("t"), "s", Message(N_("time")))
ANGLE = Quantity("phi", Symbol("phi"), "rad", Message(N_("angle turned by the main shaft")))
SPEED = Quantity("omega", Symbol("omega"), "rad/s", Message(N_("angular velocity of the main shaft")))
DEVIATION = Quantity(
    "domega",
    Symbol("Δω"),
    "rad/s",
    Message(N_("deviation of the angular velocity of the main shaft from its mean")),
)
ACCELERATION = Quantity(
    "epsilon", Symbol("epsilon"), "rad/s²", Message(N_("angular acceleration of the main shaft"))
)
SLIP = Quantity("s", Symbol("s"), "", Message(N_("slip of the motor")))
DRIVING = Quantity("M_dr", Symbol("M", DR), "N·m", Message(N_("driving moment on the main shaft")))
RESISTING = Quantity("M_res", Symbol("M", RES), "N·m", Message(N_("resisting moment on the main shaft")))
TOTAL = Quantity(
    "M", Symbol("M"), "N·m", Message(N_("excess moment, the driving one less the resisting one"))
)
OF_LOADS = Quantity(
    "M_red",
    Symbol("M", RED),
    "N·m",
    Message(N_("reduced moment of the loads and weights of the mechanism, along the rotation")),
)
FRICTION = Quantity(
    "M_fr",
    Symbol("M", FR),
    "N·m",
    Message(N_("moment of the resistances of the main shaft, against the rotation")),
)
WITH_PAIRS = Quantity(
    "M_fr",
    Symbol("M", FR),
    "N·m",
    Message(
        N_(
            "moment of the friction in the pairs and of the resistances of the main shaft, against the rotation"
        )
    ),
)
LOST = Quantity(
    "M_lost",
    Symbol("M", LOST_INDEX),
    "N·m",
    Message(N_("moment that the gears lose more than at a constant speed, by the acceleration of the parts")),
)
OF_LINKS = Quantity(
    "I_red", Symbol("I", RED), "kg·m²", Message(N_("reduced moment of inertia of the mechanism"))
)
INERTIA = Quantity(
    "J", Symbol("J"), "kg·m²", Message(N_("moment of inertia of the machine on the main shaft"))
)
SLOPE = Quantity(
    "J_slope",
    Symbol("J'"),
    "kg·m²/rad",
    Message(N_("derivative of the moment of inertia of the machine by the angle of the main shaft")),
)
WORK = Quantity("A", Symbol("A"), "J", Message(N_("work of the excess moment from position 0")))
POTENTIAL = Quantity("V", Symbol("V"), "J", Message(N_("potential energy of the weights and springs")))
POTENTIAL_SLOPE = Quantity(
    "V_slope",
    Symbol("V'"),
    "N·m",
    Message(N_("derivative of the potential energy by the angle of the main shaft")),
)
GENERALISED = Quantity(
    "Q", Symbol("Q"), "N·m", Message(N_("generalised force, the moment of all that has no potential"))
)

"""Over what the tables of positions go: their numbers, and the angle turned by the driving link."""

from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol

POSITION = Quantity("position", None, "", Message(N_("number of the position")))
PHI = Quantity("phi", Symbol("phi"), "deg", Message(N_("angle turned by the driving link from position 0")))

"""Mechanisms solved to 40 digits and more, against which the errors of all methods are measured."""

from tmm_report.mechanics.rivals.exact.moving import Exact as Exact
from tmm_report.mechanics.rivals.exact.moving import at as at
from tmm_report.mechanics.rivals.exact.moving import motion as motion

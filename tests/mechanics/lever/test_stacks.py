"""Leading axes and scales: a stack of variants equals a loop of singles, and units do not matter."""

import dataclasses

import numpy as np
import pytest
from schemes import ONES, ROOTED, SCHEMES, linkage, random_loads, turn

from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide


def pushed(found: motion.Motion) -> statics.Statics:
    return statics.solve(found, random_loads(found))


@pytest.mark.parametrize(("name", "sign"), ROOTED)
def test_stack_equals_loop_of_singles(name, sign):
    variants = np.random.default_rng(7).uniform(0.94, 1.06, size=(5, len(ONES)))
    columns = [column.reshape(-1, 1) for column in variants.T]
    together = motion.solve(linkage(SCHEMES[name](columns), sign), turn())
    forces = pushed(together)
    assert together.shape == (5, 24)
    for row, factors in enumerate(variants):
        alone = motion.solve(linkage(SCHEMES[name](list(factors)), sign), turn())
        for values in ("places", "velocities", "accelerations"):
            np.testing.assert_allclose(
                getattr(together, values)[:, row], getattr(alone, values), rtol=1e-12, atol=1e-13
            )
        expected = pushed(alone)
        np.testing.assert_allclose(forces.balancing[row], expected.balancing, rtol=1e-11, atol=1e-11)
        for key, reaction in expected.reactions.items():
            stacked = np.broadcast_to(forces.reactions[key].force, together.shape)[row]
            np.testing.assert_allclose(stacked, reaction.force, rtol=1e-11, atol=1e-11)


def scaled(scheme: Mechanism, factor: float) -> Mechanism:
    """Every length times `factor`; moments of inertia by its square."""
    links = {
        n: Link(
            n,
            {p: at * factor for p, at in link.points.items()},
            link.mass,
            link.mass_centre,
            link.inertia * factor**2,
        )
        for n, link in scheme.links.items()
    }
    guides = {n: Guide(n, g.link, g.through * factor, g.direction) for n, g in scheme.guides.items()}
    slides = tuple(Slide(s.link, s.guide, s.through * factor, s.direction) for s in scheme.slides)
    return dataclasses.replace(scheme, links=links, guides=guides, slides=slides)


@pytest.mark.parametrize("factor", [1e-5, 1e4])  # micrometres and kilometres
@pytest.mark.parametrize(("name", "sign"), ROOTED)
def test_scale_does_not_matter(name, sign, factor):
    scheme = SCHEMES[name]()
    usual = motion.solve(linkage(scheme, sign), turn())
    other = motion.solve(linkage(scaled(scheme, factor), sign), turn())
    for values in ("places", "velocities", "accelerations"):
        expected = getattr(usual, values)
        size = np.abs(expected).max()
        np.testing.assert_allclose(
            getattr(other, values) / factor / size, expected / size, rtol=0, atol=1e-12
        )
    forces = [statics.solve(m, statics.inertia_and_gravity(m, 0j)) for m in (usual, other)]
    size = np.abs(forces[0].balancing).max()
    np.testing.assert_allclose(
        forces[1].balancing / factor**2 / size, forces[0].balancing / size, rtol=0, atol=1e-11
    )


def test_speed_may_differ_between_variants():
    scheme = SCHEMES["four_bar"]()
    speeds = np.array([[3.0], [-5.0]])
    both = motion.solve(linkage(dataclasses.replace(scheme, driver=Driver("1", speeds))), turn())
    for row, omega in enumerate(speeds[:, 0]):
        alone = motion.solve(linkage(scheme), turn(), omega)
        np.testing.assert_allclose(both.velocities[:, row], alone.velocities, rtol=1e-14, atol=1e-16)

"""Every group has as many equations of equilibrium as unknown reactions: 3n = 2p5 + p4."""

import numpy as np
import pytest
from conftest import LEVERS, solved

from tmm_report.chapters.lever.structure import quantities as q
from tmm_report.chapters.lever.structure.view import KNOWN


@pytest.mark.exhaustive
def test_equations_of_every_group_are_as_many_as_its_unknowns():
    for path in LEVERS:
        found = solved(path.stem).lever.structure
        table = next(table for table in q.tables(found) if table.name == "groups")
        n, p5, p4, equations, unknowns = (
            np.asarray(table[key].values)
            for key in ("links_count", "lower", "higher", "equations", "unknowns")
        )
        assert np.all(equations == 3 * n) and np.all(unknowns == 2 * p5 + p4)
        assert np.all(equations == unknowns), path.stem
        # of the whole: the groups and the driving link with its pair make up the mechanism
        assert n.sum() + 1 == found.moving_links
        assert p5.sum() + 1 == found.lower_pairs and p4.sum() == found.higher_pairs


@pytest.mark.exhaustive
def test_every_kind_of_pair_is_told():
    for path in LEVERS:
        assert {pair.kind for pair in solved(path.stem).lever.structure.pairs} <= KNOWN.keys()

"""Any edit of a variant is a variant, or problems that say their line."""

import copy

import pytest
import yaml
from conftest import ALL_FILES, examples
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import loading, yamlread
from tmm_report.problems import ProblemError

COMPRESSOR = next(path for path in ALL_FILES if path.stem == "compressor").read_text(encoding="utf-8")
TREE = yamlread.loads(COMPRESSOR).data
ODD = [
    None,
    True,
    0,
    -1,
    1e308,
    10**39,
    "",
    "x",
    "0",
    "A-B",
    "5 kg",
    ".nan",
    "left of A-C",
    [],
    [[]],
    {},
    {"A": 0},
    [1, [2, {"at": 3}]],
]


def paths(value, path=()):
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from paths(item, (*path, key))


ALL = [path for path in paths(TREE) if path]


def mutate(tree, path, action, odd, other):
    parent = tree
    for key in path[:-1]:
        if not isinstance(parent, dict | list) or (isinstance(parent, list) and not isinstance(key, int)):
            return
        try:
            parent = parent[key]
        except (KeyError, IndexError):
            return
    if not isinstance(parent, dict):
        if isinstance(parent, list) and isinstance(path[-1], int) and path[-1] < len(parent):
            parent[path[-1]] = odd
        return
    if action == "drop":
        parent.pop(path[-1], None)
    elif action == "rename":
        parent[str(odd)] = parent.pop(path[-1], None)
    else:
        parent[path[-1]] = odd if action == "odd" else copy.deepcopy(other)


edits = st.tuples(
    st.sampled_from(ALL),
    st.sampled_from(["drop", "odd", "rename", "swap"]),
    st.sampled_from(ODD),
    st.sampled_from(ALL),
)


@pytest.mark.exhaustive
@settings(max_examples=examples(300))
@given(st.lists(edits, min_size=1, max_size=5))
def test_any_edit_is_a_variant_or_problems(changes):
    tree = copy.deepcopy(TREE)
    for path, action, odd, source in changes:
        other = TREE
        for key in source:
            other = other[key]
        mutate(tree, path, action, odd, other)
    text = yaml.safe_dump(tree, allow_unicode=True).replace("&id", "id").replace("*id", "id")
    try:
        loading.loads(text)
    except ProblemError as error:
        assert error.problems
        assert all(problem.line for problem in error.problems)
        assert len(str(error)) < 400 * len(error.problems)

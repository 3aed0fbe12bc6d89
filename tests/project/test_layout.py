"""The layout of the code, as tmm_report/README.md describes it: floors, chapters, circles, sizes, completeness.

`lint-imports` holds the contract of pyproject.toml; here stands what its words cannot say, and what no import shows:
that a chapter has all its rooms, and that it can be taken out.
"""

from __future__ import annotations

import ast
import re
import shutil
import statistics
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
import typer
import yaml
from conftest import ALL_FILES, solved
from exhaustive import many

from tmm_report import course
from tmm_report.cli import app
from tmm_report.results import tables

grimp = pytest.importorskip("grimp")

ROOT = Path(__file__).parents[2]
CHAPTERS = ROOT / "tmm_report" / "chapters"
STAGES = ("spur", "planetary", "ordinary")  # solved within a drive, and printed within its chapter
AFTER = tuple(name for name in course.OTHERS if name not in course.BEFORE)
SHARED = (
    "cam",
)  # printed after the lever mechanism, but its rooms are those of the mechanism's cam pairs, too
LATER = tuple(name for name in AFTER if name not in SHARED)
ORDER = ("title", *course.BEFORE, *SHARED, course.INITIAL_DATA, *course.LEVER, *STAGES, *LATER)  # of the note
ASIDE = ("profile",)  # a block of which no page tells
FOUND = (*course.LEVER, *STAGES, *course.OTHERS)
WINGS = ("cams", "lever", "gears", "machine")
OPEN = ("given", "solve", "quantities")  # rooms of a chapter that later chapters may enter


@cache
def arrows() -> dict[str, set[str]]:
    """Module -> the modules that it imports when it runs: what only a type checker reads is left out."""
    graph = grimp.build_graph(
        "tmm_report", include_external_packages=True, exclude_type_checking_imports=True, cache_dir=None
    )
    return {one: graph.find_modules_directly_imported_by(one) for one in graph.modules}


def between_chapters() -> Iterator[tuple[list[str], list[str]]]:
    """Imports from one chapter into another, as (chapter, room …)."""
    for one, others in arrows().items():
        for other in others:
            start, end = inside(one), inside(other)
            if start and end and start[0] != end[0]:
                yield start, end


def inside(module: str) -> list[str]:
    """Chapter and room of a module of a chapter, without its wing; empty of others."""
    found = module.removeprefix("tmm_report.chapters.").split(".")
    found = found[1:] if found[0] in WINGS else found
    return found if module.startswith("tmm_report.chapters.") and found and found[0] in ORDER else []


# --- floors and circles


@pytest.mark.exhaustive
def test_a_chapter_imports_what_chapters_before_it_found_and_nothing_of_later_ones():
    seen = list(between_chapters())
    wrong = [(start, end) for start, end in seen if ORDER.index(end[0]) > ORDER.index(start[0])]
    assert len(seen) > 20 and not wrong


@pytest.mark.exhaustive
def test_of_another_chapter_only_the_open_rooms_are_entered():
    """Blocks read blocks before them: a mistake of the loads is told by the links of the structure. The ways of a drive
    are those of its stages, too."""
    more = {"block": ("block",), "ways": ("ways",)}
    wrong = [
        (start, end) for start, end in between_chapters() if end[1] not in (*OPEN, *more.get(start[1], ()))
    ]
    assert not wrong


def test_no_circle_of_imports():
    """Depth first: a module met again on the way to itself closes a circle."""
    done: set[str] = set()

    def circle(module: str, way: tuple[str, ...]) -> tuple[str, ...]:
        if module in way:
            return (*way[way.index(module) :], module)
        if module in done:
            return ()
        found = next((ring for one in sorted(arrows()[module]) if (ring := circle(one, (*way, module)))), ())
        done.add(module)
        return found

    assert not [ring for module in sorted(arrows()) if (ring := circle(module, ()))]


def test_mechanics_imports_numpy_alone_but_where_it_integrates_and_is_judged():
    inside = [one for one in arrows() if one.startswith("tmm_report.mechanics.")]
    outside = {other.split(".")[0] for one in inside for other in arrows()[one]} - {"tmm_report"}
    assert outside - sys.stdlib_module_names == {"numpy", "scipy", "mpmath"}

    def knowing(library: str) -> set[str]:
        names = {one for one in inside if library in {x.split(".")[0] for x in arrows()[one]}}
        return {name.removeprefix("tmm_report.mechanics.") for name in names}

    assert knowing("scipy") == {"calculus.motion_laws", "calculus.ode", "rivals.motion.library"}
    assert knowing("mpmath") == {"rivals.exact.numbers"}


@pytest.mark.parametrize("chapter", FOUND)
def test_what_a_solve_imports_however_far_knows_no_page(chapter):
    rooms = [course.room(chapter, name).__name__ for name in ("solve", "quantities")]
    seen, waiting = set(), rooms
    while waiting:
        seen.add(one := waiting.pop())
        waiting += arrows().get(one, set()) - seen
    assert "tmm_report.quantity.model" in seen
    page = ("report", "figures", "variant", "course", "loading", "commands")
    assert not [one for one in seen if one.split(".")[1:2] and one.split(".")[1] in page]
    assert not {one.split(".")[0] for one in seen} & {
        "pydantic",
        "jinja2",
        "markupsafe",
        "matplotlib",
        "yaml",
    }


# --- sizes


def lines(*folders: str) -> dict[str, int]:
    files = [file for folder in folders for file in (ROOT / folder).rglob("*.py")]
    return {str(file.relative_to(ROOT)): len(file.read_text("utf-8").splitlines()) for file in files}


def test_no_file_above_500_lines_and_half_of_them_below_200():
    every = lines("tmm_report", "tests", "tools", "benchmarks")
    assert not {name: count for name, count in every.items() if count > 500}
    own = [count for count in lines("tmm_report").values() if count]
    assert len(own) > 150 and statistics.median(own) <= 200


def test_no_folder_of_code_holds_more_than_sixteen_files():
    files = [ROOT / name for name in lines("tmm_report", "tests", "tools", "benchmarks")]
    held = Counter(str(file.parent.relative_to(ROOT)) for file in files)
    assert not {folder: count for folder, count in held.items() if count > 16}


# --- nothing is missing


def test_every_folder_of_chapters_is_a_chapter_of_the_note():
    files = [*CHAPTERS.glob("*/__init__.py"), *CHAPTERS.glob("*/*/__init__.py")]
    assert {file.parent.name for file in files} == {*ORDER, *WINGS, *ASIDE}
    assert not [file for file in files if file.read_text("utf-8").count("import")]


def place(chapter: str) -> str:
    """Folder of a chapter with its wing."""
    return (course.wing(chapter) + chapter).replace(".", "/")


@pytest.mark.parametrize("chapter", FOUND)
def test_a_chapter_has_its_rooms_and_its_template(chapter):
    for name in ("block", "solve", "quantities", "view", "ways"):
        assert course.room(chapter, name).__doc__, name
    assert (ROOT / "templates" / "chapters" / f"{place(chapter)}.j2").is_file()
    assert callable(course.room(chapter, "view").parts)


@cache
def keys_of_variants() -> dict[str, set[str]]:
    return {path.stem: set(yaml.safe_load(path.read_text("utf-8"))) for path in ALL_FILES}


def asking(chapter: str) -> list[str]:
    """Names of the ready variants, those that have a key of the chapter's first."""
    keys = set(course.room(chapter, "block").Block.model_fields) if chapter not in STAGES else {"drive"}
    stated = keys_of_variants()
    return sorted(stated, key=lambda name: (not keys & stated[name], name))


@pytest.mark.parametrize("chapter", many(FOUND, 6))
def test_a_ready_variant_uses_the_chapter(chapter):
    def used(name: str) -> bool:
        results = solved(name)
        stages = results.drive.stages if results.drive else ()
        kinds = {inside(type(stage).__module__)[0] for stage in stages}
        return chapter in {one for one, _ in course.chapters(results)} | kinds

    assert any(used(name) for name in asking(chapter))


@pytest.mark.parametrize("chapter", FOUND)
def test_a_test_enters_the_chapter(chapter):
    texts = [
        file.read_text("utf-8") for file in (ROOT / "tests").rglob("test_*.py") if file != Path(__file__)
    ]
    door = re.compile(rf"chapters(\.\w+\.| import ){chapter}\b|\.{chapter}\b")
    assert any(door.search(text) for text in texts)


def test_every_command_and_option_has_its_help():
    group = typer.main.get_command(app)
    assert len(group.commands) >= 5
    for name, command in group.commands.items():
        assert command.help, name
        options = [one for one in command.params if one.name != "help"]
        assert not [one.name for one in options if not getattr(one, "help", None)], name


# --- a chapter can be taken out


def without(text: str, chapter: str) -> tuple[str, int]:
    """The text of course.py without its lines of a chapter, and how many statements or arguments they were."""
    spans = {(node.lineno, node.end_lineno or node.lineno) for node in _of(ast.parse(text), chapter)}
    spans -= {one for one in spans for other in spans if one != other and other[0] <= one[0] <= other[1]}
    rows = text.split("\n")
    kept = [row for at, row in enumerate(rows, 1) if not any(start <= at <= end for start, end in spans)]
    return "\n".join(kept), len(spans)


def _of(tree: ast.Module, chapter: str) -> Iterator[ast.stmt | ast.expr | ast.keyword]:
    """Its imports, its fields of the records, its argument where the founds are made, its late import."""
    for node in ast.walk(tree):
        match node:
            case ast.ImportFrom(module=str(module), names=[ast.alias(name=name)]):
                if inside(f"{module}.{name}")[:1] == [chapter]:
                    yield node
            case ast.Assign(targets=[ast.Name(id=name)]) if name == chapter:
                yield node
            case ast.AnnAssign(target=ast.Name(id=name)) if name == chapter:
                yield node
            case ast.Call(args=arguments, keywords=keywords):
                yield from (one for one in keywords if one.arg == chapter)
                yield from (
                    one for one in arguments if isinstance(one, ast.IfExp) and _names(one.body, chapter)
                )


def _names(node: ast.expr, chapter: str) -> bool:
    return any(isinstance(one, ast.Name) and one.id == chapter for one in ast.walk(node))


TRY = """
from importlib import import_module
from pkgutil import walk_packages
import tmm_report
from tmm_report import course, load, render, solve
for module in walk_packages(tmm_report.__path__, "tmm_report."):
    module.name.endswith("__main__") or import_module(module.name)
assert course.__file__.startswith({folder!r})
results = solve(load({variant!r}))
files = render(results, "html") | render(results, "json")
print(*[name for name, _ in course.chapters(results)], len(files["note.html"]))
"""


def not_asking(chapter: str) -> str:
    """A ready variant without the block of a chapter."""
    text = (ROOT / "variants" / "crank_rocker.yaml").read_text("utf-8")
    return re.sub(rf"^{chapter}:.*\n(?:[ #].*\n|\n)*", "", text, flags=re.M)


@pytest.mark.exhaustive
@pytest.mark.parametrize("chapter", many(["translation", "friction", "flywheel", "wear", "eccentric"]))
def test_a_chapter_taken_out_is_missed_by_nothing(chapter, tmp_path):
    """Its folder, its templates and its lines of course.py are deleted in a copy, where other chapters are solved."""
    for folder in ("tmm_report", "templates"):
        # with what is compiled, so that it need not be done again, but for what just now is
        shutil.copytree(ROOT / folder, tmp_path / folder, ignore=shutil.ignore_patterns("*.pyc.*"))
    shutil.rmtree(tmp_path / "tmm_report" / "chapters" / place(chapter))
    templates = tmp_path / "templates" / "chapters"
    (templates / f"{place(chapter)}.j2").unlink()
    shutil.rmtree(templates / place(chapter), ignore_errors=True)
    courses = tmp_path / "tmm_report" / "course.py"
    text, count = without(courses.read_text("utf-8"), chapter)
    assert 4 <= count <= 7  # friction is handed on to the machine, too
    courses.write_text(text, encoding="utf-8")
    variant = tmp_path / "variant.yaml"
    variant.write_text(not_asking(chapter), encoding="utf-8")
    program = TRY.format(folder=str(tmp_path), variant=str(variant))
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    *found, size = done.stdout.split()
    assert chapter not in found and "kinematics" in found and int(size) > 10_000


# --- documents


@pytest.mark.parametrize("name", ["compressor", "hoist_drive", "eccentric", "piston_pump", "press"])
def test_every_table_of_the_results_is_described(name):
    """Numbers of positions, groups and stages stand for all of them."""
    described = re.findall(r"`([^`\s]+)`", (ROOT / "docs" / "results.md").read_text("utf-8"))
    known = {re.sub(r"\d+", "#", word) for word in described}
    assert {re.sub(r"\d+", "#", table.name) for table in tables(solved(name))} - known == set()


def test_the_readme_of_the_code_names_every_room():
    text = (ROOT / "tmm_report" / "README.md").read_text("utf-8")
    rooms = {file.name.removesuffix(".py") for file in (ROOT / "tmm_report").iterdir()}
    rooms -= {"__init__", "__main__", "__pycache__", "README.md", "py.typed"}
    assert not [room for room in rooms if f"{room}.py`" not in text and f"`{room}/" not in text]
    assert not [chapter for chapter in ORDER if not re.search(rf"\b{chapter}\b", text)]

"""Build the documentation site: `python tools/docsite -o site` (needs `pip install -e ".[docs]"`).

The pages are gathered in a folder (site_pages.py), Zensical makes a site of them, strictly: a link that leads nowhere
ends it. English stands at the root, Russian in ru/. What site.yml does not name stands under "More".
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from itertools import chain
from pathlib import Path
from typing import Any

import yaml
from site_pages import WORDS, gathered

HERE = Path(__file__).resolve().parent
LANGUAGES = {"en": "English", "ru": "Русский"}


def named(nav: list[Any]) -> set[str]:
    """The pages that a contents has."""
    found = set()
    for one in nav:
        for to in one.values() if isinstance(one, dict) else [one]:
            found |= named(to) if isinstance(to, list) else {to}
    return found


def contents(nav: list[Any], pages: list[str], more: str) -> list[Any]:
    """The contents of site.yml; a name with `*` stands for all pages that are so called and nowhere else."""
    stated = named(nav)

    def spread(one: Any) -> list[Any]:
        if isinstance(one, dict):
            return [
                {name: [*chain.from_iterable(map(spread, to))] if isinstance(to, list) else to}
                for name, to in one.items()
            ]
        if "*" not in one:
            return [one]
        return [page for page in pages if Path(page).match(one) and page not in stated]

    found = [*chain.from_iterable(map(spread, nav))]
    left = [page for page in pages if page not in named(found)]
    return [*found, {more: left}] if left else found


def written(folder: Path, language: str, output: Path) -> Path:
    """The pages and the settings for Zensical; the settings' file."""
    settings = yaml.safe_load((HERE / "site.yml").read_text("utf-8"))
    files = gathered(language)
    for name, data in files.items():
        (folder / "docs" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "docs" / name).write_bytes(data)
    pages = sorted(name for name in files if name.endswith(".md"))
    own = settings.pop("languages")[language]
    up = "" if language == "en" else "../"
    settings |= {
        "site_name": own["name"],
        "site_dir": os.path.relpath(output, folder),
        "nav": contents(own["nav"], pages, own["more"]),
        "extra": {
            "alternate": [
                {"name": name, "lang": code, "link": f"{up}{'' if code == 'en' else f'{code}/'}index.html"}
                for code, name in LANGUAGES.items()
            ],
            "generator": False,
        },
    }
    settings["theme"] |= {"language": language}
    file = folder / "mkdocs.yml"
    file.write_text(yaml.safe_dump(settings, allow_unicode=True, sort_keys=False), encoding="utf-8")
    return file


def build(output: Path) -> int:
    """0: the site stands in `output`; else what Zensical ended with, which has said why."""
    output = output.resolve()
    for language in WORDS:
        place = output if language == "en" else output / language
        with tempfile.TemporaryDirectory() as temporary:
            file = written(Path(temporary), language, Path(temporary) / "site")
            command = [sys.executable, "-m", "zensical", "build", "--strict", "-f", str(file)]
            done = subprocess.run(command, capture_output=True, text=True, cwd=temporary)
            if done.returncode:
                print(done.stdout, done.stderr, sep="\n", file=sys.stderr)
                return done.returncode
            shutil.copytree(Path(temporary) / "site", place, dirs_exist_ok=True)
    return 0


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("-o", "--output", type=Path, default=Path("site"), help="folder of the site")
    options = parser.parse_args()
    if options.output.exists() and any(options.output.iterdir()):
        parser.error(f"{options.output} is not empty")
    return build(options.output)


if __name__ == "__main__":
    sys.exit(main())

"""What is packed while a wheel is built: the catalogues of notes, of which every language has 1.4 MB."""

from __future__ import annotations

import lzma
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

PLACE = "tmm_report/_data"


class PackedCatalogues(BuildHookInterface):
    """`note.mo` stands in a wheel as `note.mo.xz`, which `tmm_report/i18n.py` reads where it finds no `note.mo`."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if version == "editable":  # reads those of the checkout
            return
        self.packed = TemporaryDirectory()
        for file in sorted(Path(self.root, "templates", "locale").glob("*/LC_MESSAGES/note.mo")):
            small = Path(self.packed.name, f"{file.parents[1].name}.xz")
            small.write_bytes(lzma.compress(file.read_bytes(), preset=9))
            build_data["force_include"][str(small)] = f"{PLACE}/{file.relative_to(self.root).as_posix()}.xz"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        if version != "editable":
            self.packed.cleanup()

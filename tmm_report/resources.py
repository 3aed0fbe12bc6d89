"""Where the program's own files live: templates, fonts, translations and ready variants."""

from __future__ import annotations

from functools import cache
from pathlib import Path


def allowed(script: bytes) -> str:
    """How a content security policy allows this script and no other: by its hash."""
    from base64 import b64encode
    from hashlib import sha256

    return f"'sha256-{b64encode(sha256(script).digest()).decode()}'"


@cache
def data_root() -> Path:
    """The folder that holds `templates/` and `variants/`: in an installed package, or the checkout's root.

    Raises FileNotFoundError for an installation that lost them.
    """
    package = Path(__file__).resolve().parent
    for root in (package / "_data", package.parent):
        if (root / "templates").is_dir():
            return root
    raise FileNotFoundError(f"templates/ stands neither in {package / '_data'} nor in {package.parent}")


def references_root() -> Path:
    """The folder with the numbers of 40 digits that `tmm-report verify` holds the ready variants against."""
    return Path(__file__).resolve().parent / "verification"

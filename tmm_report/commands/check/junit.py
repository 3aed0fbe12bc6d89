"""The outcome of a check as JUnit XML, which GitHub, GitLab and Jenkins show: a test case a sample and kind."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple
from xml.etree.ElementTree import Element, SubElement, indent, tostring

MOST = 20_000  # characters of one case: services cut longer ones
_NOT_XML = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


class Case(NamedTuple):
    """One sample and kind. `failed`: what is different, a line each; `broken`: why it could not be looked at."""

    sample: str
    kind: str
    failed: Sequence[str] = ()
    broken: Sequence[str] = ()


def xml(cases: Sequence[Case]) -> bytes:
    """The file. Without times and dates: the same outcome is the same file."""
    failures, errors = sum(bool(case.failed) for case in cases), sum(bool(case.broken) for case in cases)
    counts = {"tests": str(len(cases)), "failures": str(failures), "errors": str(errors), "time": "0"}
    root = Element("testsuites", {"name": "tmm-report check", **counts})
    suite = SubElement(root, "testsuite", {"name": "tmm-report check", **counts, "skipped": "0"})
    for case in cases:
        names = {"classname": f"check.{case.sample}", "name": f"{case.sample}: {case.kind}", "time": "0"}
        node = SubElement(suite, "testcase", {key: clean(text) for key, text in names.items()})
        for tag, lines in (("failure", case.failed), ("error", case.broken)):
            if lines:
                found = SubElement(node, tag, {"message": clean(_headline(lines)), "type": case.kind})
                found.text = clean("\n".join(lines))[:MOST]
    indent(root, " ")
    return (
        b'<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root, "utf-8", xml_declaration=False) + b"\n"
    )


def _headline(lines: Sequence[str]) -> str:
    """The first line that says what is different: of a diff not its place."""
    return next((line for line in lines if line[:1] in ("+", "-")), lines[0])


def clean(text: str) -> str:
    """Without the characters that XML forbids."""
    return _NOT_XML.sub("\N{REPLACEMENT CHARACTER}", text)

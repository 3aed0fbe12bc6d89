"""ZIP archives made for tests, hostile ones among them."""

from __future__ import annotations

import io
import struct
import zipfile
from collections.abc import Mapping


def packed(files: Mapping[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> bytes:
    """An ordinary archive, dated alike at every run: the processes of one run must find the same tests."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0)), content, method)
    return out.getvalue()


def dos(files: Mapping[bytes, bytes]) -> bytes:
    """An archive with names as bytes and no word of their encoding, as a Russian Windows packs it."""
    stand_ins = {f"{index:0{len(name)}}": name for index, name in enumerate(files)}
    content = packed(dict(zip(stand_ins, files.values(), strict=True)), zipfile.ZIP_STORED)
    for stand_in, name in stand_ins.items():
        content = content.replace(stand_in.encode(), name)
    return content


def entry(content: bytes, offset: int, layout: str, *values: int) -> bytes:
    """The archive with a field of the first entry of its directory overwritten."""
    begin = content.index(b"PK\1\2") + offset
    new = struct.pack(layout, *values)
    return content[:begin] + new + content[begin + len(new) :]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Bytes that were packed by gzip or zlib, within a limit."""

from __future__ import annotations

import zlib

from palpate_editor.formats_child.scene import Refusal

MOST_BYTES = 600_000_000
"""That a packed file may grow to."""
GZIP = b"\x1f\x8b"


def unpack(content: bytes, where: str = "") -> bytes:
    """What was packed; the content itself where it is not. Raises Refusal."""
    return inflate(content, where) if content[:2] == GZIP else content


def inflate(content: bytes, where: str) -> bytes:
    """Of gzip or zlib. Raises Refusal."""
    machine = zlib.decompressobj(wbits=47)  # either head
    try:
        found = machine.decompress(content, MOST_BYTES)
    except zlib.error as problem:
        raise Refusal(
            where, f"packed bytes that zlib refuses ({problem})", "a sound file"
        ) from None
    if machine.unconsumed_tail:
        got = f"more than {MOST_BYTES // 1_000_000} MB once it is unpacked"
        raise Refusal(where, got, "an organ's surface")
    if not machine.eof:
        raise Refusal(where, "packed bytes that end too early", "a whole file")
    return found

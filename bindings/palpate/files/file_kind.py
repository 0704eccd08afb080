# SPDX-License-Identifier: BSD-3-Clause
"""What kind of file stands somewhere, by its content: so that no output replaces another kind."""

from __future__ import annotations

import json
import os
import re
import stat
import zipfile
from pathlib import Path

RECORD = "a record"
PUBLISHED = "a published scenario"
ORGAN = "an organ"
SCENE = "a scene file"
LAYOUT = "a layout"
SCRIPT = "a script"
PICTURE = "a PNG picture"
OBJ = "an OBJ mesh"
STL = "an STL mesh"
TRUTH = "a truth"
SVG = "an SVG picture"
FINDINGS = "findings of a study"
CHART = "the chart of an organ"
ATLAS = "the atlas of an organ"
MULTIRATE = "a multi-rate chart"
SELFTEST = "the report of a self-test"
REPLAY = "the report of a replay"
SUMMARY = "the summary of a demo"
ASSESSMENT = "an assessment"
ATTEMPTS = "a table of attempts"
ENDINGS = {
    ".organ": ORGAN,
    ".palpate": PUBLISHED,
    ".prec": RECORD,
    ".png": PICTURE,
    ".svg": SVG,
}
"""Of names, each of one kind of file: nothing else is written under it."""
NOTHING = "nothing"
"""No file, or an empty one: there is nothing to lose."""
OTHER = "another file"
NO_FILE = "something other than a file"

BEGINS = {b"\x89PREC\r\n\x1a": RECORD, b"\x89PNG\r\n\x1a\n": PICTURE}
OF_FORMAT = {
    "palpate": PUBLISHED,
    "organ": ORGAN,
    "palpate scene": SCENE,
    "palpate layout": LAYOUT,
    "palpate script": SCRIPT,
    "palpate chart": CHART,
    "palpate atlas": ATLAS,
    "palpate truth": TRUTH,
    "palpate multirate": MULTIRATE,
}
"""The member `format` of a manifest or a JSON file -> what it is."""
OF_JSON = {
    b'"findings"': FINDINGS,
    b'"action": "selftest"': SELFTEST,
    b'"largest_force_difference_N"': REPLAY,
    b'"force_plot"': SUMMARY,
    b'"palpate_scenario"': ASSESSMENT,
}
"""What stands in a JSON file without such a member -> what it is."""
FORMAT = re.compile(rb'"format"\s*:\s*"([^"]{1,40})"')
ENOUGH = 65536
"""[bytes] of a text that tell what it is."""
MOST_MANIFEST_BYTES = 4 * 2**20
TABLE_OF_ATTEMPTS = b"# Not validated. Not a medical device. Results do not show"
STL_HEADER, STL_TRIANGLE = 84, 50
"""[bytes]"""
OBJ_WORDS = {b"v", b"vn", b"vt", b"f", b"g", b"o", b"s", b"mtllib", b"usemtl"}


def find_kind(path: Path) -> str:
    """One of the kinds above. Raises OSError where the file cannot be read."""
    try:
        status = os.stat(path)
    except FileNotFoundError:
        return NOTHING
    if not stat.S_ISREG(status.st_mode):
        return NO_FILE
    if status.st_size == 0:
        return NOTHING
    with path.open("rb") as file:
        begin = file.read(ENOUGH)
    for mark, kind in BEGINS.items():
        if begin.startswith(mark):
            return kind
    if begin.startswith(b"PK"):
        return find_kind_of_archive(path)
    return find_kind_of_text(begin, status.st_size)


def find_kind_of_archive(path: Path) -> str:
    try:
        with zipfile.ZipFile(path) as archive, archive.open("manifest.json") as manifest:
            said = json.loads(manifest.read(MOST_MANIFEST_BYTES))["format"]
    except Exception:  # whatever a damaged archive makes of its reader: it is not one of ours
        return OTHER
    return OF_FORMAT.get(said, OTHER) if isinstance(said, str) else OTHER


def find_kind_of_text(begin: bytes, size: int) -> str:
    """Of what is no archive and has no magic number."""
    if begin.lstrip().startswith(b"{"):
        return find_kind_of_json(begin)
    if b"<svg" in begin:
        return SVG
    if begin.startswith(TABLE_OF_ATTEMPTS):
        return ATTEMPTS
    if begin.lstrip().startswith(b"solid") or is_binary_stl(begin, size):
        return STL
    if re.match(rb"[^\n]*: firmware [^\n]*, no\. ", begin):
        return SELFTEST
    lines = (line.strip() for line in begin.splitlines())
    first = next((line for line in lines if line and not line.startswith(b"#")), b"")
    return OBJ if first.partition(b" ")[0] in OBJ_WORDS else OTHER


def find_kind_of_json(begin: bytes) -> str:
    found = FORMAT.search(begin)
    if found is not None:
        return OF_FORMAT.get(found[1].decode(errors="replace"), OTHER)
    return next((kind for mark, kind in OF_JSON.items() if mark in begin), OTHER)


def is_binary_stl(begin: bytes, size: int) -> bool:
    if len(begin) < STL_HEADER:
        return False
    count = int.from_bytes(begin[STL_HEADER - 4 : STL_HEADER], "little")
    return size == STL_HEADER + STL_TRIANGLE * count

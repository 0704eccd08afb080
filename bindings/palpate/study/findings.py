# SPDX-License-Identifier: BSD-3-Clause
"""What the accuracy study found, kept so that others may say it without pressing anything.

    palpate study accuracy --deep --findings bindings/palpate/study/findings.json

writes the file again; tests hold it against core/ACCURACY.md and against the models themselves.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from palpate.files.json_part import read_part
from palpate.files.whole_file import write_whole

if TYPE_CHECKING:  # it loads SciPy
    from palpate.study.accuracy import Row

KEPT = Path(__file__).with_name("findings.json")
COMMAND = "palpate study accuracy --deep --findings"


@dataclass(frozen=True)
class Finding:
    """One kind on one body at one depth, over the places where it was pressed."""

    kind: str
    body: str
    depth: float | None
    """Of the thickness, negative for a pull; None for small presses."""
    force: float
    """[-] of the truth's, mean over places."""
    least: float
    most: float
    rms: float
    """[-] of the depth: displacement of the free surface, mean over places."""


def summarise(rows: Sequence[Row]) -> list[Finding]:
    """In the order of the rows; places without equilibrium are left out."""
    named = dict.fromkeys((row.kind, row.reference, row.depth) for row in rows)
    found = []
    for key in named:
        chosen = [row for row in rows if (row.kind, row.reference, row.depth) == key]
        ratios = [row.force_ratio for row in chosen if row.force_ratio is not None]
        rms = [row.rms for row in chosen if row.rms is not None]
        if ratios:
            mean = sum(ratios) / len(ratios)
            numbers = (mean, min(ratios), max(ratios), sum(rms) / len(rms))
            found.append(Finding(*key, *(float(f"{number:.4g}") for number in numbers)))
    return found


def write_findings(path: Path, rows: Sequence[Row]) -> None:
    """Raises OSError."""
    lines = ",\n  ".join(json.dumps(asdict(finding)) for finding in summarise(rows))
    text = f'{{"command": "{COMMAND}", "findings": [\n  {lines}\n]}}\n'
    write_whole(path, text.encode())


@cache
def read_findings(path: Path = KEPT) -> tuple[Finding, ...]:
    """Raises Refusal or OSError."""
    data = json.loads(path.read_bytes())
    return tuple(read_part(path, "findings", Finding, row, whole=True) for row in data["findings"])


@dataclass(frozen=True)
class Span:
    """What a kind did on some bodies at some depths."""

    least_mean: float
    """[-] of the truth's force, the least of the means over places."""
    most_mean: float
    least: float
    """[-] at the worst place."""
    most: float


def find_span(kind: str, bodies: Collection[str], depths: Collection[float | None]) -> Span:
    """Raises KeyError where nothing of that sort was found."""
    chosen = [
        finding
        for finding in read_findings()
        if finding.kind == kind and finding.body in bodies and finding.depth in depths
    ]
    if not chosen:
        raise KeyError(f"no findings of {kind}")
    return Span(
        min(finding.force for finding in chosen),
        max(finding.force for finding in chosen),
        min(finding.least for finding in chosen),
        max(finding.most for finding in chosen),
    )

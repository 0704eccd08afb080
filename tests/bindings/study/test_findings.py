# SPDX-License-Identifier: BSD-3-Clause
"""What is kept of the accuracy study is what ACCURACY.md shows; test_models.py holds that against
the models themselves."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest
from palpate.cli.study import SHIPPED
from palpate.study.accuracy import Row, compare_deep
from palpate.study.findings import find_span, read_findings, write_findings
from palpate.study.models import KINDS
from palpate.study.reference import read_reference

ACCURACY = Path(__file__).parents[3] / "core" / "ACCURACY.md"
CELL = re.compile(r"(\S+) \((\S+) to (\S+)\), (\S+) %")


def read_written() -> dict[tuple[str, str, float | None], tuple[float, ...]]:
    """Every cell of ACCURACY.md with a kind, a body and a depth: mean, least, most, rms."""
    cells, bodies, depth = {}, [], None
    for line in ACCURACY.read_text(encoding="utf-8").splitlines():
        columns = [cell.strip() for cell in line.strip("|").split("|")]
        head = re.fullmatch(r"(pressed|pulled) (\d+)%", columns[0])
        if head or columns[0] == "model":
            sign = 0.0 if not head else 0.01 if head[1] == "pressed" else -0.01
            bodies, depth = columns[1:], (sign * int(head[2]) if head else None)
        elif not line.startswith("|"):
            bodies = []
        for body, cell in zip(bodies, columns[1:], strict=False):
            if found := CELL.fullmatch(cell):
                cells[columns[0], body, depth] = tuple(map(float, found.groups()))
    return cells


def test_what_is_kept_is_what_is_written():
    kept = {(f.kind, f.body, f.depth): f for f in read_findings()}
    written = read_written()

    assert set(written) == set(kept)
    assert len(written) > 120
    for key, (mean, least, most, rms) in written.items():
        found = kept[key]
        ratios = (found.force, found.least, found.most)
        # both are rounded, one to three digits and one to four
        assert ratios == pytest.approx((mean, least, most), rel=6e-3), key
        assert 100.0 * found.rms == pytest.approx(rms, abs=0.051 + 1e-4 * rms), key


def test_a_deep_press_lies_within_what_is_kept():
    spleen = read_reference("spleen")
    kinds = [kind for kind in KINDS if kind.name == "springs + volumes, each"]

    rows = compare_deep([replace(spleen, places=spleen.places[:1])], kinds)

    kept = {f.depth: f for f in read_findings() if (f.kind, f.body) == (kinds[0].name, "spleen")}
    assert len(rows) == 6
    for row in rows:
        assert kept[row.depth].least - 2e-3 <= row.force_ratio <= kept[row.depth].most + 2e-3


def test_places_without_equilibrium_are_left_out_and_bodies_without_any_too(tmp_path):
    rows = [
        Row("a", "top", "springs", 0.15, 0.5, 0.1, 0.4),
        Row("a", "side", "springs", 0.15, 0.7, 0.3, 0.4),
        Row("a", "end", "springs", 0.15, None, None, None, "no equilibrium"),
        Row("b", "top", "springs", 0.15, None, None, None, "no equilibrium"),
    ]

    write_findings(tmp_path / "findings.json", rows)

    (found,) = read_findings(tmp_path / "findings.json")
    assert (found.body, found.depth, found.force, found.rms) == ("a", 0.15, 0.6, 0.2)
    assert (found.least, found.most) == (0.5, 0.7)


def test_a_span_is_over_every_body_and_place_and_never_of_nothing():
    span = find_span("surface springs (MSS)", SHIPPED[:3], (None,))

    chosen = [f for f in read_findings() if f.kind == "surface springs (MSS)"]
    solids = [f for f in chosen if f.body in SHIPPED[:3]]
    assert span.least_mean == min(f.force for f in solids)
    assert span.most == max(f.most for f in solids)
    with pytest.raises(KeyError, match="no findings of glue"):
        find_span("glue", SHIPPED, (None,))

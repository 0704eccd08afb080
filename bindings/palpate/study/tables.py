# SPDX-License-Identifier: BSD-3-Clause
"""Rows of a study as tables for people; they are Markdown, so that they can be kept."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from palpate.study.accuracy import Row


def write_tables(references: Sequence[dict[str, Any]], rows: Sequence[Row]) -> str:
    """Bodies full of tissue first, then walls: what is right for one is not for the other."""
    parts = [
        write_table(
            ["body", "tetrahedra", "places: thickness, error of the reference's force"],
            [describe_reference(reference) for reference in references],
        ),
        "Force over the reference's, mean of the places (least to most); error of the displacement "
        "of the free surface, root mean square, of the depth. Small presses, linear:",
    ]
    solids = [r["name"] for r in references if r["wall_thickness_m"] is None]
    walls = [r["name"] for r in references if r["wall_thickness_m"] is not None]
    parts += [write_table(["model", *names], list_kinds(names, rows, None))
              for names in (solids, walls) if names]  # fmt: skip
    for names, truth in (
        (solids, "Solids beside neo-Hookean P1 elements on the same mesh"),
        (walls, "Walls beside neo-Hookean P2 elements on the same mesh"),
    ):
        tables = write_deep_tables(names, rows)
        if tables:
            parts += [f"{truth}, by depth over thickness:", *tables]
    return "\n\n".join(parts)


def write_deep_tables(names: Sequence[str], rows: Sequence[Row]) -> list[str]:
    """Presses from the shallowest, then pulls; kinds against bodies."""
    depths = {row.depth for row in rows if row.reference in names and row.depth is not None}
    return [
        write_table(
            [f"{'pressed' if depth > 0.0 else 'pulled'} {abs(depth):.0%}", *names],
            list_kinds(names, rows, depth),
        )
        for depth in sorted(depths, key=lambda depth: (depth < 0.0, abs(depth)))
    ]


def describe_reference(reference: dict[str, Any]) -> list[str]:
    places = ", ".join(
        f"{place['name']} {1e3 * place['thickness_m']:.0f} mm {place['force_error']:.1%}"
        for place in reference["places"]
    )
    return [reference["title"], str(reference["tetrahedra"]), places]


def list_kinds(names: Sequence[str], rows: Sequence[Row], depth: float | None) -> list[list[str]]:
    chosen = [row for row in rows if row.depth == depth and row.reference in names]
    kinds = list(dict.fromkeys(row.kind for row in chosen))
    return [
        [kind, *(describe_rows([r for r in chosen if (r.kind, r.reference) == (kind, name)])
                 for name in names)]
        for kind in kinds
    ]  # fmt: skip


def describe_rows(rows: Sequence[Row]) -> str:
    """'1.18 (1.10 to 1.25), 3.5 %'; how many places had no equilibrium; inversions."""
    found = [row for row in rows if row.force_ratio is not None and row.rms is not None]
    lost = len(rows) - len(found)
    if rows and lost == len(rows) and rows[0].depth is None:
        return "cannot be built"
    cells = []
    if found:
        ratios = [row.force_ratio for row in found]
        rms = sum(row.rms for row in found) / len(found)
        mean = sum(ratios) / len(ratios)
        cells.append(f"{mean:.3g} ({min(ratios):.3g} to {max(ratios):.3g}), {100 * rms:.1f} %")
        turned = sum(row.least_volume is not None and row.least_volume <= 0.0 for row in found)
        if turned:
            cells.append(f"{turned} of {len(rows)} inside out")
    if lost:
        cells.append(f"{lost} of {len(rows)} without equilibrium")
    return "; ".join(cells) or "-"


def write_table(head: Sequence[str], lines: Sequence[Sequence[str]]) -> str:
    widths = [max(len(row[i]) for row in [head, *lines]) for i in range(len(head))]
    text = [
        "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) + " |"
        for row in [head, *lines]
    ]
    text.insert(1, "|" + "|".join("-" * (width + 2) for width in widths) + "|")
    return "\n".join(text)

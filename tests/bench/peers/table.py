# SPDX-License-Identifier: BSD-3-Clause
"""What compare_peers.py found, in words."""

from __future__ import annotations

import math


def describe(report: dict) -> str:
    lines = [
        f"{'engine':36} {'vertices':>8} {'step ms':>8} {'us':>10} {'p99 us':>10} {'x loop':>8} "
        f"{'real time':>9} {'force':>7}"
    ]
    lines += [describe_row(row) for row in report["rows"]]
    lines.append("largest shell at 1 kHz, between the sizes measured:")
    names = dict.fromkeys(row["peer"] for row in report["rows"] if not row.get("quoted"))
    lines += [f"  {name}: {describe_largest(find_largest(report['rows'], name))}" for name in names]
    lines += [f"  {name}: {n} (quoted)" for name, n in report["quoted_largest"].items()]
    lines += [
        "x loop: over the plain loop's step, measured before and after",
        "us: CPU time of a step, median of the last quarter of the press; ours is a whole tick",
        "real time: how many times faster than the clock, at the step that passes the gate and is "
        "best",
        f"force: off a converged run of the same springs, at most {report['gate']:.0%}",
        "(quoted): " + report["quoted_from"],
    ]
    return "\n".join(lines)


def describe_row(row: dict) -> str:
    name = row["peer"] + (" (quoted)" if row.get("quoted") else "")
    head = f"{name:36} {row['vertices']:8d} "
    if "not_run" in row:
        return head + "not run: " + row["not_run"]
    if not row.get("quoted") and not row["passes"]:
        return head + "no step passes the gate: " + "; ".join(row["tried"])
    p99 = f"{row['p99_us']:10.1f}" if "p99_us" in row else f"{'-':>10}"
    force = f"{row['force_error']:+7.1%}" if "force_error" in row else f"{'-':>7}"
    text = (
        f"{row['dt_ms']:8.2f} {row['median_us']:10.1f} {p99} {row['step_ratio']:8.2f} "
        f"{row['real_time_factor']:9.2f} {force}"
    )
    if row.get("substeps"):
        text += f"  {row['substeps']:.0f} substeps"
    if row.get("anchors_apart", 0.0) > 0.05:
        text += f"  anchors {row['anchors_apart']:.0%} apart"
    return head + text


def find_largest(rows: list[dict], name: str) -> float | None:
    """Vertices at which the real-time factor is 1; inf or 0 where it is on one side of it."""
    curve = sorted(
        (row["vertices"], row["real_time_factor"])
        for row in rows
        if row["peer"] == name and "real_time_factor" in row
    )
    if not curve:
        return None
    if curve[0][1] < 1.0:
        return 0.0
    for (n0, f0), (n1, f1) in zip(curve, curve[1:], strict=False):
        if f1 < 1.0:
            return n0 * (n1 / n0) ** (math.log(f0) / math.log(f0 / f1))
    return math.inf


def describe_largest(vertices: float | None) -> str:
    if vertices is None:
        return "no row passes"
    if vertices == 0.0:
        return "less than all sizes measured"
    return "more than all sizes measured" if math.isinf(vertices) else f"{vertices:.0f}"

# SPDX-License-Identifier: BSD-3-Clause
"""What compare_accuracy.py found, in words."""

from __future__ import annotations

HEAD = (
    f"{'engine':22} {'elements':>8} {'step ms':>8} {'force off by':>14} {'s / s':>8} "
    f"{'x loop':>7} {'x ours':>7}"
)


def describe(report: dict) -> str:
    parts = []
    for name, work in report["works"].items():
        depths = " and ".join(f"{1e3 * depth:.2f}" for depth in work["depths"])
        forces = " and ".join(f"{1e3 * force:.1f}" for force in work["forces"])
        parts += [
            f"{work['title']}, ball of {1e3 * work['radius']:g} mm, {depths} mm deep: {forces} mN",
            describe_best(report, name, "any_step", "cheapest within a tenth of it at both depths"),
            describe_best(report, name, "one_ms", "the same with steps of 1 ms at most"),
            "all that was tried:",
            HEAD,
            *[describe_row(row) for row in report["rows"] if row["work"] == name],
            "",
        ]
    parts += [
        "spleen, one configuration at both places and depths, where it costs more:",
        HEAD,
        *list_best(report["best_at_both_places"]),
        "",
        "s / s: processor time per simulated second, from the first touch on; x loop: over the "
        "plain loop's at 1 ms; x ours: over Palpate's",
        *[f"not compared: {words}" for words in report["not_compared"]],
    ]
    return "\n".join(parts)


def describe_best(report: dict, name: str, key: str, title: str) -> str:
    best = {engine: found[key] for engine, found in report["best"][name].items()}
    lines = list_best(best)
    for k, (engine, row) in enumerate(best.items()):
        if row is None:
            lines[k] += f"; nearest: {describe_nearest(report, name, engine, key)}"
    return "\n".join([title + ":", HEAD, *lines])


def list_best(best: dict[str, dict | None]) -> list[str]:
    """A line per engine, ours first."""
    ours, lines = next(iter(best.values())), []
    for engine, row in best.items():
        if row is None:
            lines.append(f"{engine:22} none")
            continue
        ratio = f"{row['cpu_per_second'] / ours['cpu_per_second']:7.1f}" if ours else f"{'-':>7}"
        lines.append(describe_numbers(engine, row) + f" {ratio}   {row['words']}")
    return lines


def describe_nearest(report: dict, name: str, engine: str, key: str) -> str:
    """The run whose larger error is least, in words."""
    rows = [
        row
        for row in report["rows"]
        if row["work"] == name
        and row["engine"] == engine
        and "errors" in row
        and (key == "any_step" or row["dt_ms"] <= 1.0 + 1e-9)
    ]
    if not rows:
        return "no run came to its end"
    row = min(rows, key=lambda row: max(map(abs, row["errors"])))
    errors = ", ".join(f"{error:+.0%}" for error in row["errors"])
    return f"{row['words']}: {errors}, {row['cpu_per_second']:.2f} s / s"


def describe_row(row: dict) -> str:
    if "errors" not in row:
        return f"{row['engine']:22} {row['words']}: {row.get('why', 'no force')}"
    mark = "*" if row["passes"] else " "
    apart = row["anchors_apart"]
    note = f"  anchors {apart:.0%} apart" if apart > 0.05 else ""
    return describe_numbers(row["engine"], row) + f" {'':7} {mark} {row['words']}{note}"


def describe_numbers(engine: str, row: dict) -> str:
    errors = " ".join(f"{error:+7.1%}" for error in row["errors"])
    return (
        f"{engine:22} {row['cells']:8d} {row['dt_ms']:8.2f} {errors:>14} "
        f"{row['cpu_per_second']:8.3f} {row['ratio_to_loop']:7.1f}"
    )

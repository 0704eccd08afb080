# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of `palpate felt`, as text."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from palpate.command.verb import Report
from palpate.runs.trial import DEPTH
from palpate.study.felt import PRESSED, summarise
from palpate.study.tables import write_table

from palpate_editor.felt import TIP


def write_felt(report: Report) -> str:
    """Those of the parts that a report has."""
    writers = {
        "block": write_block,
        "mesh": write_meshes,
        "scenes": write_scenes,
        "cost": write_costs,
    }
    return "\n\n".join(writers[part](rows) for part, rows in report.items() if part in writers)


def write_block(rows: Sequence[Report]) -> str:
    balls = sorted({row["radius"] for row in rows})
    lines = []
    for kind, law in list_pairs(rows):
        ours = [row for row in rows if (row["kind"], row["law"]) == (kind, law)]
        cells = [
            summarise([row["felt"] / row["theory"] for row in ours if row["radius"] == ball])
            for ball in balls
        ]
        lines.append([kind, law, *cells])
    head = ["block of 3000 tetrahedra", "contact", *(f"ball of {1e3 * b:g} mm" for b in balls)]
    return (
        f"Felt over theory, pressed {1e3 * PRESSED:g} mm, mean (least to most) of the places:\n\n"
        + write_table(head, lines)
    )


def write_meshes(rows: Sequence[Report]) -> str:
    counts = sorted({row["vertices"] for row in rows})
    lines = []
    for kind, law in list_pairs(rows):
        felt = [r["felt"] for r in rows if (r["kind"], r["law"]) == (kind, law)]
        change = max(felt) / min(felt) - 1.0
        lines.append(
            [kind.replace("_", " "), law, *(f"{1e3 * f:.0f}" for f in felt), f"{change:.0%}"]
        )
    head = ["ellipsoid", "contact", *(f"{count} vertices" for count in counts), "most over least"]
    return (
        f"Force [mN] of one ellipsoid, ball of {1e3 * TIP:g} mm, hand {1e3 * DEPTH:g} mm deep, "
        "mean of three places:\n\n" + write_table(head, lines)
    )


def write_scenes(rows: Sequence[Report]) -> str:
    lines = [
        [
            name_scene(row["scene"]),
            row["law"],
            f"{1e3 * row['felt']:.0f} mN",
            "-" if row["home_share"] is None else f"{row['home_share']:.0%}",
            *(
                "-" if row[part] is None else f"{row[part]:.2f}"
                for part in ("home_twice", "links_twice", "angles_twice")
            ),
        ]
        for row in rows
    ]
    head = ["scene", "contact", "felt", "through home springs", "home springs twice as stiff",
            "springs and bonds", "angles"]  # fmt: skip
    return (
        f"What carries a press of {1e3 * DEPTH:g} mm, and how many times the force is felt once a "
        "part is twice as stiff, means of the places:\n\n" + write_table(head, lines)
    )


def name_scene(path: str) -> str:
    """Its file and the folder that that lies in."""
    return "/".join(Path(path).parts[-2:])


def write_costs(rows: Sequence[Report]) -> str:
    lines = [
        [
            row["kind"].replace("_", " "),
            row["law"],
            f"{row['substeps_in_air']}",
            f"{row['substeps_in_touch']}",
            f"{row['ratio']:.1f}",
        ]
        for row in rows
    ]
    head = [
        "kind",
        "contact",
        "substeps in the air",
        "in touch",
        "time in touch over air",
    ]
    return "What touch costs, on the ellipsoid of 600 vertices:\n\n" + write_table(head, lines)


def list_pairs(rows: Sequence[Report]) -> list[tuple[str, str]]:
    """Kinds and laws, each once, as they come."""
    return list(dict.fromkeys((row["kind"], row["law"]) for row in rows))

# SPDX-License-Identifier: BSD-3-Clause
"""Which configurations of which engine are tried at equal accuracy, cheapest first.

Meshes, steps, solvers and laws were searched beforehand; these are the ones about the boundary of
the tenth, those that a user would take first, and some that say what a finer one costs. A recipe
is explained in organ_meshes.py, the words after it in the engine's program.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Try:
    """One configuration: the words after the work's name."""

    words: tuple[str, ...]
    quick: bool = False
    """Whether `--quick` runs it."""


@dataclass(frozen=True)
class Entry:
    """An engine with what is tried on each work."""

    engine: str
    program: str
    tries: dict[str, tuple[Try, ...]]
    ours: bool = False


def tries(*lines: str) -> tuple[Try, ...]:
    """A line is words; a star in front: also with `--quick`."""
    return tuple(Try(tuple(line.lstrip("*").split()), line.startswith("*")) for line in lines)


SOLID, WALL = ("spleen", "spleen_top"), ("wall",)


def on(works: tuple[str, ...], *lines: str) -> dict[str, tuple[Try, ...]]:
    return {work: tries(*lines) for work in works}


LADDER = (
    Entry(
        "Palpate",
        "palpate_tissue.py",
        on(
            SOLID,
            "300 linear facets hz:50",
            "*300 linear facets hz:100",
            "600 linear facets hz:100",
            "*300 linear facets",
            "600 linear facets",
            "300 facets",
            "*600 facets",
            "3000 facets",
            "300 linear hz:100",
            "600",
            "3000",
            "600 mesh",
            "12000 mesh",
        )
        | on(
            WALL,
            "200 damping:0.02",
            "*300 damping:0.02",
            "400 damping:0.02",
            "600 damping:0.02",
            "*300",
            "400",
            "600",
            "800 1e8",
        ),
        ours=True,
    ),
    Entry(
        "PositionBasedDynamics",
        "pbd_tissue.py",
        on(
            SOLID,
            "coarse:1.0:1.1 2 1 fem",
            "*coarse:1.0:1.1 1 1 fem",
            "coarse:1.1:1.1 0.5 1 fem",
            "coarse:1.5:1.1 1 1 fem",
            "middle:2.0:1.1 0.5 1 fem",
        )
        | on(WALL, "*coarse 1 1 fem", "middle 1 1 fem", "coarse 0.25 1 fem"),
    ),
    Entry(
        "MuJoCo",
        "mujoco_tissue.py",
        on(
            SOLID,
            "*middle:4.0:1.1 20 discrete 30 neo_hookean",
            "middle:4.0:1.1 10 discrete 30 neo_hookean",
            "middle:4.0:1.1 10 discrete 30 stvk",
            "middle:6.0:0.8 20 discrete 30 neo_hookean",
            "*middle:6.0:0.8 10 discrete 30 neo_hookean",
        )
        | on(
            WALL,
            "*shell_coarse 20 discrete 30 stvk",
            "*shell_coarse 10 discrete 30 stvk",
            "shell_middle 20 discrete 30 stvk",
            "shell_middle 10 discrete 30 stvk",
            "shell_fine 10 discrete 30 stvk",
            "middle 10 discrete 30 neo_hookean",
            "shell_coarse 1 discrete 30 stvk",
        ),
    ),
    Entry(
        "Newton",
        "newton_tissue.py",
        on(
            SOLID,
            "coarse:2.0:1.1 20 vbd 10",
            "*middle:2.0:1.1 20 vbd 10",
            "middle:2.0:1.1 20 vbd 5",
            "*middle:4.0:1.1 20 vbd 10",
            "middle:2.0:1.1 0.2 semi",
        )
        | on(WALL, "*coarse 20 vbd 10", "middle 20 vbd 10"),
    ),
)

# SPDX-License-Identifier: BSD-3-Clause
"""What an atlas says in words: titles, margins, and what becomes of each method."""

from __future__ import annotations

import math

from palpate.study.atlas import (
    AT_REST,
    FAILED,
    LIMITED,
    NEVER,
    REFUSED,
    UNLIMITED,
    Atlas,
    Present,
    Row,
)
from palpate.study.step_limit import LIMIT_SHARE

INTEGRATORS = {
    "symplectic_euler": ("symplectic Euler", "#1f6fb2"),
    "explicit_euler": ("explicit Euler", "#b0256f"),
    "midpoint": ("explicit midpoint", "#d9822b"),
    "runge_kutta_4": ("Runge-Kutta 4", "#0f9d7a"),
    "symplectic_euler_implicit_damping": ("implicit damping", "#6b4fbb"),
    "implicit_euler_linear": ("implicit Euler, linear", "#5f6b7a"),
    "implicit_euler": ("implicit Euler", "#5f6b7a"),
    "implicit_midpoint": ("implicit midpoint", "#5f6b7a"),
    "xpbd": ("XPBD", "#5f6b7a"),
    "projective_dynamics": ("projective dynamics", "#5f6b7a"),
}
"""Integrator -> what it is called, its colour."""
DAMPINGS = {"none": "nothing damped", "own": "damped as it is", "critical": "damped critically"}
LITTLE = 0.05
"""[-] A fault below this is not worth a word."""


def write_step(seconds: float) -> str:
    """83 us, 1.3 ms"""
    return f"{1e6 * seconds:.3g} us" if seconds < 0.9995e-4 else f"{1e3 * seconds:.3g} ms"


def write_pair(used: float, limit: float) -> str:
    """1.3 of 2.6 ms: both in the unit of the limit."""
    if limit < 0.9995e-4:
        return f"{1e6 * used:.3g} of {1e6 * limit:.3g} us"
    return f"{1e3 * used:.3g} of {1e3 * limit:.3g} ms"


def find_limit(present: Present) -> float | None:
    """[s] That was found, else that is foretold."""
    return present.measured or present.predicted


def say_present(present: Present) -> str:
    """The scene's margin, in a few words."""
    limit = find_limit(present)
    if limit is None:
        return f"this scene: steps of {write_step(present.step)}, no limit"
    return f"this scene: {write_pair(present.step, limit)} used"


def write_title(atlas: Atlas) -> str:
    done = "" if atlas.complete else " (not finished)"
    return f"{atlas.organ}: how long a time step may be before the simulation blows up{done}"


def write_subtitle(atlas: Atlas) -> str:
    return (
        f"With nothing in touch: knocked very lightly and followed for {atlas.steps} steps; where "
        "motion grows, the step was too long. Lines: found so. Dashes: foretold, without a run."
    )


def count_substeps(row: Row, rate: float) -> int | None:
    """That a tick needs in the air, with the reserve that is kept."""
    if row.measured is None or row.outcome != LIMITED:
        return None
    limit = min(row.measured, row.predicted or row.measured)
    return max(1, math.ceil(1.0 / (rate * LIMIT_SHARE * limit)))


def say_row(row: Row, rate: float) -> tuple[str, str]:
    """What becomes of a method on the organ, and what that means: a line each."""
    if row.outcome == LIMITED:
        if row.measured is None:
            return f"to {write_step(row.predicted or 0.0)}", "foretold; not found"
        count = count_substeps(row, rate)
        return f"to {write_step(row.measured)}", f"{count} step{'s' * (count != 1)} a tick"
    if row.outcome == NEVER:
        return "never", "something is not damped"
    if row.outcome == AT_REST:
        return "any step", "follows at rest"
    if row.outcome == UNLIMITED:
        return "any step", say_fault(row)
    if row.outcome == FAILED:
        return "fails", "long steps do not settle"
    return ("not for it", "") if row.outcome == REFUSED else ("lost", "")


def say_fault(row: Row) -> str:
    """How a method errs that never blows up, in steps of one tick: the worst of it."""
    if row.loss is None:
        return ""
    off = 0.0 if row.softness is None else row.softness - 1.0
    chatter = 0.0 if row.chatter is None or row.integrator != "implicit_midpoint" else row.chatter
    faults = {
        f"sags {off:.0%} too far": off,
        f"sags {-off:.0%} too little": -off,
        f"chatters, {chatter:.0%}": chatter,
        f"swallows {row.loss:.0%}": row.loss,
    }
    worst = max(faults, key=lambda fault: faults[fault])
    return worst.replace("%", " %") if faults[worst] >= LITTLE else "little error"

# SPDX-License-Identifier: GPL-3.0-or-later
"""The truth of a path on an organ: taken from the cache, or solved and kept there."""

from __future__ import annotations

import importlib.util
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from palpate.files.refusal import Refusal
from palpate.study.truth import Truth
from palpate.study.truth_file import read_truth, write_truth
from palpate.system.data_folder import find_cache_folder

from palpate_editor.document import Organ
from palpate_editor.truth import wanted
from palpate_editor.truth.progress import Asked, Told, TruthError

SOLVER = ("skfem", "cvxopt", "pymetis")
MOST_KEPT = 200
"""Files in the cache; those that were written longest ago go first."""


def solve_truth(
    organ: Organ,
    path: wanted.Path | None = None,
    *,
    radius: float | None = None,
    depths: Sequence[float] | None = None,
    progress: Told | None = None,
    cancelled: Asked | None = None,
    cache: Path | None = None,
) -> Truth:
    """Force and displacement that linear tissue gives to a rigid, frictionless ball.

    Solved on finer and finer meshes until forces change by less than 3 %, in minutes and on any
    thread; a second call with the same organ, path, ball and depths takes what was kept.

    Args:
        organ: Its surface before it was decimated, what is held, its material and what is painted
            stiffer count; how it is simulated does not.
        path: Where the tool goes; a press where a check presses first if None.
        radius: [m] of the ball; the organ's own tool's if None.
        depths: [m] of the ball beyond its first touch, of a pull how high over it; four up to the
            most if None.
        progress: Told of every stage.
        cancelled: Asked between stages and in the long ones; a factor, some seconds, is finished.
        cache: The folder of kept truths; the user's own if None.

    Raises:
        TruthError: a sentence on what is missing, wrong or too large.
        Stopped: once `cancelled` says so.
    """
    require_solver()
    # they load the solver, which may not be installed
    from palpate_editor.truth.keys import compute_key
    from palpate_editor.truth.paths import choose_depths, find_stations
    from palpate_editor.truth.solve import solve_way
    from palpate_editor.truth.subject import find_whole, take_subject

    ball = organ.tool.radius if radius is None else radius
    if not (np.isfinite(ball) and ball > 0.0):
        raise TruthError(f"radius: got {ball} m, expected one above 0")
    if organ.tool.length > 0.0 and radius is None:
        raise TruthError(
            f"tool.length: got {organ.tool.length:g} m, expected 0: the truth is that of a ball "
            "(palpate truth --radius for one)"
        )
    body = find_whole(organ)
    subject = take_subject(body)
    way = find_stations(organ, subject, ball, path or wanted.Press())
    deep, said = choose_depths(way, None if depths is None else np.asarray(depths, dtype=float))
    key = compute_key(body, way, ball, deep)
    file = (find_cache_folder() / "truths" if cache is None else cache) / f"{key}.truth"
    kept, remarks = take_kept(file, key)
    if kept is not None:
        return replace(kept, remarks=kept.remarks + said)
    truth = solve_way(subject, way, ball, deep, key, progress, cancelled)
    remarks += (*keep(file, truth), *said)
    return replace(truth, remarks=truth.remarks + remarks)


def require_solver() -> None:
    """Raises TruthError where the extra is not installed."""
    missing = [name for name in SOLVER if importlib.util.find_spec(name) is None]
    if missing:
        raise TruthError(
            f"truth: got no {', '.join(missing)}, expected the solver: pip install "
            "'palpate-editor[reference]'"
        )


def take_kept(file: Path, key: str) -> tuple[Truth | None, tuple[str, ...]]:
    """What the cache has under a key, and what is odd about it."""
    try:
        truth = read_truth(file)
        if truth.key != key:
            raise Refusal(file, "key", truth.key, key)
    except FileNotFoundError:
        return None, ()
    except (Refusal, OSError) as refused:
        return None, (f"what was kept could not be read and was solved again: {refused}",)
    return truth, ()


def keep(file: Path, truth: Truth) -> tuple[str, ...]:
    """Writes into the cache; what cannot be kept is said, and no reason to fail."""
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        write_truth(file, truth)
        kept = sorted(file.parent.glob("*.truth"), key=lambda path: path.stat().st_mtime)
        for old in kept[:-MOST_KEPT]:
            old.unlink(missing_ok=True)
    except OSError as problem:
        return (f"it could not be kept: {problem}",)
    return ()

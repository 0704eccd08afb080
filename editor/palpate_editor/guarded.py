# SPDX-License-Identifier: GPL-3.0-or-later
"""Work on a surface that may take long, in a process that ends with its time or when it is told to.

Who does such work in a thread says by `stopping` how to ask whether it is still wanted.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from os import sysconf
from pathlib import Path
from tempfile import TemporaryDirectory, TemporaryFile
from time import monotonic
from typing import Any

import numpy as np
from palpate.files.whole_file import write_whole
from palpate.system.isolated import build_command

from palpate_editor.document import Surface

TIME = 10.0
"""[s] That a job may take where nobody says otherwise."""
MEMORY = 8_000_000_000
"""[bytes] Of address space."""
PATIENCE = 4.0
"""[-] How much longer than its processor time it may take on a clock."""
START = 1.0
"""[s] Of processor time that its process takes to begin."""
POLL = 0.02
"""[s] Between two questions whether the work is still wanted."""


class Cancelled(Exception):  # noqa: N818  # not an error: a person wanted it
    """The work is no longer wanted."""


class GuardedError(Exception):
    """Why a job gave nothing: a sentence."""


@dataclass(frozen=True, eq=False)
class Found:
    """What a job found."""

    surface: Surface
    told: Mapping[str, Any]
    finished: bool
    """False where its time was over: then this is what it had by then."""


def never() -> bool:
    return False


STOPPED: ContextVar[Callable[[], bool]] = ContextVar("stopped", default=never)


@contextmanager
def stopping(stopped: Callable[[], bool]) -> Iterator[None]:
    """Work begun within asks `stopped` some times a second, and ends where it says True."""
    token = STOPPED.set(stopped)
    try:
        yield
    finally:
        STOPPED.reset(token)


def check_wanted() -> None:
    """Raises Cancelled where the work is no longer wanted."""
    if STOPPED.get()():
        raise Cancelled


def run_guarded(
    job: str, surface: Surface, numbers: Mapping[str, Any], seconds: float = TIME
) -> Found | None:
    """Does one of `surface_child.jobs`; None where the time was over before anything was found.

    Raises GuardedError where it cannot be done, Cancelled once it is no longer wanted.

    Args:
        job: Its name.
        surface: What it works on.
        numbers: What else it is told, as JSON has it.
        seconds: [s] of processor time it may take; four times as long on a clock.
    """
    with TemporaryDirectory(prefix="palpate-surface-") as name:
        folder = Path(name)
        np.savez(folder / "surface.npz", vertices=surface.vertices, triangles=surface.triangles)
        request = {"job": job, "numbers": dict(numbers), "memory": MEMORY}
        write_whole(folder / "request.json", json.dumps(request).encode())
        finished = run(folder, seconds)
        refused = folder / "refused.json"
        if refused.exists():
            kind, sentence = json.loads(refused.read_text(encoding="utf-8"))
            if kind == "MemoryError":
                sentence = f"it needs more than {MEMORY // 1_000_000_000} GB of memory"
            raise GuardedError(sentence)
        return read_found(folder / "found.npz", finished)


def run(folder: Path, seconds: float) -> bool:
    """Whether it came to its end in time. Raises GuardedError where it broke down."""
    command = build_command("-m", "palpate_editor.surface_child", folder)
    with TemporaryFile() as said:
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=said, stderr=said,
                                 cwd=folder)  # fmt: skip
        try:
            code = wait(child, seconds)
        finally:
            if child.poll() is None:
                child.kill()
                child.wait()
        if code not in (None, 0) and not (folder / "refused.json").exists():
            said.seek(0)
            lines = said.read().decode(errors="replace").split("\n")
            last = next((line.strip() for line in reversed(lines) if line.strip()), "")
            raise GuardedError(last or f"its process ended with {code}")
    return code == 0


def wait(child: subprocess.Popen[bytes], seconds: float) -> int | None:
    """Its exit code; None where its time was over. Raises Cancelled.

    Its own time counts, so that a job gives the same on a busy machine as on an idle one.
    """
    end = monotonic() + PATIENCE * seconds
    while True:
        try:
            return child.wait(timeout=POLL)
        except subprocess.TimeoutExpired:
            check_wanted()
        if monotonic() > end or measure_time(child.pid) > seconds:
            return None


def measure_time(process: int) -> float:
    """[s] Of processor time that it has taken, the start of its Python not counted; 0 once it has
    ended."""
    try:
        stat = Path(f"/proc/{process}/stat").read_text(encoding="ascii", errors="replace")
    except OSError:
        return 0.0
    user, system = stat.rpartition(")")[2].split()[11:13]
    return (int(user) + int(system)) / sysconf("SC_CLK_TCK") - START


def read_found(path: Path, finished: bool) -> Found | None:
    if not path.exists():
        return None
    with np.load(path, allow_pickle=False) as arrays:
        surface = Surface(arrays["vertices"], arrays["triangles"])
        told = json.loads(arrays["told"].tobytes())
    return Found(surface, told, finished)

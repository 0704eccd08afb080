# SPDX-License-Identifier: GPL-3.0-or-later
"""Starts the reader of scans, watches it, and believes nothing that it has not checked."""

from __future__ import annotations

import errno
import hashlib
import json
import signal
import subprocess
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from tempfile import TemporaryDirectory, TemporaryFile
from time import monotonic
from typing import IO, Any

import numpy as np
from palpate.error import FileError
from palpate.files.refusal import Refusal
from palpate.system.isolated import build_command

from palpate_editor.scan.values import Label, Scan, ScanSurface, Series
from palpate_editor.scan_child.choice import Choice

SUFFIXES = (".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".dcm")
INSTALL = "pip install 'palpate-editor[scan]'"
POLL = 0.05
"""[s] Between two questions whether the reading is still wanted."""
BROKE = "data that broke its reader"
SAID = 400
"""[letters] Of what a reader that broke down wrote last."""


@dataclass(frozen=True)
class Limits:
    """What reading a scan may take."""

    time: float = 120.0
    """[s]"""
    memory: int = 6_000_000_000
    """[bytes] Of address space."""


class MissingExtra(Refusal):
    """What reads scans is not installed."""

    def __init__(self, path: Path, module: str):
        super().__init__(path, "", f"no {module} to read it with", INSTALL)


class SeveralSeries(FileError):
    """A folder of several series, of which one must be named."""

    def __init__(self, path: Path, where: str, got: str, expected: str, series: tuple[Series, ...]):
        super().__init__(str(path), where, got, expected)
        self.series = series


class Cancelled(Exception):  # noqa: N818  # not an error: a person wanted it
    """The scan is no longer wanted."""


def never() -> bool:
    return False


def is_scan(path: Path) -> bool:
    """Whether a path looks like a scan: by its name, or a folder."""
    return path.name.lower().endswith(SUFFIXES) or path.is_dir()


def read_scan(
    path: Path,
    *,
    series: str | None = None,
    voxels: bool = False,
    limits: Limits | None = None,
    stopped: Callable[[], bool] = never,
) -> Scan:
    """What a volume is. Raises FileError, MissingExtra, OSError, or Cancelled once `stopped()`.

    Args:
        path: A file, or a folder of DICOM slices.
        series: The UID of one among several series of a folder.
        voxels: Give the voxels too.
        limits: Of the reader.
        stopped: Asked some times a second.
    """
    with TemporaryDirectory(prefix="palpate-scan-") as folder:
        said = ask(Path(folder), path, series, None, voxels, limits or Limits(), stopped)
        found = read_array(path, Path(folder) / "voxels.npy", None) if voxels else None
    return describe(path, said, found)


def segment_scan(
    path: Path,
    choice: Choice,
    *,
    series: str | None = None,
    limits: Limits | None = None,
    stopped: Callable[[], bool] = never,
) -> ScanSurface:
    """A surface of a volume; arguments and refusals as of `read_scan`."""
    with TemporaryDirectory(prefix="palpate-scan-") as folder:
        said = ask(Path(folder), path, series, choice, False, limits or Limits(), stopped)
        vertices = read_array(path, Path(folder) / "vertices.npy", 3)
        triangles = read_array(path, Path(folder) / "triangles.npy", 3)
    check_surface(path, vertices, triangles)
    found = said["surface"]
    return ScanSurface(
        scan=describe(path, said, None),
        choice=choice,
        vertices=vertices.astype(np.float64),
        triangles=triangles.astype(np.int32),
        voxel_volume=float(found["voxel_volume"]),
        volume=float(found["volume"]),
        change=float(found["change"]),
        pieces_dropped=int(found["pieces_dropped"]),
        shells_dropped=int(found["shells_dropped"]),
        cut_sides=tuple(map(str, found["cut_sides"])),
    )


def hash_scan(path: Path) -> str:
    """SHA-256 of a file; of a folder that of the hashes of its files, in the order of their names.

    Raises OSError.
    """
    if path.is_file():
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    whole = hashlib.sha256()
    for name in sorted(entry for entry in path.iterdir() if entry.is_file()):
        with name.open("rb") as file:
            whole.update(hashlib.file_digest(file, "sha256").digest())
    return whole.hexdigest()


def ask(
    folder: Path,
    path: Path,
    series: str | None,
    choice: Choice | None,
    voxels: bool,
    limits: Limits,
    stopped: Callable[[], bool],
) -> dict[str, Any]:
    """The reader's answer; its arrays are left in `folder`."""
    if not path.exists():
        raise FileNotFoundError(errno.ENOENT, "No such file or directory", str(path))
    request = {
        "path": str(path.resolve()),
        "series": series,
        "voxels": voxels,
        "choice": None if choice is None else asdict(choice),
        "time_limit": limits.time,
        "memory_limit": limits.memory,
    }
    said = run(folder, json.dumps(request).encode(), path, limits, stopped)
    if "missing" in said:
        raise MissingExtra(path, str(said["missing"]))
    if "series" in said:
        rows = tuple(read_series(row) for row in said["series"])
        raise SeveralSeries(path, *map(str, said["refused"]), rows)
    if "refused" in said:
        raise FileError(str(path), *map(str, said["refused"]))
    if "failed" in said:
        number, text, name = said["failed"]
        raise OSError(number, text, name or str(path))
    return dict(said["answer"])


def read_series(row: Any) -> Series:
    return Series(
        str(row["uid"]), str(row["title"]), int(row["slices"]), tuple(map(int, row["size"]))
    )


def run(
    folder: Path, request: bytes, path: Path, limits: Limits, stopped: Callable[[], bool]
) -> dict[str, Any]:
    """Runs the reader to its end. Raises FileError where it does not come to one, or Cancelled."""
    command = build_command("-m", "palpate_editor.scan_child", folder)
    with TemporaryFile() as asked, TemporaryFile() as said, TemporaryFile() as complained:
        asked.write(request)
        asked.seek(0)
        child = subprocess.Popen(command, stdin=asked, stdout=said, stderr=complained, cwd=folder)
        try:
            code = wait(child, path, limits, stopped)
        finally:
            if child.poll() is None:
                child.kill()
                child.wait()
        if code != 0:
            raise FileError(str(path), "", describe_end(code, complained), "a volume")
        said.seek(0)
        try:
            return dict(json.loads(said.read().splitlines()[-1]))
        except (ValueError, TypeError, IndexError):
            raise FileError(str(path), "", BROKE, "a volume") from None


def wait(
    child: subprocess.Popen[bytes], path: Path, limits: Limits, stopped: Callable[[], bool]
) -> int:
    """Its exit code. Raises FileError once its time is over, or Cancelled."""
    end = monotonic() + limits.time
    while True:
        try:
            return child.wait(timeout=POLL)
        except subprocess.TimeoutExpired:
            if stopped():
                raise Cancelled from None
        if monotonic() > end:
            most = f"at most {limits.time:g} s"
            raise FileError(str(path), "", "a volume that takes longer to read", most)


def describe_end(code: int, complained: IO[bytes]) -> str:
    """How a reader ended that gave no answer."""
    if code == -signal.SIGXCPU:
        return "a volume that takes longer to read than it may"
    if code < 0:
        return f"{BROKE} ({signal.Signals(-code).name})"
    complained.seek(0)
    lines = complained.read().decode(errors="replace").splitlines()
    last = next((line.strip() for line in reversed(lines) if line.strip()), "")
    return f"{BROKE} ({last[-SAID:]})"


def read_array(path: Path, name: Path, width: int | None) -> np.ndarray:
    """An array that the reader left; `width` columns, or a volume. Raises FileError."""
    try:
        array = np.load(name, allow_pickle=False)
    except (OSError, ValueError, EOFError):
        raise FileError(str(path), "", BROKE, "a volume") from None
    fits = array.ndim == 3 if width is None else array.ndim == 2 and array.shape[1] == width
    if not fits or array.dtype.kind not in "iuf":
        raise FileError(str(path), "", f"an array of shape {array.shape}", "numbers of a volume")
    return array


def check_surface(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> None:
    sound = len(triangles) > 0 and triangles.min() >= 0 and triangles.max() < len(vertices)
    if not sound or not np.isfinite(vertices).all():
        raise FileError(str(path), "", "voxels without a surface", "an organ of several voxels")


def describe(path: Path, said: dict[str, Any], voxels: np.ndarray | None) -> Scan:
    labels = said["labels"]
    return Scan(
        path=path,
        format=str(said["format"]),
        size=tuple(map(int, said["size"])),
        steps=1e-3 * np.reshape(said["steps"], (3, 3)).astype(float),
        origin=1e-3 * np.reshape(said["origin"], 3).astype(float),
        tilt=float(said["tilt"]),
        type=str(said["type"]),
        low=float(said["low"]),
        high=float(said["high"]),
        labels=None if labels is None else tuple(Label(**row) for row in labels),
        notes=tuple(map(str, said["notes"])),
        voxels=voxels,
    )

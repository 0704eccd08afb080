# SPDX-License-Identifier: BSD-3-Clause
"""A disk that loses power: what may stand in a folder after any step of what a program did to it.

tests/disk/trace_writes.c, preloaded before the program, writes the steps down. What was not synced
when the power went may be on the disk in whole, in part or not at all: names and contents each for
themselves, in any order between files, as POSIX allows. Without a sync of the folder not even the
name of a file is sure.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import pytest

SHIM = Path(__file__).parent / "disk" / "trace_writes.c"


@dataclass(frozen=True)
class Step:
    """One thing that was done."""

    kind: str
    words: tuple[str, ...] = ()
    data: bytes = b""


def build_shim(folder: Path) -> Path:
    """Compiles what is preloaded; skips the test where there is no compiler for it."""
    shim = folder / "trace_writes.so"
    command = ["cc", "-O1", "-shared", "-fPIC", "-o", shim, SHIM, "-ldl", "-pthread"]
    try:
        subprocess.run(command, check=True, capture_output=True)
    except FileNotFoundError:
        pytest.skip("a C compiler cannot be had here")
    return shim


def run_traced(
    shim: Path, folder: Path, command: Sequence[object], fail: str = ""
) -> subprocess.CompletedProcess[str]:
    """Runs a program whose writes into `folder` are traced into FOLDER.trace beside it."""
    env = os.environ | {
        "LD_PRELOAD": str(shim),
        "PALPATE_DISK_FOLDER": str(folder),
        "PALPATE_DISK_TRACE": str(name_trace(folder)),
        "PALPATE_DISK_FAIL": fail,
    }
    return subprocess.run(
        list(map(str, command)), env=env, capture_output=True, encoding="utf-8", check=False
    )


def name_trace(folder: Path) -> Path:
    return folder.with_name(f"{folder.name}.trace")


def acknowledge(word: str) -> None:
    """Called by the program: from here on `word` is promised to its user."""
    trace = os.open(os.environ["PALPATE_DISK_TRACE"], os.O_WRONLY | os.O_APPEND)
    os.write(trace, f"promise {word}\n".encode())
    os.close(trace)


def read_steps(folder: Path) -> list[Step]:
    steps, data, at = [], name_trace(folder).read_bytes(), 0
    while at < len(data):
        end = data.index(b"\n", at)
        kind, *words = data[at:end].decode().split(" ")
        at = end + 1
        size = int(words[2]) if kind == "write" else 0
        steps.append(Step(kind, tuple(words), data[at : at + size]))
        at += size
    return steps


@dataclass
class File:
    """What of a file is sure, and what has been done to it since."""

    sure: bytes = b""
    pending: list[tuple[int, bytes | None]] = field(default_factory=list)
    """(offset, bytes) of a write, (size, None) of a truncation."""


@dataclass
class Disk:
    """A folder in the middle of a program's work."""

    files: dict[int, File] = field(default_factory=dict)
    names: dict[str, int] = field(default_factory=dict)
    """Those that are sure."""
    pending: list[Step] = field(default_factory=list)
    """Changes of names since the last sync of the folder."""
    promises: list[str] = field(default_factory=list)

    def take(self, step: Step, before: dict[str, bytes]) -> None:
        """Does one step. `before` is what stood in the folder when the program began."""
        if step.kind in ("create", "known"):
            number, name = int(step.words[0]), step.words[1]
            self.files[number] = File(b"" if step.kind == "create" else before[name])
            if step.kind == "create":
                self.pending.append(step)
            else:
                self.names[name] = number
        elif step.kind == "write":
            self.files[int(step.words[0])].pending.append((int(step.words[1]), step.data))
        elif step.kind == "truncate":
            self.files[int(step.words[0])].pending.append((int(step.words[1]), None))
        elif step.kind == "sync":
            file = self.files[int(step.words[0])]
            file.sure, file.pending = apply(file.sure, file.pending), []
        elif step.kind == "sync-folder":
            self.names, self.pending = rename(self.names, self.pending), []
        elif step.kind == "promise":
            self.promises.append(step.words[0])
        else:
            self.pending.append(step)


def apply(content: bytes, changes: Sequence[tuple[int, bytes | None]]) -> bytes:
    made = bytearray(content)
    for at, data in changes:
        if data is None:
            made = made[:at] + bytes(max(0, at - len(made)))
        else:
            made += bytes(max(0, at - len(made)))
            made[at : at + len(data)] = data
    return bytes(made)


def rename(names: dict[str, int], changes: Sequence[Step]) -> dict[str, int]:
    made = dict(names)
    for step in changes:
        if step.kind == "create":
            made[step.words[1]] = int(step.words[0])
        elif step.kind == "rename":
            if step.words[0] in made:
                made[step.words[1]] = made.pop(step.words[0])
        else:
            made.pop(step.words[0], None)
    return made


def list_contents(file: File) -> Iterator[bytes]:
    """What a file may hold: nothing of what is pending, all, a beginning, torn, with holes."""
    yield apply(file.sure, file.pending)
    if not file.pending:
        return
    yield file.sure
    for count in range(1, len(file.pending)):
        yield apply(file.sure, file.pending[:count])
    at, data = file.pending[-1]
    if data is None:
        return
    before, half = file.pending[:-1], len(data) // 2
    yield apply(file.sure, [*before, (at, data[:half])])  # cut in the middle
    yield apply(file.sure, [*before, (at, data[:half] + bytes(len(data) - half))])  # as long, empty
    yield apply(file.sure, [*before, (at, bytes(half) + data[half:])])  # its end came first
    yield apply(file.sure, [*before, (at, bytes(len(data)))])
    for hole in range(len(file.pending) - 1):  # all but one of the others
        if file.pending[hole][1] is not None:
            where, lost = file.pending[hole]
            holed = [*file.pending]
            holed[hole] = (where, bytes(len(lost or b"")))
            yield apply(file.sure, holed)


def list_folders(disk: Disk) -> Iterator[dict[str, bytes]]:
    """Every folder the disk may show: each beginning of the pending names, all contents of each."""
    for count in range(len(disk.pending) + 1):
        names = rename(disk.names, disk.pending[:count])
        whole = {name: apply(f.sure, f.pending) for name, f in find(disk, names).items()}
        yield whole
        for name, file in find(disk, names).items():
            for content in list_contents(file):
                if content != whole[name]:
                    yield {**whole, name: content}


def find(disk: Disk, names: dict[str, int]) -> dict[str, File]:
    return {name: disk.files[number] for name, number in names.items()}


@dataclass(frozen=True)
class Loss:
    """What a loss of power left."""

    after: int
    """Steps that had been taken."""
    promises: tuple[str, ...]
    folder: dict[str, bytes]


def list_losses(steps: Sequence[Step], before: dict[str, bytes]) -> Iterator[Loss]:
    """After every step, everything that the disk may show. `before` is taken to be sure."""
    disk = Disk()
    for number, (name, content) in enumerate(before.items(), start=1):
        disk.files[-number] = File(content)
        disk.names[name] = -number
    for after, step in enumerate([None, *steps]):
        if step is not None:
            disk.take(step, before)
        for folder in list_folders(disk):
            yield Loss(after, tuple(disk.promises), folder)


def put_back(loss: Loss, folder: Path) -> None:
    """Makes `folder` what the loss left."""
    folder.mkdir(exist_ok=True)
    for file in folder.iterdir():
        file.unlink()
    for name, content in loss.folder.items():
        (folder / name).write_bytes(content)

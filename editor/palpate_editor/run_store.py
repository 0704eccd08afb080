# SPDX-License-Identifier: GPL-3.0-or-later
"""Finished runs on disk at once: a second call goes on where the first one ended.

A file of JSON lines for every key, in a folder: first what it is, then a line for each run.
"""

from __future__ import annotations

import json
from abc import ABC, abstractmethod
from pathlib import Path
from typing import Any

from palpate.files.json_part import json_kind
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal
from palpate.files.whole_file import Journal

MOST_BYTES = 256 * 2**20


class RunStore(ABC):
    """The finished runs of one key; a file where there is a folder, else memory alone."""

    format = ""
    """What the first line says it is; of a subclass, as is `take`."""
    version = 0

    def __init__(self, key: str, folder: Path | None, stem: str):
        """Takes up what stands in the folder. Raises Refusal or OSError."""
        self.journal: Journal | None = None
        if folder is None:
            return
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / f"{stem}-{key[:16]}.jsonl"
        whole = self.read(key) if self.path.exists() else 0
        self.journal = Journal(self.path, whole)
        if not whole:
            self.append({"format": self.format, "version": self.version, "key": key})

    def read(self, key: str) -> int:
        """Takes up what was finished; returns the bytes that are whole lines. A last line that was
        cut short by an end of the process is left out."""
        data = read_file(self.path, MOST_BYTES)
        whole = data.rfind(b"\n") + 1
        for number, line in enumerate(data[:whole].splitlines()):
            where = f"line {number + 1}"
            try:
                said = json.loads(line)
            except (ValueError, RecursionError):
                raise Refusal(self.path, where, "text that is not JSON", "a finished run") from None
            if number == 0:
                self.check_head(said, key)
            else:
                self.take(where, said)
        return whole

    def check_head(self, said: Any, key: str) -> None:
        expected = {"format": self.format, "version": self.version, "key": key}
        if said != expected:
            raise Refusal(self.path, "line 1", json_kind(said), json.dumps(expected))

    @abstractmethod
    def take(self, where: str, said: Any) -> None:
        """One finished run. Raises Refusal."""

    def append(self, said: dict[str, Any]) -> None:
        """On the disk when it returns."""
        if self.journal is not None:
            self.journal.append(json.dumps(said, allow_nan=False).encode())

    def close(self) -> None:
        if self.journal is not None:
            self.journal.close()

    def __exit__(self, *problem: object) -> None:
        self.close()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What a chart has finished, on disk at once: a second call goes on where the first one ended.

A file of JSON lines for every key, in a folder: first what it is, then a line for each run.
"""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from palpate.files.json_part import is_whole, json_kind, read_part
from palpate.files.read_file import read_file
from palpate.files.refusal import Refusal
from palpate.files.whole_file import Journal
from palpate.study.chart_file import read_row
from palpate.study.scene_chart import LOST, Configuration, Cost, Errors, Row

from palpate_editor.chart_jobs import Converged

FORMAT, VERSION = "palpate chart rows", 1
MOST_BYTES = 256 * 2**20


class Store:
    """The finished runs of one chart; a file where there is a folder, else memory alone."""

    def __init__(self, key: str, folder: Path | None = None):
        """Takes up what stands in the folder. Raises Refusal or OSError."""
        self.converged: dict[Configuration, Converged] = {}
        self.rows: dict[Configuration, Row] = {}
        self.costs: dict[Configuration, Cost | None] = {}
        self.journal: Journal | None = None
        if folder is None:
            return
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / f"rows-{key[:16]}.jsonl"
        whole = self.read(key) if self.path.exists() else 0
        self.journal = Journal(self.path, whole)
        if not whole:
            self.append({"format": FORMAT, "version": VERSION, "key": key})

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
        expected = {"format": FORMAT, "version": VERSION, "key": key}
        if said != expected:
            raise Refusal(self.path, "line 1", json_kind(said), json.dumps(expected))

    def take(self, where: str, said: Any) -> None:
        """One finished run; a row that was lost is tried again."""
        if not isinstance(said, dict) or len(said) != 2 or "configuration" not in said:
            raise Refusal(self.path, where, json_kind(said), "a configuration and what it came to")
        configuration = read_part(
            self.path, where, Configuration, said["configuration"], whole=True
        )
        if "row" in said:
            row = read_row(self.path, where, said["row"])
            if row.outcome != LOST:
                self.rows[configuration] = row
        elif "cost" in said:
            cost = said["cost"]
            self.costs[configuration] = cost and read_part(self.path, where, Cost, cost, whole=True)
        elif "converged" in said:
            self.converged[configuration] = self.read_converged(where, said["converged"])
        else:
            raise Refusal(self.path, where, ", ".join(said), "a row, a cost, or what converged")

    def read_converged(self, where: str, said: Any) -> Converged:
        if not isinstance(said, dict) or set(said) != {"force", "model"}:
            raise Refusal(self.path, where, json_kind(said), "force and model")
        force, model = said["force"], said["model"]
        numbers = isinstance(force, list) and all(
            isinstance(row, list) and len(row) == 3 and all(map(is_number_or_whole, row))
            for row in force
        )
        if not numbers:
            raise Refusal(self.path, f"{where}.force", json_kind(force), "a list of three numbers")
        errors = model and read_part(self.path, f"{where}.model", Errors, model, whole=True)
        return Converged(tuple(map(tuple, force)), errors)

    def keep_row(self, row: Row) -> None:
        self.rows[row.configuration] = row
        self.append({"configuration": asdict(row.configuration), "row": asdict(row)})

    def keep_converged(self, configuration: Configuration, converged: Converged) -> None:
        self.converged[configuration] = converged
        self.append({"configuration": asdict(configuration), "converged": asdict(converged)})

    def keep_cost(self, configuration: Configuration, cost: Cost | None) -> None:
        self.costs[configuration] = cost
        said = None if cost is None else asdict(cost)
        self.append({"configuration": asdict(configuration), "cost": said})

    def append(self, said: dict[str, Any]) -> None:
        """On the disk when it returns."""
        if self.journal is not None:
            self.journal.append(json.dumps(said, allow_nan=False).encode())

    def close(self) -> None:
        if self.journal is not None:
            self.journal.close()

    def __enter__(self) -> Store:
        return self

    def __exit__(self, *problem: object) -> None:
        self.close()


def is_number_or_whole(value: object) -> bool:
    return isinstance(value, float) or is_whole(value)

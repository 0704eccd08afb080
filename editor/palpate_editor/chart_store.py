# SPDX-License-Identifier: GPL-3.0-or-later
"""What a chart has finished: rows, what converged, costs (run_store)."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

from palpate.files.json_part import is_whole, json_kind, read_part
from palpate.files.refusal import Refusal
from palpate.study.chart_file import read_row
from palpate.study.scene_chart import LOST, Configuration, Cost, Errors, Row

from palpate_editor.chart_jobs import Converged
from palpate_editor.run_store import RunStore

FORMAT, VERSION = "palpate chart rows", 1


class Store(RunStore):
    """The finished runs of one chart; a file where there is a folder, else memory alone."""

    format, version = FORMAT, VERSION

    def __init__(self, key: str, folder: Path | None = None):
        """Takes up what stands in the folder. Raises Refusal or OSError."""
        self.converged: dict[Configuration, Converged] = {}
        self.rows: dict[Configuration, Row] = {}
        self.costs: dict[Configuration, Cost | None] = {}
        super().__init__(key, folder, "rows")

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

    def __enter__(self) -> Store:
        return self


def is_number_or_whole(value: object) -> bool:
    return isinstance(value, float) or is_whole(value)

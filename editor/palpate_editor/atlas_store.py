# SPDX-License-Identifier: GPL-3.0-or-later
"""What an atlas has finished: the rows of each tissue (run_store)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from palpate.files.json_part import json_kind
from palpate.files.refusal import Refusal
from palpate.study.atlas import LOST, Row, Spot
from palpate.study.atlas_file import read_row

from palpate_editor.run_store import RunStore

FORMAT, VERSION = "palpate atlas rows", 1


class Store(RunStore):
    """The finished rows of one atlas; a file where there is a folder, else memory alone."""

    format, version = FORMAT, VERSION

    def __init__(self, key: str, folder: Path | None = None):
        """Takes up what stands in the folder. Raises Refusal or OSError."""
        self.rows: dict[tuple[Spot, str], Row] = {}
        super().__init__(key, folder, "atlas")

    def take(self, where: str, said: Any) -> None:
        """One finished row; one that was lost is tried again."""
        if not isinstance(said, dict) or set(said) != {"row"}:
            raise Refusal(self.path, where, json_kind(said), "a row")
        self.remember(read_row(self.path, where, said["row"]))

    def remember(self, row: Row) -> None:
        if row.outcome != LOST:
            self.rows[row.spot, row.integrator] = row

    def keep(self, rows: Iterable[Row]) -> None:
        for row in rows:
            self.rows[row.spot, row.integrator] = row
            self.append({"row": asdict(row)})

    def __enter__(self) -> Store:
        return self

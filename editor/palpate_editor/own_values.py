# SPDX-License-Identifier: GPL-3.0-or-later
"""Published values that a designer has added to those that ship, kept beside the user's data."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from palpate.files.json_part import json_kind, read_part
from palpate.files.refusal import Refusal
from palpate.files.whole_file import write_whole
from palpate.system.data_folder import find_data_folder

from palpate_editor.document import Phrase, phrase
from palpate_editor.document.constants import Constant, find_constant

FORMAT, VERSION = "palpate published values", 1
QUANTITIES = ("young_modulus", "poisson_ratio", "density", "damping_ratio", "wall_thickness")
"""Constants of a material that a publication can have a value of."""
MOST_VALUES, MOST_LETTERS, MOST_BYTES = 1000, 300, 4_000_000


@dataclass(frozen=True)
class OwnValue:
    """What a publication says of a tissue, in SI."""

    tissue: str
    """Its name among those that ship, such as "liver"."""
    quantity: str
    """One of QUANTITIES."""
    low: float
    high: float
    method: str
    """How it was measured."""
    source: str
    """Who published it, and where."""


class BadValue(Refusal):
    """A value of a file that no publication can have."""

    def __init__(self, file: object, where: str, fault: Phrase, expected: str):
        super().__init__(file, where, str(fault), expected)
        self.fault = fault


def find_file() -> Path:
    """Where they are kept; need not exist."""
    return find_data_folder() / "published_values.json"


def find_fault(value: OwnValue) -> Phrase | None:
    """What is wrong with a value, or none."""
    constant = find_constant("material", value.quantity)
    if value.quantity not in QUANTITIES or constant is None:
        return phrase("There is no number {name}.", name=value.quantity)
    for number in (value.low, value.high):
        if not constant.allows(number):
            return phrase(
                "{label} must be {range}, got {got}.",
                label=constant.label,
                range=constant.describe_range(),
                got=constant.describe(number),
            )
    return find_order_fault(value, constant) or find_text_fault(value)


def find_order_fault(value: OwnValue, constant: Constant) -> Phrase | None:
    if value.low <= value.high:
        return None
    low, high = constant.describe(value.low), constant.describe(value.high)
    return phrase(
        "The range begins at {low} and ends at {high}: turn it round.", low=low, high=high
    )


def find_text_fault(value: OwnValue) -> Phrase | None:
    if not value.source.strip():
        return phrase("A published value needs its source.")
    for text in (value.tissue, value.method, value.source):
        if len(text) > MOST_LETTERS:
            most = MOST_LETTERS
            return phrase(
                "Got {count} letters, expected at most {most}.", count=len(text), most=most
            )
    return None


def read_own_values(path: Path) -> tuple[OwnValue, ...]:
    """None where there is no file. Raises Refusal or OSError."""
    try:
        with path.open("rb") as file:
            data = file.read(MOST_BYTES + 1)
    except FileNotFoundError:
        return ()
    if len(data) > MOST_BYTES:
        raise Refusal(path, "", "a file of more bytes", f"at most {MOST_BYTES}")
    try:
        content = json.loads(data)
    except (ValueError, RecursionError):
        raise Refusal(path, "", "text that is not JSON", "published values") from None
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise Refusal(path, "format", json_kind(content)[:40], FORMAT)
    if content.get("version") != VERSION:
        raise Refusal(path, "version", json_kind(content.get("version")), f"{VERSION}")
    rows = content.get("values")
    if not isinstance(rows, list) or len(rows) > MOST_VALUES:
        raise Refusal(path, "values", json_kind(rows), f"a list of at most {MOST_VALUES}")
    values = [
        read_part(path, f"values[{k}]", OwnValue, row, whole=True) for k, row in enumerate(rows)
    ]
    for k, value in enumerate(values):
        fault = find_fault(value)
        if fault is not None:
            raise BadValue(path, f"values[{k}]", fault, "a published value")
    return tuple(values)


def write_own_values(path: Path, values: Sequence[OwnValue]) -> None:
    """Whole or not at all. Raises ValueError or OSError."""
    if len(values) > MOST_VALUES:
        raise ValueError(f"values: got {len(values)}, expected at most {MOST_VALUES}")
    for value in values:
        fault = find_fault(value)
        if fault is not None:
            raise ValueError(str(fault))
    path.parent.mkdir(parents=True, exist_ok=True)
    content = {"format": FORMAT, "version": VERSION, "values": [asdict(v) for v in values]}
    write_whole(path, (json.dumps(content, indent=1, ensure_ascii=False) + "\n").encode())

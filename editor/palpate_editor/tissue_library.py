# SPDX-License-Identifier: GPL-3.0-or-later
"""The library of tissues: those of shipped organs, further ones, and a designer's own.

    tissues = read_library()                 # own ones from the user's folder among them
    found = search(tissues, "heart")         # by name, title and words, in English and Turkish
    applied = choose(found[0])               # raises Refusal where nothing checked is known

A value is checked (read in its source), recalled or unknown. Only checked ones are taken by
themselves; a recalled one has to be asked for, and a rule says so ever after.
"""

from __future__ import annotations

import math
import tomllib
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from palpate.files.json_part import json_kind, read_part
from palpate.files.refusal import Refusal
from palpate.system.data_folder import find_config_folder
from palpate_meshes.catalogue import LIBRARY, Tissue, read_tissues

from palpate_editor import appearance
from palpate_editor.document import AppliedTissue
from palpate_editor.document.constants import find_constant
from palpate_editor.document.tissue import STATUSES

QUANTITIES = ("young_modulus", "poisson_ratio", "density", "wall_thickness")
KINDS = ("solid", "hollow", "sheet", "rigid")
SETTINGS = ("in vivo", "ex vivo", "table", "assumed", "unknown")
MOST_BYTES, MOST_TISSUES, MOST_VALUES, MOST_LETTERS = 1_000_000, 500, 40, 300
OF_SHIPPED = {
    "liver": ("hepar", "karaciğer"),
    "spleen": ("lien", "dalak"),
    "kidney": ("ren", "cortex", "böbrek"),
    "gallbladder": ("vesica fellea", "safra kesesi"),
    "stomach": ("gaster", "mide"),
    "soft_patch": ("silicone", "pad", "yama"),
    "stone": ("calculus", "böbrek taşı"),
}
"""Words by which tissues of shipped organs are found; their `names` tell what looks like them."""
WIDE = 2.0
"""[-] A range that spans more has its geometric mean in the middle."""


@dataclass(frozen=True)
class Value:
    """What is known of one constant of a tissue."""

    quantity: str
    """One of QUANTITIES."""
    method: str
    """How it was measured."""
    setting: str
    """One of SETTINGS."""
    rate: str
    """How fast: a frequency, a strain rate, "shear waves", or "unknown"."""
    source: str
    status: str
    """One of STATUSES."""
    low: float | None = None
    """SI; None where the status is unknown."""
    high: float | None = None

    @property
    def middle(self) -> float | None:
        """SI, of the range."""
        if self.low is None or self.high is None:
            return None
        if self.low > 0.0 and self.high > WIDE * self.low:
            return math.sqrt(self.low * self.high)
        return 0.5 * (self.low + self.high)


@dataclass(frozen=True)
class LibraryTissue:
    """A tissue and all that is known of it."""

    name: str
    title: str
    kind: str
    """One of KINDS."""
    note: str
    words: tuple[str, ...]
    """By which it is found beside its title."""
    values: tuple[Value, ...]
    origin: str
    """Where it stands: "Palpate", or the designer's file."""
    shipped: Tissue | None = None
    """Of an organ that ships: its constants were chosen within what is published."""

    def values_of(self, quantity: str) -> list[Value]:
        return [value for value in self.values if value.quantity == quantity]

    @property
    def status(self) -> str:
        """The best of what is known of its stiffness."""
        known = {value.status for value in self.values_of("young_modulus")}
        return next((status for status in STATUSES if status in known), "unknown")


def find_own_file() -> Path:
    """Where a designer's own tissues are kept; need not exist."""
    return find_config_folder() / "tissues.toml"


def read_library(own: Path | bool | None = None) -> list[LibraryTissue]:
    """Every tissue, those that ship first.

    Args:
        own: A designer's file; None for the one in the user's folder, where there is one; False for
            none at all.

    Raises Refusal, or OSError where `own` cannot be read.
    """
    found = [from_shipped(tissue) for tissue in read_tissues().values()]
    found += read_tissue_file(LIBRARY, "Palpate")
    if own is False:
        return found
    path = own if isinstance(own, Path) else find_own_file()
    if isinstance(own, Path) or path.exists():
        mine = read_tissue_file(path, path.name)
        known = {tissue.name for tissue in found}
        for tissue in mine:
            if tissue.name in known:
                raise Refusal(path, tissue.name, "a name that ships", "one of your own")
        found += mine
    return found


def from_shipped(tissue: Tissue) -> LibraryTissue:
    values = tuple(
        Value(
            quantity=row.quantity,
            method=row.method,
            setting=next((s for s in SETTINGS[:2] if s in row.method), "unknown"),
            rate="shear waves" if "shear wave" in row.method else "unknown",
            source=row.source,
            status="recalled" if row.uncertain else "checked",
            low=row.low,
            high=row.high,
        )
        for row in tissue.published
    )
    return LibraryTissue(
        tissue.name,
        tissue.title,
        tissue.kind,
        tissue.note,
        OF_SHIPPED.get(tissue.name, ()),
        values,
        "Palpate",
        tissue,
    )


def read_tissue_file(path: Path, origin: str) -> list[LibraryTissue]:
    """Raises Refusal or OSError."""
    with path.open("rb") as file:
        data = file.read(MOST_BYTES + 1)
    if len(data) > MOST_BYTES:
        raise Refusal(path, "", "a file of more bytes", f"at most {MOST_BYTES}")
    try:
        tables = tomllib.loads(data.decode("utf-8"))
    except (ValueError, RecursionError) as problem:
        raise Refusal(path, "", f"text that is no TOML ({problem})", "a library") from None
    if len(tables) > MOST_TISSUES:
        raise Refusal(path, "", f"{len(tables)} tissues", f"at most {MOST_TISSUES}")
    return [read_tissue(path, name, table, origin) for name, table in tables.items()]


def read_tissue(path: Path, name: str, table: Any, origin: str) -> LibraryTissue:
    if not isinstance(table, dict):
        raise Refusal(path, name, "no table", "a table of a tissue")
    known = {"title", "kind", "note", "words", "published"}
    if odd := sorted(set(table) - known):
        raise Refusal(path, f"{name}.{odd[0]}", "an unknown field", ", ".join(sorted(known)))
    for field in ("title", "kind", "published"):
        if field not in table:
            raise Refusal(path, f"{name}.{field}", "nothing", "a field of this name")
    texts = [table["title"], table["kind"], table.get("note", ""), *list_words(path, name, table)]
    for text in texts:
        if not isinstance(text, str) or len(text) > MOST_LETTERS:
            raise Refusal(path, name, json_kind(str(text)), f"text of at most {MOST_LETTERS}")
    if table["kind"] not in KINDS:
        raise Refusal(path, f"{name}.kind", json_kind(table["kind"]), f"one of {', '.join(KINDS)}")
    rows = table["published"]
    if not isinstance(rows, list) or len(rows) > MOST_VALUES:
        raise Refusal(path, f"{name}.published", "no list", f"a list of at most {MOST_VALUES}")
    values = tuple(read_value(path, f"{name}.published[{k}]", row) for k, row in enumerate(rows))
    return LibraryTissue(name, texts[0], texts[1], texts[2], tuple(texts[3:]), values, origin)


def list_words(path: Path, name: str, table: dict[str, Any]) -> list[Any]:
    words = table.get("words", [])
    if not isinstance(words, list) or len(words) > MOST_VALUES:
        raise Refusal(path, f"{name}.words", "no list", f"a list of at most {MOST_VALUES} texts")
    return words


def read_value(path: Path, where: str, row: Any) -> Value:
    """Raises Refusal for what no publication can have."""
    value: Value = read_part(path, where, Value, row)
    for field, allowed in (("quantity", QUANTITIES), ("setting", SETTINGS), ("status", STATUSES)):
        if getattr(value, field) not in allowed:
            got, expected = json_kind(getattr(value, field)), f"one of {', '.join(allowed)}"
            raise Refusal(path, f"{where}.{field}", got, expected)
    for field in fields(Value):
        text = getattr(value, field.name)
        if isinstance(text, str) and len(text) > MOST_LETTERS:
            got = f"{len(text)} letters"
            raise Refusal(path, f"{where}.{field.name}", got, f"at most {MOST_LETTERS}")
    if not value.source.strip():
        raise Refusal(path, f"{where}.source", "nothing", "who published it, and where")
    check_numbers(path, where, value)
    return value


def check_numbers(path: Path, where: str, value: Value) -> None:
    if value.status == "unknown":
        if (value.low, value.high) != (None, None):
            raise Refusal(path, where, "a number that is unknown", "neither low nor high")
        return
    constant = find_constant("material", value.quantity)
    assert constant is not None
    for end in ("low", "high"):
        number = getattr(value, end)
        if number is None or not constant.allows(number):
            expected = f"{constant.describe_range()}, in SI here"
            raise Refusal(path, f"{where}.{end}", json_kind(number), expected)
    assert value.low is not None and value.high is not None
    if value.low > value.high:
        raise Refusal(path, where, f"{value.low:g} to {value.high:g}", "the lower end first")


# ---------------------------------------------------------------- finding and choosing


def fold(text: str) -> str:
    """Without case and marks, so that "bobrek" finds "böbrek" and "KIDNEY" "kidney"."""
    folded = unicodedata.normalize("NFKD", text.replace("İ", "i").replace("ı", "i").casefold())
    return "".join(c for c in folded if not unicodedata.combining(c)).replace("_", " ")


def search(
    tissues: Sequence[LibraryTissue], text: str, titles: dict[str, str] | None = None
) -> list[LibraryTissue]:
    """Those that have every word of `text` in what they are called, or in their note.

    Args:
        tissues: Where to look.
        text: Words; none finds all.
        titles: By name, what a window calls them.
    """
    wanted = fold(text).split()
    return [
        tissue
        for tissue in tissues
        if all(word in describe_words(tissue, titles or {}) for word in wanted)
    ]


def find_named(tissues: Sequence[LibraryTissue], name: str) -> LibraryTissue | None:
    """The tissue of which an organ's name has a whole word, or several; None where it has none."""
    within = appearance.fold(name) + " "
    words = (
        (appearance.fold(word), tissue)
        for tissue in tissues
        for word in (tissue.name, tissue.title, *tissue.words)
    )
    return appearance.find_longest_word(words, lambda word: f"{word} " in within)


def describe_words(tissue: LibraryTissue, titles: dict[str, str]) -> str:
    also = titles.get(tissue.name, "")
    return fold(" ".join((tissue.name, tissue.title, also, tissue.note, *tissue.words)))


def find_tissue(tissues: Sequence[LibraryTissue], name: str) -> LibraryTissue:
    """By name. Raises Refusal."""
    for tissue in tissues:
        if tissue.name == name:
            return tissue
    near = [tissue.name for tissue in search(tissues, name)] or [t.name for t in tissues]
    raise Refusal(None, "--tissue", name, f"one of {', '.join(near)}")


def choose(
    tissue: LibraryTissue,
    region: str = "",
    *,
    recalled: bool = False,
    young_modulus: float | None = None,
) -> AppliedTissue:
    """The constants that are taken of a tissue. Raises Refusal where its stiffness is not known.

    Args:
        tissue: Of the library.
        region: Of the organ; empty for all of it.
        recalled: Take recalled values where none is checked.
        young_modulus: [Pa] A designer's own, in the place of the tissue's.
    """
    statuses = STATUSES[:2] if recalled else STATUSES[:1]
    taken = {name: find_value(tissue, name, statuses) for name in QUANTITIES}
    modulus = taken["young_modulus"]
    own = young_modulus is not None
    if modulus is None and not own:
        raise Refusal(None, "--tissue", *explain(tissue))
    numbers = {name: None if found is None else found[0] for name, found in taken.items()}
    if tissue.shipped is not None:  # all that was chosen within what is published
        numbers |= {name: tissue.shipped.material.get(name) for name in QUANTITIES}
    if own:
        numbers["young_modulus"] = young_modulus
    if region or tissue.kind == "solid":
        numbers["wall_thickness"] = None
    if region:
        numbers |= {"poisson_ratio": None, "density": None}
    assert numbers["young_modulus"] is not None
    status, source = ("unknown", "") if own or modulus is None else (modulus[1], modulus[2])
    return AppliedTissue(tissue.name, tissue.title, region, status=status, source=source, **numbers)


def find_value(
    tissue: LibraryTissue, quantity: str, statuses: Sequence[str]
) -> tuple[float, str, str] | None:
    """Number [SI], status and source of the first value of the best status."""
    for status in statuses:
        for value in tissue.values_of(quantity):
            if value.status == status and value.middle is not None:
                return value.middle, status, value.source
    return None


def explain(tissue: LibraryTissue) -> tuple[str, str]:
    """Got and expected of a tissue that cannot be taken as it is."""
    known = [value for value in tissue.values_of("young_modulus") if value.middle is not None]
    if not known:
        return f"{tissue.name}, whose Young's modulus is unknown", "--young-modulus with it"
    return (
        f"{tissue.name}, whose Young's modulus is only recalled ({known[0].source})",
        "--recalled to take it all the same, or --young-modulus with it",
    )


def list_sources(tissue: LibraryTissue) -> Iterator[str]:
    """Each source once, in order."""
    yield from dict.fromkeys(value.source for value in tissue.values)

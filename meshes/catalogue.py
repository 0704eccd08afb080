# SPDX-License-Identifier: BSD-3-Clause
"""What ships: CATALOGUE.toml and tissues.toml as plain values, and the files they speak of."""

from __future__ import annotations

import copy
import functools
import hashlib
import json
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from palpate.scene.mesh_file import read_mesh_file
from palpate.scene.scene_parts import AppearancePart

HERE = Path(__file__).parent
PUBLISHED = HERE / "published"
"""One OBJ in metres per organ, its regions beside it; tools in a folder of their own."""
PICTURES = HERE / "pictures"
"""Small ones of every organ, NAME_light.png and NAME_dark.png."""
CATALOGUE, TISSUES = HERE / "CATALOGUE.toml", HERE / "tissues.toml"
LIBRARY = HERE / "tissue_library.toml"
"""Further tissues, which no organ that ships is made of; palpate_editor.tissue_library reads it."""


@dataclass(frozen=True)
class Published:
    """A constant of a tissue as the literature has it."""

    quantity: str
    """young_modulus, density, ..."""
    unit: str
    low: float
    high: float
    method: str
    source: str
    uncertain: bool
    """Quoted by another source or from memory, and not looked up in the original."""


@dataclass(frozen=True)
class Tissue:
    """What an organ is made of."""

    name: str
    title: str
    kind: str
    """solid, hollow, sheet or rigid."""
    note: str
    names: tuple[str, ...]
    """Words, or beginnings of words, of what looks like it; see palpate_editor.appearance."""
    material: dict[str, float]
    """Fields of a scene's material, SI."""
    model: dict[str, Any]
    """Fields of a scene's model, SI."""
    published: tuple[Published, ...]
    appearance: AppearancePart


@dataclass(frozen=True)
class Entry:
    """An organ of the catalogue."""

    name: str
    title: str
    generator: str
    parameters: dict[str, float]
    tissue: str
    vertices: int
    triangles: int
    border: tuple[int, ...]
    """Vertices of every border loop."""
    sha256: str
    """Of the OBJ."""
    view: tuple[float, float]
    """[degree] Azimuth and elevation from which it is known at a glance."""
    tip_radius: float
    """[m] Of the tool it is touched with: half an edge of its triangles or more."""
    task: str
    """What a trainee is asked to do with it."""
    languages: dict[str, dict[str, str]]
    """Title and task in further languages, by code."""
    size_mm: tuple[tuple[float, float], ...]
    """[mm] Least and most of the box along x, y and z."""
    size_source: str
    tetrahedra: int | None = None
    """That a solid is to be filled with: about three quarters are made. None for what is none."""
    wall_vertices: int | None = None
    """To which the mesh is decimated for a wall of prisms; None where none is, or as it is."""
    volume_ml: tuple[float, float] | None = None
    volume_source: str = ""

    @property
    def mesh(self) -> Path:
        return PUBLISHED / f"{self.name}.obj"

    @property
    def regions(self) -> Path:
        return PUBLISHED / f"{self.name}.regions.json"


@dataclass(frozen=True)
class ToolMesh:
    """A part of an instrument in the catalogue."""

    vertices: int
    triangles: int
    sha256: str
    """Of the OBJ."""


def read_tables(path: Path) -> dict[str, Any]:
    """The tables of a file, parsed again only once it was changed."""
    return copy.deepcopy(parse(path, path.stat().st_mtime_ns))


@functools.lru_cache(maxsize=8)
def parse(path: Path, changed: int) -> dict[str, Any]:
    del changed
    return tomllib.loads(path.read_text(encoding="utf-8"))


def read_tool_catalogue() -> dict[str, dict[str, ToolMesh]]:
    """The parts of every instrument, in the order of the file; read_tool says what they are."""
    tables = read_tables(CATALOGUE)["tools"]
    return {
        name: {part: ToolMesh(**row) for part, row in table["parts"].items()}
        for name, table in tables.items()
    }


def read_catalogue() -> dict[str, Entry]:
    """Every organ, in the order of the file."""
    tables = read_tables(CATALOGUE)["organs"]
    return {name: Entry(name, **freeze(table)) for name, table in tables.items()}


def read_tissues() -> dict[str, Tissue]:
    """Every tissue, in the order of the file."""
    tables = read_tables(TISSUES)
    return {
        name: Tissue(
            name=name,
            title=table["title"],
            kind=table["kind"],
            note=table["note"],
            names=tuple(table["names"]),
            material=table["material"],
            model=table["model"],
            published=tuple(Published(**row) for row in table["published"]),
            appearance=AppearancePart(**freeze(table["appearance"])),
        )
        for name, table in tables.items()
    }


def read_terms() -> dict[str, str]:
    """Author, licence, unit and axes, which all meshes share."""
    tables = read_tables(CATALOGUE)
    return {key: value for key, value in tables.items() if isinstance(value, str)}


def freeze(value: Any) -> Any:
    """Lists, and the lists in them, as tuples."""
    if isinstance(value, dict):
        return {key: freeze(item) for key, item in value.items()}
    return tuple(map(freeze, value)) if isinstance(value, list) else value


def find_entry(name: str) -> Entry:
    """Raises ValueError for a name that is not in the catalogue."""
    entries = read_catalogue()
    if name not in entries:
        raise ValueError(f"organ: got {name!r}, expected one of {', '.join(entries)}")
    return entries[name]


def read_organ_mesh(name: str) -> tuple[np.ndarray, np.ndarray]:
    """Vertices [m] and triangles of a shipped organ. Raises ValueError or OSError."""
    mesh = read_mesh_file(find_entry(name).mesh)
    return np.asarray(mesh.vertices), np.asarray(mesh.triangles)


def read_regions(name: str) -> dict[str, np.ndarray]:
    """Named vertex sets of a shipped organ, each ascending. Raises ValueError or OSError."""
    found = json.loads(find_entry(name).regions.read_text(encoding="utf-8"))
    return {region: np.array(ids, np.int32) for region, ids in found["regions"].items()}


def hash_bytes(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()

# SPDX-License-Identifier: BSD-3-Clause
"""Makes meshes/published: `python -m palpate_meshes.build [NAME ...]`, or `./run meshes`."""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path

import numpy as np
from palpate.files.whole_file import write_whole
from palpate.render.instrument_meshes import DRAWN
from palpate_meshes.anatomy import ATTACHMENT, GENERATORS, find_regions, generate
from palpate_meshes.build_scenes import SCENES, write_scene
from palpate_meshes.catalogue import (
    CATALOGUE,
    PUBLISHED,
    Entry,
    hash_bytes,
    read_catalogue,
    read_tissues,
)
from palpate_meshes.gate import find_faults
from palpate_meshes.generate import write_obj
from palpate_meshes.tools import FOLDER, build_tools, ship_descriptions


def main(words: list[str] | None = None) -> int:
    """Builds what is named, or everything; exits 1 where the gate refuses a mesh."""
    parser = argparse.ArgumentParser(prog="palpate_meshes.build", description=__doc__)
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help="organs and scenes; default: organs and tools"
    )
    parser.add_argument("--vertices", type=int, help="another resolution, which is not published")
    parser.add_argument("--out", type=Path, help="OBJ of another resolution")
    call = parser.parse_args(words)
    unknown = [name for name in call.names if name not in (*GENERATORS, *SCENES)]
    if unknown:
        known = ", ".join((*GENERATORS, *SCENES))
        parser.error(f"unknown: {', '.join(unknown)}; there are {known}")
    if (call.vertices is None) != (call.out is None) or (call.out and len(call.names) != 1):
        parser.error("--vertices and --out go together, with one NAME")
    if call.out:
        return write_other(call.names[0], call.vertices, call.out)
    for name in (name for name in call.names if name in SCENES):
        print(f"wrote {write_scene(name)}")
    organs = [name for name in call.names if name in GENERATORS]
    return publish(organs) if organs or not call.names else 0


def write_other(name: str, vertices: int, out: Path) -> int:
    """One organ at another resolution."""
    try:
        points, triangles = generate(name, vertices=vertices)
    except ValueError as refusal:
        print(f"{name}: {refusal}", file=sys.stderr)
        return 1
    write_obj(out, points, triangles)
    print(f"wrote {out}: {len(points)} vertices, {len(triangles)} triangles")
    return 0


def publish(names: list[str]) -> int:
    """Organs by name and, where none is named, the tools as well."""
    PUBLISHED.mkdir(exist_ok=True)
    tissues, faults = read_tissues(), []
    for entry in read_catalogue().values():
        if names and entry.name not in names:
            continue
        began = time.process_time()
        mesh = generate(entry.generator, **entry.parameters)
        regions = find_regions(entry.generator, *mesh, size=entry.parameters["size"])
        found = find_faults(entry, tissues[entry.tissue], *mesh, regions)
        faults += found
        if not found:
            write_organ(entry, mesh, regions)
            cost = time.process_time() - began
            counts = f"{entry.vertices} vertices, {entry.triangles} triangles"
            print(f"{entry.name}: {counts}, {cost:.0f} s")
    if not names:
        FOLDER.mkdir(exist_ok=True)
        ship_descriptions()
        for tool, parts in build_tools().items():
            write_tool(tool, parts)
            print(f"{tool}: {', '.join(parts)}")
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


def write_organ(
    entry: Entry, mesh: tuple[np.ndarray, np.ndarray], regions: dict[str, np.ndarray]
) -> None:
    """The OBJ, its regions, and its hash in the catalogue."""
    write_obj(entry.mesh, *mesh)
    digest = hash_bytes(entry.mesh.read_bytes())
    said = {
        "mesh": entry.mesh.name,
        "sha256": digest,
        "attachment": ATTACHMENT,
        "regions": {name: ids.tolist() for name, ids in regions.items()},
    }
    write_whole(entry.regions, (json.dumps(said, separators=(",", ":")) + "\n").encode())
    write_hash(entry.name, digest)


def write_hash(name: str, digest: str) -> None:
    """Puts a hash into the organ's table, and leaves the rest of the file as people wrote it."""
    before, head, rest = CATALOGUE.read_text(encoding="utf-8").partition(f"[organs.{name}]\n")
    lines = rest.split("\n")
    row = next(i for i, line in enumerate(lines) if line.startswith("sha256 = "))
    lines[row] = f'sha256 = "{digest}"'
    write_whole(CATALOGUE, (before + head + "\n".join(lines)).encode())


def write_tool(name: str, parts: dict[str, tuple[np.ndarray, np.ndarray]]) -> None:
    """The OBJ of every part, their counts and hashes in the catalogue."""
    rows = []
    for part, (vertices, triangles) in parts.items():
        path = FOLDER / f"{name}_{part}.obj"
        write_obj(path, vertices, triangles)
        # the player draws it, and has no other file of this folder
        write_whole(DRAWN / path.name, path.read_bytes())
        counts = f"vertices = {len(vertices)}, triangles = {len(triangles)}"
        rows.append(f'{part} = {{ {counts}, sha256 = "{hash_bytes(path.read_bytes())}" }}')
    lines = CATALOGUE.read_text(encoding="utf-8").split("\n")
    first = lines.index(f"[tools.{name}.parts]") + 1
    lines[first : lines.index("", first)] = rows
    write_whole(CATALOGUE, "\n".join(lines).encode())


if __name__ == "__main__":
    sys.exit(main())

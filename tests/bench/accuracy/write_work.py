# SPDX-License-Identifier: BSD-3-Clause
"""Writes the common work at equal accuracy for every engine: `write_work.py FOLDER [WORK ...]`.

For each work a JSON of ball, place and truth, and an archive for every mesh that ladder.py tries an
engine on.
"""

from __future__ import annotations

import json
import sys
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from ladder import LADDER
from organ_meshes import Body
from palpate.files.whole_file import write_whole
from palpate.study.contact_reference import FOLDER as SHIPPED
from palpate.study.contact_reference import ContactReference, read_contact_file
from work import Work, name_mesh

HERE = Path(__file__).parent


@dataclass(frozen=True)
class Choice:
    """What of a contact reference is pressed here."""

    title: str
    reference: Path
    young_modulus: float
    """[Pa] Forces are in proportion to it."""
    density: float
    """[kg/m³]"""
    place: str
    radius: float
    """[m] of the ball."""
    depths: tuple[int, ...]
    """Which of the reference's."""


CHOICES = {
    "spleen": Choice(
        "spleen of 5 kPa, outside", SHIPPED / "spleen.json", 5e3, 1055.0, "outside", 8e-3, (0, 1)
    ),
    "spleen_top": Choice(
        "spleen of 5 kPa, top", SHIPPED / "spleen.json", 5e3, 1055.0, "top", 8e-3, (0, 1)
    ),
    "wall": Choice(
        "gallbladder's wall of 2 mm", HERE / "wall_2mm.json", 250e3, 1060.0, "outside", 5e-3, (0, 1)
    ),
}


def make_work(name: str) -> tuple[Work, ContactReference]:
    choice = CHOICES[name]
    reference = read_contact_file(choice.reference)
    spot = reference.find_place(choice.place)
    [case] = [
        case
        for case in reference.list_cases("linear")
        if case.place == choice.place and np.isclose(case.radius, choice.radius)
    ]
    scale = choice.young_modulus / reference.young_modulus
    results = [case.results[k] for k in choice.depths]
    work = Work(
        name=name,
        title=choice.title,
        shipped=Path(reference.shape.file).stem,
        young_modulus=choice.young_modulus,
        poisson_ratio=reference.poisson_ratio,
        density=choice.density,
        wall_thickness=reference.wall_thickness,
        radius=choice.radius,
        point=tuple(spot.point),
        direction=tuple(spot.direction),
        depths=tuple(result.depth for result in results),
        forces=tuple(scale * result.force for result in results),
    )
    return work, reference


def write(folder: Path, name: str) -> None:
    """The work, and the mesh of every recipe that an engine is tried on."""
    work, reference = make_work(name)
    write_whole(folder / f"{name}.json", json.dumps(asdict(work), indent=1).encode())
    body = Body(work, np.array(reference.fixed))
    for recipe in list_recipes(name):
        mesh = body.make_mesh(recipe)
        np.savez(
            name_mesh(folder, work, recipe),
            x=mesh.x,
            cells=mesh.cells,
            held=mesh.held,
            touch=[mesh.touch_faces, mesh.touch_vertices],
        )


def list_recipes(name: str) -> list[str]:
    others = (entry for entry in LADDER if not entry.ours)
    words = (attempt.words for entry in others for attempt in entry.tries[name])
    return list(dict.fromkeys(recipe for recipe, *_ in words))


if __name__ == "__main__":
    for name in sys.argv[2:] or CHOICES:
        write(Path(sys.argv[1]), name)

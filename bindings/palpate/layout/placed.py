# SPDX-License-Identifier: BSD-3-Clause
"""Published organs where a layout has them: their bodies, turned and moved, and their regions."""

from __future__ import annotations

import copy
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import palpate
from palpate import scenario
from palpate.assessment.publish import find_regions
from palpate.files.refusal import Refusal
from palpate.layout.document import Layout, Placed, PlacedBody
from palpate.runs.run import is_published
from palpate.scene.scene_file import hash_file

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
KEPT = 8
"""Organs that are read once, as checking, snapping and drawing a layout ask for each."""


@dataclass(frozen=True)
class Organ:
    """A published file with one body."""

    path: Path
    published: scenario.Scenario

    @property
    def body(self) -> palpate.SoftBody:
        return self.published.scene.bodies[0]


def read_organ(path: Path) -> Organ:
    """Raises FileError, or Refusal for a file that is not of one body."""
    if not is_published(path):
        raise Refusal(path, "", f"a name ending in {path.suffix!r}", "a published organ, .palpate")
    published = scenario.read(path)
    if len(published.scene.bodies) != 1:
        count = f"{len(published.scene.bodies)} bodies"
        raise Refusal(path, "scene.bodies", count, "one, an organ that is placed")
    return Organ(path, published)


def read_organs(path: Path, layout: Layout) -> list[Organ]:
    """Of all bodies of the layout at `path`. Raises Refusal for a file that has changed."""
    return [read_placed(path, body) for body in layout.bodies]


@lru_cache(maxsize=KEPT)
def read_known(path: Path, sha256: str) -> Organ:
    """As read_organ, of a file with that hash: read once, and never changed by who asks for it."""
    del sha256
    return read_organ(path)


def read_placed(path: Path, body: PlacedBody) -> Organ:
    file = path.parent / body.file
    if not file.is_file():
        return read_organ(file)  # says what is there
    found = hash_file(file)
    organ = read_known(file, found)
    if found != body.sha256:
        raise Refusal(
            file, "", "another file than was added to the layout",
            f"that one; `palpate scene place {path.name} {body.name} --renew` takes this one",
        )  # fmt: skip
    return organ


def move_points(body: Placed, points: Floats) -> Floats:
    """[m] (n, 3) of an organ or a mesh, where it stands."""
    return np.asarray(
        Rotation.from_rotvec(body.rotation).apply(points) + np.asarray(body.position), dtype=float
    )


def build_body(organ: Organ, placed: PlacedBody, touches: bool) -> palpate.SoftBody:
    """The organ's body as it stands; build_scene chooses its substeps again.

    One that `touches` others never sleeps: how wrong sleep makes a force is known of balls only.
    """
    was = organ.body
    tissue = copy.copy(was.tissue)
    rest = np.asarray(tissue.rest_position)
    rest[:] = move_points(placed, rest)
    return palpate.SoftBody(
        tissue=tissue,
        force_error=0.0 if touches else was.force_error,
        integrator=was.integrator,
        contact_modulus=was.contact_modulus,
        iterations=was.iterations,
        far_compliance=turn_tensors(np.asarray(was.far_compliance), placed),
        contact_facets=was.contact_facets,
        tied_holds=was.tied_holds,
        tear_stretch=was.tear_stretch,
        may_fold=placed.may_fold,
        weightless=placed.weightless,
    )


def turn_tensors(tensors: Floats, placed: PlacedBody) -> Floats:
    """Symmetric ones (n, 6), as xx, yy, zz, xy, yz, zx, turned with their body."""
    if not len(tensors) or not np.any(placed.rotation):
        return tensors
    turn = Rotation.from_rotvec(placed.rotation).as_matrix()
    rows = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]
    full = np.einsum("ij,njk,lk->nil", turn, tensors[:, rows], turn)
    return np.stack([full[:, i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))], 1)


def build_instruments(organ: Organ, placed: PlacedBody) -> list[palpate.Instrument]:
    """The organ's, with their trocars where they are over it."""
    made = [copy.copy(each) for each in organ.published.scene.instruments]
    for instrument in made:
        if instrument.trocar is not None:
            instrument.trocar = move_points(placed, np.asarray(instrument.trocar)[None])[0]
    return made


def find_surface(body: palpate.SoftBody) -> tuple[Floats, Ints]:
    """Vertices at rest [m] (n, 3) and triangles (t, 3)."""
    tissue = body.tissue
    x = np.array(palpate.compute_surface(tissue, tissue.rest_position))
    return x, np.array(tissue.triangles, dtype=np.int32)


def find_region(organ: Organ, name: str) -> Ints:
    """The vertices of the surface of a region. Raises Refusal."""
    regions = find_regions(organ.path, organ.published)
    if name not in regions:
        known = ", ".join(regions) or "none"
        raise Refusal(organ.path, "regions", repr(name), f"one of {known}")
    return regions[name]

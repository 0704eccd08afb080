# SPDX-License-Identifier: GPL-3.0-or-later
"""From foreign mesh files to clean surfaces (assimp, OpenMesh, CGAL behind plain types)."""

from collections.abc import Sequence
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray
from palpate import SolidMesh, SurfaceMesh

Path = str | PathLike[str]

class ImportedPart:
    """One named part of a scene, its node's transforms applied, in the file's units and axes."""

    @property
    def name(self) -> str: ...
    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def groups(self) -> list[str]:
        """Names of the groups it stands under, outermost first."""
    @property
    def colour(self) -> list[float] | None:
        """sRGB, 0 to 1, of its material or the mean of its vertices'."""
    @property
    def paint(self) -> NDArray[np.float32]:
        """(3 t, 5) of each corner u, v, 0 to 1 from the picture's lower left, and r, g, b, sRGB,
        which multiply the picture's; no rows where all are alike."""
    @property
    def pictures(self) -> NDArray[np.int32]:
        """(t,) The picture of each triangle, beside `paint`; -1 for none."""

class Picture:
    """What surfaces are painted with, as its file has it."""

    @property
    def name(self) -> str: ...
    @property
    def bytes(self) -> bytes: ...

class PartPlace:
    """How a part lies to the others of its file."""

    @property
    def inside(self) -> int:
        """The smallest part it lies inside of; -1 for none."""
    @property
    def crosses(self) -> list[int]:
        """Parts whose triangles cross its own, ascending."""
    @property
    def closed(self) -> bool: ...
    @property
    def crossing_faces(self) -> int:
        """Of its own triangles that cross each other; -1 where they are not counted."""

class ImportedScene:
    """What a mesh file holds, before its unit and axes are chosen."""

    @property
    def file(self) -> str: ...
    @property
    def format(self) -> str: ...
    @property
    def parts(self) -> list[ImportedPart]: ...
    @property
    def unit(self) -> str | None:
        """The unit the file or its format states."""
    @property
    def up(self) -> str | None:
        """The up axis the file or its format states: x, y, z, -x, -y or -z."""
    @property
    def notes(self) -> list[str]:
        """What was odd about the file but could be read all the same."""
    @property
    def pictures(self) -> list[Picture]: ...
    @property
    def filling(self) -> SolidMesh:
        """Tetrahedra whose outer faces the parts are; empty where the file has none."""

class JoinedSurface:
    """Chosen parts welded into one surface in metres, right-handed, z up."""

    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def parts(self) -> list[str]: ...
    @property
    def unit(self) -> str: ...
    @property
    def unit_guessed(self) -> bool: ...
    @property
    def unit_reason(self) -> str: ...
    @property
    def up(self) -> str: ...
    @property
    def up_guessed(self) -> bool: ...
    @property
    def up_reason(self) -> str: ...
    @property
    def welded_vertices(self) -> int: ...
    @property
    def subtracted(self) -> list[str]:
        """The names of the parts that were taken away."""
    @property
    def welded_across(self) -> int:
        """Vertices that became one with another by the stated tolerance."""
    @property
    def largest_move(self) -> float:
        """[m] of a vertex by the stated tolerance."""
    @property
    def notes(self) -> list[str]:
        """What parts had to be changed in to be united."""

class Histogram:
    """How many values lie between one limit and the next; the last limit belongs to the last
    count."""

    @property
    def limits(self) -> list[float]: ...
    @property
    def counts(self) -> list[int]: ...

class MeshReport:
    """What a surface is like; None where a number is not defined."""

    @property
    def vertices(self) -> int: ...
    @property
    def triangles(self) -> int: ...
    @property
    def shells(self) -> int: ...
    @property
    def border_loops(self) -> list[int]: ...
    @property
    def euler_number(self) -> int: ...
    @property
    def border_lengths_mm(self) -> list[float]:
        """Of those loops, in their order."""
    @property
    def genus(self) -> int | None: ...
    @property
    def closed(self) -> bool: ...
    @property
    def outward(self) -> bool | None: ...
    @property
    def non_manifold_edges(self) -> int: ...
    @property
    def pinched_vertices(self) -> list[int]:
        """Where surfaces touch in a point alone, ascending."""
    @property
    def disagreeing_edges(self) -> int:
        """Edges whose two triangles run along them the same way."""
    @property
    def coincident_vertices(self) -> int:
        """Vertices in the very place of one before."""
    @property
    def duplicate_faces(self) -> list[int]:
        """Triangles of the same three vertices as one before, ascending."""
    @property
    def degenerate_faces(self) -> list[int]:
        """Triangles of no height, ascending."""
    @property
    def self_intersecting_faces(self) -> int | None: ...
    @property
    def crossing_faces(self) -> list[int]:
        """Those triangles, ascending; empty where they are not counted."""
    @property
    def orientable(self) -> bool:
        """Whether neighbours can agree on a side; not of a Moebius band."""
    @property
    def smallest_angle_deg(self) -> float | None: ...
    @property
    def angles_deg(self) -> Histogram:
        """Every corner of every triangle, in steps of ten degrees."""
    @property
    def edges_mm(self) -> list[float] | None:
        """Shortest, median and longest."""
    @property
    def edge_lengths_mm(self) -> Histogram:
        """In steps of equal ratio."""
    @property
    def thinnest_mm(self) -> float | None:
        """Of the body behind a triangle; None where no look behind one meets another."""
    @property
    def thickness_looks(self) -> int:
        """Triangles behind which the body ends somewhere; at most 4000 are looked behind."""
    @property
    def thin_faces(self) -> list[int]:
        """Of those, the triangles behind which the body is thinner than half their edges."""
    @property
    def size_mm(self) -> list[float]: ...
    @property
    def volume_ml(self) -> float | None: ...
    def as_dict(self) -> dict[str, Any]:
        """The fields by name, ready for JSON."""

class RepairedMesh:
    """A surface without faults a triangle list can have, and what was done for that."""

    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def duplicate_triangles(self) -> int: ...
    @property
    def degenerate_triangles(self) -> int: ...
    @property
    def unused_vertices(self) -> int: ...
    @property
    def split_vertices(self) -> int: ...
    @property
    def parted_edges(self) -> int: ...
    @property
    def dropped_islands(self) -> int: ...
    @property
    def turned_triangles(self) -> int: ...

class CombinedParts:
    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def notes(self) -> list[str]: ...

class DecimatedMesh:
    """A coarser surface, and how far it is from the one it was made of."""

    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def smallest_angle_before_deg(self) -> float:
        """Right after the edges were collapsed, before the triangles were improved."""
    @property
    def smallest_angle_deg(self) -> float: ...
    @property
    def mean_distance(self) -> float:
        """[m] from the new surface to the source."""
    @property
    def max_distance(self) -> float:
        """[m]"""
    @property
    def self_intersecting_faces(self) -> int | None: ...
    @property
    def kept_length(self) -> float:
        """[m] Of ridges and borders of regions that are kept as lines."""
    @property
    def left_out_length(self) -> float:
        """[m] Of those that so few vertices have no room for."""

class ImportedMesh:
    """An organ's surface as it can be shown, and how it came to be."""

    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def joined(self) -> JoinedSurface: ...
    @property
    def repaired(self) -> RepairedMesh: ...
    @property
    def report(self) -> MeshReport:
        """Of the repaired mesh."""

def read_mesh(
    path: Path,
    *,
    time_limit: float = ...,
    memory_limit: int = ...,
    reader: Path,
    words: Sequence[str] = ...,
) -> ImportedScene: ...
def join_parts(
    scene: ImportedScene,
    *,
    parts: Sequence[str] = ...,
    unit: str | None = None,
    up: str | None = None,
    weld: float | None = None,
    unite: bool = False,
    subtract: Sequence[str] = ...,
) -> JoinedSurface: ...
def find_places(scene: ImportedScene) -> list[PartPlace]: ...
def unite_shells(mesh: SurfaceMesh) -> CombinedParts: ...
def inspect_mesh(mesh: SurfaceMesh) -> MeshReport: ...
def measure_exposure(mesh: SurfaceMesh) -> list[float]:
    """[-] Of each shell."""

def repair_mesh(mesh: SurfaceMesh) -> RepairedMesh: ...
def import_scene(
    scene: ImportedScene,
    *,
    parts: Sequence[str] = ...,
    unit: str | None = None,
    up: str | None = None,
    weld: float | None = None,
    unite: bool = False,
    subtract: Sequence[str] = ...,
) -> ImportedMesh: ...
def decimate(
    mesh: SurfaceMesh,
    vertex_count: int,
    regions: Sequence[int] = ...,
    names: Sequence[int] = ...,
    features: bool = ...,
) -> DecimatedMesh: ...
def cut_crowded_edges(mesh: SurfaceMesh) -> SurfaceMesh: ...
def find_self_intersecting_faces(mesh: SurfaceMesh) -> list[int] | None: ...
def find_crossing_groups(
    mesh: SurfaceMesh, group: Sequence[int]
) -> tuple[list[tuple[int, int]], list[int]] | None: ...
def write_mesh(path: Path, mesh: SurfaceMesh) -> None: ...

class FilledHoles:
    """A surface with some of its holes closed."""

    @property
    def mesh(self) -> SurfaceMesh:
        """Vertices and triangles of the source first, in their order."""
    @property
    def filled(self) -> int:
        """Holes that are closed now."""
    @property
    def left_open(self) -> list[int]:
        """Those asked for that no patch was found for, ascending."""

def fill_holes(mesh: SurfaceMesh, holes: Sequence[int]) -> FilledHoles:
    """Closes holes, numbered as palpate.find_border_loops lists them. Raises ValueError."""

MOST_HOLE_EDGES: int
"""Of a hole that fill_holes closes."""
MOST_TETRAHEDRA: int
"""That fill_interior makes."""

def choose_cell_size(surface: SurfaceMesh, tetrahedron_count: int) -> float:
    """[m] At which about tetrahedron_count tetrahedra fill the surface; good to a third."""

COUNT_ERROR: float
"""[-] By how much another number than was asked for may come of fill_to_count."""

def fill_to_count(
    surface: SurfaceMesh,
    tetrahedron_count: int,
    fine: Sequence[int] = (),
    ratio: float = 1.0,
) -> SolidMesh:
    """tetrahedron_count tetrahedra, to a tenth, that fill a closed surface; cells at its triangles
    `fine` are smaller by `ratio` than far away from them. Raises ValueError."""

def fill_interior(surface: SurfaceMesh, cell_size: float) -> SolidMesh:
    """Tetrahedra of about cell_size [m] that fill a closed surface. Raises ValueError."""

SHARP_EDGE: float
"""[degree] Where neighbouring triangles turn by more, remeshing keeps their edge."""

class UncrossedMesh:
    """What one round made of a surface that crosses itself."""

    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def replaced_triangles(self) -> int: ...
    @property
    def dropped_pieces(self) -> int: ...

def remove_crossings(mesh: SurfaceMesh, rings: int) -> UncrossedMesh:
    """Takes out triangles that cross others with rings around them. Raises ValueError."""

class StitchedMesh:
    """A surface whose borders were joined where they lie on each other."""

    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def split_edges(self) -> int: ...
    @property
    def joined_vertices(self) -> int: ...

def stitch_borders(mesh: SurfaceMesh, tolerance: float) -> StitchedMesh:
    """Joins borders that lie within `tolerance` [m] of each other, T-junctions too."""

class SurfaceDistance:
    """How far the points of one surface are from another."""

    @property
    def mean(self) -> float:
        """[m] over the area."""
    @property
    def least(self) -> float:
        """[m] One point is at least so far away."""
    @property
    def most(self) -> float:
        """[m] No point is further away."""

def measure_distance(mesh: SurfaceMesh, onto: SurfaceMesh) -> SurfaceDistance: ...
def measure_seen_distance(mesh: SurfaceMesh, onto: SurfaceMesh) -> SurfaceDistance:
    """Of what is seen of `mesh` from outside; `most` within a hundredth of its diagonal."""

class DroppedPiece:
    """What of a surface hung together and is gone."""

    @property
    def triangles(self) -> int: ...
    @property
    def size(self) -> float:
        """[m] From corner to corner."""
    @property
    def middle(self) -> list[float]:
        """[m] Of its box."""

class WrappedMesh:
    """A surface around another one, and what it cost."""

    @property
    def mesh(self) -> SurfaceMesh: ...
    @property
    def to_source(self) -> SurfaceDistance: ...
    @property
    def from_source(self) -> SurfaceDistance:
        """Of what is seen of the source from outside."""
    @property
    def volume(self) -> float:
        """[m³]"""
    @property
    def dropped(self) -> list[DroppedPiece]:
        """Pieces of the source that lie inside, the largest first."""

def wrap_surface(mesh: SurfaceMesh, alpha: float) -> WrappedMesh:
    """Wraps any triangles in a closed surface that crosses nothing. Raises ValueError."""

def smooth_surface(mesh: SurfaceMesh, steps: int) -> SurfaceMesh:
    """Smooths without shrinking. Raises ValueError."""

def remesh_surface(mesh: SurfaceMesh, edge_lengths: Sequence[float]) -> SurfaceMesh:
    """Even triangles, edges [m] as asked for at each vertex. Raises ValueError."""

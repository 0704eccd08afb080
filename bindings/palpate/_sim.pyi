# SPDX-License-Identifier: BSD-3-Clause
"""Written by bindings/write_stub.py from what the compiled module says of itself."""

import enum
import os
from collections.abc import Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csc_matrix

__version__: str

class SurfaceMesh:
    """A triangulated surface, closed or open."""
    def __init__(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        """Copies vertices [m], shape (n, 3), and triangles, shape (t, 3), counter-clockwise
        from outside.

        Arguments are the fields of these names, with their shapes and units.
        """
    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions [m], shape (n, 3); a view, so writing moves the vertices."""
    @property
    def triangles(self) -> NDArray[np.int32]:
        """Vertex indices, shape (t, 3), counter-clockwise from outside; a view, read-only."""
    def __copy__(self) -> SurfaceMesh:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SurfaceMesh:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str: ...

class Topology:
    """Who is next to whom on a surface."""
    @property
    def edges(self) -> NDArray[np.int32]:
        """Vertex pairs, ends ascending, sorted, shape (e, 2); a view, read-only."""
    @property
    def edge_triangles(self) -> NDArray[np.int32]:
        """The one or two triangles of each edge, -1 for none, shape (e, 2); a view, read-only."""
    @property
    def triangle_edges(self) -> NDArray[np.int32]:
        """The edge opposite each corner, shape (t, 3); a view, read-only."""
    def __copy__(self) -> Topology:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Topology:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

@overload
def validate(mesh: SurfaceMesh) -> None:
    """validate(*args, **kwargs)

    Raises ValueError, naming the first offender, unless every vertex is finite and used,
    every index in range, no triangle uses a vertex twice or has no area, no edge has more
    than two triangles, and neighbours agree on which side is outside.

    Raises ValueError, naming the first offender, unless every vertex is finite and used,
    every tetrahedron has a positive volume, and no face has more than two.

    Raises ValueError naming the field, what it got and the admissible range.

    Raises ValueError, naming table, row, what was found and what was expected; also where a
    triangle's constants make its tangent at rest indefinite.

    Raises ValueError naming the field, what it got and what was expected.

    Raises ValueError naming the field, what it got and what was expected.

    Raises ValueError naming the field, what it got and what was expected.

    Raises ValueError naming the field, what it got and what was expected.

    Raises ValueError naming the field, what it got and what was expected.
    """

@overload
def validate(solid: SolidMesh) -> None: ...
@overload
def validate(material: Material) -> None: ...
@overload
def validate(model: TissueModel) -> None: ...
@overload
def validate(task: DeviceTask) -> None: ...
@overload
def validate(arm: Arm) -> None: ...
@overload
def validate(plant: Plant) -> None: ...
@overload
def validate(calibration: Calibration) -> None: ...
@overload
def validate(faults: Faults) -> None: ...
def build_topology(triangles: ArrayLike) -> Topology:
    """Edges and their triangles. Only the first two triangles of an edge are kept;
    count_non_manifold_edges tells of others.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
    """

def count_non_manifold_edges(triangles: ArrayLike) -> int:
    """Edges with more than two triangles, or whose two triangles run along it in the same
    direction.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
    """

def find_border_loops(triangles: ArrayLike) -> list[NDArray[np.int32]]:
    """Border loops as arrays of vertices, shape (k,), in the direction that keeps the surface
    on the left; empty for a closed surface. A vertex where two loops touch ends up in both.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
    """

def find_shells(vertex_count: int, triangles: ArrayLike) -> NDArray[np.int32]:
    """The shell number of every vertex, shape (n,), counted from 0 in order of first vertex;
    vertices no triangle uses get -1.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
    """

def compute_euler_number(triangles: ArrayLike) -> int:
    """V - E + F over the vertices in use.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
    """

def is_closed(triangles: ArrayLike) -> bool:
    """Whether the surface has no border.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
    """

def compute_area(mesh: SurfaceMesh) -> float:
    """[m²]"""

@overload
def compute_volume(mesh: SurfaceMesh) -> float:
    """compute_volume(*args, **kwargs)

    [m³], positive when the triangles run counter-clockwise from outside; a number without
    meaning for an open surface.

    [m³] of the tetrahedron a b c d, negative where it is turned inside out.

    [m³] in all.

    Args:
        a: [m] shape (3,), a corner
        b: [m] shape (3,), a corner
        c: [m] shape (3,), a corner
        d: [m] shape (3,), a corner
    """

@overload
def compute_volume(a: ArrayLike, b: ArrayLike, c: ArrayLike, d: ArrayLike) -> float: ...
@overload
def compute_volume(solid: SolidMesh) -> float: ...
def compute_vertex_areas(mesh: SurfaceMesh) -> NDArray[np.float64]:
    """[m²] per vertex, shape (n,): a third of every triangle around it. Sums to compute_area."""

def compute_vertex_normals(vertices: ArrayLike, triangles: ArrayLike) -> NDArray[np.float64]:
    """[-] Unit normals per vertex, weighted by area, shape (n, 3); zero where the triangles
    cancel out.

    Args:
        vertices: [m] shape (n, 3)
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
    """

def compute_smallest_angle(mesh: SurfaceMesh) -> float:
    """Smallest corner angle of any triangle [rad]."""

def compute_bounds(vertices: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lower and upper corner of the axis-aligned box [m], shape (3,) each.

    Args:
        vertices: [m] shape (n, 3)
    """

def compute_diagonal(vertices: ArrayLike) -> float:
    """[m] from corner to corner of the bounding box.

    Args:
        vertices: [m] shape (n, 3)
    """

class SolidMesh:
    """A body cut into tetrahedra."""
    def __init__(self, vertices: ArrayLike, tetrahedra: ArrayLike) -> None:
        """Copies vertices [m], shape (n, 3), and tetrahedra, shape (t, 4), each with (b - a) x
        (c - a) towards d.

        Arguments are the fields of these names, with their shapes and units.
        """
    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions [m], shape (n, 3); a view, so writing moves the vertices."""
    @property
    def tetrahedra(self) -> NDArray[np.int32]:
        """Vertex indices, shape (t, 4); a view, read-only."""
    def __copy__(self) -> SolidMesh:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SolidMesh:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str: ...

def find_boundary(solid: SolidMesh) -> NDArray[np.int32]:
    """The faces that only one tetrahedron has, counter-clockwise from outside, (f, 3)."""

def find_edges(solid: SolidMesh) -> NDArray[np.int32]:
    """Vertex pairs along which some tetrahedron has an edge, ends ascending, sorted, (e, 2)."""

def compute_smallest_dihedral(solid: SolidMesh) -> float:
    """[rad] The smallest angle between two faces of any tetrahedron."""

class DampingLaw(enum.Enum):
    """How the damping of a link acts on the relative velocity of its ends (Eq 2 of the paper)."""

    axis = 0
    isotropic = 1

class AngleLaw(enum.Enum):
    """How an angle pushes back."""

    gradient = 0
    eq10 = 1

class Material:
    """What an organ is made of, as a designer states it."""
    def __init__(
        self,
        *,
        density: float = ...,
        young_modulus: float = ...,
        poisson_ratio: float = ...,
        damping_ratio: float = ...,
        wall_thickness: float | None = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    density: float
    """[kg/m³]"""
    young_modulus: float
    """[Pa]"""
    poisson_ratio: float
    """[-]"""
    damping_ratio: float
    """[-] of a single link between its two end masses; 1 is critical."""
    wall_thickness: float | None
    """[m] of a hollow organ or sheet, None for a solid."""
    def __copy__(self) -> Material:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Material:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Links:
    """Pairs of particles that resist a change of distance: springs of the mass-spring model and
    bonds of the molecular model.
    """
    @overload
    def __init__(
        self, ends: ArrayLike, rest_length: ArrayLike, stiffness: ArrayLike, damping: ArrayLike
    ) -> None:
        """__init__(*args, **kwargs)

        Copies its tables.

        Arguments are the fields of these names, with their shapes and units.
        """
    @overload
    def __init__(self) -> None: ...
    @property
    def ends(self) -> NDArray[np.int32]:
        """particle indices, ends[l, 0] < ends[l, 1], shape (rows, 2); a view, read-only."""
    @property
    def rest_length(self) -> NDArray[np.float64]:
        """[m], shape (rows,); a view."""
    @property
    def stiffness(self) -> NDArray[np.float64]:
        """[N/m] a bond's may be negative, shape (rows,); a view."""
    @property
    def damping(self) -> NDArray[np.float64]:
        """[N·s/m], shape (rows,); a view."""
    def __copy__(self) -> Links:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Links:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class Angles:
    """Triangles whose three corners resist a change of angle (molecular model, Eq 9 and 11).
    Row a is one triangle; column c belongs to its corner c, or to the side opposite corner
    c.
    """
    @overload
    def __init__(
        self,
        corners: ArrayLike,
        rest_cosine: ArrayLike,
        rest_length: ArrayLike,
        bend_stiffness: ArrayLike,
        stretch_coupling: ArrayLike,
        bond_share: ArrayLike,
    ) -> None:
        """__init__(*args, **kwargs)

        Copies its tables.

        Arguments are the fields of these names, with their shapes and units.
        """
    @overload
    def __init__(self) -> None: ...
    @property
    def corners(self) -> NDArray[np.int32]:
        """particle indices, shape (rows, 3); a view, read-only."""
    @property
    def rest_cosine(self) -> NDArray[np.float64]:
        """[-] of the angle at the corner, shape (rows, 3); a view."""
    @property
    def rest_length(self) -> NDArray[np.float64]:
        """[m] of the side opposite the corner, shape (rows, 3); a view."""
    @property
    def bend_stiffness(self) -> NDArray[np.float64]:
        """[J] K_theta of the corner, [N] under AngleLaw.eq10, shape (rows, 3); a view."""
    @property
    def stretch_coupling(self) -> NDArray[np.float64]:
        """[N] K_btheta of the corner, shape (rows, 3); a view."""
    @property
    def bond_share(self) -> NDArray[np.float64]:
        """[N/m] this triangle's part of the bond opposite the corner, shape (rows, 3); a view."""
    def __copy__(self) -> Angles:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Angles:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class Prisms:
    """Triangular prisms of a wall that resist transverse shear, which is what makes a wall
    bend. Row p joins a triangle of the inner face to the one above it; column c is the side
    opposite corner c.
    """
    @overload
    def __init__(
        self,
        corners: ArrayLike,
        rest_difference: ArrayLike,
        shear_stiffness: ArrayLike,
        shear_damping: ArrayLike,
    ) -> None:
        """__init__(*args, **kwargs)

        Copies its tables.

        Arguments are the fields of these names, with their shapes and units.
        """
    @overload
    def __init__(self) -> None: ...
    @property
    def corners(self) -> NDArray[np.int32]:
        """particles: three inner, then the three above them, shape (rows, 6); a view,
        read-only.
        """
    @property
    def rest_difference(self) -> NDArray[np.float64]:
        """[m] first diagonal less the second, shape (rows, 3); a view."""
    @property
    def shear_stiffness(self) -> NDArray[np.float64]:
        """[N/m] of that difference, shape (rows, 3); a view."""
    @property
    def shear_damping(self) -> NDArray[np.float64]:
        """[N·s/m] likewise, shape (rows, 3); a view."""
    def __copy__(self) -> Prisms:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Prisms:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class Volumes:
    """Tetrahedra that resist a change of volume, and with it being turned inside out. With J
    the volume over that at rest, the part 1 - nodal_share of each tetrahedron's bulk acts on
    its own J, the part nodal_share on the mean J around each of its particles.
    """
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def corners(self) -> NDArray[np.int32]:
        """particle indices, shape (rows, 4); a view, read-only."""
    @property
    def rest_volume(self) -> NDArray[np.float64]:
        """[m³] positive, shape (rows,); a view."""
    @property
    def bulk(self) -> NDArray[np.float64]:
        """[Pa] lambda - mu: what springs leave to be done, shape (rows,); a view."""
    @property
    def first_around(self) -> NDArray[np.int32]:
        """of each particle in around, and the end, shape (n + 1,); a view, read-only."""
    @property
    def around(self) -> NDArray[np.int32]:
        """the rows around particle 0, those around 1, ... each ascending, shape (k,); a view,
        read-only.
        """
    nodal_share: float
    """[-] 0 to 1"""
    def __copy__(self) -> Volumes:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Volumes:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class Elastic:
    """Tetrahedra of a linear elastic solid, for shallow presses: constant strain and Hooke's
    law. The part nodal_share of lambda acts on the mean trace of the strain around each
    particle.
    """
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def corners(self) -> NDArray[np.int32]:
        """particle indices, shape (rows, 4); a view, read-only."""
    @property
    def lame(self) -> NDArray[np.float64]:
        """[Pa] lambda, Lamé's first constant, shape (rows,); a view."""
    @property
    def shear(self) -> NDArray[np.float64]:
        """[Pa] mu, shape (rows,); a view."""
    @property
    def first_around(self) -> NDArray[np.int32]:
        """as in Volumes, shape (n + 1,); a view, read-only."""
    @property
    def around(self) -> NDArray[np.int32]:
        """as in Volumes, shape (k,); a view, read-only."""
    @property
    def reach(self) -> NDArray[np.int32]:
        """particles that pushes may move, ascending; empty for all that carry the surface,
        shape (rows,); a view, read-only.
        """
    nodal_share: float
    """[-] 0 to 1"""
    damping_time: float
    """[s] in which strain follows stress (Kelvin-Voigt)"""
    def __copy__(self) -> Elastic:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Elastic:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class Hyperelastic:
    """Tetrahedra of a solid that may be strained and turned far, of the corotated or the
    neo-Hookean law. The part nodal_share of lambda acts on the mean J around each particle.
    """
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def corners(self) -> NDArray[np.int32]:
        """particle indices, shape (rows, 4); a view, read-only."""
    @property
    def lame(self) -> NDArray[np.float64]:
        """[Pa] lambda, Lamé's first constant, shape (rows,); a view."""
    @property
    def shear(self) -> NDArray[np.float64]:
        """[Pa] mu, shape (rows,); a view."""
    @property
    def viscosity(self) -> NDArray[np.float64]:
        """[Pa·s] eta: 2 eta times the rate of Green's strain, shape (rows,); a view."""
    @property
    def first_around(self) -> NDArray[np.int32]:
        """as in Volumes, shape (n + 1,); a view, read-only."""
    @property
    def around(self) -> NDArray[np.int32]:
        """as in Volumes, shape (k,); a view, read-only."""
    nodal_share: float
    """[-] 0 to 1"""
    def __copy__(self) -> Hyperelastic:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Hyperelastic:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class Maxwell:
    """Linear viscoelasticity: beside every spring, bond, angle and stretch-bend a Maxwell
    branch of ratio times its stiffness, whose force fades with time while the tissue holds
    still.
    """
    @overload
    def __init__(self, ratio: float = ..., time: float = ...) -> None:
        """__init__(*args, **kwargs)

        Copies its tables.

        Arguments are the fields of these names, with their shapes and units.
        """
    @overload
    def __init__(self) -> None: ...
    ratio: float
    """[-] k_v/k, 0 for none"""
    time: float
    """[s] tau, in which 63 % of the branch's force has faded"""
    def __copy__(self) -> Maxwell:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Maxwell:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class Skin:
    """How a fine surface rides on coarse tetrahedra: vertex v is at the sum over k of
    weights[v, k] times the position of particle corners[v, k]. Empty where the particles
    themselves are the surface.
    """
    @overload
    def __init__(self, corners: ArrayLike, weights: ArrayLike) -> None:
        """__init__(*args, **kwargs)

        Copies its tables.

        Arguments are the fields of these names, with their shapes and units.
        """
    @overload
    def __init__(self) -> None: ...
    @property
    def corners(self) -> NDArray[np.int32]:
        """particle indices, shape (rows, 4); a view, read-only."""
    @property
    def weights(self) -> NDArray[np.float64]:
        """[-] sum 1; below 0 outside of the tetrahedron, shape (rows, 4); a view."""
    def __copy__(self) -> Skin:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Skin:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

def build_volumes(
    particle_count: int,
    corners: ArrayLike,
    rest_volume: ArrayLike,
    bulk: ArrayLike,
    nodal_share: float = ...,
) -> Volumes:
    """Volumes with the tables of what lies around each particle filled in. Copies its tables.

    Args:
        corners: particle indices, shape (t, 4)
        rest_volume: [m³] shape (t,), of each tetrahedron
        bulk: [Pa] shape (t,), of each tetrahedron
        nodal_share: [-] 0 to 1
    """

def build_elastic(
    particle_count: int,
    corners: ArrayLike,
    lame: ArrayLike,
    shear: ArrayLike,
    nodal_share: float = ...,
    damping_time: float = ...,
) -> Elastic:
    """A linear solid's table with what lies around each particle filled in; pushes reach all of
    its surface. Copies its tables.

    Args:
        corners: particle indices, shape (t, 4)
        lame: [Pa] shape (t,), lambda of each tetrahedron
        shear: [Pa] shape (t,), mu of each tetrahedron
        nodal_share: [-] 0 to 1
        damping_time: [s] in which strain follows stress
    """

def build_hyperelastic(
    particle_count: int,
    corners: ArrayLike,
    lame: ArrayLike,
    shear: ArrayLike,
    viscosity: ArrayLike,
    nodal_share: float = ...,
) -> Hyperelastic:
    """A table of the corotated or the neo-Hookean law with what lies around each particle
    filled in. Copies its tables.

    Args:
        corners: particle indices, shape (t, 4)
        lame: [Pa] shape (t,), lambda of each tetrahedron
        shear: [Pa] shape (t,), mu of each tetrahedron
        viscosity: [Pa·s] shape (t,), eta of each tetrahedron
        nodal_share: [-] 0 to 1
    """

def move_skin(skin: Skin, x: ArrayLike, surface: NDArray[np.float64]) -> None:
    """Sets surface [m] to where the vertices of a surface are that rides on particles at x [m].

    Args:
        x: [m] shape (n, 3), positions
        surface: [m] shape (n, 3), float64, C order, written to
    """

class TissueModel:
    """An organ as built: everything about it that a simulation never changes. Made by a build_
    function, or from tables, which are validated.
    """
    def __init__(
        self,
        *,
        rest_position: ArrayLike,
        mass: ArrayLike,
        fixed: ArrayLike = ...,
        springs: Links = ...,
        bonds: Links = ...,
        angles: Angles = ...,
        prisms: Prisms = ...,
        volumes: Volumes = ...,
        elastic: Elastic = ...,
        corotated: Hyperelastic = ...,
        neo_hookean: Hyperelastic = ...,
        maxwell: Maxwell = ...,
        skin: Skin = ...,
        home: ArrayLike = ...,
        pressure: float = ...,
        triangles: ArrayLike = ...,
        drag: float = ...,
        damping_law: DampingLaw = ...,
        angle_law: AngleLaw = ...,
    ) -> None:
        """Copies its tables and validates the whole. Raises ValueError.

        Arguments are the fields of these names, with their shapes and units.
        """
    @property
    def rest_position(self) -> NDArray[np.float64]:
        """[m], shape (n, 3); a view."""
    @property
    def mass(self) -> NDArray[np.float64]:
        """[kg], positive, shape (n,); a view."""
    @property
    def fixed(self) -> NDArray[np.int32]:
        """Particles held at rest, ascending, shape (k,); a view, read-only."""
    @property
    def springs(self) -> Links:
        """Mass-spring model; may be empty."""
    @property
    def bonds(self) -> Links:
        """Molecular model; may be empty."""
    @property
    def angles(self) -> Angles:
        """Molecular model; may be empty."""
    @property
    def prisms(self) -> Prisms:
        """Walls that bend; may be empty."""
    @property
    def volumes(self) -> Volumes:
        """Solids; may be empty."""
    @property
    def elastic(self) -> Elastic:
        """Linear solids, which have no other law; may be empty."""
    @property
    def corotated(self) -> Hyperelastic:
        """Corotated solids; may be empty."""
    @property
    def neo_hookean(self) -> Hyperelastic:
        """Neo-Hookean solids; may be empty."""
    maxwell: Maxwell
    """What of links and angles relaxes; may be empty."""
    @property
    def skin(self) -> Skin:
        """Solids under a finer surface; may be empty."""
    @property
    def home(self) -> NDArray[np.float64]:
        """[N/m] pull of every particle to its rest position, shape (n,) or empty; a view."""
    pressure: float
    """[Pa] inside above outside."""
    @property
    def triangles(self) -> NDArray[np.int32]:
        """Outer surface, counter-clockwise from outside, of vertices of the skin, or of
        particles where there is none, shape (t, 3); a view, read-only.
        """
    drag: float
    """[1/s], velocity lost to the surroundings."""
    damping_law: DampingLaw
    """How links are damped."""
    angle_law: AngleLaw
    """How angles push back."""
    def __copy__(self) -> TissueModel:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TissueModel:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str: ...

def particle_count(model: TissueModel) -> int:
    """How many particles a model has."""

def surface_count(model: TissueModel) -> int:
    """Vertices of the surface: those of the skin, or the particles where there is none."""

def compute_total_mass(model: TissueModel) -> float:
    """[kg]"""

@overload
def describe(model: TissueModel) -> str:
    """describe(*args, **kwargs)

    One line for people: how many particles and links of each kind, and the total mass [g].

    '-0.058 to 54 N', drawn in by a hair so that the numbers shown are themselves admissible.

    One line for people.
    """

@overload
def describe(range: CouplingRange) -> str: ...
@overload
def describe(fit: MembraneFit) -> str: ...

class SurfaceOptions:
    """What a designer may choose about a surface model beside its material."""
    def __init__(
        self,
        *,
        home_stiffness: float | None = ...,
        stiffness_scale: ArrayLike = ...,
        fixed: ArrayLike = ...,
        pressure: float = ...,
        drag: float = ...,
        damping_law: DampingLaw = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    home_stiffness: float | None
    """[N/m³] pull home per area; None: default_home_stiffness."""
    @property
    def stiffness_scale(self) -> NDArray[np.float64]:
        """[-] per vertex, shape (n,), positive, empty for 1 everywhere; a link takes the mean
        of its ends. Reads as a read-only copy: assign a new array to change it.
        """
    @stiffness_scale.setter
    def stiffness_scale(self, value: ArrayLike) -> None: ...
    @property
    def fixed(self) -> NDArray[np.int32]:
        """Vertices held at rest: indices, shape (k,), or a mask, one boolean per vertex, which
        is turned into the indices of its true rows. Reads as a read-only copy: assign a new
        array to change it.
        """
    @fixed.setter
    def fixed(self, value: ArrayLike) -> None: ...
    pressure: float
    """[Pa]"""
    drag: float
    """[1/s]"""
    damping_law: DampingLaw
    """How links are damped."""
    def __copy__(self) -> SurfaceOptions:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SurfaceOptions:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class MolecularConstants:
    """Constants of the molecular model, the same at every bond and corner (Eq 8, 9, 11)."""
    def __init__(
        self,
        *,
        bond_stiffness: float = ...,
        bend_stiffness: float = ...,
        stretch_coupling: float = ...,
        angle_law: AngleLaw = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    bond_stiffness: float
    """[N/m] K_b of a bond inside the surface; a border bond gets half."""
    bend_stiffness: float
    """[J] K_theta per corner; [N] under AngleLaw.eq10."""
    stretch_coupling: float
    """[N] K_btheta per corner; may be negative."""
    angle_law: AngleLaw
    """How angles push back."""
    def __copy__(self) -> MolecularConstants:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> MolecularConstants:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def default_home_stiffness(mesh: SurfaceMesh, material: Material) -> float:
    """[N/m³] home stiffness when none is given. 0 for a solid (no wall thickness); for hollow
    organs and sheets E h / d² with d a tenth of the bounding box's diagonal.
    """

def compute_lumped_mass(mesh: SurfaceMesh, material: Material) -> NDArray[np.float64]:
    """[kg] per vertex, shape (n,), lumped by area: density x volume for a closed solid, density
    x wall thickness x area for hollow organs and open surfaces. Raises ValueError for an
    open surface without a wall thickness.
    """

def membrane_spring_stiffness(material: Material) -> float:
    """[N/m] of the springs that make a surface stretch like a membrane of the material and its
    wall thickness. Raises ValueError without one.
    """

def build_mass_spring(
    mesh: SurfaceMesh, material: Material, stiffness: float, options: SurfaceOptions = ...
) -> TissueModel:
    """The mass-spring model of a surface: one spring of stiffness [N/m] (Eq 1) along every
    edge. Raises ValueError on an invalid mesh, material or option.

    Args:
        stiffness: [N/m]
    """

def build_molecular(
    mesh: SurfaceMesh,
    material: Material,
    constants: MolecularConstants,
    options: SurfaceOptions = ...,
) -> TissueModel:
    """The molecular model of a surface: a bond along every edge, an angle and a stretch-bend
    term at every triangle corner. Raises ValueError as build_mass_spring does, and where the
    constants make a triangle indefinite, naming it and the admissible range.
    """

def compute_rest_stiffness(angles: Angles, row: int) -> NDArray[np.float64]:
    """[N/m] (3, 3) second derivative, at rest, of the energy of one triangle in the lengths of
    its three sides.
    """

def compute_rest_slopes(angles: Angles, row: int, law: AngleLaw) -> NDArray[np.float64]:
    """[N/m] (3, 3) what a change of each side's length at rest does to the tension of each
    side; under AngleLaw.eq10 not symmetric.
    """

def is_positive_definite(stiffness: ArrayLike) -> bool:
    """True when all eigenvalues are positive by more than rounding.

    Args:
        stiffness: [N/m] shape (3, 3), symmetric
    """

class CouplingRange:
    """[N] K_btheta lies strictly between the two; either may be infinite."""
    def __init__(self, low: float, high: float) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    low: float
    """[N] K_btheta is larger."""
    high: float
    """[N] K_btheta is smaller."""
    def __copy__(self) -> CouplingRange:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> CouplingRange:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def find_coupling_range(
    angles: Angles, row: int, proportion: Sequence[float]
) -> CouplingRange | None:
    """The K_btheta for which a triangle is positive definite when its three stretch_coupling
    are K_btheta times proportion; None if no number helps.

    Args:
        proportion: [-] three, one per corner
    """

def check_definiteness(angles: Angles, law: AngleLaw) -> None:
    """Raises ValueError on the first triangle that does not hold, with the numbers its
    stretch_coupling may have.
    """

SMALLEST_ANGLE: float

def compute_membrane_stiffnesses(mesh: SurfaceMesh, material: Material) -> NDArray[np.float64]:
    """[N/m] (t, 3, 3) the second derivative of every triangle's energy, as a wall of the
    material under plane stress, in the lengths of its three sides. Raises ValueError without
    a wall thickness and for a triangle below SMALLEST_ANGLE [degree].
    """

class MembraneFit:
    """How a surface model at rest compares with a membrane of its material."""
    def __init__(self) -> None:
        """Every field at its first value."""
    young_modulus: float
    """[Pa] of the isotropic membrane nearest to the model as a whole."""
    poisson_ratio: float
    """[-] of the same."""
    least: float
    """[-] of the material's stiffness, in the softest strain anywhere."""
    most: float
    """[-] in the stiffest."""
    error: float
    """[-] root mean square over area of |C_model - C| / |C|."""
    worst_triangle: int
    """Where |C_model - C| is largest."""
    def __copy__(self) -> MembraneFit:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> MembraneFit:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def compare_with_membrane(
    model: TissueModel, material: Material, stiffness_scale: ArrayLike = ...
) -> MembraneFit:
    """Measures springs, bonds, angles and stretch-bend terms against a membrane of the
    material, whose modulus stiffness_scale, empty or one per particle, multiplies locally.
    Raises ValueError as compute_membrane_stiffnesses does, and for a model without
    triangles.

    Args:
        stiffness_scale: [-] shape (n,) or empty, per particle
    """

class SpringRule(enum.Enum):
    """How a spring's constant follows from the two triangles at it."""

    van_gelder = 0
    lloyd = 1

def build_membrane_springs(
    mesh: SurfaceMesh, material: Material, rule: SpringRule = ..., options: SurfaceOptions = ...
) -> TissueModel:
    """The mass-spring model of a wall of the material. Raises ValueError as build_mass_spring
    does, without a wall thickness, and for triangles below SMALLEST_ANGLE.
    """

def build_membrane_molecular(
    mesh: SurfaceMesh,
    material: Material,
    bend_stiffness: float = ...,
    angle_law: AngleLaw = ...,
    options: SurfaceOptions = ...,
) -> TissueModel:
    """The molecular model of a wall of the material: at rest exactly the finite element of
    plane stress, whatever bend_stiffness [J] is; under AngleLaw.eq10 the nearest to it.
    Raises ValueError as build_membrane_springs does.

    Args:
        bend_stiffness: [J] of every corner; no bearing on the stretch
    """

def build_shell(
    mesh: SurfaceMesh, material: Material, options: SurfaceOptions = ...
) -> TissueModel:
    """A wall of triangular prisms, which stretches and bends as its material does. Vertex i of
    the surface is particle i, on the outer face; particle n + i lies below it on the inner
    face. Raises ValueError as build_membrane_molecular does, and where the wall is too thick
    for the surface.
    """

def convert_to_eq10(angles: Angles) -> Angles:
    """The constants of Eq 10 nearest to those under AngleLaw.gradient, row by row, in the sum
    of squares of the stiffness at rest.
    """

def compute_eq10_residuals(angles: Angles) -> NDArray[np.float64]:
    """[-] per row, shape (a,): |S_eq10 - S| / |S| of the slopes at rest after convert_to_eq10."""

def list_tetrahedra(model: TissueModel) -> NDArray[np.int32]:
    """Tetrahedra of a solid of any law, shape (t, 4)."""

def compute_surface(model: TissueModel, x: ArrayLike) -> NDArray[np.float64]:
    """[m] shape (n, 3), where the vertices of the model's surface are with its particles at x
    [m]: the skin's, or the particles themselves.

    Args:
        x: [m] shape (n, 3), positions
    """

def compute_surface_mass(model: TissueModel) -> NDArray[np.float64]:
    """[kg] shape (n,), with what mass a vertex of the surface withstands a push when all of the
    surface is pushed alike.
    """

class SolidOptions:
    """What a designer may choose about a solid beside its material."""
    def __init__(
        self,
        *,
        nodal_share: float = ...,
        stiffness_scale: ArrayLike = ...,
        fixed: ArrayLike = ...,
        drag: float = ...,
        damping_law: DampingLaw = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    nodal_share: float
    """[-] 0 to 1: how much of the resistance to a change of volume acts on the mean around each
    particle.
    """
    @property
    def stiffness_scale(self) -> NDArray[np.float64]:
        """[-] per vertex of the solid, shape (n,), positive, empty for 1 everywhere. Reads as a
        read-only copy: assign a new array to change it.
        """
    @stiffness_scale.setter
    def stiffness_scale(self, value: ArrayLike) -> None: ...
    @property
    def fixed(self) -> NDArray[np.int32]:
        """Vertices of the solid held at rest: indices, shape (k,), or a mask, one boolean per
        vertex, which is turned into the indices of its true rows. Reads as a read-only copy:
        assign a new array to change it.
        """
    @fixed.setter
    def fixed(self, value: ArrayLike) -> None: ...
    drag: float
    """[1/s]"""
    damping_law: DampingLaw
    """How links are damped."""
    def __copy__(self) -> SolidOptions:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SolidOptions:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class LameConstants:
    """Lamé's constants of a material."""
    def __init__(self, *, lambda_: float = ..., mu: float = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    lambda_: float
    """[Pa]"""
    mu: float
    """[Pa] the shear modulus."""
    def __copy__(self) -> LameConstants:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> LameConstants:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def compute_lame_constants(material: Material) -> LameConstants:
    """Raises ValueError for a Poisson's ratio of 0.5, where lambda is infinite."""

LEAST_SOLID_POISSON: float
MOST_SOLID_POISSON: float

def build_solid(solid: SolidMesh, material: Material, options: SolidOptions = ...) -> TissueModel:
    """The mass-spring model of a solid with true volumes: a spring along every edge of the
    tetrahedra, and what resists a change of volume in each of them. Raises ValueError, also
    for a Poisson's ratio outside of 0.25 to 0.49.
    """

def build_linear_solid(
    solid: SolidMesh, material: Material, options: SolidOptions = ...
) -> TissueModel:
    """The linear elastic model of the same solid, for shallow presses: Hooke's law in every
    tetrahedron, no links. Raises ValueError as build_solid does.
    """

def build_corotated_solid(
    solid: SolidMesh, material: Material, options: SolidOptions = ...
) -> TissueModel:
    """The same solid of tetrahedra that may be strained and turned far, of corotated linear
    elasticity. Raises ValueError as build_solid does.
    """

def build_neo_hookean_solid(
    solid: SolidMesh, material: Material, options: SolidOptions = ...
) -> TissueModel:
    """The same solid of tetrahedra that may be strained and turned far, of the stable
    neo-Hookean law. Raises ValueError as build_solid does.
    """

def limit_reach(model: TissueModel, surface_vertices: ArrayLike) -> TissueModel:
    """The same linear solid for pushes on these vertices of its surface alone, indices of shape
    (k,) or a mask with one boolean per vertex of the surface; elsewhere it does not give.
    Raises ValueError for another model, no vertices, or one that is not there.

    Args:
        surface_vertices: indices, shape (k,), or a mask, shape (n,)
    """

def build_skin(surface: SurfaceMesh, solid: SolidMesh) -> Skin:
    """The skin by which a surface rides on the tetrahedra of a solid.

    Args:
        surface: [m] shape (n, 3), float64, C order, written to
    """

def cover_with_skin(model: TissueModel, surface: SurfaceMesh) -> TissueModel:
    """The same solid under a finer surface, which is what is touched and seen. Raises
    ValueError where it lies so far from the tetrahedra that these say nothing about it.

    Args:
        surface: [m] shape (n, 3), float64, C order, written to
    """

class State:
    """Everything about a tissue that changes from step to step."""
    def __init__(self, model: TissueModel) -> None:
        """The tissue at rest, at time zero."""
    time: float
    """[s]"""
    @property
    def position(self) -> NDArray[np.float64]:
        """Particle positions [m], shape (n, 3); a view, so writing moves the particles."""
    @property
    def velocity(self) -> NDArray[np.float64]:
        """[m/s], shape (n, 3); a view."""
    @property
    def force(self) -> NDArray[np.float64]:
        """[N] of the last evaluation, loads included, shape (n, 3); a view."""
    @property
    def internal(self) -> NDArray[np.float64]:
        """[-] or [m]: what laws with a memory keep, law by law, shape (k,); empty without one;
        a view.
        """
    def __copy__(self) -> State:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> State:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class Push:
    """A force on a point of a triangle."""
    def __init__(
        self, triangle: int = ..., weights: ArrayLike = ..., force: ArrayLike = ...
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    triangle: int
    """Row of the surface."""
    @property
    def weights(self) -> NDArray[np.float64]:
        """[-] Barycentric, sum 1. Shape (3,), a view."""
    @weights.setter
    def weights(self, value: ArrayLike) -> None: ...
    @property
    def force(self) -> NDArray[np.float64]:
        """[N]; shape (3,), a view."""
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    dtype: np.dtype[np.void]
    def __copy__(self) -> Push:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Push:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Load:
    """What the surroundings do to a tissue during one step. Pushes have a fixed capacity, so
    the haptic thread never allocates.
    """
    def __init__(self, capacity: int = ...) -> None:
        """Room for so many pushes."""
    @property
    def gravity(self) -> NDArray[np.float64]:
        """[m/s²]; shape (3,), a view."""
    @gravity.setter
    def gravity(self, value: ArrayLike) -> None: ...
    @property
    def storage(self) -> NDArray[Any]:
        """All pushes there is room for, a structured array of shape (capacity,); a view,
        read-only.
        """
    @property
    def push_count(self) -> int:
        """How many of them are in force."""
    def pushes(self) -> NDArray[Any]:
        """The pushes in force, a structured array (triangle, weights, force) of shape
        (push_count,); a view, read-only.
        """
    def clear(self) -> None:
        """No pushes any more."""
    def add(self, push: Push) -> bool:
        """False, and nothing added, when the capacity is used up."""
    def __copy__(self) -> Load:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Load:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def accumulate_link_forces(
    links: Links, law: DampingLaw, x: ArrayLike, v: ArrayLike, f: NDArray[np.float64]
) -> None:
    """Adds to f [N] the pull of every link: Hooke's law with damping (Eq 1, 2, 8).

    Args:
        x: [m] shape (n, 3), positions
        v: [m/s] shape (n, 3), velocities
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_angle_forces(angles: Angles, x: ArrayLike, f: NDArray[np.float64]) -> None:
    """Adds to f [N] Eq 9 and Eq 11 of the paper as edge tensions.

    Args:
        x: [m] shape (n, 3), positions
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_eq10_forces(angles: Angles, x: ArrayLike, f: NDArray[np.float64]) -> None:
    """Adds to f [N] Eq 10 of the paper, as printed but with the sign that reopens a closed
    angle.

    Args:
        x: [m] shape (n, 3), positions
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_prism_forces(
    prisms: Prisms, x: ArrayLike, v: ArrayLike, f: NDArray[np.float64]
) -> None:
    """Adds to f [N] what resists the transverse shear of a wall.

    Args:
        x: [m] shape (n, 3), positions
        v: [m/s] shape (n, 3), velocities
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_volume_forces(volumes: Volumes, x: ArrayLike, f: NDArray[np.float64]) -> None:
    """Adds to f [N] what resists a change of volume.

    Args:
        x: [m] shape (n, 3), positions
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_elastic_forces(
    elastic: Elastic, rest: ArrayLike, x: ArrayLike, v: ArrayLike, f: NDArray[np.float64]
) -> None:
    """Adds to f [N] what resists strain; rest [m] are the places at rest.

    Args:
        rest: [m] shape (n, 3), particles at rest
        x: [m] shape (n, 3), positions
        v: [m/s] shape (n, 3), velocities
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_corotated_forces(
    table: Hyperelastic, rest: ArrayLike, x: ArrayLike, v: ArrayLike, f: NDArray[np.float64]
) -> None:
    """Adds into f [N] what resists finite strain by the corotated law; see Hyperelastic. rest
    [m] are the places at rest.

    Args:
        rest: [m] shape (n, 3), particles at rest
        x: [m] shape (n, 3), positions
        v: [m/s] shape (n, 3), velocities
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_neo_hookean_forces(
    table: Hyperelastic, rest: ArrayLike, x: ArrayLike, v: ArrayLike, f: NDArray[np.float64]
) -> None:
    """Adds into f [N] what resists finite strain by the neo-Hookean law; see Hyperelastic. rest
    [m] are the places at rest.

    Args:
        rest: [m] shape (n, 3), particles at rest
        x: [m] shape (n, 3), positions
        v: [m/s] shape (n, 3), velocities
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_home_forces(
    home: ArrayLike, rest: ArrayLike, x: ArrayLike, f: NDArray[np.float64]
) -> None:
    """Adds to f [N] the pull of every particle to its rest position, home [N/m].

    Args:
        home: [N/m] shape (n,) or empty, per particle
        rest: [m] shape (n, 3), particles at rest
        x: [m] shape (n, 3), positions
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_pressure_forces(
    triangles: ArrayLike, pressure: float, x: ArrayLike, f: NDArray[np.float64]
) -> None:
    """Adds to f [N] the push of a pressure [Pa] inside a surface.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
        pressure: [Pa]
        x: [m] shape (n, 3), positions
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_push_forces(
    triangles: ArrayLike, skin: Skin, pushes: object, f: NDArray[np.float64]
) -> None:
    """Adds to f [N] pushes, a structured array as of Load.pushes() or a list of Push, shared by
    their barycentric weights, and again by those of a skin that is not empty.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
        pushes: a structured array with the fields of Push, shape (k,), or a list of Push
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_gravity(mass: ArrayLike, gravity: ArrayLike, f: NDArray[np.float64]) -> None:
    """Adds to f [N] the weight of every particle.

    Args:
        mass: [kg] shape (n,), per particle
        gravity: [m/s²] shape (3,)
        f: [N] shape (n, 3), float64, C order, written to
    """

def accumulate_drag(mass: ArrayLike, drag: float, v: ArrayLike, f: NDArray[np.float64]) -> None:
    """Adds to f [N] what the surroundings take: drag [1/s] x mass x velocity.

    Args:
        mass: [kg] shape (n,), per particle
        drag: [1/s]
        v: [m/s] shape (n, 3), velocities
        f: [N] shape (n, 3), float64, C order, written to
    """

def compute_forces(
    model: TissueModel,
    load: Load,
    x: ArrayLike,
    v: ArrayLike,
    f: NDArray[np.float64],
    internal: ArrayLike = ...,
) -> None:
    """Sets f [N] to all of the above for a model under a load. The entries of fixed particles
    hold what the support must carry. internal is State.internal; none stands for zeros.

    Args:
        x: [m] shape (n, 3), positions
        v: [m/s] shape (n, 3), velocities
        f: [N] shape (n, 3), float64, C order, written to
        internal: [-] or [m] shape (k,) or empty
    """

class ResponseSize:
    """How much of a linear solid's response there is to keep; known before it is solved for."""
    def __init__(self, *, moved: int = ..., pushed: int = ..., bytes: int = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    moved: int
    """Particles that carry the surface and are not held."""
    pushed: int
    """Those of them within reach of pushes."""
    bytes: int
    """Of the table: 3 moved x 3 pushed numbers of 4 bytes."""
    def __copy__(self) -> ResponseSize:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> ResponseSize:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Response:
    """How a linear solid answers when nothing of it swings: displacements of the particles that
    carry its surface under forces on those that pushes reach. Made by build_response.
    """
    @property
    def size(self) -> ResponseSize:
        """How much there is of it."""
    @property
    def compliance(self) -> NDArray[np.float32]:
        """[m/N] shape (3 pushed, 3 moved): row 3c + k is what all of the moved do under 1 N on
        c along axis k; a view, read-only.
        """
    @property
    def sag(self) -> NDArray[np.float32]:
        """[m] under gravity alone, shape (moved, 3); a view, read-only."""
    @property
    def damping_time(self) -> float:
        """[s]"""
    @property
    def particle(self) -> NDArray[np.int32]:
        """Of the moved, ascending, shape (moved,); a view."""
    @property
    def row(self) -> NDArray[np.int32]:
        """Per particle of the model, shape (n,): among the moved, or -1; a view."""
    @property
    def column(self) -> NDArray[np.int32]:
        """Per particle, shape (n,): among the pushed, or -1; a view."""
    @property
    def self_compliance(self) -> NDArray[np.float64]:
        """[m/N] per vertex of the surface, shape (n,), of itself; 0 out of reach; a view."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

MOST_RESPONSE_BYTES: int
SHALLOW: float

def measure_response(model: TissueModel) -> ResponseSize:
    """How much of a linear solid's response there is to keep. Raises ValueError for another
    model.
    """

def build_response(model: TissueModel, gravity: ArrayLike = ..., most: int = ...) -> Response:
    """Solves for the response of a linear solid in gravity [m/s²]. Raises ValueError for
    another model, for a table of more than most bytes, before anything is solved, and for a
    body that is not held.

    Args:
        gravity: [m/s²] shape (3,)
    """

class Energy:
    """[J] each. AngleLaw.eq10 has no energy and counts 0."""
    def __init__(self) -> None:
        """Every field at its first value."""
    kinetic: float
    """[J] Of all particles."""
    links: float
    """[J] Springs and bonds, Eq 8."""
    angles: float
    """[J] Eq 9 and Eq 11."""
    prisms: float
    """[J] Transverse shear of walls."""
    volumes: float
    """[J] Of tetrahedra."""
    strain: float
    """[J] Of linear, corotated and neo-Hookean solids."""
    home: float
    """[J] Of the pull to where particles rest."""
    gravity: float
    """[J] Relative to the origin."""
    pressure: float
    """[J] -p V; its gradient is the pressure force on closed surfaces."""
    def total(self) -> float:
        """[J] All of them."""
    def elastic(self) -> float:
        """[J] What is stored in the tissue itself: all but kinetic, gravity and pressure."""
    def __copy__(self) -> Energy:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Energy:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def count_internal(model: TissueModel) -> int:
    """How many internal variables a state of the model has."""

@overload
def compute_energy(model: TissueModel, gravity: ArrayLike, state: State) -> Energy:
    """compute_energy(*args, **kwargs)

    [J] What a tissue holds, by kind.

    [J] kinetic and potential, without the hand.

    Args:
        gravity: [m/s²] shape (3,)
    """

@overload
def compute_energy(plant: Plant, state: PlantState) -> float: ...

class Projection(enum.Enum):
    """Which stiffness an implicit step is given."""

    none = 0
    positive_semidefinite = 1

def compute_stiffness(model: TissueModel, x: ArrayLike, projection: Projection) -> csc_matrix:
    """K = -df/dx at positions x [N/m], (3n, 3n), springs, bonds, angles, prisms, volumes,
    solids of every law and home; pressure and pushes are left out. Rows and columns of fixed
    particles are zero.

    Args:
        x: [m] shape (n, 3), positions
    """

def compute_damping(model: TissueModel, x: ArrayLike) -> csc_matrix:
    """C = -df/dv at positions x [N·s/m], (3n, 3n), links, prisms, solids and drag. Fixed as
    above.

    Args:
        x: [m] shape (n, 3), positions
    """

class Integrator(enum.Enum):
    """How a step goes from one moment to the next."""

    explicit_euler = 0
    symplectic_euler = 1
    midpoint = 2
    runge_kutta_4 = 3
    symplectic_euler_implicit_damping = 4
    implicit_euler_linear = 5
    implicit_euler = 6
    implicit_midpoint = 7
    xpbd = 8
    projective_dynamics = 9

def find_integrator(name: str) -> Integrator | None:
    """'symplectic_euler' -> Integrator.symplectic_euler; None for an unknown name."""

def integrator_name(integrator: Integrator) -> str:
    """Integrator.midpoint -> 'midpoint'."""

def is_implicit(integrator: Integrator) -> bool:
    """Whether it solves for the state that it steps to (ImplicitStepper)."""

@overload
def step(model: TissueModel, load: Load, dt: float, state: State) -> None:
    """step(*args, **kwargs)

    Advances state in place by dt [s] with symplectic Euler, which must stay below
    stable_step(model).

    The same with any explicit integrator.

    Args:
        dt: [s]
    """

@overload
def step(
    model: TissueModel, load: Load, dt: float, integrator: Integrator, state: State
) -> None: ...

class ImplicitStepper:
    """Steps with an implicit integrator; owns the sparse factorisation."""
    def __init__(self, model: TissueModel, integrator: Integrator, iterations: int = ...) -> None:
        """Steps this model, which it keeps. Iterations are how often xpbd goes over all
        constraints in a step, and projective_dynamics solves with its matrix: up to 1000, 0
        for the usual 5 and 10. The others take 0 alone.
        """
    def step(self, load: Load, dt: float, state: State) -> int:
        """Advances state by dt [s]; returns the iterations used, or 0 where no solution was
        found: positions and time are then as they were.

        Args:
            dt: [s]
        """
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class Spectrum:
    """Largest eigenvalues at rest, fixed particles left out, with a coupling [N/m] holding the
    particle it hurts most.
    """
    def __init__(self, *, stiffness: float = ..., damping: float = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    stiffness: float
    """[1/s²] of M⁻¹K"""
    damping: float
    """[1/s] of M⁻¹C"""
    def __copy__(self) -> Spectrum:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Spectrum:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def estimate_spectrum(model: TissueModel, coupling: float = ...) -> Spectrum:
    """The largest eigenvalues at rest.

    Args:
        coupling: [N/m] that a tool may add at any one particle
    """

@overload
def stable_step(model: TissueModel, coupling: float = ...) -> float:
    """stable_step(*args, **kwargs)

    [s] A step at which symplectic Euler is stable at rest, with a margin; coupling [N/m] is
    the stiffness that a tool may add at any one particle. Lies between 0.6 and 1.0 of the
    exact limit.

    [s] The same for any integrator: infinite for an implicit one, and 0 where no step is
    stable, because something swings that nothing damps: explicit Euler and the explicit
    midpoint rule feed it energy at any step.

    Args:
        coupling: [N/m] that a tool may add at any one particle
    """

@overload
def stable_step(model: TissueModel, integrator: Integrator) -> float: ...
def has_packed_form(model: TissueModel) -> bool:
    """Whether a tissue can be packed, where there is vector code: all can but linear, corotated
    and neo-Hookean solids.
    """

def simd_targets() -> list[str]:
    """The vector targets this machine can run ('AVX3', 'AVX2', 'SSE4', ...), the best first;
    empty where Palpate was built without vector code.
    """

class AlarmKind(enum.Enum):
    """What may be wrong with a running tissue."""

    none = 0
    not_finite = 1
    moved_far = 2
    overstretched = 3
    collapsed = 4
    energy = 5
    inverted = 6
    pressed_deep = 7
    invalid_input = 8
    not_solved = 9

class Alarm:
    """What is wrong with a running tissue, as a value; false for nothing."""
    def __init__(self) -> None:
        """Every field at its first value."""
    kind: AlarmKind
    """What is wrong; none for nothing."""
    index: int
    """Particle, link, ...: AlarmKind says of what; -1 for none."""
    value: float
    """What was measured, in the unit of its kind: [m], [-] or [J]."""
    limit: float
    """What it may be, likewise: [m], [-] or [J]."""
    time: float
    """[s]"""
    def __bool__(self) -> bool: ...
    def __copy__(self) -> Alarm:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Alarm:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

FARTHEST_HAND: float

class TickInput(enum.IntEnum):
    """What a tick cannot use: the index of an invalid_input alarm."""

    time = 0
    position = 1
    orientation = 2
    velocity = 3
    grip = 4
    dt = 5
    scene = 6
    tool_radius = 7
    tool_stiffness = 8
    coupling_stiffness = 9
    coupling_force_max = 10
    hold_stiffness = 11
    gravity = 12
    substeps = 13
    substeps_max = 14
    tool_friction = 16

class Guard:
    """The memory of the blow-up alarm between checks."""
    def __init__(self, model: TissueModel, gravity: ArrayLike, state: State) -> None:
        """Of a tissue as it is now.

        Args:
            gravity: [m/s²] shape (3,)
        """
    @property
    def last_position(self) -> NDArray[np.float64]:
        """[m] at the last check that found nothing wrong, shape (n, 3); a view."""
    last_time: float
    """[s] of the last check."""
    shortest_rest_length: float
    """[m]"""
    start_energy: float
    """[J] elastic and kinetic."""
    last_energy: float
    """[J] elastic and kinetic."""
    work: float
    """[J] done by pushes, gravity and pressure since the start."""
    unnoticed_energy: float
    """[J] less than can be seen or felt."""
    given_energy: float
    """[J] of start and work, less what has long been lost."""
    reference_energy: float
    """[J] the most that has lately been given."""
    rising_steps: int
    """Checks in a row at which energy rose without work."""
    strained_checks: int
    """Checks in a row at which a link was out of its bounds."""
    torn_energy: float
    """[J] of what has torn: the model has it, and the tissue has not."""
    @property
    def torn_links(self) -> list[int]:
        """1 of each link that has torn and may have any length, springs before bonds; a list,
        empty where nothing tears.
        """
    @torn_links.setter
    def torn_links(self, value: Sequence[int]) -> None: ...
    def __copy__(self) -> Guard:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Guard:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def check(
    model: TissueModel,
    gravity: ArrayLike,
    state: State,
    work: float,
    guard: Guard,
    steps: int = ...,
) -> Alarm:
    """Checks a tissue after a step; the first thing wrong comes back. work [J] is what pushes
    have done to the tissue since the last check; what gravity and pressure have done is
    found here. steps taken since then may have moved a particle that many times as far.

    Args:
        gravity: [m/s²] shape (3,)
        work: [J]
    """

class AabbTree:
    """Axis-aligned boxes around the triangles of a deforming surface. Built once over the
    surface at rest; refit follows the deformation without changing the shape of the tree.
    """
    def __init__(self, x: ArrayLike, triangles: ArrayLike) -> None:
        """Raises ValueError for no triangles, an index out of range or a position that is not
        finite.

        Arguments are the fields of these names, with their shapes and units.

        Args:
            x: [m] shape (n, 3), positions
        """
    def refit(self, x: ArrayLike) -> None:
        """Follows the surface to positions x; the same particle count as at the start.

        Args:
            x: [m] shape (n, 3), positions
        """
    def nodes(self) -> NDArray[Any]:
        """Eight boxes each [m], rounded outwards, depth first, a structured array of shape
        (k,): low and high (3, 8) by axis and child, first and count (8,); a view.
        """
    def low(self) -> NDArray[np.float64]:
        """The corner of the box around the whole surface [m], shape (3,)."""
    def high(self) -> NDArray[np.float64]:
        """The opposite corner [m], shape (3,)."""
    def leaf_triangles(self) -> NDArray[np.int32]:
        """triangles() in the sequence of order(), shape (t, 3); a view, read-only."""
    def order(self) -> NDArray[np.int32]:
        """Triangles in the sequence of the leaves, shape (t,); a view, read-only."""
    def triangles(self) -> NDArray[np.int32]:
        """Shape (t, 3); a view, read-only."""
    WIDTH: int
    LEAF_SIZE: int
    MAX_DEPTH: int
    def __copy__(self) -> AabbTree:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> AabbTree:
        """A copy of its own."""
    def __repr__(self) -> str:
        """What it is, on one line."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

def compute_query_cost(tree: AabbTree) -> float:
    """[-] What a query of the tree costs on average, in nodes and leaves visited."""

class SurfacePoint:
    """A point of a surface, found by a query."""
    @property
    def triangle(self) -> int:
        """Row of the surface."""
    @property
    def distance(self) -> float:
        """[m] from where the query began."""
    @property
    def weights(self) -> NDArray[np.float64]:
        """[-] Barycentric, from 0 to 1, sum 1. Shape (3,), a view."""
    @weights.setter
    def weights(self, value: ArrayLike) -> None: ...
    @property
    def point(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @point.setter
    def point(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> SurfacePoint:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SurfacePoint:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def find_closest_on_triangle(
    p: ArrayLike, a: ArrayLike, b: ArrayLike, c: ArrayLike
) -> SurfacePoint:
    """The closest point of one triangle; degenerate triangles are segments or points. Fills
    weights, point and distance.

    Args:
        p: [m] shape (3,)
        a: [m] shape (3,), a corner
        b: [m] shape (3,), a corner
        c: [m] shape (3,), a corner
    """

def find_closest_point(
    tree: AabbTree, x: ArrayLike, p: ArrayLike, max_distance: float = ...
) -> SurfacePoint | None:
    """The closest surface point within max_distance [m], or None.

    Args:
        x: [m] shape (n, 3), positions
        p: [m] shape (3,)
        max_distance: [m]
    """

def find_segment_hit(
    tree: AabbTree, x: ArrayLike, from_: ArrayLike, to: ArrayLike
) -> SurfacePoint | None:
    """The first triangle on the segment from from_ to to, both sides counting; None if it is
    clear. No segment slips between triangles that share an edge.

    Args:
        x: [m] shape (n, 3), positions
        from_: [m] shape (3,)
        to: [m] shape (3,)
    """

def find_ray_hit(
    tree: AabbTree, x: ArrayLike, origin: ArrayLike, direction: ArrayLike
) -> SurfacePoint | None:
    """The first triangle along a ray, or None; direction of any length but zero, distances in
    metres.

    Args:
        x: [m] shape (n, 3), positions
        origin: [m] shape (3,)
        direction: [-] shape (3,), of any length but zero
    """

def find_in_sphere(
    tree: AabbTree, x: ArrayLike, centre: ArrayLike, radius: float, out: NDArray[np.int32]
) -> int:
    """Triangles with a point inside the ball or on it; ascending, written into out, an int32
    array. Returns how many there are; only as many as out holds are written.

    Args:
        x: [m] shape (n, 3), positions
        centre: [m] shape (3,), of the ball
        radius: [m]
        out: triangle indices, shape (k,), int32, C order, written to
    """

def find_near_segment(
    tree: AabbTree,
    x: ArrayLike,
    from_: ArrayLike,
    to: ArrayLike,
    radius: float,
    out: NDArray[np.int32],
) -> int:
    """Triangles whose boxes, grown by radius [m], meet the segment: a superset of those that
    touch the capsule; ascending, written into out, an int32 array. Returns how many there
    are; only as many as out holds are written.

    Args:
        x: [m] shape (n, 3), positions
        from_: [m] shape (3,)
        to: [m] shape (3,)
        radius: [m]
        out: triangle indices, shape (k,), int32, C order, written to
    """

MOST_CAPSULES: int

class Capsule:
    """All points within the tool's radius of a segment, which is given in the tool's frame."""
    def __init__(self, from_: ArrayLike = ..., to: ArrayLike = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def from_(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @from_.setter
    def from_(self, value: ArrayLike) -> None: ...
    @property
    def to(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @to.setter
    def to(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> Capsule:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Capsule:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Jaws:
    """Two jaws on one hinge, which close on what lies between them with a limited force: of a
    tool of two capsules, each of them a jaw where it is closed. The first opens by turning
    about axis, the second the other way.
    """
    def __init__(
        self,
        *,
        hinge: ArrayLike = ...,
        axis: ArrayLike = ...,
        open: float = ...,
        grip: float = ...,
        pad_area: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def hinge(self) -> NDArray[np.float64]:
        """[m] a point of the axis, in the tool's frame. Shape (3,), a view."""
    @hinge.setter
    def hinge(self, value: ArrayLike) -> None: ...
    @property
    def axis(self) -> NDArray[np.float64]:
        """[-] Unit. Shape (3,), a view."""
    @axis.setter
    def axis(self, value: ArrayLike) -> None: ...
    open: float
    """[rad] the farthest that each jaw turns."""
    grip: float
    """[N] that each closes with at most, at the middle of its capsule."""
    pad_area: float
    """[m²] of the side of each that holds."""
    def __copy__(self) -> Jaws:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Jaws:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Tool:
    """What of the instrument touches, never a point: a ball, or a rigid list of capsules."""
    def __init__(
        self,
        *,
        radius: float = ...,
        stiffness: float = ...,
        friction: float = ...,
        capsules: Sequence[Capsule] = ...,
        jaws: Jaws | None = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    radius: float
    """[m]"""
    stiffness: float
    """[N/m³] k_A: pressure per depth of the contact law."""
    friction: float
    """[-] Coulomb's coefficient mu between tip and tissue; 0: it slides."""
    @property
    def capsules(self) -> list[Capsule]:
        """A list of at most MOST_CAPSULES, copied; empty: a ball about the position."""
    @capsules.setter
    def capsules(self, value: Sequence[Capsule]) -> None: ...
    jaws: Jaws | None
    """Of a tool of two capsules, copied; None: what touches is rigid."""
    def __copy__(self) -> Tool:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Tool:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class ToolState:
    """Where the tool is (the paper's ideal tip, IUN) and what it is fastened to."""
    def __init__(
        self, capacity: int = ..., patch_capacity: int = ..., anchor_capacity: int = ...
    ) -> None:
        """Room for so many holds and, with friction, triangles that are touched at once, and
        with jaws, of both.
        """
    class Carrier:
        """The surface nearest to the tool after the last substep; the tool rides on its motion."""
        @property
        def triangle(self) -> int:
            """-1 when nothing is touched."""
        @property
        def weights(self) -> NDArray[np.float64]:
            """[-] Barycentric, of the closest point. Shape (3,), a view."""
        @weights.setter
        def weights(self, value: ArrayLike) -> None: ...
        @property
        def point(self) -> NDArray[np.float64]:
            """[m] where that was. Shape (3,), a view."""
        @point.setter
        def point(self, value: ArrayLike) -> None: ...
        @property
        def direction(self) -> NDArray[np.float64]:
            """[-] Unit, from there to the tool's centre. Shape (3,), a view."""
        @direction.setter
        def direction(self, value: ArrayLike) -> None: ...
        @property
        def body(self) -> int:
            """Whose triangle."""
        def __copy__(self) -> ToolState.Carrier:
            """A copy of its own."""
        def __deepcopy__(self, memo: dict[int, object]) -> ToolState.Carrier:
            """A copy of its own."""
        def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
        def __setstate__(self, arg0: tuple) -> None: ...
        def __repr__(self) -> str:
            """The value on one line."""

    @property
    def position(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    @property
    def orientation(self) -> NDArray[np.float64]:
        """[-] Of the tool's frame: unit quaternion (x, y, z, w), shape (4,); a view."""
    @property
    def torque(self) -> NDArray[np.float64]:
        """[N m] on a tool with capsules about its position, in the last substep. Shape (3,), a
        view.
        """
    @torque.setter
    def torque(self, value: ArrayLike) -> None: ...
    placed: bool
    """False until the first sample has put it somewhere."""
    @property
    def holds(self) -> NDArray[Any]:
        """All holds there is room for, a structured array of shape (capacity,) (triangle,
        weights, stiffness, offset); a view, read-only: attach_tool writes it.
        """
    @property
    def hold_count(self) -> int:
        """0 when nothing is attached."""
    touching: bool
    """Any contact in force in the last substep."""
    @property
    def residual(self) -> NDArray[np.float64]:
        """[N] left between hand and tissue after the last substep. Shape (3,), a view."""
    @residual.setter
    def residual(self, value: ArrayLike) -> None: ...
    @property
    def patch(self) -> NDArray[Any]:
        """What a tool with friction touched in the last substep, all there is room for: a
        structured array of shape (patch_capacity,) (triangle, body, weights, share); a view,
        read-only.
        """
    @property
    def patch_count(self) -> int:
        """How many of them there are."""
    @property
    def patch_position(self) -> NDArray[np.float64]:
        """[m] where the mean of the patch's points was. Shape (3,), a view."""
    @patch_position.setter
    def patch_position(self, value: ArrayLike) -> None: ...
    @property
    def patch_normal(self) -> NDArray[np.float64]:
        """[-] Unit, in which the contacts together push the tool. Shape (3,), a view."""
    @patch_normal.setter
    def patch_normal(self, value: ArrayLike) -> None: ...
    @property
    def friction(self) -> NDArray[np.float64]:
        """[N] on the tool in the last substep. Shape (3,), a view."""
    @friction.setter
    def friction(self, value: ArrayLike) -> None: ...
    @property
    def carrier(self) -> ToolState.Carrier:
        """The surface nearest to the tool."""
    @property
    def jaw_angle(self) -> float:
        """[rad] by which each jaw is open; of a tool with jaws, as what follows."""
    @property
    def jaw_wanted(self) -> float:
        """[rad] by which the hand would have it open."""
    @property
    def grip_limit(self) -> float:
        """[N] up to which it closes now: Jaws.grip, less as it lets go."""
    @property
    def pinch(self) -> float:
        """[N] that each jaw presses with, the mean of both."""
    @property
    def pad_pressure(self) -> float:
        """[Pa] of that on what is touched of a pad."""
    @property
    def carried(self) -> NDArray[np.float64]:
        """[N] on the tool, of all anchors: what it holds up. Shape (3,), a view."""
    @carried.setter
    def carried(self, value: ArrayLike) -> None: ...
    @property
    def felt_before(self) -> NDArray[np.float64]:
        """[N] What was felt in the tick before, for felt_change. Shape (3,), a view."""
    @felt_before.setter
    def felt_before(self, value: ArrayLike) -> None: ...
    @property
    def anchors(self) -> NDArray[Any]:
        """Where tissue sticks to the jaws, all there is room for: a structured array of shape
        (anchor_capacity,) (triangle, body, jaw, weights, place, pressed, stiffness); a view,
        read-only.
        """
    @property
    def turn_limited(self) -> bool:
        """Tissue keeps it from turning as its hand does, in this tick."""
    @property
    def anchor_count(self) -> int:
        """How many of them there are."""
    @property
    def held_load(self) -> float:
        """[N] that they carry, each whatever its direction."""
    @property
    def pinches(self) -> bool:
        """Tissue sticks to both jaws."""
    @property
    def felt_change(self) -> float:
        """[N] by which what is felt may change in this tick, as it lets go; 0: by any."""
    def has_hold(self) -> bool:
        """Something follows the tool: it is fastened, or pinched."""
    def __copy__(self) -> ToolState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> ToolState:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Coupling:
    """The hand's spring: what pulls the tool to where the device is."""
    def __init__(self, *, stiffness: float = ..., force_max: float = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    stiffness: float
    """[N/m] K of Eq 12."""
    force_max: float
    """[N]"""
    def __copy__(self) -> Coupling:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Coupling:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

BARRIER_FLOOR: float
NO_ARM: float
FULL_FACING: float
PARALLEL: float
JAW_SPREAD: float

class Contact:
    """How the tip touches one triangle."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def weights(self) -> NDArray[np.float64]:
        """[-] Barycentric, of the closest point. Shape (3,), a view."""
    @weights.setter
    def weights(self, value: ArrayLike) -> None: ...
    @property
    def direction(self) -> NDArray[np.float64]:
        """[-] Unit, from the closest point to the tool's centre. Shape (3,), a view."""
    @direction.setter
    def direction(self, value: ArrayLike) -> None: ...
    distance: float
    """[m] between the two."""
    force: float
    """[N] along direction on the tool, against it on the tissue."""
    stiffness: float
    """[N/m] d force / d depth."""
    def __copy__(self) -> Contact:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Contact:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def find_contact(
    tool: Tool,
    rest_area: float,
    centre: ArrayLike,
    a: ArrayLike,
    b: ArrayLike,
    c: ArrayLike,
    contact: Contact,
) -> bool:
    """Fills in the contact of a tip at centre with the triangle a, b, c of rest_area [m²];
    False where there is none, or where the centre lies behind the triangle.

    Args:
        rest_area: [m²]
        centre: [m] shape (3,)
        a: [m] shape (3,), a corner
        b: [m] shape (3,), a corner
        c: [m] shape (3,), a corner
    """

def find_capsule_contact(
    tool: Tool,
    rest_area: float,
    from_: ArrayLike,
    to: ArrayLike,
    a: ArrayLike,
    b: ArrayLike,
    c: ArrayLike,
    contact: Contact,
) -> bool:
    """The same of a capsule of the tool whose axis goes from from_ to to [m].

    Args:
        rest_area: [m²]
        from_: [m] shape (3,)
        to: [m] shape (3,)
        a: [m] shape (3,), a corner
        b: [m] shape (3,), a corner
        c: [m] shape (3,), a corner
    """

def compute_point(t: Sequence[int], weights: ArrayLike, x: ArrayLike) -> NDArray[np.float64]:
    """[m] The point of a triangle with these barycentric weights.

    Args:
        t: three vertex indices
        weights: [-] shape (3,), barycentric
        x: [m] shape (n, 3), positions
    """

class NearField:
    """What a body's tissue does near a ball, and what its mesh does of that already: with it a
    ball is felt as on tissue, however large the triangles are. Made by build_near_field.
    """
    @property
    def modulus(self) -> float:
        """[Pa] E / (1 - nu²)."""
    @property
    def wall_thickness(self) -> float:
        """[m] of prisms; 0 of a solid."""
    @property
    def far_compliance(self) -> NDArray[np.float64]:
        """[m/N] per vertex of the surface, shape (n,): of the body beyond that of a half space;
        a view, read-only.
        """
    @property
    def far_tensor(self) -> NDArray[np.float64]:
        """[m/N] the same in every direction (xx, yy, zz, xy, yz, zx), shape (n, 6), where it
        was given, else empty; a view, read-only.
        """
    @property
    def curvature(self) -> NDArray[np.float64]:
        """[1/m] per vertex, shape (n,): of the surface at rest, positive where it is convex; a
        view, read-only.
        """
    @property
    def rest_position(self) -> NDArray[np.float64]:
        """[m] per vertex, shape (n, 3): at rest, where a ball feels how curved facets are, else
        empty; a view, read-only.
        """
    @property
    def first(self) -> NDArray[np.int32]:
        """Of each vertex in neighbour and compliance, shape (n + 1,); a view, read-only."""
    @property
    def neighbour(self) -> NDArray[np.int32]:
        """Vertices around each vertex, ascending, shape (k,); a view, read-only."""
    @property
    def compliance(self) -> NDArray[np.float32]:
        """[m/N] of the mesh, shape (k,): what a vertex moves along its normal under 1 N along
        that of a neighbour; a view, read-only.
        """
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

def build_near_field(
    model: TissueModel, modulus: float, radius: float, far: ArrayLike = ..., facets: bool = ...
) -> NearField:
    """The near field of a model touched by balls of up to radius [m]; modulus [Pa] is E / (1 -
    nu²). Solves for a unit force on each vertex of the surface. far [m/N] is the far
    compliance of each vertex; where it is empty, that of this mesh is found. With facets a
    ball feels how curved those of a solid are. Raises ValueError for numbers that are not
    positive.

    Args:
        modulus: [Pa] E / (1 - nu²) of the tissue
        radius: [m]
        far: [m/N] shape (n, 6): xx, yy, zz, xy, yz, zx per vertex; empty: that of the mesh
    """

CANDIDATE_MARGIN: float

class Candidates:
    """Triangles the tool may touch during one tick, ascending, with the area of each [m²]."""
    def __init__(self, capacity: int = ..., capsules: int = ...) -> None:
        """Room for so many triangles, for each of the capsules of a tool."""
    @property
    def triangles(self) -> NDArray[np.int32]:
        """All there is room for, shape (capacity,); the first count of them hold; a view,
        read-only.
        """
    @property
    def areas(self) -> NDArray[np.float64]:
        """[m²] shape (capacity,), at rest, so that pressing does not change the law; a view."""
    @property
    def count(self) -> int:
        """How many of them there are."""
    @property
    def from_(self) -> NDArray[np.float64]:
        """[m] the path they were looked for along. Shape (3,), a view."""
    @from_.setter
    def from_(self, value: ArrayLike) -> None: ...
    @property
    def to(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @to.setter
    def to(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> Candidates:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Candidates:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def find_candidates(
    tree: AabbTree,
    x: ArrayLike,
    tool: Tool,
    tool_position: ArrayLike,
    hand_position: ArrayLike,
    rest_areas: ArrayLike,
    candidates: Candidates,
    orientation: ArrayLike = ...,
    jaw_angle: float = ...,
) -> None:
    """Finds every triangle within radius + CANDIDATE_MARGIN of the path from the tool's last
    position to where the hand is now, with jaws open by jaw_angle [rad]. rest_areas [m²] per
    triangle of the tissue.

    Args:
        x: [m] shape (n, 3), positions
        tool_position: [m] shape (3,)
        hand_position: [m] shape (3,)
        rest_areas: [m²] shape (t,), per triangle
        orientation: [-] shape (4,), of the tool's frame: unit quaternion (x, y, z, w)
        jaw_angle: [rad] by which each jaw is open
    """

def balance_tool(
    tool: Tool,
    coupling: Coupling,
    hand_position: ArrayLike,
    candidates: Candidates,
    triangles: ArrayLike,
    x: ArrayLike,
    state: ToolState,
    load: Load,
) -> NDArray[np.float64]:
    """Moves the massless tool to where the hand's spring and the tissue's pushes cancel, and
    writes those pushes into load. Returns the force on the hand [N], K (tool - hand),
    limited to force_max: Eq 12.

    Args:
        coupling: [N/m] that a tool may add at any one particle
        hand_position: [m] shape (3,)
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
        x: [m] shape (n, 3), positions
    """

def attach_tool(
    contacts: Load, triangles: ArrayLike, x: ArrayLike, stiffness: float, state: ToolState
) -> bool:
    """Fastens the tool to the patch it touches, shares weighted by contact force; stiffness
    [N/m] in all. Does nothing, and returns False, when it touches nothing.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
        x: [m] shape (n, 3), positions
        stiffness: [N/m]
    """

def release_tool(state: ToolState) -> None:
    """Lets go of what the tool is fastened to."""

def bound_contact_stiffness(
    tool: Tool,
    candidates: Candidates,
    triangles: ArrayLike,
    x: ArrayLike,
    mass: ArrayLike,
    state: ToolState,
    scratch: NDArray[np.float64],
    body: int = ...,
    near: NearField | None = ...,
    coupling: float = ...,
) -> float:
    """Largest extra eigenvalue [1/s²] that contacts and holds may add to M⁻¹K: max over
    particles of sum k_t w / m. scratch holds one number per particle.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
        x: [m] shape (n, 3), positions
        mass: [kg] shape (n,), per particle
        scratch: [-] shape (n,), float64, C order: work space, written to
        coupling: [N/m] that a tool may add at any one particle
    """

class HapticSample:
    """What a device says of the hand: six degrees of freedom in."""
    def __init__(
        self,
        *,
        time: float = ...,
        position: ArrayLike = ...,
        orientation: ArrayLike = ...,
        velocity: ArrayLike = ...,
        buttons: int = ...,
        grip: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    time: float
    """[s] since the run began."""
    @property
    def position(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    @property
    def orientation(self) -> NDArray[np.float64]:
        """[-] Unit quaternion (x, y, z, w), shape (4,); a view."""
    @orientation.setter
    def orientation(self, value: ArrayLike) -> None: ...
    @property
    def velocity(self) -> NDArray[np.float64]:
        """[m/s]; shape (3,), a view."""
    @velocity.setter
    def velocity(self, value: ArrayLike) -> None: ...
    buttons: int
    """Bit 0: attach while held; of a tool with jaws, close them."""
    grip: float
    """[rad] by which a grip axis has closed each jaw, 0: open."""
    dtype: np.dtype[np.void]
    def __copy__(self) -> HapticSample:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> HapticSample:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

ATTACH_BUTTON: int

class HapticCommand:
    """What the device shall make the hand feel: three degrees of freedom out."""
    def __init__(self, force: ArrayLike = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def force(self) -> NDArray[np.float64]:
        """[N]; shape (3,), a view."""
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> HapticCommand:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> HapticCommand:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Felt:
    """What was felt in one tick, of one instrument."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def force(self) -> NDArray[np.float32]:
        """[N] float32, shape (3,), from tick(), before the safety wrapper."""
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> NDArray[np.float32]:
        """[m] float32, shape (3,), the tool."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    touched: int
    """Bit 0: touching, bit 1: attached, bit 2 (NOT_RENDERED): the device's motors were not on,
    so nobody felt the force.
    """
    lateness_us: int
    """[us] saturates."""
    dtype: np.dtype[np.void]
    def __copy__(self) -> Felt:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Felt:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

TOUCHING: int
ATTACHED: int
NOT_RENDERED: int

class EventKind(enum.IntEnum):
    """What may happen at a tick."""

    missed_ticks = 1
    record_gap = 2
    alarm = 3
    fault = 4
    attached = 5
    released = 6
    paused = 7
    tree_exchanged = 8
    motors_off = 9
    motors_on = 10
    safeguard = 11
    passivity = 12
    tissue_exchanged = 13
    coupling_limited = 14
    coupling_follows = 15

class Event:
    """Something that happened at a tick."""
    def __init__(
        self,
        *,
        tick: int = ...,
        kind: EventKind = ...,
        index: int = ...,
        value: float = ...,
        source: int = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    tick: int
    """Its number."""
    kind: EventKind
    """What happened."""
    index: int
    """EventKind says of what."""
    value: float
    """[s] or [-]; EventKind says what."""
    source: int
    """Which body an alarm, tree_exchanged or safeguard is of, or which instrument fault,
    attached, released, motors_off, motors_on, passivity, coupling_limited and
    coupling_follows are; else 0.
    """
    dtype: np.dtype[np.void]
    def __copy__(self) -> Event:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Event:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class StateHash:
    """The world's hash after a tick (compute_hash)."""
    def __init__(self, *, tick: int = ..., hash: Sequence[int] = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    tick: int
    """Its number."""
    @property
    def hash(self) -> list[int]:
        """128 bits as two whole numbers."""
    @hash.setter
    def hash(self, value: Sequence[int]) -> None: ...
    dtype: np.dtype[np.void]
    def __copy__(self) -> StateHash:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> StateHash:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TickLog:
    """Where the haptic thread leaves what it did: rings with room for 4 s, one writer and one
    reader, without lock or allocation. A full ring is a counted gap, never a blocked tick.
    """
    def __init__(self, tick_capacity: int = ..., instruments: int = ...) -> None:
        """Room for so many ticks of so many instruments. Raises ValueError for none, or more
        than MOST_LOGGED_INSTRUMENTS.

        Arguments are the fields of these names, with their shapes and units.
        """
    class Tick:
        """One tick of one instrument as logged."""
        def __init__(
            self, *, tick: int = ..., sample: HapticSample = ..., felt: Felt = ...
        ) -> None:
            """Arguments are the fields of these names, with their shapes and units."""
        tick: int
        """Its number."""
        sample: HapticSample
        """What the device said."""
        felt: Felt
        """What was felt."""
        def __copy__(self) -> TickLog.Tick:
            """A copy of its own."""
        def __deepcopy__(self, memo: dict[int, object]) -> TickLog.Tick:
            """A copy of its own."""
        def __getstate__(self, /) -> tuple[object, object, object]: ...
        def __setstate__(self, arg0: tuple) -> None: ...
        def __repr__(self) -> str:
            """The value on one line."""
        dtype: np.dtype[np.void]

    @overload
    def push(self, tick: TickLog.Tick) -> bool:
        """push(*args, **kwargs)

        For the one writer of a log of one instrument; False, and counted, when there is no
        room.

        A tick of all instruments in order; False also for another number of them.

        Likewise.

        Likewise.
        """
    @overload
    def push(self, ticks: Sequence[TickLog.Tick]) -> bool: ...
    @overload
    def push(self, event: Event) -> bool: ...
    @overload
    def push(self, hash: StateHash) -> bool: ...
    def take(self) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """For the one reader: ticks, events and hashes that have arrived since the last call,
        as structured arrays of shape (k,); ticks of several instruments have a column for
        each.
        """
    def instruments(self) -> int:
        """How many every tick has a row of."""
    def gap_count(self) -> int:
        """How many ticks it had no room for."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

MOST_LOGGED_INSTRUMENTS: int

class BodyCost:
    """What a body cost in one tick, [s]."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def follow(self) -> float:
        """[s] Its tree brought to where its surface is."""
    @property
    def step(self) -> float:
        """[s] All its substeps."""
    @property
    def guard(self) -> float:
        """[s] Checked, and brought up to date."""
    def total(self) -> float:
        """[s] All of these."""
    def __copy__(self) -> BodyCost:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> BodyCost:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class InstrumentCost:
    """What an instrument cost in one tick, [s]."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def read(self) -> float:
        """[s] Hand and button."""
    @property
    def balance(self) -> float:
        """[s] In the air, all substeps."""
    def total(self) -> float:
        """[s] All of these."""
    def __copy__(self) -> InstrumentCost:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> InstrumentCost:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class PairCost:
    """What an instrument cost with a body in one tick, [s]. Where a tool may touch several
    bodies at once it is balanced among all of them, and the time for that is shared out by
    their candidates. Or two bodies, a body and scenery, or rigid bodies with all they touch.
    """
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def candidates(self) -> float:
        """[s] Found in the body's tree."""
    @property
    def contact(self) -> float:
        """[s] The tool balanced against the body, all substeps."""
    def total(self) -> float:
        """[s] All of these."""
    def __copy__(self) -> PairCost:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> PairCost:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TickCosts:
    """What the last tick cost, in the order of the parts of its World; zeros unless it
    measures.
    """
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def bodies(self) -> tuple:
        """A tuple."""
    @property
    def instruments(self) -> tuple:
        """A tuple."""
    @property
    def pairs(self) -> tuple:
        """A tuple."""
    @property
    def body_pairs(self) -> tuple:
        """As Scene.body_pairs, a tuple."""
    @property
    def scenery(self) -> tuple:
        """Bodies that it stops, as World.scenery_contacts, a tuple."""
    @property
    def rigid(self) -> PairCost:
        """All rigid bodies, a PairCost."""
    @property
    def tick(self) -> float:
        """[s] the whole"""
    def __copy__(self) -> TickCosts:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TickCosts:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Percentiles:
    """[s] Right within 0.4 %, the largest exactly."""
    @property
    def median(self) -> float:
        """[s] Half of them are shorter."""
    @property
    def p99(self) -> float:
        """[s] 99 % of them are shorter."""
    @property
    def p99_9(self) -> float:
        """[s] 99.9 % of them are shorter."""
    @property
    def max(self) -> float:
        """[s] The longest."""
    def __copy__(self) -> Percentiles:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Percentiles:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class SceneCosts:
    """What the ticks of a run cost."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def ticks(self) -> int:
        """How many."""
    @property
    def tick(self) -> Percentiles:
        """The whole."""
    @property
    def bodies(self) -> tuple:
        """All stages of each, as Scene.bodies, a tuple."""
    @property
    def instruments(self) -> tuple:
        """As Scene.instruments, a tuple."""
    @property
    def pairs(self) -> tuple:
        """Every instrument with every body, as World.pairs, a tuple."""
    @property
    def body_pairs(self) -> tuple:
        """As Scene.body_pairs, a tuple."""
    @property
    def scenery(self) -> tuple:
        """Bodies that it stops, as World.scenery_contacts, a tuple."""
    @property
    def rigid(self) -> Percentiles:
        """All rigid bodies with what they touch; zeros without any."""
    @property
    def alarm(self) -> Alarm:
        """What ended the run early; false for nothing."""
    def __copy__(self) -> SceneCosts:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SceneCosts:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Kernel(enum.Enum):
    """Which form of the tissue's laws a tick runs."""

    reference = 0
    packed = 1
    response = 2
    automatic = 3

class SoftBody:
    """A tissue and how it is moved."""
    def __init__(
        self,
        *,
        tissue: TissueModel | None = ...,
        substeps: int = ...,
        substeps_max: int = ...,
        force_error: float = ...,
        kernel: Kernel = ...,
        integrator: Integrator = ...,
        simd_target: str = ...,
        contact_modulus: float = ...,
        iterations: int = ...,
        far_compliance: ArrayLike = ...,
        contact_facets: bool = ...,
        tied_holds: bool = ...,
        may_fold: bool = ...,
        weightless: bool = ...,
        tear_stretch: float = ...,
    ) -> None:
        """Copies its tissue.

        Arguments are the fields of these names, with their shapes and units.
        """
    tissue: TissueModel
    """The tissue; assigned, and copied, once."""
    substeps: int
    """Steps per tick without contact; build_scene chooses when 0."""
    substeps_max: int
    """Contact may raise them to this; build_scene chooses when 0."""
    force_error: float
    """[N] by which the force may be wrong so that what is at rest may sleep, under the packed
    kernel; 0: the tissue moves until it is at rest to the last bit.
    """
    kernel: Kernel
    """Which form of the tissue's laws a tick runs; packed is reference where there is no vector
    code for this machine.
    """
    integrator: Integrator
    """How a step goes from one moment to the next; any but symplectic_euler under the reference
    kernel only. An implicit one allocates in every step, and what cannot be solved is an
    alarm.
    """
    iterations: int
    """Of xpbd and projective_dynamics in every step; build_scene chooses when 0, and refuses
    any for another integrator.
    """
    simd_target: str
    """Of the packed kernel: one of simd_targets(), empty for the best."""
    contact_modulus: float
    """[Pa] E / (1 - nu²) of a solid organ: balls are felt as on such tissue, whatever the size
    of its triangles; 0: by the hard law alone.
    """
    contact_facets: bool
    """Of a solid with a contact_modulus: a ball feels how curved the facets under it are; else
    as curved as vertices are on the mean.
    """
    tied_holds: bool
    """Of a body with a contact_modulus: what a tool holds gives way as tissue does under it;
    else as the mesh does where it is fastened.
    """
    tear_stretch: float
    """[-] What an instrument holds tears where it is longer than so many times its length at
    rest for 5 ms, and its force fades over 50 ms [contact: tear]. 0: nothing tears; else
    1.01 to 10, of springs and bonds.
    """
    may_fold: bool
    """Parts of its surface may touch others of it: build_scene adds a BodyPair of it with
    itself.
    """
    weightless: bool
    """Gravity does not act on it: its rest shape is the one that it has under its weight, as of
    an organ that was scanned as it lies.
    """
    @property
    def far_compliance(self) -> NDArray[np.float64]:
        """[m/N] per vertex of the surface, shape (n, 6): how much more the body gives way than
        a half space, solved on a finer mesh than this; empty: that of this mesh, found by
        build_scene. Reads as a read-only copy: assign a new array to change it.
        """
    @far_compliance.setter
    def far_compliance(self, value: ArrayLike) -> None: ...
    @property
    def rest_areas(self) -> NDArray[np.float64]:
        """[m²] per triangle, shape (t,), filled in by build_scene; a view, read-only."""
    @property
    def spectrum_stiffness(self) -> float:
        """[1/s²] largest eigenvalue of M⁻¹K at rest, filled in by build_scene."""
    @property
    def spectrum_damping(self) -> float:
        """[1/s] of M⁻¹C, filled in by build_scene."""
    @property
    def least_damping_time(self) -> float:
        """[s] of C over K, filled in by build_scene for an integrator that needs it."""
    @property
    def damped_limit(self) -> float:
        """[s] the step up to which symplectic Euler with implicit damping is stable at rest,
        filled in by build_scene for that integrator; else 0.
        """
    @property
    def response(self) -> Response:
        """Under the response kernel, filled in by build_scene; else None."""
    @property
    def near_field(self) -> NearField:
        """With a contact_modulus, filled in by build_scene; else None."""
    def __copy__(self) -> SoftBody:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SoftBody:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class BodyPair:
    """Two bodies that may touch, or one that touches itself where it folds, and the barrier
    between their surfaces. Bodies in no common pair pass through each other.
    """
    def __init__(
        self,
        first: int = ...,
        second: int = ...,
        *,
        thickness: float = ...,
        stiffness: float = ...,
        damping: float = ...,
        friction: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def first(self) -> int:
        """Of Scene.bodies."""
    @property
    def second(self) -> int:
        """Another one; the same for a body that may fold."""
    @property
    def thickness(self) -> float:
        """[m] nearer than this, surfaces push each other; build_scene chooses 0.3 to 0.5 mm
        when 0.
        """
    @property
    def stiffness(self) -> float:
        """[N/m³] the pressure over the depth in that thickness; build_scene chooses E / (3
        thickness) when 0, E of the stiffer body.
        """
    @property
    def damping(self) -> float:
        """[-] of critical, of the vertices that touch; 0 to 1."""
    @property
    def friction(self) -> float:
        """[-] Coulomb's coefficient between the surfaces; 0: they slide."""
    def __copy__(self) -> BodyPair:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> BodyPair:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class RigidBody:
    """What moves and keeps its shape, a stone for one. Instruments touch its mesh; tissues,
    scenery and other rigid bodies its spheres, which lie in that.
    """
    def __init__(
        self,
        sphere_centres: ArrayLike,
        sphere_radii: ArrayLike,
        *,
        mass: float = ...,
        inertia: ArrayLike = ...,
        position: ArrayLike = ...,
        orientation: ArrayLike = ...,
        mesh: SurfaceMesh = ...,
        friction: float = ...,
        stiffness: float = ...,
        contact_stiffness: float = ...,
    ) -> None:
        """Copies what it is given.

        Arguments are the fields of these names, with their shapes and units.
        """
    @property
    def mesh(self) -> SurfaceMesh:
        """[m] in its own frame; build_scene makes that of the spheres if empty."""
    @property
    def sphere_centres(self) -> NDArray[np.float64]:
        """[m] in its own frame, whose origin is its centre of mass, shape (k, 3); a view."""
    @property
    def sphere_radii(self) -> NDArray[np.float64]:
        """[m] shape (k,); a view."""
    mass: float
    """[kg]"""
    @property
    def inertia(self) -> NDArray[np.float64]:
        """[kg m²] about the axes of its frame. Shape (3,), a view."""
    @inertia.setter
    def inertia(self, value: ArrayLike) -> None: ...
    @property
    def position(self) -> NDArray[np.float64]:
        """[m] of its frame, at the start. Shape (3,), a view."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    @property
    def orientation(self) -> NDArray[np.float64]:
        """[-] of its frame, at the start: unit quaternion (x, y, z, w), shape (4,); a view."""
    friction: float
    """[-] Coulomb's coefficient on tissue, scenery and other rigid bodies; instruments have
    their own.
    """
    stiffness: float
    """[N/m³] of its spheres on tissue."""
    contact_stiffness: float
    """[N/m] of each sphere on what is hard, and of instruments."""
    def __copy__(self) -> RigidBody:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> RigidBody:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class RigidState:
    """Where a rigid body is and how it moves, after every tick."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def position(self) -> NDArray[np.float64]:
        """[m] of its frame. Shape (3,), a view."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    @property
    def orientation(self) -> NDArray[np.float64]:
        """[-] of its frame: unit quaternion (x, y, z, w), shape (4,); a view."""
    @property
    def velocity(self) -> NDArray[np.float64]:
        """[m/s]; shape (3,), a view."""
    @velocity.setter
    def velocity(self, value: ArrayLike) -> None: ...
    @property
    def angular_velocity(self) -> NDArray[np.float64]:
        """[rad/s]; shape (3,), a view."""
    @angular_velocity.setter
    def angular_velocity(self, value: ArrayLike) -> None: ...
    @property
    def tissue_force(self) -> NDArray[np.float64]:
        """[N] that all tissues push it with, mean of the last tick. Shape (3,), a view."""
    @tissue_force.setter
    def tissue_force(self, value: ArrayLike) -> None: ...
    @property
    def instrument_force(self) -> NDArray[np.float64]:
        """[N] that all instruments push it with, mean of the last tick. Shape (3,), a view."""
    @instrument_force.setter
    def instrument_force(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> RigidState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> RigidState:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Fluid:
    """What rigid bodies are in where nothing else is: water that irrigates, for one."""
    def __init__(self, density: float = ..., viscosity: float = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    density: float
    """[kg/m³] of buoyancy and drag; 0: none."""
    viscosity: float
    """[Pa s] of drag."""
    def __copy__(self) -> Fluid:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Fluid:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Scenery:
    """What never moves, a bone or a table for one. Neither instruments pass it, nor the bodies
    that it lists.
    """
    def __init__(
        self, mesh: SurfaceMesh, bodies: ArrayLike = ..., *, friction: float = ...
    ) -> None:
        """Copies its mesh.

        Arguments are the fields of these names, with their shapes and units.
        """
    @property
    def mesh(self) -> SurfaceMesh:
        """[m] in the scene's frame; read-only."""
    @property
    def bodies(self) -> NDArray[np.int32]:
        """Of Scene.bodies: those that stop at it; others pass through. Shape (k,), a view."""
    friction: float
    """[-] Coulomb's coefficient of these on it; 0: they slide."""
    def __copy__(self) -> Scenery:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Scenery:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

class SceneryContact:
    """How a body of a running scene stops at a scenery, after every tick."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def scenery(self) -> int:
        """Of Scene.scenery."""
    @property
    def body(self) -> int:
        """Of Scene.bodies."""
    @property
    def near(self) -> bool:
        """Some of their surfaces may come to touch."""
    @property
    def touching(self) -> int:
        """Vertices on it, in the body's last step."""
    @property
    def force(self) -> NDArray[np.float64]:
        """[N] on the body, mean of the last tick. Shape (3,), a view."""
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> SceneryContact:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SceneryContact:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Instrument:
    """A tool, and how the hand that moves it is coupled to it."""
    def __init__(
        self,
        *,
        tool: Tool = ...,
        coupling: Coupling = ...,
        hold_stiffness: float = ...,
        trocar: ArrayLike | None = ...,
        pair_friction: Sequence[float] = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    tool: Tool
    """The tip."""
    coupling: Coupling
    """The hand's spring."""
    hold_stiffness: float
    """[N/m] between tool and patch while attached."""
    @property
    def trocar(self) -> NDArray[np.float64] | None:
        """[m] shape (3,): where the shaft, which goes along the tool's z to the hand, passes
        the abdominal wall: z points there from the tool's position, and only the roll is the
        device's. None: the device turns the tool. A copy.
        """
    @trocar.setter
    def trocar(self, value: ArrayLike | None) -> None: ...
    @property
    def pair_friction(self) -> list[float]:
        """[-] Coulomb's coefficient of the tool with each surface of the scene: bodies, then
        scenery, then rigid bodies, in place of tool.friction; empty: that with all. Where
        that is 0, nothing rubs. Assign the whole list.
        """
    @pair_friction.setter
    def pair_friction(self, value: Sequence[float]) -> None: ...
    def __copy__(self) -> Instrument:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Instrument:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Scene:
    """Tissues and the instruments that touch them: all that a tick needs and never changes.
    Each instrument has a hand of its own.
    """
    def __init__(
        self,
        *,
        bodies: Sequence[SoftBody] = ...,
        instruments: Sequence[Instrument] = ...,
        gravity: ArrayLike = ...,
        rate: float = ...,
        rigid: Sequence[RigidBody] = ...,
        scenery: Sequence[Scenery] = ...,
        exchange_rate: float = ...,
        body_pairs: Sequence[BodyPair] = ...,
        fluid: Fluid = ...,
    ) -> None:
        """Copies its parts: one body and one instrument unless others are given. build_scene
        makes it ready for ticks.

        Arguments are the fields of these names, with their shapes and units.
        """
    @property
    def bodies(self) -> tuple:
        """The tissues, a tuple."""
    @property
    def rigid(self) -> tuple:
        """What moves and keeps its shape, a tuple."""
    @property
    def scenery(self) -> tuple:
        """What never moves, a tuple."""
    @property
    def instruments(self) -> tuple:
        """A tuple; each has a hand of its own."""
    @property
    def body_pairs(self) -> tuple:
        """Which bodies may touch each other, a tuple; each pair once."""
    fluid: Fluid
    """What the rigid bodies are in."""
    @property
    def gravity(self) -> NDArray[np.float64]:
        """[m/s²]; shape (3,), a view."""
    @gravity.setter
    def gravity(self, value: ArrayLike) -> None: ...
    rate: float
    """[Hz]"""
    exchange_rate: float
    """[Hz] 0: the live loop ticks the tissue with the hands. Else the tissue ticks in a thread
    of its own, is told where the hands are so often, and is felt between by its local
    stiffness. tick() knows nothing of it.
    """
    def __copy__(self) -> Scene:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Scene:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        list[SoftBody],
        list[Instrument],
        NDArray[np.float64],
        float,
        bool,
        list[RigidBody],
        list[Scenery],
        float,
        list[BodyPair],
        Fluid,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

def make_scene(tissue: TissueModel) -> Scene:
    """A scene of one tissue, which is copied, and one instrument with the usual values."""

def build_scene(scene: Scene) -> Scene:
    """Checks a scene once and fills in what is derived from it. Raises ValueError naming the
    field, what it got and what was expected.
    """

class Safeguard(enum.IntEnum):
    """What a body is stepped by where it would blow up without, each beyond the one before."""

    none = 0
    half_steps = 1
    quarter_steps = 2
    implicit_damping = 3
    implicit_euler = 4

class SoftState:
    """A soft body of a running scene, after every tick."""
    @property
    def tissue(self) -> State:
        """The tissue after the last tick; read-only."""
    @property
    def tree(self) -> AabbTree:
        """The boxes around its surface; read-only."""
    @property
    def load(self) -> Load:
        """What all tools do to the tissue; read-only."""
    @property
    def guard(self) -> Guard:
        """The memory of the alarm; read-only."""
    @property
    def torn_count(self) -> int:
        """Links, or triangles of bonds, that have torn since the start."""
    @property
    def substeps(self) -> int:
        """Of the last tick."""
    @property
    def safeguard(self) -> Safeguard:
        """Of the last tick."""
    @property
    def averted(self) -> Alarm:
        """The last alarm that a safeguard has averted; none so far."""
    @property
    def asleep(self) -> bool:
        """It has come to rest far from every instrument, and ticks leave it out until one comes
        near: no bit of it would change.
        """
    @property
    def skin(self) -> NDArray[np.float64]:
        """[m] the vertices of the skin, shape (n, 3), after every tick; empty where there is
        none; a view.
        """
    def __copy__(self) -> SoftState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SoftState:
        """A copy of its own."""
    def __repr__(self) -> str:
        """What it is, on one line."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class DeviceCoupling:
    """The hand's spring of an instrument whose device bears less of one than the instrument
    has.
    """
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def passive_stiffness(self) -> float:
        """[N/m] Up to which a spring is passive with the device, see find_passive_stiffness; 0,
        or no less than the instrument's own, for none of this: World.bound_coupling.
        """
    @property
    def delay(self) -> float:
        """[s] By which a force is late, T/2 + d: times passive_stiffness the device's damping.
        Likewise.
        """
    @property
    def energy(self) -> float:
        """[J] That the spring may give as it gets stiffer."""
    @property
    def stiffness(self) -> float:
        """[N/m] Of the spring in the last tick."""
    @property
    def tissue(self) -> float:
        """[N/m] As the contact has shown it to be to the tool."""
    @property
    def follows_tissue(self) -> bool:
        """9 tissue is above what is passive, so that the spring follows the tissue."""
    @property
    def way(self) -> float:
        """[m] Of the tool against its force, in this touch."""
    @property
    def mean_way(self) -> float:
        """[m] Lately, as what follows."""
    @property
    def mean_force(self) -> float:
        """[N]"""
    @property
    def way_square(self) -> float:
        """[m²] Variance."""
    @property
    def way_force(self) -> float:
        """[N m] Covariance."""
    @property
    def tool(self) -> NDArray[np.float64]:
        """[m] In the last tick. Shape (3,), a view."""
    @tool.setter
    def tool(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> DeviceCoupling:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> DeviceCoupling:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class InstrumentState:
    """An instrument of a running scene, and the hand that moves it."""
    @property
    def tool(self) -> ToolState:
        """Where the tool is; read-only."""
    @property
    def attach_pressed(self) -> bool:
        """Whether the attach button was, in the last tick."""
    @property
    def opens(self) -> bool:
        """Its jaws open by themselves, until the hand has."""
    @property
    def release_ticks(self) -> int:
        """Left until a hold that fades is gone; 0 when none does."""
    @property
    def device(self) -> DeviceCoupling:
        """A DeviceCoupling: off unless its device needs it."""
    @property
    def hand(self) -> NDArray[np.float64]:
        """[m] where the tool is drawn to: the hand, unless that jumped. Shape (3,), a view."""
    @hand.setter
    def hand(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> InstrumentState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> InstrumentState:
        """A copy of its own."""
    def __repr__(self) -> str:
        """What it is, on one line."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class ContactPair:
    """What an instrument may touch of a body, and what it does to it."""
    @property
    def candidates(self) -> Candidates:
        """What the tool may touch in this tick; read-only."""
    @property
    def load(self) -> Load:
        """What the tool did in the last substep; read-only."""
    def __copy__(self) -> ContactPair:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> ContactPair:
        """A copy of its own."""
    def __repr__(self) -> str:
        """What it is, on one line."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class BodyPairState:
    """How two bodies of a running scene touch, after every tick."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def near(self) -> bool:
        """Some of their surfaces may come to touch."""
    @property
    def touching(self) -> int:
        """Vertices and middles of long edges within the thickness, in the last substep."""
    @property
    def least_gap(self) -> float:
        """[m] between the surfaces where they were nearest in the last tick, below 0 inside of
        each other; infinite where nothing was within the thickness.
        """
    @property
    def force(self) -> NDArray[np.float64]:
        """[N] on the second body, mean of the last tick; 0 of a body with itself. Shape (3,), a
        view.
        """
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> BodyPairState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> BodyPairState:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class World:
    """A running scene. Everything a tick needs is allocated here, once."""
    def __init__(self, scene: Scene, *, recovers: bool = ...) -> None:
        """The scene at rest.

        Arguments are the fields of these names, with their shapes and units.
        """
    @property
    def bodies(self) -> tuple:
        """As Scene.bodies, a tuple; read-only."""
    @property
    def rigid(self) -> tuple:
        """As Scene.rigid, a tuple."""
    @property
    def instruments(self) -> tuple:
        """As Scene.instruments, a tuple; read-only."""
    @property
    def pairs(self) -> tuple:
        """Every instrument with every body, a tuple; read-only."""
    @property
    def body_pairs(self) -> tuple:
        """As Scene.body_pairs, a tuple; read-only."""
    @property
    def scenery_contacts(self) -> tuple:
        """As Scene.scenery, one for each body that it lists, a tuple; read-only."""
    def bound_coupling(self, instrument: int, passive_stiffness: float, delay: float) -> None:
        """Has an instrument felt through a device that bears no more of a spring, as a live run
        has it. Before the first tick; raises ValueError after it.

        Args:
            instrument: Which, from 0.
            passive_stiffness: [N/m] See find_passive_stiffness; 0 for the instrument's own.
            delay: [s] By which a force is late, T/2 + d.
        """
    def pair(self, instrument: int, body: int) -> object:
        """An instrument with a body; read-only."""
    @property
    def alarm(self) -> Alarm:
        """The first alarm; from then on the forces fade and all tissue stands still."""
    @property
    def alarm_body(self) -> int:
        """Whose tissue raised it; -1 for what is of no body."""
    @property
    def tick_count(self) -> int:
        """How many ticks have been run."""
    @property
    def recovers(self) -> bool:
        """Whether a tick in which a body blows up is done again, from where it began, under the
        body's next safeguard, before its alarm stands. What judges a scene as it is asks for
        none of it.
        """
    @property
    def measures_costs(self) -> bool:
        """Whether tick() keeps costs: forces are the same to the bit with and without, and a
        tick takes some microseconds more.
        """
    @property
    def costs(self) -> TickCosts:
        """Of the last tick; read-only."""
    def __copy__(self) -> World:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> World:
        """A copy of its own."""
    def __repr__(self) -> str:
        """What it is, on one line."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

def surface_position(body: object) -> NDArray[np.float64]:
    """[m] The vertices of the surface, shape (n, 3): the skin's, or the particles where there
    is none; a view, read-only.
    """

@overload
def tick(scene: Scene, sample: HapticSample, dt: float, world: World) -> HapticCommand:
    """tick(*args, **kwargs)

    One haptic tick of dt [s]: from where the hand is to the force it must feel, the mean
    over the substeps. The live loop, the replay of a record and the tests all call this
    function.

    One haptic tick with a sample and a command for each instrument.

    Args:
        dt: [s]
        samples: a structured array with the fields of HapticSample, shape (k,), or a list of
            these
    """

@overload
def tick(
    scene: Scene, samples: Sequence[HapticSample], dt: float, world: World
) -> list[HapticCommand]: ...
def compute_felt(command: HapticCommand, world: World, instrument: int = ...) -> Felt:
    """What a record keeps of a tick, lateness left at 0; command is that of the instrument."""

def measure_costs(scene: Scene, samples: Sequence[HapticSample]) -> SceneCosts:
    """Runs a scene as fast as the machine can, in the calling thread, from rest through
    samples: for every tick one of each instrument. An alarm ends it. Raises ValueError for
    samples that are not some of each instrument.

    Args:
        samples: a structured array with the fields of HapticSample, shape (k,), or a list of
            these
    """

def compute_hash(world: World) -> list[int]:
    """128 bits over positions, velocities and the tool: equal worlds, equal hashes."""

def place_tool(
    tree: AabbTree, x: ArrayLike, hand_position: ArrayLike, radius: float, tool: ToolState
) -> bool:
    """Puts a tool that is nowhere yet where the hand is, and returns whether it is in the
    scene. A hand that begins inside the tissue has no tool until it has come out, and as far
    as three quarters of the tool's radius [m].

    Args:
        x: [m] shape (n, 3), positions
        hand_position: [m] shape (3,)
        radius: [m]
    """

@overload
def has_room(tree: AabbTree, x: ArrayLike, hand_position: ArrayLike, radius: float) -> bool:
    """has_room(*args, **kwargs)

    Whether place_tool would put a tool there.

    The same for a tool of any shape that is held so, with jaws open by jaw_angle [rad].

    Args:
        x: [m] shape (n, 3), positions
        hand_position: [m] shape (3,)
        radius: [m]
        orientation: [-] shape (4,), of the tool's frame: unit quaternion (x, y, z, w)
        jaw_angle: [rad] by which each jaw is open
    """

@overload
def has_room(
    tree: AabbTree,
    x: ArrayLike,
    hand_position: ArrayLike,
    tool: Tool,
    orientation: ArrayLike,
    jaw_angle: float = ...,
) -> bool: ...
def compute_winding_number(triangles: ArrayLike, x: ArrayLike, p: ArrayLike) -> float:
    """[-] How often the surface goes round p: 1 inside of a closed surface, 0 outside, and for
    an open one the share of all directions from p that it covers.

    Args:
        triangles: vertex indices, shape (t, 3), counter-clockwise from outside
        x: [m] shape (n, 3), positions
        p: [m] shape (3,)
    """

class MotorState(enum.Enum):
    """Whether a device makes the hand feel the force that it is sent."""

    on = 0
    silent = 1
    off = 2
    cut = 3

class DeviceDynamics:
    """What a device declares of itself, from which follows how stiff what is felt through it
    may be.
    """
    def __init__(
        self, *, damping: float = ..., delay: float = ..., position_source: bool = ...
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    damping: float
    """[N·s/m] The least that the hand always feels of it; 0: none declared."""
    delay: float
    """[s] From a hand to the force that answers it, holding not included."""
    position_source: bool
    """No force moves its hand: a script, a record, a mouse."""
    def __copy__(self) -> DeviceDynamics:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> DeviceDynamics:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def find_passive_stiffness(dynamics: DeviceDynamics, period: float) -> float:
    """[N/m] Up to which a spring that is told every period [s] calms the hand, b / (T/2 + d)
    [Colgate97]; 0 where no damping is declared.

    Args:
        dynamics: What the device declares.
        period: [s] From one force to the next.
    """

COUPLING_SHARE: float

def fit_coupling(coupling: float, passive: float, tissue: float) -> float:
    """[N/m] The hand's spring before a tissue, with a device that bears less than the
    instrument's own: never softer than is passive, as stiff as lets nine tenths of the
    tissue be felt, and no stiffer than leaves what is felt, k K / (k + K), passive.

    Args:
        coupling: [N/m] The instrument's own.
        passive: [N/m] That the device keeps passive.
        tissue: [N/m] Of the tissue, to the tool.

    Args:
        coupling: [N/m] that a tool may add at any one particle
    """

class HapticDevice:
    """A haptic device, real or simulated. read and write belong to the haptic thread, which
    Python never enters: to write a device in Python, hand its driver to a PythonDevice.
    """
    def read(self, time: float) -> HapticSample:
        """The hand at time [s] since the run began; devices with a clock of their own may
        ignore it.

        Args:
            time: [s] since the run began
        """
    def write(self, command: HapticCommand) -> None:
        """The force the device shall make the hand feel."""
    def end(self) -> None:
        """A run is over: motors off, until the next write. The live loop calls it at its end."""
    def rest(self, seconds: float) -> None:
        """The run is paused and its time stands still: no force, and so many [s] of the world's
        time have passed since the last call.

        Args:
            seconds: [s]
        """
    def dynamics(self) -> DeviceDynamics:
        """What it declares of itself. Asked for at the start of a run, not while it is on."""
    def motors(self) -> MotorState:
        """Whether the hand feels what is written now."""
    def explain_fault(self) -> str:
        """Why the motors are cut, or the device has failed, and what to do; empty where it
        cannot tell.
        """
    def name(self) -> str:
        """What it is called in reports."""
    def failed(self) -> bool:
        """True once the device is gone for good: what it says and is told no longer counts."""
    def report_rate(self) -> float:
        """[Hz] of the reports that can be waited for, 0 where the device has no clock of its
        own. Where it is that of the ticks, the live loop ticks when a report has come.
        """
    def wait_for_report(self, latest: int) -> bool:
        """Waits for a report that read has not seen, until latest [ns of the monotonic clock]
        at most. False if none came.

        Args:
            latest: [ns] of the monotonic clock
        """
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class SafetyLimits:
    """What a device may be sent. The defaults suit a device that nothing can hurt; a real one
    is given its own, as find_safety_limits does for the low-cost arm.
    """
    def __init__(
        self,
        *,
        force_max: float = ...,
        force_continuous: float = ...,
        heat_time: float = ...,
        slew_max: float = ...,
        ramp_time: float = ...,
        start_force_max: float = ...,
        velocity_max: float = ...,
        brake: float = ...,
        energy_max: float = ...,
        damping_max: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    force_max: float
    """[N] norm, at any moment."""
    force_continuous: float
    """[N] root mean square that the motors stand for ever."""
    heat_time: float
    """[s] in which they warm up."""
    slew_max: float
    """[N/s]"""
    ramp_time: float
    """[s] from the first command, or the first after a rest, to full force."""
    start_force_max: float
    """[N] no force at all before one as small as this was asked for."""
    velocity_max: float
    """[m/s] of the hand; beyond it forces only brake."""
    brake: float
    """[N·s/m] on what is faster."""
    energy_max: float
    """[J] the hand may be given more than it gave; then damping."""
    damping_max: float
    """[N·s/m] that the passivity controller may add."""
    def __copy__(self) -> SafetyLimits:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SafetyLimits:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class DeviceFault(enum.Enum):
    """Why a device is sent no force any more."""

    none = 0
    sample_not_finite = 1
    force_not_finite = 2
    device_failed = 3
    sample_out_of_reach = 4
    sample_too_fast = 5
    motors_cut = 6

class SafeDevice(HapticDevice):
    """Stands between the tick and any device. What passes is finite, gives the hand no energy
    it did not put in, never pushes a hand that is too fast, is limited in norm, moment by
    moment and on the whole, fades in at the start, and changes no faster than the slew
    limit. The first fault latches.
    """
    def __init__(self, device: HapticDevice, limits: SafetyLimits = ...) -> None:
        """Raises ValueError for limits that are not positive."""
    def set_tool(self, position: ArrayLike) -> None:
        """Where the tool is that the force of the next command draws the hand to; until this is
        told, at the hand. By it is judged how much of what the hand put in it may get back.
        A place that is not finite is passed over.

        Args:
            position: [m] shape (3,).
        """
    def rest(self, seconds: float = ...) -> None:
        """A zero force at once, past the slew limit; the next command fades in as the first one
        did. So many [s] have passed in a pause.

        Args:
            seconds: [s]
        """
    def fault(self) -> DeviceFault:
        """The first fault; none for none."""
    def fault_value(self) -> float:
        """What the fault found: [m] or [m/s], 0 for a fault without a value."""
    def sent(self) -> HapticCommand:
        """What was really sent last; nothing while the motors are not on."""
    def limited_count(self) -> int:
        """How often a limit had to act."""
    def damped_count(self) -> int:
        """How often the passivity controller had to."""
    def given_energy(self) -> float:
        """[J] that the hand has been given since it last felt nothing, fading within a second."""
    def heat(self) -> float:
        """[-] Of what the motors stand for ever, 0 to 1."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

def describe_fault(fault: DeviceFault, value: float, device: HapticDevice) -> str:
    """One sentence without a stop. value is what the fault found, [m] or [m/s] where it has
    one; what the motors are cut for, or why the device failed, the device says.

    Args:
        value: [m] or [m/s] that the fault found
    """

class DeviceCheck:
    """One thing a device owes, and whether it keeps it."""
    @property
    def name(self) -> str:
        """What is owed, as a sentence."""
    @property
    def passed(self) -> bool:
        """Whether the device keeps it."""
    @property
    def detail(self) -> str:
        """What was found."""
    def __copy__(self) -> DeviceCheck:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> DeviceCheck:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class ConformanceOptions:
    """How a device is checked."""
    def __init__(
        self, *, duration: float = ..., rate: float = ..., force: float = ..., live: bool = ...
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    duration: float
    """[s] of each part; a real hand should move the device meanwhile."""
    rate: float
    """[Hz]"""
    force: float
    """[N] of the pushes."""
    live: bool
    """Wait for the clock between ticks, as a device in real time needs."""
    def __copy__(self) -> ConformanceOptions:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> ConformanceOptions:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def check_conformance(device: HapticDevice, options: ConformanceOptions = ...) -> list[DeviceCheck]:
    """What any HapticDevice has to keep, ours or another maker's, before a person holds it. The
    device is pushed gently. Raises ValueError; Ctrl-C ends it.
    """

class DeviceTask:
    """What the hand shall feel where there is no tissue: a force, and a spring to a place."""
    def __init__(
        self, *, force: ArrayLike = ..., stiffness: float = ..., rest: ArrayLike = ...
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def force(self) -> NDArray[np.float64]:
        """[N]; shape (3,), a view."""
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    stiffness: float
    """[N/m] 0 for no spring."""
    @property
    def rest(self) -> NDArray[np.float64]:
        """[m] where the spring draws to. Shape (3,), a view."""
    @rest.setter
    def rest(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> DeviceTask:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> DeviceTask:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class DeviceLoop:
    """Keeps a device company at 1 kHz without a tissue: F = force + stiffness (rest - x),
    through a SafeDevice. Either in a thread of its own, by the clock; or, for a simulated
    device, as fast as the machine can.
    """
    def __init__(self, device: HapticDevice, limits: SafetyLimits = ...) -> None:
        """Raises ValueError as SafeDevice does."""
    def start(self) -> None:
        """Raises RuntimeError while it runs; may be started again once stopped."""
    def stop(self) -> None:
        """Asks and waits; the device gets a zero force last."""
    def running(self) -> bool:
        """Whether its own thread runs."""
    def run(self, seconds: float) -> None:
        """Ticks for so many [s] in this thread, without waiting; Ctrl-C ends it. Raises
        RuntimeError while the loop's own thread runs, ValueError for no time or more than a
        day.

        Args:
            seconds: [s]
        """
    def set_task(self, task: DeviceTask) -> None:
        """One calling thread: felt from the next tick on. Raises ValueError."""
    def fall_silent(self, seconds: float) -> None:
        """From any thread: the device hears nothing for so many [s], as if the host had died.

        Args:
            seconds: [s]
        """
    def time(self) -> float:
        """[s] that the loop has run."""
    def missed_ticks(self) -> int:
        """Skipped so far."""
    def fault(self) -> DeviceFault:
        """The first fault; none for none."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class KeyFrame:
    """One moment of a script; between key frames the hand moves smoothly (minimum jerk),
    buttons hold from their frame on.
    """
    def __init__(self, time: float = ..., position: ArrayLike = ..., buttons: int = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    time: float
    """[s], ascending."""
    @property
    def position(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    buttons: int
    """Bit 0: attach while held."""
    def __copy__(self) -> KeyFrame:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> KeyFrame:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class ScriptedDevice(HapticDevice):
    """A hand that follows a script, the same in every run."""
    def __init__(self, frames: Sequence[KeyFrame]) -> None:
        """Raises ValueError for no frames, times that do not ascend, or non-finite numbers.

        Args:
            frames: the key frames of the script, in order
        """
    def duration(self) -> float:
        """[s]"""
    @property
    def last_command(self) -> HapticCommand:
        """The force it was last sent."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class Fulcrum:
    """A shaft through a trocar: where its tip is when its handle is held, and the other way
    round.
    """
    def __init__(self, trocar: ArrayLike = ..., length: float = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def trocar(self) -> NDArray[np.float64]:
        """[m] where the shaft passes the abdominal wall. Shape (3,), a view."""
    @trocar.setter
    def trocar(self, value: ArrayLike) -> None: ...
    length: float
    """[m] from the tip to the handle, positive."""
    def __copy__(self) -> Fulcrum:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Fulcrum:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def compute_fulcrum_tip(fulcrum: Fulcrum, handle: ArrayLike) -> NDArray[np.float64]:
    """[m] The tip of a shaft whose handle is there, shape (3,); never nearer than 5 mm to the
    trocar, on the side away from the handle.

    Args:
        fulcrum: Trocar and length of the shaft.
        handle: [m] shape (3,).
    """

def compute_fulcrum_handle(fulcrum: Fulcrum, tip: ArrayLike) -> NDArray[np.float64]:
    """[m] The handle of a shaft whose tip is there, shape (3,); likewise.

    Args:
        fulcrum: Trocar and length of the shaft.
        tip: [m] shape (3,).

    Args:
        tip: [m] shape (3,)
    """

def carry_force(fulcrum: Fulcrum, handle: ArrayLike, f: ArrayLike) -> NDArray[np.float64]:
    """[N] On the handle of what pushes the tip by f, shape (3,), by virtual work. Across the
    shaft no more of it is felt than leaves the handle as stiff as the tip is.

    Args:
        fulcrum: Trocar and length of the shaft.
        handle: [m] shape (3,), where it is.
        f: [N] shape (3,).

    Args:
        f: [N] shape (n, 3), float64, C order, written to
    """

class FulcrumDevice(HapticDevice):
    """Stands between a device that is the handle of an instrument and what wants to know of its
    tip.
    """
    def __init__(self, handle: HapticDevice, fulcrum: Fulcrum) -> None:
        """Raises ValueError for a trocar that is not finite or a length that is not positive."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class MailboxDevice(HapticDevice):
    """A hand that another thread tells of as often as it can, and that takes the newest force
    from here; PythonDevice is one with a thread of its own. Outside of real time: what is
    felt is late by as long as that thread takes. Where no sample comes for 20 ms the force
    is taken back until one does; after a second the motors count as cut.
    """
    def __init__(self, title: str) -> None:
        """What it is called in reports."""
    def tell(self, sample: HapticSample) -> None:
        """The other thread: where the hand is now. time is filled in by read()."""
    def take_command(self) -> HapticCommand:
        """The same thread: the newest force."""
    def fail(self, reason: str) -> None:
        """From any thread: the device is gone for good, and why; the first reason counts."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class ScenePart(enum.Enum):
    """What of a scene a surface is of."""

    body = 0
    scenery = 1
    rigid = 2

class ScenePoint:
    """A point of a surface of a scene."""
    @property
    def part(self) -> ScenePart:
        """What it is of."""
    @property
    def index(self) -> int:
        """Of that kind."""
    @property
    def triangle(self) -> int:
        """Row of its surface."""
    @property
    def distance(self) -> float:
        """[m] from where the query began."""
    @property
    def point(self) -> NDArray[np.float64]:
        """[m] shape (3,). Shape (3,), a view."""
    @point.setter
    def point(self, value: ArrayLike) -> None: ...
    @property
    def normal(self) -> NDArray[np.float64]:
        """[-] Unit, smooth, outward, shape (3,). Shape (3,), a view."""
    @normal.setter
    def normal(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> ScenePoint:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> ScenePoint:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class SceneSurfaces:
    """All that a hand may meet in a scene: bodies and scenery at rest, and rigid bodies where
    they were placed last, at first where the scene has them.
    """
    def __init__(self, scene: Scene) -> None:
        """The scene need not outlive it."""
    def place_rigid(self, index: int, position: ArrayLike, orientation: ArrayLike) -> None:
        """Where a rigid body is now. Raises ValueError.

        Args:
            index: Of the scene's rigid bodies.
            position: [m] shape (3,).
            orientation: [-] a unit quaternion, shape (4,): x, y, z, w.

        Args:
            orientation: [-] shape (4,), of the tool's frame: unit quaternion (x, y, z, w)
        """
    def rigid_count(self) -> int:
        """How many rigid bodies there are."""
    def find_ray_hit(self, origin: ArrayLike, direction: ArrayLike) -> ScenePoint | None:
        """The first surface along a ray; None where the ray meets that from inside, as nothing
        behind it is in sight.

        Args:
            origin: [m] shape (3,)
            direction: [-] shape (3,), of any length but zero
        """
    def find_closest_point(self, p: ArrayLike, rigid: int = ...) -> ScenePoint | None:
        """The nearest point of bodies, scenery and one rigid body, or none of them for -1.

        Args:
            p: [m] shape (3,)
        """
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class PointerPath(enum.Enum):
    """How a hand gets to its goal."""

    along = 0
    around = 1
    straight = 2

class PointerTarget:
    """What a window wants of the hand."""
    def __init__(
        self,
        *,
        time: float = ...,
        goal: ArrayLike = ...,
        depth: float = ...,
        path: PointerPath = ...,
        pressing: bool = ...,
        buttons: int = ...,
        orientation: ArrayLike = ...,
        rigid: int = ...,
        rigid_position: ArrayLike = ...,
        rigid_orientation: ArrayLike = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    time: float
    """[s] of the event that led to it, by the window's clock."""
    @property
    def goal(self) -> NDArray[np.float64]:
        """[m], shape (3,), a point of the surface at rest, or beside it. Shape (3,), a view."""
    @goal.setter
    def goal(self, value: ArrayLike) -> None: ...
    depth: float
    """[m] of the tip below the goal; negative above it."""
    path: PointerPath
    """How the hand goes there."""
    pressing: bool
    """A button is down: the hand presses for as long as it was."""
    buttons: int
    """Of the sample, once the tip has been where it began for a moment."""
    @property
    def orientation(self) -> NDArray[np.float64]:
        """[-] Of the sample, at 3 rad/s at most: unit quaternion (x, y, z, w), shape (4,); a
        view.
        """
    @orientation.setter
    def orientation(self, value: ArrayLike) -> None: ...
    rigid: int
    """The rigid body that the goal is of, and where it is now; -1: of none."""
    @property
    def rigid_position(self) -> NDArray[np.float64]:
        """[m] of its frame, shape (3,). Shape (3,), a view."""
    @rigid_position.setter
    def rigid_position(self, value: ArrayLike) -> None: ...
    @property
    def rigid_orientation(self) -> NDArray[np.float64]:
        """[-] Of its frame: unit quaternion (x, y, z, w), shape (4,); a view."""
    @rigid_orientation.setter
    def rigid_orientation(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> PointerTarget:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> PointerTarget:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class SurfacePointer(HapticDevice):
    """A hand that a window moves over a surface: post() from one thread, read() from the haptic
    thread, which moves the hand. How often the window finds time to post makes no difference
    to what is felt: the hand goes over the surfaces of bodies and scenery at rest, and of
    the rigid body that a target names, at 250 mm/s at most and into them at 50 mm/s, and a
    press that was over before it was heard of lasts as long as the window says.
    """
    def __init__(self, scene: Scene, body: int = ..., instrument: int = ...) -> None:
        """Surfaces and tool are those of a scene; the hand begins over a body."""
    def post(self, target: PointerTarget) -> None:
        """One calling thread. Raises ValueError for a number that is not finite, an orientation
        not of norm 1 and a rigid body that the scene does not have.
        """
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class PointerDevice(HapticDevice):
    """A hand that a window moves: set() from one thread, read() from the haptic thread. Between
    two positions the hand glides, never faster than 1 m/s; the first is taken at once.
    """
    def __init__(self) -> None:
        """A hand that is nowhere yet."""
    def set(self, sample: HapticSample) -> None:
        """One calling thread; time and velocity are filled in by read()."""
    def take_command(self) -> HapticCommand:
        """The newest force, for the same thread as set()."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class ReplayDevice(HapticDevice):
    """A hand read back from a record, one sample per call, whatever the time; the last one
    stays.
    """
    def __init__(self, samples: object) -> None:
        """Takes a structured array as of Record.hand or a list of HapticSample. Raises
        ValueError for no samples.

        Args:
            samples: a structured array with the fields of HapticSample, shape (k,), or a
                list of these
        """
    def finished(self) -> bool:
        """Whether every sample has been read."""
    @property
    def last_command(self) -> HapticCommand:
        """The force it was last sent."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class Arm:
    """The arm of the low-cost device: two links in a plane that yaws about the upright axis,
    all three motors on the ground. Joints [rad]: yaw, positive to the right; elevation of
    the upper link; the forearm's own angle from straight down. Frame: x to the right, y away
    from the user, z up.
    """
    def __init__(
        self,
        *,
        upper_length: float = ...,
        forearm_length: float = ...,
        upper_weight: float = ...,
        forearm_weight: float = ...,
        joint_min: ArrayLike = ...,
        joint_max: ArrayLike = ...,
        bend_max: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    upper_length: float
    """[m]"""
    forearm_length: float
    """[m]"""
    upper_weight: float
    """[N·m] that carries the arm when the upper link is level."""
    forearm_weight: float
    """[N·m] that carries it when the forearm is level."""
    @property
    def joint_min(self) -> NDArray[np.float64]:
        """[rad]; shape (3,), a view."""
    @joint_min.setter
    def joint_min(self, value: ArrayLike) -> None: ...
    @property
    def joint_max(self) -> NDArray[np.float64]:
        """[rad]; shape (3,), a view."""
    @joint_max.setter
    def joint_max(self, value: ArrayLike) -> None: ...
    bend_max: float
    """[rad] between upper link and forearm, 0 at a right angle."""
    def __copy__(self) -> Arm:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Arm:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Workspace:
    """A box that lies within the workspace."""
    def __init__(self, center: ArrayLike = ..., size: ArrayLike = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def center(self) -> NDArray[np.float64]:
        """[m] in the arm's frame. Shape (3,), a view."""
    @center.setter
    def center(self, value: ArrayLike) -> None: ...
    @property
    def size(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @size.setter
    def size(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> Workspace:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Workspace:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def compute_tip(arm: Arm, joints: ArrayLike) -> NDArray[np.float64]:
    """Where the tip is [m], shape (3,).

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
    """

def compute_stylus(joints: ArrayLike, gimbal: ArrayLike) -> NDArray[np.float64]:
    """[-] How the stylus is held, a quaternion (x, y, z, w), shape (4,): three gimbal angles
    [rad] (yaw, pitch, roll) after yaw and forearm.

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
        gimbal: [rad] shape (3,)
    """

def compute_jacobian(arm: Arm, joints: ArrayLike) -> NDArray[np.float64]:
    """How the tip moves with the joints [m/rad], shape (3, 3), one column per joint.

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
    """

def find_joints(arm: Arm, tip: ArrayLike) -> NDArray[np.float64] | None:
    """The joints [rad], shape (3,), that bring the tip to a place [m]; None where it is out of
    reach or on the yaw axis. They may lie beyond the joints' limits: is_within tells.

    Args:
        tip: [m] shape (3,)
    """

def is_within(arm: Arm, joints: ArrayLike) -> bool:
    """Whether every joint is within its limits, and the links are bent enough to push every
    way.

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
    """

def compute_edge_fade(arm: Arm, joints: ArrayLike) -> float:
    """[-] 1 in the workspace, fading to 0 over the last 3 degrees before its edge, 0 beyond.

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
    """

def compute_weight_torque(arm: Arm, joints: ArrayLike) -> NDArray[np.float64]:
    """The torques [N·m], shape (3,), that hold the arm up against its weight.

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
    """

def compute_torque(
    arm: Arm, joints: ArrayLike, force: ArrayLike, torque_max: ArrayLike
) -> NDArray[np.float64]:
    """The torques [N·m], shape (3,), that let the hand feel a force [N] while the arm's weight
    is carried, none beyond torque_max. Too large a force loses length, never direction.

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
        force: [N] shape (3,)
        torque_max: [N·m] shape (3,), of each motor
    """

def compute_tip_force(arm: Arm, joints: ArrayLike, torque: ArrayLike) -> NDArray[np.float64]:
    """The inverse: what the hand feels of torques [N·m] when the arm rests. Needs a bent arm.

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
        torque: [N·m] shape (3,)
    """

class VelocityWindow:
    """The speed of something that is known in steps, from a window that adapts itself: as many
    of the last readings as one straight line passes within a step of.
    """
    def __init__(self, step: float, longest: int = ...) -> None:
        """step is how far apart two neighbouring readings are, in their unit; longest from 2
        readings to LONGEST. Raises ValueError.

        Args:
            step: between two neighbouring readings, [-] in their unit
        """
    def add(self, time: float, value: float) -> float:
        """Takes a reading at time [s] and returns its speed, per second; 0 for the first. The
        same time again is ignored, an earlier one starts again.

        Args:
            time: [s] since the run began
            value: the reading, [-] in its own unit
        """
    def speed(self) -> float:
        """[1/s] times the unit of the readings: the speed last found."""
    def length(self) -> int:
        """How many readings the last speed came from."""
    def clear(self) -> None:
        """Forgets all readings."""
    LONGEST: int
    def __copy__(self) -> VelocityWindow:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> VelocityWindow:
        """A copy of its own."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class ArmMasses:
    """The masses of the arm's parts."""
    def __init__(
        self,
        *,
        upper: float = ...,
        forearm: float = ...,
        gimbal: float = ...,
        motor: float = ...,
        balance: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    upper: float
    """[kg] a rod, heavy in its middle."""
    forearm: float
    """[kg] likewise."""
    gimbal: float
    """[kg] at the tip."""
    motor: float
    """[kg·m²] of each motor, seen from its joint."""
    balance: float
    """[-] 0 to 1: how much of the weight springs or counterweights carry."""
    def __copy__(self) -> ArmMasses:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> ArmMasses:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Motor:
    """One brushed motor under a voltage, behind a capstan."""
    def __init__(
        self,
        *,
        supply: float = ...,
        resistance: float = ...,
        torque_constant: float = ...,
        gear: float = ...,
        efficiency: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    supply: float
    """[V]"""
    resistance: float
    """[Ohm]"""
    torque_constant: float
    """[N·m/A], and [V·s/rad]."""
    gear: float
    """[-] Motor turns per joint turn."""
    efficiency: float
    """[-] 0 to 1."""
    def __copy__(self) -> Motor:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Motor:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Hand:
    """The hand that holds the stylus: a mass, drawn by spring and damper to where it wants to
    be.
    """
    def __init__(self, *, mass: float = ..., stiffness: float = ..., damping: float = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    mass: float
    """[kg]"""
    stiffness: float
    """[N/m]"""
    damping: float
    """[N·s/m]"""
    def __copy__(self) -> Hand:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Hand:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Plant:
    """What a real arm does to what it is told, and to what it says: everything of the device
    that is not firmware, in numbers. Nothing in it is left to chance: noise comes from the
    seed.
    """
    def __init__(self) -> None:
        """Every field at its first value."""
    upper_length: float
    """[m]"""
    forearm_length: float
    """[m]"""
    masses: ArmMasses
    """The masses of its parts."""
    @property
    def joint_min(self) -> NDArray[np.float64]:
        """[rad] where the joints have their stops. Shape (3,), a view."""
    @joint_min.setter
    def joint_min(self, value: ArrayLike) -> None: ...
    @property
    def joint_max(self) -> NDArray[np.float64]:
        """[rad]; shape (3,), a view."""
    @joint_max.setter
    def joint_max(self, value: ArrayLike) -> None: ...
    motor: Motor
    """Each of its three motors."""
    @property
    def dry_friction(self) -> NDArray[np.float64]:
        """[N·m] per joint. Shape (3,), a view."""
    @dry_friction.setter
    def dry_friction(self, value: ArrayLike) -> None: ...
    @property
    def viscous_friction(self) -> NDArray[np.float64]:
        """[N·m·s/rad] per joint. Shape (3,), a view."""
    @viscous_friction.setter
    def viscous_friction(self, value: ArrayLike) -> None: ...
    hand: Hand
    """The hand that holds the stylus."""
    count: float
    """[rad] of the arm joints' sensors."""
    gimbal_count: float
    """[rad] of the gimbal's."""
    noise: float
    """[counts] standard deviation."""
    seed: int
    """Of the noise."""
    step: float
    """[s] the longest step of its motion."""
    def __copy__(self) -> Plant:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Plant:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Drive:
    """What the drivers are told."""
    def __init__(self, duty: ArrayLike = ..., enabled: bool = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def duty(self) -> NDArray[np.float64]:
        """[-] -255 to 255. Shape (3,), a view."""
    @duty.setter
    def duty(self, value: ArrayLike) -> None: ...
    enabled: bool
    """Off, the motors are not connected."""
    def __copy__(self) -> Drive:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Drive:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class HandTarget:
    """Where the hand wants to be."""
    def __init__(
        self, position: ArrayLike = ..., velocity: ArrayLike = ..., holding: bool = ...
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def position(self) -> NDArray[np.float64]:
        """[m] in the arm's frame. Shape (3,), a view."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    @property
    def velocity(self) -> NDArray[np.float64]:
        """[m/s]; shape (3,), a view."""
    @velocity.setter
    def velocity(self, value: ArrayLike) -> None: ...
    holding: bool
    """No hand holds the stylus otherwise."""
    def __copy__(self) -> HandTarget:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> HandTarget:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class PlantState:
    """At rest in the middle of its workspace, at first."""
    def __init__(self, plant: Plant) -> None:
        """The arm of this plant, at rest."""
    time: float
    """[s]"""
    @property
    def joints(self) -> NDArray[np.float64]:
        """[rad]; shape (3,), a view."""
    @joints.setter
    def joints(self, value: ArrayLike) -> None: ...
    @property
    def rates(self) -> NDArray[np.float64]:
        """[rad/s]; shape (3,), a view."""
    @rates.setter
    def rates(self, value: ArrayLike) -> None: ...
    @property
    def gimbal(self) -> NDArray[np.float64]:
        """[rad]; shape (3,), a view."""
    @gimbal.setter
    def gimbal(self, value: ArrayLike) -> None: ...
    @property
    def hand_force(self) -> NDArray[np.float64]:
        """[N] of the hand on the stylus. Shape (3,), a view."""
    @hand_force.setter
    def hand_force(self, value: ArrayLike) -> None: ...
    random: int
    """State of the noise."""
    def __copy__(self) -> PlantState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> PlantState:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

SENSOR_MIDDLE: int
SENSOR_END: int

@overload
def find_arm(plant: Plant) -> Arm:
    """find_arm(*args, **kwargs)

    What kinematics and weights of this plant are, as a calibration would find them.

    The kinematics and the joints' limits of a calibrated device.
    """

@overload
def find_arm(calibration: Calibration) -> Arm: ...
def compute_mass(plant: Plant, joints: ArrayLike, holding: bool) -> NDArray[np.float64]:
    """[kg·m²] of the arm, and of the hand where one is holding it.

    Args:
        joints: [rad] shape (3,): yaw, elevation, forearm
    """

def compute_motor_torque(plant: Plant, drive: Drive, rates: ArrayLike) -> NDArray[np.float64]:
    """[N·m] at the joints, of motors that turn at rates [rad/s].

    Args:
        rates: [rad/s] shape (3,)
    """

def compute_stall_torque(motor: Motor) -> float:
    """[N·m] at the joint of a motor held still at full duty."""

def compute_motor_damping(motor: Motor) -> float:
    """[N·m·s/rad] that a motor under voltage brakes its joint with."""

def move_plant(plant: Plant, drive: Drive, hand: HandTarget, dt: float, state: PlantState) -> None:
    """Moves the arm on by dt [s] in steps no longer than its own.

    Args:
        dt: [s]
    """

def read_sensors(plant: Plant, state: PlantState) -> list[int]:
    """What the sensors of three joints and the gimbal say: 0 to 1023. Noise moves the seed on."""

def find_tip(plant: Plant, state: PlantState) -> NDArray[np.float64]:
    """[m] where the stylus' tip really is."""

class JointSensor:
    """What one sensor's counts mean."""
    def __init__(
        self, *, zero: int = ..., scale: float = ..., min: int = ..., max: int = ...
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    zero: int
    """[counts] at angle zero."""
    scale: float
    """[rad/count], its sign is the direction."""
    min: int
    """[counts] end of the joint's range."""
    max: int
    """[counts] end of the joint's range."""
    def __copy__(self) -> JointSensor:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> JointSensor:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Calibration:
    """What a device keeps of itself in its EEPROM, in SI units."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def joints(self) -> list[JointSensor]:
        """Three of the arm, three of the gimbal; assign the whole list."""
    @joints.setter
    def joints(self, value: Sequence[JointSensor]) -> None: ...
    upper_length: float
    """[m]"""
    forearm_length: float
    """[m]"""
    @property
    def torque_full(self) -> NDArray[np.float64]:
        """[N·m] at the joint, of full duty; signed. Shape (3,), a view."""
    @torque_full.setter
    def torque_full(self, value: ArrayLike) -> None: ...
    upper_weight: float
    """[N·m] that carries the level upper link."""
    forearm_weight: float
    """[N·m] that carries the level forearm."""
    @property
    def deadband(self) -> list[int]:
        """[duty] at which the motor begins to push."""
    @deadband.setter
    def deadband(self, value: Sequence[int]) -> None: ...
    @property
    def continuous_duty(self) -> list[int]:
        """[duty] that may be held for ever."""
    @continuous_duty.setter
    def continuous_duty(self, value: Sequence[int]) -> None: ...
    heat_time: float
    """[s] in which the motors warm up."""
    speed_max: int
    """[counts/ms] of an arm joint; more is a fault."""
    serial_number: int
    """Of the device."""
    def __copy__(self) -> Calibration:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Calibration:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object, object, object, object, object, object, object, object, object, object, object
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def find_calibration(plant: Plant) -> Calibration:
    """The calibration a plant would get if nothing were measured wrong."""

def compute_angles(calibration: Calibration, counts: Sequence[int]) -> list[float]:
    """[rad] of six sensors.

    Args:
        counts: [counts] six, 0 to 1023
    """

def find_safety_limits(calibration: Calibration) -> SafetyLimits:
    """What forces a device can bear: in every direction and place of its workspace, at any
    moment and for ever.
    """

class Transport:
    """Bytes to a device and back, real or simulated."""
    def read(self, time: float) -> bytes:
        """What has come by time [s] since the run began.

        Args:
            time: [s] since the run began
        """
    def write(self, time: float, bytes: bytes) -> None:
        """Sends bytes at time [s].

        Args:
            time: [s] since the run began
        """
    def is_open(self) -> bool:
        """False for good once the other end is gone."""
    def can_wait(self) -> bool:
        """True if wait can: something of the machine's own tells that bytes have come."""
    def wait(self, latest: int) -> bool:
        """Until bytes have come, or latest [ns of the monotonic clock]. False if none have.

        Args:
            latest: [ns] of the monotonic clock
        """
    def now(self, time: float) -> float:
        """[s] of the clock that arrivals are told by.

        Args:
            time: [s] since the run began
        """
    def name(self) -> str:
        """What it is called in messages."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class NativeCoreOptions:
    """How the simulated wire and the clocks at its ends are."""
    def __init__(
        self,
        *,
        baud: float = ...,
        link_delay: float = ...,
        report_delay: float = ...,
        drift: float = ...,
        calibrated: bool = ...,
        damaged: bool = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    baud: float
    """[bit/s]"""
    link_delay: float
    """[s] of what joins wire and host, each way."""
    report_delay: float
    """[s] from a tick's samples to the first byte of its report."""
    drift: float
    """[-] By how much the device's clock is fast."""
    calibrated: bool
    """Its EEPROM holds what find_calibration says of the plant."""
    damaged: bool
    """A byte of that has changed since it was stored."""
    def __copy__(self) -> NativeCoreOptions:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> NativeCoreOptions:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class NativeCore(Transport):
    """The firmware's own C code, compiled for this machine, on a simulated arm at the far end
    of a simulated wire. The same in every run; no clock but the time it is given.
    """
    def __init__(self, plant: Plant = ..., options: NativeCoreOptions = ...) -> None:
        """Raises ValueError.

        Arguments are the fields of these names, with their shapes and units.
        """
    def advance(self, time: float) -> None:
        """Lives on up to time [s] although nobody reads; what it says is then lost. Ctrl-C ends
        it. Raises ValueError for more than a day in one call.

        Args:
            time: [s] since the run began
        """
    def time(self) -> float:
        """[s] of the run, up to which it has lived."""
    def hold(self, hand: HandTarget) -> None:
        """Whether and where to a hand moves the stylus."""
    def press_buttons(self, buttons: int) -> None:
        """The stylus' buttons: bit 0 attaches."""
    def press_stop(self, pressed: bool) -> None:
        """The emergency stop."""
    def cut_sensor(self, joint: int, cut: bool) -> None:
        """Its wire is off: the reading is at the rail."""
    def pull_cable(self) -> None:
        """From then on nothing goes either way."""
    def reset(self) -> None:
        """As if its power had failed for a moment."""
    def plant(self) -> Plant:
        """The arm that is simulated."""
    def state(self) -> PlantState:
        """The arm as it really is."""
    def drive(self) -> Drive:
        """What the motors get."""
    def motor_force(self) -> NDArray[np.float64]:
        """[N] shape (3,), of the motors at the tip, without the arm's own weight."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class SerialPort:
    """A serial port of this machine, as far as the system knows it."""
    @property
    def path(self) -> str:
        """To open."""
    @property
    def product(self) -> str:
        """What it calls itself; empty where it does not say."""
    @property
    def driver(self) -> str:
        """Of the system."""
    @property
    def latency_timer(self) -> int:
        """[ms] that the adapter may keep bytes back; -1 where it has none."""
    @property
    def permitted(self) -> bool:
        """This user may open it."""
    def __copy__(self) -> SerialPort:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> SerialPort:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def find_serial_ports() -> list[SerialPort]:
    """The USB serial adapters of this machine, by path."""

class SerialTransport(Transport):
    """A serial port, or the far end of a PtyDevice. Bytes are told by the machine's own clock.
    What keeps bytes back is switched off as far as the system and the adapter let it.
    """
    def __init__(self, path: str, baud: int = ...) -> None:
        """Raises DeviceError where the port cannot be opened or does not know the rate."""
    def latency_note(self) -> str:
        """What was done about latency, and what could not be, in words."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class PtyDevice:
    """A simulated device behind a pseudo terminal: a file that any program can open as if it
    were the serial port of the real one.
    """
    def __init__(self, plant: Plant = ..., options: NativeCoreOptions = ...) -> None:
        """Raises DeviceError."""
    def path(self) -> str:
        """Of the file to open."""
    def press_buttons(self, buttons: int) -> None:
        """From any thread: bits 0 and 1."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class LinkState(enum.Enum):
    """How far a host has come with a device."""

    greeting = 0
    loading = 1
    uncalibrated = 2
    ready = 3
    lost = 4

class DeviceMode(enum.Enum):
    """What a device does."""

    boot = 0
    idle = 1
    ramp = 2
    run = 3
    faulted = 4

class DeviceStatus:
    """Everything there is to know of a device, as its driver left it for others some
    milliseconds ago.
    """
    @property
    def link(self) -> LinkState:
        """How far the host has come with it."""
    @property
    def mode(self) -> DeviceMode:
        """What it does."""
    @property
    def blank(self) -> bool:
        """No calibration was ever stored in it."""
    @property
    def damaged(self) -> bool:
        """The newest calibration in its EEPROM is not what was stored."""
    @property
    def degraded(self) -> bool:
        """Reports are missing: the force is taken back."""
    @property
    def first_fault(self) -> int:
        """Bit that cut the motors, 15 for none: see name_fault."""
    @property
    def faults(self) -> int:
        """Bits: whatever was noticed."""
    @property
    def buttons(self) -> int:
        """Bits 0 and 1: pressed, by the last report."""
    @property
    def time(self) -> float:
        """[s] of the last report, by the host's clock."""
    @property
    def counts(self) -> list[int]:
        """Of the sensors."""
    @property
    def joints(self) -> NDArray[np.float64]:
        """[rad] yaw, elevation, forearm. Shape (3,), a view."""
    @joints.setter
    def joints(self, value: ArrayLike) -> None: ...
    @property
    def gimbal(self) -> NDArray[np.float64]:
        """[rad]; shape (3,), a view."""
    @gimbal.setter
    def gimbal(self, value: ArrayLike) -> None: ...
    @property
    def tip(self) -> NDArray[np.float64]:
        """[m] in the arm's frame. Shape (3,), a view."""
    @tip.setter
    def tip(self, value: ArrayLike) -> None: ...
    @property
    def force_commanded(self) -> NDArray[np.float64]:
        """[N]; shape (3,), a view."""
    @force_commanded.setter
    def force_commanded(self, value: ArrayLike) -> None: ...
    @property
    def force_applied(self) -> NDArray[np.float64]:
        """[N] by the duties the motors really got. Shape (3,), a view."""
    @force_applied.setter
    def force_applied(self, value: ArrayLike) -> None: ...
    @property
    def duty(self) -> list[int]:
        """-255 to 255."""
    @property
    def counters(self) -> list[int]:
        """Heat of three motors, then the device's own counts."""
    @property
    def reports(self) -> int:
        """From the device."""
    @property
    def lost_reports(self) -> int:
        """That its own count says are missing."""
    @property
    def damaged_frames(self) -> int:
        """That failed their check, here."""
    @property
    def commands(self) -> int:
        """To the device."""
    @property
    def report_rate(self) -> float:
        """[Hz] over the last second."""
    @property
    def round_trip_median(self) -> float:
        """[s] command to its acknowledgement."""
    @property
    def round_trip_p99(self) -> float:
        """[s]"""
    @property
    def round_trips(self) -> list[int]:
        """How many took 0 to 0.25 ms, to 0.5 ms ...; the last all longer ones."""
    @property
    def jitter_p99(self) -> float:
        """[s] reports off the line through their times."""
    @property
    def clock_drift(self) -> float:
        """[-] By how much the device's clock is fast, 1e-6 for 1 ppm."""
    @property
    def local_stiffness(self) -> float:
        """[N/m] along the force that it answers by itself."""
    @property
    def release(self) -> list[int]:
        """Of the firmware."""
    @property
    def serial_number(self) -> int:
        """Of the device."""
    def __copy__(self) -> DeviceStatus:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> DeviceStatus:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def name_fault(fault: int) -> str:
    """A fault's name in words, for instance "host silent"; "none" for no fault."""

def describe_status(status: DeviceStatus) -> str:
    """One sentence: what the device does, or what is wrong and what to do."""

class SerialDevice(HapticDevice):
    """The driver of the low-cost device, at the other end of whatever transport."""
    def __init__(self, transport: Transport, origin: ArrayLike = ...) -> None:
        """The workspace's centre shall lie at origin [m] of the scene.

        Args:
            origin: [m] shape (3,)
        """
    def open(self, timeout: float = ...) -> None:
        """Greets the device, reads its calibration and waits for its first report; to be called
        before a run. Raises DeviceError in words where that does not come about within
        timeout [s].

        Args:
            timeout: [s]
        """
    def clear_fault(self) -> None:
        """From any thread: asks the device to forget its fault, if the cause is gone."""
    def enable(self, on: bool) -> None:
        """From any thread: motors on (as they are from the start) or off."""
    def take_status(self) -> bool:
        """For one reader thread: True if something newer than last time was taken."""
    def status(self) -> DeviceStatus:
        """A copy of the status last taken."""
    def calibration(self) -> Calibration:
        """As it was read when the link was made. Raises DeviceError where there is none."""
    def store(self, calibration: Calibration, timeout: float = ...) -> None:
        """Writes a calibration to the device, which keeps it; then the device is greeted again.
        Not while a run is on. Raises DeviceError in words, and ValueError for numbers it
        cannot hold.

        Args:
            timeout: [s]
        """
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class SimulatedArm(HapticDevice):
    """The low-cost device without its metal: a hand holds a simulated arm, whose firmware is
    the real one, and is felt through the real driver.
    """
    def __init__(
        self,
        hand: HapticDevice,
        origin: ArrayLike = ...,
        plant: Plant = ...,
        options: NativeCoreOptions = ...,
    ) -> None:
        """hand says where the hand wants to be, in the scene, whose place origin [m] is the
        middle of the arm's workspace. Raises ValueError.

        Args:
            origin: [m] shape (3,)
        """
    def open(self) -> None:
        """Puts the arm where the hand begins and makes the link. Raises DeviceError."""
    def widen(self, wide: bool) -> None:
        """From any thread: whether the hand may leave the workspace and go to the joints'
        stops.
        """
    def press_stop(self, pressed: bool) -> None:
        """From any thread: the emergency stop."""
    def cut_sensor(self, joint: int, cut: bool) -> None:
        """From any thread: the wire of a sensor is off."""
    def pull_cable(self) -> None:
        """From any thread, and for good."""
    def hand_force(self) -> NDArray[np.float64]:
        """From any thread: [N] shape (3,), of the hand on the stylus, as a scale between them
        would say.
        """
    def core(self) -> NativeCore:
        """The simulated device."""
    def driver(self) -> SerialDevice:
        """Its driver."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class Faults:
    """What goes wrong, and how often: shares of frames or samples, 0 to 1. The same in every
    run.
    """
    def __init__(
        self,
        *,
        drop: float = ...,
        corrupt: float = ...,
        reorder: float = ...,
        delay: float = ...,
        stick_at: float = ...,
        unplug_at: float = ...,
        cut_at: float = ...,
        seed: int = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    drop: float
    """[-] Lost."""
    corrupt: float
    """[-] Changed: a bit of a frame, a number of a sample."""
    reorder: float
    """[-] Comes after the one that follows it."""
    delay: float
    """[s] each way."""
    stick_at: float
    """[s] from then on the same again."""
    unplug_at: float
    """[s] from then on nothing."""
    cut_at: float
    """[s] from then on a device moves but its motors are off; a transport knows of none."""
    seed: int
    """Of what goes wrong, and when."""
    def __copy__(self) -> Faults:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Faults:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class FaultyDevice(HapticDevice):
    """A device to which faults happen."""
    def __init__(self, device: HapticDevice, faults: Faults) -> None:
        """Raises ValueError."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class FaultyTransport(Transport):
    """A transport on which faults happen to whole frames, both ways."""
    def __init__(self, transport: Transport, faults: Faults) -> None:
        """Raises ValueError."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class PlaceKind(enum.Enum):
    """Where a step or a limit is, of a tissue at rest."""

    region = 0
    path = 1
    ball = 2
    object = 3
    space = 4

class TaskVerb(enum.Enum):
    """What a step asks for."""

    touch = 0
    hold = 1
    push = 2
    pull = 3
    grasp = 4
    release = 5
    trace = 6
    find = 7
    look = 8
    remove = 9
    carry = 10

class TaskMeasure(enum.Enum):
    """What a limit watches."""

    force = 0
    force_rate = 1
    contact = 2
    depth = 3
    distance = 4
    speed = 5
    clearance = 6
    off_path = 7
    strain = 8
    loose = 9
    out_of_view = 10
    object_force = 11
    pad_pressure = 12
    torn = 13

class LimitConsequence(enum.Enum):
    """What becomes of a limit that opens."""

    warn = 0
    error = 1
    end = 2

class Outcome(enum.IntEnum):
    """How an attempt at a task came out."""

    running = 0
    done = 1
    failed = 2
    timed_out = 3
    left = 4
    device_fault = 5
    diverged = 6
    interrupted = 7

class TaskEvent(enum.IntEnum):
    """Kinds of an Event that a judge tells of, beside those of EventKind."""

    step_begun = 32
    step_done = 33
    step_overdue = 34
    click_missed = 35
    limit_opened = 36
    limit_closed = 37
    task_ended = 38

class StepStatus(enum.Enum):
    """How far a step is."""

    waiting = 0
    active = 1
    done = 2

class Band:
    """From least to most, both included."""
    def __init__(self, least: float = ..., most: float = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    least: float
    """[N] or [m]; minus infinity for no bound."""
    most: float
    """[N] or [m]; infinity for no bound."""
    def __copy__(self) -> Band:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Band:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TaskPlace:
    """Where a step or a limit is: of a tissue at rest, which moves with it, an object of the
    scene, or a space in it.
    """
    def __init__(
        self,
        *,
        kind: PlaceKind = ...,
        body: int = ...,
        vertices: Sequence[int] = ...,
        points: Sequence[ArrayLike] = ...,
        radius: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    kind: PlaceKind
    """What it is."""
    body: int
    """Of the scene; of an object: of Scene.rigid."""
    @property
    def vertices(self) -> list[int]:
        """Of a region: of the body's surface."""
    @vertices.setter
    def vertices(self, value: Sequence[int]) -> None: ...
    @property
    def points(self) -> list[NDArray[np.float64]]:
        """[m] shape (k, 3) when set: of a path two or more, of a ball or a space its centre."""
    @points.setter
    def points(self, value: Sequence[ArrayLike]) -> None: ...
    radius: float
    """[m] of a ball or a space; of a path, how far beside it still counts as on it."""
    @property
    def members(self) -> list[int]:
        """Of a region: per vertex of the surface 1 or 0; filled in by build_task."""
    @property
    def arc_length(self) -> list[float]:
        """[m] of a path: per point, from its beginning; filled in by build_task."""
    @property
    def seen(self) -> list[int]:
        """Of a region or a ball: vertices of the surface by which a camera sees it; filled in
        by build_task.
        """
    def __copy__(self) -> TaskPlace:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TaskPlace:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TaskStep:
    """Something that a trainee is asked to do."""
    def __init__(
        self,
        *,
        verb: TaskVerb = ...,
        instrument: int = ...,
        place: int = ...,
        space: int = ...,
        force: Band = ...,
        depth: Band = ...,
        distance: Band = ...,
        duration: float = ...,
        share: float = ...,
        time_limit: float = ...,
        after: Sequence[int] = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    verb: TaskVerb
    """What it asks for."""
    instrument: int
    """Of the scene."""
    place: int
    """Of the task; -1 for none, which only release may have."""
    space: int
    """Of the task: that remove is from, and carry into; else -1."""
    force: Band
    """[N] size of what the hand feels."""
    depth: Band
    """[m] of the tip below the surface at rest."""
    distance: Band
    """[m] of what is held from where it is at rest; to look, of the lens."""
    duration: float
    """[s] for which it must be so; gaps of up to 0.1 s are left out."""
    share: float
    """[-] of a path, 0 to 1."""
    time_limit: float
    """[s] since it began; once longer is an error. 0 for none."""
    @property
    def after(self) -> list[int]:
        """Steps that must be done before it begins."""
    @after.setter
    def after(self, value: Sequence[int]) -> None: ...
    def __copy__(self) -> TaskStep:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TaskStep:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object, object, object, object, object, object, object, object, object, object, object
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TaskLimit:
    """What must not be, and what becomes of it."""
    def __init__(
        self,
        *,
        measure: TaskMeasure = ...,
        instrument: int = ...,
        place: int = ...,
        above: bool = ...,
        bound: float = ...,
        duration: float = ...,
        then: LimitConsequence = ...,
        during: Sequence[int] = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    measure: TaskMeasure
    """What it watches."""
    instrument: int
    """Of the scene."""
    place: int
    """Of the task; -1 for none."""
    above: bool
    """Wrong above the bound; else below it."""
    bound: float
    """[N], [N/s], [m] or [m/s], as the measure is."""
    duration: float
    """[s] for which it must be so."""
    then: LimitConsequence
    """What becomes of it."""
    @property
    def during(self) -> list[int]:
        """Steps while one of which it is watched; empty for always."""
    @during.setter
    def during(self, value: Sequence[int]) -> None: ...
    def __copy__(self) -> TaskLimit:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TaskLimit:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TaskSurface:
    """A body's surface at rest."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def vertices(self) -> NDArray[np.float64]:
        """[m] shape (n, 3); a view."""
    @property
    def normals(self) -> NDArray[np.float64]:
        """[-] unit, outwards, shape (n, 3); a view."""
    @property
    def triangles(self) -> NDArray[np.int32]:
        """Shape (t, 3); a copy, read-only."""
    def __copy__(self) -> TaskSurface:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TaskSurface:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TaskCamera:
    """The lens of an instrument, in the tool's frame."""
    def __init__(
        self,
        *,
        instrument: int = ...,
        at: ArrayLike = ...,
        forward: ArrayLike = ...,
        field_of_view: float = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    instrument: int
    """Of the scene."""
    field_of_view: float
    """[rad] The whole angle of the round picture."""
    @property
    def at(self) -> NDArray[np.float64]:
        """[m] shape (3,); shape (3,), a view."""
    @at.setter
    def at(self, value: ArrayLike) -> None: ...
    @property
    def forward(self) -> NDArray[np.float64]:
        """[-] unit, shape (3,); shape (3,), a view."""
    @forward.setter
    def forward(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> TaskCamera:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TaskCamera:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TaskObject:
    """What is no tissue of a scene, as a task knows it."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def rigid(self) -> int:
        """Of Scene.rigid; -1 of scenery."""
    @property
    def start(self) -> RigidState:
        """Of a rigid body: where the scene begins."""
    @property
    def vertices(self) -> NDArray[np.float64]:
        """[m] shape (n, 3) in its own frame, of scenery the scene's; a view."""
    @property
    def sphere_centres(self) -> NDArray[np.float64]:
        """[m] shape (k, 3) of a rigid body, in its own frame; a view."""
    @property
    def radii(self) -> NDArray[np.float64]:
        """[m] shape (k,) of these; a view."""
    def __copy__(self) -> TaskObject:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TaskObject:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Task:
    """All that judge() knows of a task, and never changes."""
    def __init__(
        self,
        *,
        places: Sequence[TaskPlace] = ...,
        steps: Sequence[TaskStep] = ...,
        limits: Sequence[TaskLimit] = ...,
        time_limit: float = ...,
        errors_at_most: int = ...,
        cameras: Sequence[TaskCamera] = ...,
    ) -> None:
        """Copies what it is given; build_task checks it.

        Arguments are the fields of these names, with their shapes and units.
        """
    time_limit: float
    """[s] of ticks, positive."""
    errors_at_most: int
    """With more the task has failed; -1 for any number."""
    @property
    def tool_radii(self) -> list[float]:
        """[m] per instrument; filled in by build_task."""
    @property
    def places(self) -> tuple:
        """A TaskPlace each, a tuple of copies."""
    @property
    def steps(self) -> tuple:
        """A TaskStep each, a tuple of copies."""
    @property
    def limits(self) -> tuple:
        """A TaskLimit each, a tuple of copies."""
    @property
    def cameras(self) -> tuple:
        """A TaskCamera each, a tuple of copies."""
    @property
    def objects(self) -> tuple:
        """A TaskObject each, scenery before rigid bodies, a tuple of copies; filled in by
        build_task.
        """
    @property
    def surfaces(self) -> tuple:
        """A TaskSurface for each body, a tuple of copies; filled in by build_task."""
    def __copy__(self) -> Task:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Task:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """What it is, on one line."""

MOST_STEPS: int
MOST_LIMITS: int
MOST_PLACES: int
MOST_SEEN_POINTS: int

def is_yes_or_no(measure: TaskMeasure) -> bool:
    """Whether what a limit watches is or is not, so that its bound is 0 and it is wrong above
    that.
    """

def is_of_task(event: Event) -> bool:
    """Whether its kind is one of TaskEvent."""

def is_kind(event: Event, kind: TaskEvent) -> bool:
    """Whether its kind is that."""

def watches_sight(task: Task) -> bool:
    """Whether its verdict depends on where all of a tissue is, so that World.follows_all must
    be on.
    """

def build_task(scene: Scene, task: Task) -> Task:
    """A task, checked once, with what is derived from it and the scene. Raises ValueError
    naming the field, what it got and what was expected.
    """

class StepState:
    """How far a trainee has come with a step."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def status(self) -> StepStatus:
        """Waiting, active or done."""
    @property
    def dwell(self) -> float:
        """[s] for which what it asks has been so."""
    @property
    def progress(self) -> float:
        """[-] of a path: the share touched so far."""
    @property
    def from_tick(self) -> int:
        """It began; -1 before."""
    @property
    def until_tick(self) -> int:
        """It was done; -1 before."""
    @property
    def overdue(self) -> bool:
        """It has taken longer than its time limit."""
    def __copy__(self) -> StepState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> StepState:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class LimitState:
    """How often and how far a limit was passed."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def open(self) -> bool:
        """Now."""
    @property
    def count(self) -> int:
        """How often it has opened."""
    @property
    def duration(self) -> float:
        """[s] open in all."""
    @property
    def excess(self) -> float:
        """[N s], [m s] ...: integral over that time of what lies beyond the bound."""
    @property
    def worst(self) -> float:
        """[N], [m] ...: the value farthest beyond the bound so far."""
    def __copy__(self) -> LimitState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> LimitState:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class TaskState:
    """How far a trainee has come."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def outcome(self) -> Outcome:
        """How it came out; running before."""
    @property
    def ticks(self) -> int:
        """Judged."""
    @property
    def time(self) -> float:
        """[s]"""
    @property
    def errors(self) -> int:
        """So far."""
    @property
    def warnings(self) -> int:
        """So far."""
    @property
    def peak_force(self) -> float:
        """[N] the largest that was held for 10 ms, of any instrument."""
    @property
    def steps(self) -> tuple:
        """A StepState each, a tuple."""
    @property
    def limits(self) -> tuple:
        """A LimitState each, a tuple."""
    def __copy__(self) -> TaskState:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> TaskState:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Progress:
    """A running task: everything that judge() needs."""
    def __init__(self, task: Task) -> None:
        """At its beginning. Raises ValueError for a task that is not from build_task."""
    @property
    def state(self) -> TaskState:
        """How far the trainee has come, a copy."""
    @property
    def events(self) -> NDArray[Any]:
        """Of the last judge(), in order, a structured array with the fields of Event, shape
        (k,).
        """
    @property
    def event_count(self) -> int:
        """How many these are."""
    def __copy__(self) -> Progress:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Progress:
        """A copy of its own."""
    def __repr__(self) -> str:
        """The value on one line."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

def judge(
    task: Task,
    world: World,
    samples: Sequence[HapticSample],
    commands: Sequence[HapticCommand],
    dt: float,
    progress: Progress,
) -> None:
    """Judges a tick of dt [s] that has just been done: to be called once after every tick()
    with what that took and gave, one of each for each instrument. Nothing changes once the
    outcome is no longer running.

    Args:
        samples: a structured array with the fields of HapticSample, shape (k,), or a list of
            these
        dt: [s]
    """

class LocalForceMode(enum.Enum):
    """What is felt between two exchanges with a slow tissue."""

    local_stiffness = 0
    hold = 1
    extrapolation = 2

class LocalModel:
    """What a tissue does to a tool near some place, to first order: F(p) = f0 - K (p - p0), and
    nothing where that would pull.
    """
    def __init__(
        self,
        *,
        time: float = ...,
        position: ArrayLike = ...,
        force: ArrayLike = ...,
        normal: ArrayLike = ...,
        stiffness: ArrayLike = ...,
        held: bool = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    time: float
    """[s] of the hand that it was taken at."""
    @property
    def position(self) -> NDArray[np.float64]:
        """[m] p0 of the tool. Shape (3,), a view."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    @property
    def force(self) -> NDArray[np.float64]:
        """[N] f0 on the tool there. Shape (3,), a view."""
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    @property
    def normal(self) -> NDArray[np.float64]:
        """[-] Unit, out of the tissue; 0 where none is near. Shape (3,), a view."""
    @normal.setter
    def normal(self, value: ArrayLike) -> None: ...
    @property
    def stiffness(self) -> NDArray[np.float64]:
        """[N/m] K, shape (3, 3), symmetric."""
    @stiffness.setter
    def stiffness(self, value: ArrayLike) -> None: ...
    held: bool
    """The force pulls as well: the tool is attached."""
    def __copy__(self) -> LocalModel:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> LocalModel:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class SlowTissue:
    """A scene whose tissue moves at a rate of its own beside hands that are read faster. Hands
    are told to it every so many ticks; it follows them until the next exchange, and is then
    told as a local model, which is one to two intervals old while it is felt.
    """
    def __init__(
        self, scene: Scene, hand_rate: float, ticks: int, mode: LocalForceMode = ...
    ) -> None:
        """Hands are read at hand_rate [Hz] and told every `ticks` of theirs; the tissue ticks
        at Scene.rate. Raises ValueError where an interval is not a whole number of its
        ticks.

        Args:
            hand_rate: [Hz] at which hands are read
        """
    @overload
    def tick(self, sample: HapticSample) -> HapticCommand:
        """tick(*args, **kwargs)

        One tick of the hand of a scene with one instrument: the force to be felt.

        One tick of the hands, with a sample and a command for each instrument.

        Args:
            samples: a structured array with the fields of HapticSample, shape (k,), or a
                list of these
        """
    @overload
    def tick(self, samples: Sequence[HapticSample]) -> list[HapticCommand]: ...
    def model(self, instrument: int = ...) -> LocalModel:
        """What an instrument is rendered from; a copy. Raises IndexError for one that there is
        not.
        """
    def alarm(self) -> Alarm:
        """The first of the tissue."""
    def interval(self) -> float:
        """[s] between exchanges."""
    def tissue_ticks(self) -> int:
        """Ticks of the tissue in an interval."""
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class FaultResponse(enum.Enum):
    """What becomes of a run of which a device fails, or gives no force any more. The force of
    that device is zero from then on; the other instruments know nothing of it.
    """

    go_on = 0
    pause = 1
    end = 2

class LoopOptions:
    """How the live loop runs."""
    def __init__(
        self,
        *,
        duration: float = ...,
        realtime: bool = ...,
        cpu: int = ...,
        spin: float = ...,
        safety: SafetyLimits = ...,
        on_fault: FaultResponse = ...,
        device_safety: Sequence[SafetyLimits] = ...,
        measures_costs: bool = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    duration: float
    """[s] 0 runs until stop()."""
    realtime: bool
    """Ask for SCHED_FIFO and locked memory."""
    cpu: int
    """Pin the thread to this core, -1 for none."""
    spin: float
    """[s] spun instead of slept before every tick."""
    safety: SafetyLimits
    """What the device may be sent."""
    on_fault: FaultResponse
    """What becomes of the run where a device fails."""
    @property
    def device_safety(self) -> list[SafetyLimits]:
        """What each device may be sent, in the order of the instruments; where empty, safety
        for all. Copied when read and when set.
        """
    @device_safety.setter
    def device_safety(self, value: Sequence[SafetyLimits]) -> None: ...
    measures_costs: bool
    """Of every body, instrument and pair: LoopReport.part_costs."""
    def __copy__(self) -> LoopOptions:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> LoopOptions:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class BodySnapshot:
    """A body as a reader sees it."""
    @property
    def position(self) -> NDArray[np.float64]:
        """[m] of the vertices of the surface, shape (n, 3); a view."""
    @property
    def substeps(self) -> int:
        """Of that tick."""
    @property
    def safeguard(self) -> Safeguard:
        """Of that tick."""
    @property
    def torn(self) -> NDArray[np.float32]:
        """[-] Of each vertex, 0 where all is whole to 1 where something bears nothing any more,
        shape (n,); empty of a body that does not tear; a view.
        """
    def __copy__(self) -> BodySnapshot:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> BodySnapshot:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class RigidSnapshot:
    """A rigid body as a reader sees it."""
    @property
    def position(self) -> NDArray[np.float64]:
        """[m] of its frame. Shape (3,), a view."""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    @property
    def orientation(self) -> NDArray[np.float64]:
        """[-] Of its frame: unit quaternion (x, y, z, w), shape (4,); a view."""
    def __copy__(self) -> RigidSnapshot:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> RigidSnapshot:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class InstrumentSnapshot:
    """An instrument and its device as a reader sees them."""
    @property
    def sample(self) -> HapticSample:
        """What the device said."""
    @property
    def tool_position(self) -> NDArray[np.float64]:
        """[m]; shape (3,), a view."""
    @tool_position.setter
    def tool_position(self, value: ArrayLike) -> None: ...
    @property
    def tool_orientation(self) -> NDArray[np.float64]:
        """[-] Of the tool's frame: unit quaternion (x, y, z, w), shape (4,); a view."""
    @property
    def force(self) -> NDArray[np.float64]:
        """[N] on the hand; none while the motors are not on. Shape (3,), a view."""
    @force.setter
    def force(self, value: ArrayLike) -> None: ...
    @property
    def touching(self) -> bool:
        """Any contact in force."""
    @property
    def jaw_angle(self) -> float:
        """[rad] by which each of its jaws is open."""
    @property
    def pinch(self) -> float:
        """[N] that each of them presses with."""
    @property
    def pad_pressure(self) -> float:
        """[Pa] of that."""
    @property
    def turn_limited(self) -> bool:
        """Tissue keeps it from turning as its hand does."""
    @property
    def motors(self) -> MotorState:
        """Of the device."""
    @property
    def interventions(self) -> int:
        """Of the device's passivity controller, so far."""
    @property
    def stiffness_error(self) -> float:
        """[-] Part of the tissue's stiffness that the hand does not feel in this contact; 0
        where the device bears the instrument's own coupling.
        """
    @property
    def carried(self) -> NDArray[np.float64]:
        """[N] on the tool, of what its jaws hold. Shape (3,), a view."""
    @carried.setter
    def carried(self, value: ArrayLike) -> None: ...
    def __copy__(self) -> InstrumentSnapshot:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> InstrumentSnapshot:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Snapshot:
    """What a reader outside the haptic thread sees: the world as it was at most 8 ms ago."""
    @property
    def tick(self) -> int:
        """Number of the tick it shows."""
    @property
    def time(self) -> float:
        """[s]"""
    @property
    def bodies(self) -> tuple:
        """As Scene.bodies, a tuple."""
    @property
    def rigid(self) -> tuple:
        """As Scene.rigid, a tuple."""
    @property
    def instruments(self) -> tuple:
        """As Scene.instruments, a tuple."""
    @property
    def sample(self) -> object:
        """Of the first instrument."""
    @property
    def tool_position(self) -> object:
        """Of the first instrument."""
    @property
    def force(self) -> object:
        """Of the first instrument."""
    @property
    def touching(self) -> object:
        """Of the first instrument."""
    @property
    def motors(self) -> object:
        """Of the first instrument."""
    @property
    def interventions(self) -> object:
        """Of the first instrument."""
    @property
    def task(self) -> TaskState:
        """A TaskState, without steps where there is no task; a copy."""
    @property
    def cost(self) -> float:
        """[s] of the last tick."""
    @property
    def lateness(self) -> float:
        """[s] of the last tick."""
    @property
    def missed_ticks(self) -> int:
        """Skipped so far."""
    def __copy__(self) -> Snapshot:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Snapshot:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[object, object, object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class DeviceReport:
    """What one device gave of a run."""
    @property
    def fault(self) -> DeviceFault:
        """Now or when the run ended; none for none."""
    @property
    def fault_reason(self) -> str:
        """In words."""
    @property
    def unrendered_ticks(self) -> int:
        """Its motors were not on: their force counts nowhere else here."""
    @property
    def peak_force(self) -> float:
        """[N] The largest that was sent."""
    @property
    def touch_ticks(self) -> int:
        """Touching or attached."""
    @property
    def touch_force(self) -> float:
        """[N] The mean of what was sent in them."""
    @property
    def damped_ticks(self) -> int:
        """In which its passivity controller had to act."""
    @property
    def interventions(self) -> int:
        """Times that it began to, after 100 ms without."""
    @property
    def passive_stiffness(self) -> float:
        """[N/m] Up to which a spring that is told at the rate of the run is passive with the
        damping and the delay that the device declared at its start; 0 where it declares
        none.
        """
    @property
    def follows_tissue_ticks(self) -> int:
        """Of an instrument whose coupling is stiffer than that: ticks in which the hand's
        spring was as well, as the tissue asked.
        """
    @property
    def tissue_stiffness(self) -> float:
        """[N/m] Likewise: of the stiffest tissue that it touched, to the tool."""
    @property
    def stiffness_error(self) -> float:
        """[-] Likewise: the largest part of a tissue's stiffness that was not felt."""
    def __copy__(self) -> DeviceReport:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> DeviceReport:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class LoopReport:
    """What a run of the loop cost."""
    @property
    def ticks(self) -> int:
        """How many were run."""
    @property
    def missed_ticks(self) -> int:
        """Skipped because an earlier tick was still at work."""
    @property
    def slow_ticks(self) -> int:
        """That took longer than a period of the processor's own time. Where ticks are missed
        and these are none, the loop was kept waiting.
        """
    @property
    def unpaced_ticks(self) -> int:
        """Went without the report of a device that has its own pace."""
    @property
    def lateness(self) -> Percentiles:
        """Start of a tick behind the first due time since the last one."""
    @property
    def cost(self) -> Percentiles:
        """Of the tick itself, device included."""
    @property
    def processor(self) -> Percentiles:
        """Of the processor, for a tick and all that comes with it."""
    @property
    def part_costs(self) -> SceneCosts:
        """Of its parts; of no ticks unless LoopOptions.measures_costs."""
    @property
    def realtime(self) -> bool:
        """Granted."""
    @property
    def realtime_note(self) -> str:
        """Why not, in words."""
    @property
    def alarm(self) -> Alarm:
        """What ended the run; false for nothing."""
    @property
    def alarm_body(self) -> int:
        """Whose tissue raised the alarm; -1 for what is of no body."""
    @property
    def safeguarded_ticks(self) -> int:
        """In which a body had a safeguard."""
    @property
    def averted(self) -> Alarm:
        """The first alarm that a safeguard averted; false for none."""
    @property
    def averted_body(self) -> int:
        """Whose tissue that was; -1 without one."""
    @property
    def fault(self) -> DeviceFault:
        """Of the first device that has one, now or when the run ended."""
    @property
    def fault_reason(self) -> str:
        """In words."""
    @property
    def outcome(self) -> Outcome:
        """Of the task; running while it is, and for none. A run that ended before it was
        decided was left, or its device failed.
        """
    @property
    def record_gaps(self) -> int:
        """Ticks the log had no room for."""
    @property
    def unrendered_ticks(self) -> int:
        """The motors were not on: their force counts nowhere else here. Sum of all devices."""
    @property
    def peak_force(self) -> float:
        """[N] The largest that was sent, of all devices."""
    @property
    def touch_ticks(self) -> int:
        """Touching or attached, the sum of all instruments."""
    @property
    def touch_force(self) -> float:
        """[N] The mean of what was sent in them."""
    @property
    def damped_ticks(self) -> int:
        """In which a passivity controller had to act, the sum of all devices."""
    @property
    def interventions(self) -> int:
        """Times that one began to, after 100 ms without; the sum of all devices."""
    @property
    def exchanges(self) -> int:
        """With the tissue of a scene with an exchange_rate; else none."""
    @property
    def late_exchanges(self) -> int:
        """Of them, because the tissue was still at work when they were due."""
    @property
    def exchange_cost(self) -> Percentiles:
        """Of the tissue, for one."""
    @property
    def devices(self) -> tuple:
        """A DeviceReport each, in the order of the instruments, a tuple."""
    def __copy__(self) -> LoopReport:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> LoopReport:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Loop:
    """The live 1 kHz loop: a thread that waits, reads, ticks, writes. Python's lock is never
    taken by it. As a context manager it starts, and stops at the end.

    Leave the scene, the devices and the log alone while it runs, except for what is made for
    another thread: PointerDevice.set, TickLog.take.
    """
    @overload
    def __init__(
        self,
        scene: Scene,
        device: HapticDevice,
        options: LoopOptions = ...,
        log: TickLog | None = ...,
        task: Task | None = ...,
    ) -> None:
        """__init__(*args, **kwargs)

        A loop over a scene that build_scene made; log takes what every tick did; a task, of
        build_task with that scene, is judged in every tick, and ends the run when it is
        decided.

        The same with one device for each instrument, in their order. Raises ValueError for
        another number of them, or one that is there twice.
        """
    @overload
    def __init__(
        self,
        scene: Scene,
        devices: Sequence,
        options: LoopOptions = ...,
        log: TickLog | None = ...,
        task: Task | None = ...,
    ) -> None: ...
    def start(self) -> None:
        """Raises RuntimeError the second time: a loop runs once."""
    def stop(self) -> None:
        """Asks and waits; every device gets a zero force last."""
    def wait(self, timeout: float) -> bool:
        """[s] True once the run has ended.

        Args:
            timeout: [s]
        """
    def running(self) -> bool:
        """Whether the thread runs."""
    def pause(self) -> None:
        """From any thread; followed within a tick. While it is paused devices get zero forces
        and the time of the run stands still: what would have been due is neither missed nor
        made up. The force then fades in as at the start.
        """
    def resume(self) -> None:
        """Goes on where pause stopped."""
    def paused(self) -> bool:
        """The last command has gone out, a zero force after it."""
    def take_snapshot(self) -> bool:
        """For one reader thread: True if something newer than last time was taken."""
    def snapshot(self) -> Snapshot:
        """A copy of the snapshot last taken."""
    def report(self) -> LoopReport:
        """Costs so far; while running, of the ticks finished by now."""
    def __enter__(self) -> Loop: ...
    def __exit__(self, *args: object) -> None: ...
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

class Record:
    """A whole run in memory: enough to run it again."""
    def __init__(
        self,
        *,
        header: str = ...,
        hand: object = ...,
        felt: object = ...,
        events: object = ...,
        hashes: object = ...,
        complete: bool = ...,
        instruments: int | None = ...,
    ) -> None:
        """Copies its tables: structured arrays with the dtype of HapticSample, Felt, Event and
        StateHash, or lists of these. hand and felt of k instruments have the shape (n, k),
        or are lists with those of each tick in order, and instruments says how many.

        Arguments are the fields of these names, with their shapes and units.
        """
    header: str
    """JSON: version, kernel, build, scene hash, device, columns, ..."""
    @property
    def hand(self) -> NDArray[Any]:
        """Per tick, a structured array with the fields of HapticSample, shape (n,), or (n, k)
        of k instruments; a view.
        """
    @property
    def felt(self) -> NDArray[Any]:
        """Per tick, a structured array with the fields of Felt, shape (n,), or (n, k) of k
        instruments; a view.
        """
    @property
    def events(self) -> NDArray[Any]:
        """A structured array with the fields of Event, shape (n,); a view."""
    @property
    def hashes(self) -> NDArray[Any]:
        """At 1 Hz, a structured array with the fields of StateHash, shape (n,); a view."""
    complete: bool
    """The file has its summary and the summary's SHA-256 holds."""
    @property
    def instruments(self) -> int:
        """Rows of hand and of felt a tick."""
    def __copy__(self) -> Record:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Record:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str: ...

def count_ticks(record: Record) -> int:
    """Ticks of a record. Raises ValueError where hand and felt are not as many whole ones."""

class RecordCodec(enum.Enum):
    """How a block's body is stored."""

    none = 0
    deflate = 1

class Recorder:
    """Writes a .prec record while it is being made, readable up to its last whole block at any
    moment. As a context manager it finishes at the end.
    """
    def __init__(
        self,
        path: os.PathLike[str] | str | bytes,
        header_json: str,
        codec: RecordCodec = ...,
        instruments: int = ...,
        bodies: int = ...,
    ) -> None:
        """header_json is one JSON object; the column table and the format version are added to
        it. instruments and bodies are how many the scene has. Raises FileError when the file
        cannot be written, ValueError for a bad header or none of them.
        """
    def log(self) -> TickLog:
        """Where the haptic thread pushes; hand it to a Loop."""
    def finish(self) -> None:
        """Writes what is left, then the summary; syncs. Raises FileError."""
    def __enter__(self) -> Recorder: ...
    def __exit__(self, *args: object) -> None: ...
    def __reduce_ex__(self, protocol: int) -> object:
        """Raises TypeError: not to be pickled."""

def write_record(
    path: os.PathLike[str] | str | bytes, record: Record, codec: RecordCodec = ...
) -> None:
    """Writes a whole record at once, to a temporary name, synced, renamed. Raises FileError."""

def read_record(path: os.PathLike[str] | str | bytes) -> Record:
    """Reads a record; an unfinished file ends at its last good block (complete = False). Raises
    FileError for anything else that is wrong, naming block and field.
    """

class ReplayReport:
    """How a replay compares with what was recorded."""
    @property
    def ticks(self) -> int:
        """How many were run."""
    @property
    def equal(self) -> bool:
        """Every force, every tool position and every hash, bit by bit."""
    @property
    def first_difference(self) -> int:
        """Tick, -1 for none."""
    @property
    def largest_force_difference(self) -> float:
        """[N]"""
    @property
    def largest_position_difference(self) -> float:
        """[m] of the tool."""
    @property
    def felt(self) -> NDArray[Any]:
        """As replayed, a structured array with the fields of Felt, shape as in the record; a
        view.
        """
    @property
    def instruments(self) -> int:
        """Rows of felt a tick."""
    @property
    def task(self) -> TaskState:
        """The TaskState at its end; without steps where no task was judged."""
    @property
    def events(self) -> NDArray[Any]:
        """Of the task, as judged again, a structured array with the fields of Event, shape
        (k,); a view.
        """
    @property
    def events_equal(self) -> bool:
        """The record has the very same."""
    @property
    def first_event_difference(self) -> int:
        """Tick, -1 for none."""
    def __copy__(self) -> ReplayReport:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> ReplayReport:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object, object, object, object, object, object, object, object, object, object, object
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def replay(scene: Scene, record: Record, task: Task | None = ...) -> ReplayReport:
    """Runs the recorded hands through the same tick from a fresh world, and judges a task, of
    build_task with that scene, where one is given. What the judge leaves undecided came out
    as the record says: left, a fault of the device, or interrupted, where it does not say.
    Raises ValueError for a record with gaps, with more rows of hand than of felt, or of
    another number of instruments than the scene has. To learn what any hand would feel, give
    it zeros for felt, as many as rows of hand, and read the report's felt.
    """

def find_outcome(record: Record) -> Outcome:
    """How the task of a recorded run came out: as its last event says, else interrupted, also
    for a record without a task.
    """

class BenchRow:
    """What one piece of work costs, beside the same work done naively in the same process."""
    @property
    def work(self) -> str:
        """'mss_step', 'refit', 'mms_tick', ..."""
    @property
    def vertices(self) -> int:
        """Of the surface."""
    @property
    def substeps(self) -> int:
        """Of a tick; 0 for other work."""
    @property
    def median(self) -> float:
        """[s] CPU time of the calling thread."""
    @property
    def p99(self) -> float:
        """[s]"""
    @property
    def naive_median(self) -> float:
        """[s] of the naive form."""
    @property
    def ratio_to_naive(self) -> float:
        """[-] naive_median / median: above 1 is faster than naive."""
    @property
    def elements(self) -> float:
        """[-] Links, triangles, queries, ... that the time is for; 1 for a tick."""
    @property
    def share_of_bound(self) -> float:
        """[-] The least time this machine needs, by its measured arithmetic and memory, over
        median; 0 where no such time is stated.
        """
    @property
    def simd_target(self) -> str:
        """'AVX3', 'AVX2', ...; empty for plain code."""
    @property
    def compiler_flags(self) -> str:
        """Of all forms alike."""
    def ns_per_element(self) -> float:
        """[ns]"""
    @property
    def physics(self) -> str:
        """What is in it, in words."""
    def __copy__(self) -> BenchRow:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> BenchRow:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class BenchOptions:
    """What is timed, and for how long."""
    def __init__(
        self,
        *,
        budget: float = ...,
        least_runs: int = ...,
        works: Sequence[str] = ...,
        air_substeps: Sequence[int] = ...,
        press: bool = ...,
    ) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    budget: float
    """[s] of CPU time per row, the naive form not counted."""
    least_runs: int
    """Fewer where a run takes so long that they would take 20 budgets."""
    @property
    def works(self) -> list[str]:
        """Of bench_works(); all where empty."""
    @works.setter
    def works(self, value: Sequence[str]) -> None: ...
    @property
    def air_substeps(self) -> list[int]:
        """Of ticks with the hand in the air: a row for each."""
    @air_substeps.setter
    def air_substeps(self, value: Sequence[int]) -> None: ...
    press: bool
    """And a row with a press held, at its own substeps."""
    def __copy__(self) -> BenchOptions:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> BenchOptions:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def bench_works() -> list[str]:
    """Every work this machine can do, in the order of the rows."""

def run_bench(mass_spring: Scene, molecular: Scene, options: BenchOptions = ...) -> list[BenchRow]:
    """Times the steps, queries and ticks of two scenes on the same surface, one of the
    mass-spring and one of the molecular model. Raises RuntimeError where ours and the naive
    form disagree, ValueError where the scenes do not fit or a work is not known.
    """

def bench_body_works() -> list[str]:
    """Every work of bodies: walls of prisms, solids of springs and volumes, linear solids."""

def run_body_bench(scene: Scene, options: BenchOptions = ...) -> list[BenchRow]:
    """Times the step and the tick of one body beside its naive form, as run_bench does. What is
    asked for and not of this kind of body is left out. A linear solid has one row in the
    air, since its ticks there have one substep. Raises as run_bench does, and ValueError for
    a tissue of another kind or under a skin.
    """

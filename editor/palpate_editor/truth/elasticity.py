# SPDX-License-Identifier: GPL-3.0-or-later
"""Static elasticity on tetrahedra, linear and neo-Hookean: P1 and P2 of scikit-fem."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.sparse as sparse
from skfem import Basis, ElementTetP1, ElementTetP2, MeshTet

from palpate_editor.truth.cholesky import Factor, NotPositiveDefinite
from palpate_editor.truth.tetrahedra import Floats, Ints

RESIDUAL = 1e-6
"""Newton ends when the free forces are this part of the force that holds the fixed ones."""
NEWTON_MAX = 40
CG_MAX = 40
CLOSE = 1e-2
"""Of Newton's residual: what conjugate gradients leave of it."""


class Diverged(Exception):
    """Newton did not reach equilibrium."""


@dataclass(frozen=True)
class Lame:
    """Both of Lamé's constants [Pa]."""

    shear: float
    first: float


def find_lame(young_modulus: float, poisson_ratio: float) -> Lame:
    return Lame(
        young_modulus / (2.0 * (1.0 + poisson_ratio)),
        young_modulus * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio)),
    )


class Body:
    """A mesh with its finite elements; displacements are (nodes, 3), vertices come first."""

    def __init__(
        self,
        x: Floats,
        t: Ints,
        lame: Lame,
        order: int,
        refinements: int,
        tags: dict,
        scale: Floats | None = None,
    ):
        mesh = MeshTet(np.ascontiguousarray(x.T), np.ascontiguousarray(t.T))
        for _ in range(refinements):
            tags = {name: refine_faces(mesh, faces) for name, faces in tags.items()}
            mesh = mesh.refined(1)
        basis = Basis(mesh, {1: ElementTetP1, 2: ElementTetP2}[order](), intorder=order)
        self.lame = lame
        self.node_count: int = basis.N
        self.vertex_nodes: Ints = basis.nodal_dofs[0]
        self.cells: Ints = basis.element_dofs.T
        # (element, quadrature point, local node, axis)
        self.slopes = np.stack([f[0].grad for f in basis.basis]).transpose(2, 3, 0, 1).copy()
        # both of Lamé's constants are as many times larger as a tetrahedron is stiffer
        self.weights: Floats = np.asarray(basis.dx) * (1.0 if scale is None else scale[:, None])
        self.tags: dict[str, Ints] = {
            name: basis.get_dofs(find_facets(mesh, f)).all() for name, f in tags.items()
        }
        self.basis = basis

    def strain(self, u: Floats) -> Floats:
        """The gradient of the displacement, (element, point, 3, 3)."""
        return u[self.cells].transpose(0, 2, 1)[:, None] @ self.slopes

    def stress(self, u: Floats, law: str) -> tuple[Floats, Floats, Floats]:
        """First Piola-Kirchhoff stress [Pa], inverse of F, ln J; NaN where turned inside out."""
        mu, lam = self.lame.shear, self.lame.first
        h = self.strain(u)
        one = np.eye(3)
        if law == "linear":
            trace = np.trace(h, axis1=2, axis2=3)[..., None, None]
            stress = mu * (h + h.transpose(0, 1, 3, 2)) + lam * trace * one
            return stress, np.broadcast_to(one, h.shape), np.zeros(h.shape[:2])
        f = h + one
        volume = np.linalg.det(f)
        with np.errstate(invalid="ignore"):
            log = np.log(np.where(volume > 0.0, volume, np.nan))
        inverse = np.linalg.inv(f)
        turned = inverse.transpose(0, 1, 3, 2)
        return mu * (f - turned) + lam * log[..., None, None] * turned, inverse, log

    def energy(self, u: Floats) -> float:
        """[J] of the neo-Hookean body; infinite where it is turned inside out."""
        mu, lam = self.lame.shear, self.lame.first
        f = self.strain(u) + np.eye(3)
        volume = np.linalg.det(f)
        if not (volume > 0.0).all():
            return np.inf
        log = np.log(volume)
        density = 0.5 * mu * ((f**2).sum(axis=(2, 3)) - 3.0 - 2.0 * log) + 0.5 * lam * log**2
        return float((density * self.weights).sum())

    def forces(self, u: Floats, law: str) -> Floats:
        """What the body pulls its nodes back with, [N], (nodes, 3): the gradient of the energy."""
        stress = self.stress(u, law)[0] * self.weights[..., None, None]
        local = (self.slopes @ stress.transpose(0, 1, 3, 2)).sum(axis=1)
        f = np.zeros((self.node_count, 3))
        for axis in range(3):
            f[:, axis] = np.bincount(
                self.cells.ravel(), weights=local[..., axis].ravel(), minlength=self.node_count
            )
        return f

    def tangent(self, u: Floats, law: str) -> Floats:
        """Element stiffness [N/m], (element, 3a + i, 3b + j)."""
        mu, lam = self.lame.shear, self.lame.first
        _, inverse, log = self.stress(u, law)
        g, w = self.slopes, self.weights
        # slopes in space: F^-T grad N
        s = g if law == "linear" else g @ inverse
        count, nodes = len(g), g.shape[2]
        k = np.zeros((count, nodes, 3, nodes, 3))
        for q in range(w.shape[1]):
            sq, wq = s[:, q], w[:, q, None, None]
            flat = sq.reshape(count, -1)
            outer = (flat[:, :, None] * flat[:, None, :]).reshape(k.shape)
            turn = (wq * (mu - lam * log[:, q, None, None]))[..., None, None]
            k += (lam * wq)[..., None, None] * outer + turn * outer.transpose(0, 1, 4, 3, 2)
            same = mu * wq * (g[:, q] @ g[:, q].transpose(0, 2, 1))
            for axis in range(3):
                k[:, :, axis, :, axis] += same
        return k.reshape(count, 3 * nodes, 3 * nodes)


def find_facets(mesh: MeshTet, faces: Ints) -> Ints:
    """Facet numbers of triangles given by their vertices."""
    found = {tuple(f): i for i, f in enumerate(np.sort(mesh.facets.T, axis=1).tolist())}
    return np.array([found[tuple(f)] for f in np.sort(faces, axis=1).tolist()])


def refine_faces(mesh: MeshTet, faces: Ints) -> Ints:
    """The four parts of every triangle, as scikit-fem will number their vertices."""
    ends = np.sort(mesh.edges.T, axis=1).tolist()
    middle = {(a, b): mesh.p.shape[1] + i for i, (a, b) in enumerate(ends)}
    parts = []
    for a, b, c in faces.tolist():
        p, q, r = (middle[min(e), max(e)] for e in ((a, b), (b, c), (c, a)))
        parts += [(a, p, r), (b, q, p), (c, r, q), (p, q, r)]
    return np.array(parts)


class Press:
    """A body held at one tag, and moved at another as a whole: equilibrium, and the force of it."""

    def __init__(self, body: Body, held: str, moved: str):
        self.body = body
        fixed = np.union1d(body.tags[held], body.tags[moved])
        self.moved = np.setdiff1d(body.tags[moved], body.tags[held])
        free = np.setdiff1d(np.arange(body.node_count), fixed)
        self.free = free
        number = np.full(3 * body.node_count, -1)
        dofs = (3 * free[:, None] + np.arange(3)).ravel()
        number[dofs] = np.arange(len(dofs))
        local = number[(3 * body.cells[:, :, None] + np.arange(3)).reshape(len(body.cells), -1)]
        rows, cols = np.broadcast_arrays(local[:, :, None], local[:, None, :])
        # the lower half alone: the tangent is symmetric, and CHOLMOD reads no more
        self.kept = (rows >= cols) & (cols >= 0)
        self.rows, self.cols = (part[self.kept].astype(np.int32) for part in (rows, cols))
        self.size = len(dofs)

    @cached_property
    def matrix(self) -> sparse.csc_matrix:
        """The lower half of the linear stiffness [N/m]."""
        return self.stiffness(np.zeros((self.body.node_count, 3)), "linear")

    @cached_property
    def factor(self) -> Factor:
        """Of the linear stiffness, or of the last one that was factorised."""
        return Factor(self.matrix)

    def stiffness(self, u: Floats, law: str) -> sparse.csc_matrix:
        values = self.body.tangent(u, law)[self.kept]
        return sparse.csc_matrix((values, (self.rows, self.cols)), shape=(self.size, self.size))

    def solve(self, matrix: sparse.csc_matrix, right: Floats) -> Floats:
        """A descent direction: conjugate gradients on the last factor, until they are close or
        meet a direction in which the body gives way. Factorises again where they are slow."""
        diagonal = matrix.diagonal()
        found, left = np.zeros_like(right), right.copy()
        close = self.factor(left)
        step, goal = close.copy(), CLOSE**2 * (left @ close)
        reach = left @ close
        for _ in range(CG_MAX):
            pull = matrix @ step + matrix.T @ step - diagonal * step
            curve = step @ pull
            if curve <= 0.0:
                return found if found.any() else step
            found += reach / curve * step
            left -= reach / curve * pull
            close = self.factor(left)
            before, reach = reach, left @ close
            if reach < goal:
                return found
            step = close + reach / before * step
        try:
            self.factor = Factor(matrix)
        except NotPositiveDefinite:
            return found
        return self.factor(right)

    def respond(self, shift: Floats) -> Floats:
        """The linear response to the moved nodes going by `shift` [m]."""
        u = np.zeros((self.body.node_count, 3))
        u[self.moved] = shift
        u[self.free] = -self.factor(self.body.forces(u, "linear")[self.free].ravel()).reshape(-1, 3)
        return u

    def balance(self, u: Floats) -> Floats:
        """Neo-Hookean equilibrium with all but the free nodes where `u` has them."""
        u = u.copy()
        f = self.body.forces(u, "neo_hookean")
        if not np.isfinite(f).all():
            raise Diverged("the first guess is turned inside out")
        for _ in range(NEWTON_MAX):
            right = f[self.free].ravel()
            if np.linalg.norm(right) < RESIDUAL * np.linalg.norm(f):
                return u
            step = self.solve(self.stiffness(u, "neo_hookean"), -right).reshape(-1, 3)
            u, f = self.search(u, step, float(-right @ step.ravel()))
        raise Diverged(f"no equilibrium after {NEWTON_MAX} steps")

    def search(self, u: Floats, step: Floats, slope: float) -> tuple[Floats, Floats]:
        """As far along the step as lowers the energy."""
        energy, part = self.body.energy(u), 1.0
        while part > 1e-5:
            there = u.copy()
            there[self.free] += part * step
            after = self.body.energy(there)
            # the last steps change less energy than its rounding
            if after <= energy - 1e-4 * part * slope + 1e-12 * energy:
                return there, self.body.forces(there, "neo_hookean")
            part *= 0.5
        raise Diverged("no lower energy along the step")

    def force(self, u: Floats, law: str) -> Floats:
        """What the moved nodes must be pushed with, [N]."""
        return self.body.forces(u, law)[self.moved].sum(axis=0)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Sparse Cholesky factors: CHOLMOD of CVXOPT's wheel, in METIS' nested dissection."""

from __future__ import annotations

import numpy as np
import pymetis
import scipy.sparse as sparse
from cvxopt import cholmod, matrix, spmatrix

from palpate_editor.truth.tetrahedra import Floats, Ints

A_X, L_X, PT_X = 0, 4, 7
"""What CHOLMOD solves: A x = b, L x = b, P^T x = b."""
AXES = 3
"""Freedoms of a node, which follow each other."""


class NotPositiveDefinite(Exception):
    """A matrix that has no Cholesky factor."""


class Factor:
    """P A P^T = L L^T; called with right-hand sides (n,) or (n, k), it gives A^-1 of them."""

    def __init__(self, lower: sparse.csc_matrix):
        """Of the lower half of a symmetric matrix. Raises NotPositiveDefinite."""
        whole = lower.tocoo()
        values = spmatrix(whole.data, whole.row.astype(int), whole.col.astype(int), lower.shape)
        order = find_order(lower)
        self.size: int = lower.shape[0]
        self.factor = cholmod.symbolic(values, p=matrix(order))
        try:
            cholmod.numeric(values, self.factor)
        except ArithmeticError:
            raise NotPositiveDefinite from None

    def __call__(self, right: Floats) -> Floats:
        return self.solve(right, A_X)

    def halve(self, right: Floats) -> Floats:
        """L^-1 P of right-hand sides: what two of them give by A^-1 is the product of theirs, at
        half the work."""
        return self.solve(right, PT_X, L_X)

    def solve(self, right: Floats, *systems: int) -> Floats:
        found = matrix(np.ascontiguousarray(right.reshape(self.size, -1)))
        for system in systems:
            cholmod.solve(self.factor, found, sys=system)
        return np.array(found).reshape(right.shape)


def find_order(lower: sparse.csc_matrix) -> Ints:
    """(n,) the order in which freedoms are eliminated, those of a node together."""
    whole = lower.tocoo()
    count = lower.shape[0] // AXES
    rows, columns = whole.row // AXES, whole.col // AXES
    apart = rows != columns
    ends = (rows[apart], columns[apart])
    half = sparse.csr_matrix((np.ones(len(ends[0]), np.int32), ends), shape=(count, count))
    graph = (half + half.T).tocsr()
    order, _ = pymetis.nested_dissection(pymetis.CSRAdjacency(graph.indptr, graph.indices))
    nodes = np.array(order, dtype=int)
    return (AXES * nodes[:, None] + np.arange(AXES)).ravel().astype(int)

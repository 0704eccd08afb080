# SPDX-License-Identifier: BSD-3-Clause
"""Organs of our own: (parameters, seed) -> (vertices [m], triangles), counts exact.

    vertices, triangles = ellipsoid(vertices=600)      # a closed spleen
    write_obj("spleen.obj", vertices, triangles)

Right-handed, z up, triangles counter-clockwise from outside. The same call gives the same mesh.
"""

from palpate_meshes.generate.ellipsoid import ellipsoid
from palpate_meshes.generate.obj import write_obj
from palpate_meshes.generate.sheet import sheet
from palpate_meshes.generate.tube import tube

__all__ = ["ellipsoid", "sheet", "tube", "write_obj"]

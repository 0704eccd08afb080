# SPDX-License-Identifier: BSD-3-Clause
"""Organs of our own: (parameters, seed) -> (vertices [m], triangles), counts exact.

    vertices, triangles = spleen()                     # the one that ships: 600 vertices
    vertices, triangles = liver(vertices=1500, seed=3) # another, coarser
    write_obj("liver.obj", vertices, triangles)

Right-handed, z up, -y the front, x the patient's left; triangles counter-clockwise from outside.
The same call gives the same mesh. `ellipsoid`, `sheet` and `tube` are plain shapes for tests.
"""

from palpate_meshes.generate.collecting_system import collecting_system
from palpate_meshes.generate.ellipsoid import ellipsoid
from palpate_meshes.generate.gallbladder import gallbladder
from palpate_meshes.generate.kidney import kidney
from palpate_meshes.generate.kidney_stone import kidney_stone
from palpate_meshes.generate.liver import liver
from palpate_meshes.generate.obj import write_obj
from palpate_meshes.generate.sheet import sheet
from palpate_meshes.generate.simple_tissue import simple_tissue
from palpate_meshes.generate.spleen import spleen
from palpate_meshes.generate.stomach import stomach
from palpate_meshes.generate.tube import tube

__all__ = [
    "collecting_system",
    "ellipsoid",
    "gallbladder",
    "kidney",
    "kidney_stone",
    "liver",
    "sheet",
    "simple_tissue",
    "spleen",
    "stomach",
    "tube",
    "write_obj",
]

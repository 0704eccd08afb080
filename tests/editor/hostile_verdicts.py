# SPDX-License-Identifier: GPL-3.0-or-later
"""What becomes of every hostile file of the shared data: opened, or refused with these words."""

from __future__ import annotations

OPENS: dict[str, tuple[int, tuple[str, ...]]] = {
    "assimp_OBJ_box_longline.obj": (14, ("non_manifold", "crossing")),
    "assimp_OBJ_concave_polygon.obj": (64, ()),
    "assimp_OBJ_multiple_spaces.obj": (1, ()),
    "assimp_OBJ_testmixed.obj": (12, ()),
    "assimp_OBJ_only_a_part_of_vertexcolors.obj": (3, ()),
    "assimp_PLY_cube_binary_starts_with_nl.ply": (12, ()),
    "assimp_STL_triangle_with_two_solids.stl": (2, ()),
    "assimp_glTF2_BoxBadNormals-glTF-Binary_BoxBadNormals.glb": (12, ("size",)),
    "assimp_FBX_cubes_with_mirroring_and_pivot.fbx": (420, ()),
    "assimp_Collada_regr01.dae": (172, ("crossing",)),
    "trimesh_soup.stl": (100, ("crossing",)),
    "trimesh_notenoughindices.obj": (1, ()),
    "trimesh_polygonfaces.obj": (3, ()),
    "trimesh_multibody.stl": (32, ()),
    "trimesh_joined_tetrahedra.obj": (7, ("non_manifold",)),
    "trimesh_singlevn.obj": (2, ()),
    "trimesh_large_block.STL": (12, ()),
}
"""File -> its triangles, and the errors that keep a tissue from being built on them."""

REFUSED: dict[str, str] = {
    "assimp_invalid_OutOfMemory.off": "the end of the file",
    "assimp_invalid_empty.obj": "0 bytes",
    "assimp_invalid_empty.off": "0 bytes",
    "assimp_invalid_malformed.obj": "vertex 12",
    "assimp_OFF_invalid.off": "'2'",
    "assimp_OBJ_testline.obj": "no triangles",
    "assimp_PLY_points.ply": "no faces",
    "assimp_glTF2_IndexOutOfRange_IndexOutOfRange.gltf": "could not open referenced file",
    "assimp_glTF2_RecursiveNodes_RecursiveNodes.gltf": "content assimp refuses (GLTF: Object",
    "assimp_glTF2_TestNoRootNode_NoScene.gltf": "content assimp refuses (GLTF: No scene)",
    "assimp_glTF2_IncorrectVertexArrays_Cube.gltf": "could not open referenced file",
    "trimesh_ply_empty_header.ply": "no faces",
    "trimesh_points_emptyface.ply": "no faces",
}
"""File -> what was found in the place of a mesh, or part of it."""

SIMULABLE: dict[str, tuple[str, ...]] = {
    "hostile/assimp_OBJ_box_longline.obj": (),
    "hostile/assimp_OBJ_concave_polygon.obj": (),
    "hostile/assimp_OBJ_multiple_spaces.obj": (),
    "hostile/assimp_OBJ_testmixed.obj": (),
    "hostile/assimp_OBJ_only_a_part_of_vertexcolors.obj": (),
    "hostile/assimp_PLY_cube_binary_starts_with_nl.ply": (),
    "hostile/assimp_STL_triangle_with_two_solids.stl": (),
    "hostile/assimp_glTF2_BoxBadNormals-glTF-Binary_BoxBadNormals.glb": (),
    "hostile/assimp_FBX_cubes_with_mirroring_and_pivot.fbx": (),
    "hostile/assimp_Collada_regr01.dae": ("too_slow", "too_many_substeps"),
    "hostile/trimesh_soup.stl": ("too_slow",),
    "hostile/trimesh_notenoughindices.obj": (),
    "hostile/trimesh_polygonfaces.obj": (),
    "hostile/trimesh_multibody.stl": (),
    "hostile/trimesh_joined_tetrahedra.obj": (),
    "hostile/trimesh_singlevn.obj": (),
    "hostile/trimesh_large_block.STL": (),
    "organs/VH_F_Spleen.glb": (),
    "organs/VH_F_Pancreas.glb": (),
    "organs/VH_F_Kidney_L.glb": ("too_slow",),
    "organs/VH_F_Liver.glb": (),
    "organs/VH_M_Heart.glb": (),
    "organs/gca_EdinGCA_3D_00020_small-intestine.vtk": (),
    "organs/hra_VH_F_Urinary_Bladder.glb": (),
    "organs/vtkdata_Torso.vtp": (),
}
"""Every shared file that opens -> the errors that are left of its surface and tissue once Repair
all is done. The soup of a hundred triangles and the Collada scene of pieces that cross have no
tissue that is stable in a tick."""

# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the files of VTK: legacy (.vtk), polygons (.vtp), grids (.vtu, .vts), blocks of
them (.vtm); and from those of other programs that VTK reads as well (vtk_data.OTHERS).

Which of them a file is, its beginning tells, whatever its name ends in.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkDataSetAttributes,
    vtkGenericCell,
    vtkPolyData,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import (
    vtkExtractCells,
    vtkStaticCleanUnstructuredGrid,
    vtkTriangleFilter,
)
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from palpate_editor.formats_child.scene import (
    NO_FILLING,
    Filling,
    Part,
    Refusal,
    Scene,
    check_corners,
    cut_filling,
    cut_out,
    describe_cells,
    describe_tetrahedra,
)
from palpate_editor.formats_child.vtk_data import OTHERS, open_other, open_vtk

VOXELS = ("a volume of voxels", "a surface: palpate segment cuts one out of a volume")
SURFACE = "polygons, or a grid of cells"
WHAT = {
    "vtkImageData": VOXELS,
    "vtkStructuredPoints": VOXELS,
    "vtkRectilinearGrid": ("a grid of boxes", SURFACE),
    "vtkTable": ("a table", SURFACE),
}
"""Kind of data -> what it is in words and what was expected, where it is no surface."""
TETRAHEDRA = (10, 24)
"""VTK_TETRA, VTK_QUADRATIC_TETRA: their corners come first."""


def read_vtk(path: str, form: str) -> Scene:
    """The outside of what a file holds; of several data sets, a part for each. Raises Refusal."""
    data, notes = open_other(path, form) if form in OTHERS else open_vtk(path, form)
    stem = Path(path).stem
    if isinstance(data, vtkCompositeDataSet):
        return read_blocks(stem, data, notes)
    part, filling = read_data(stem, data, notes)
    return Scene([part], notes, filling)


def read_blocks(stem: str, data: vtkCompositeDataSet, notes: list[str]) -> Scene:
    parts: list[Part] = []
    fillings: list[Filling] = []
    refusals: list[tuple[str, Refusal]] = []
    names: Counter[str] = Counter()
    for name, block in list_blocks(data):
        name = name or stem
        names[name] += 1
        label = name if names[name] == 1 else f"{name} ({names[name]})"
        said: list[str] = []
        try:
            part, filling = read_data(label, block, said)
        except Refusal as refusal:
            refusals.append((label, refusal))
            continue
        parts.append(part)
        fillings.append(filling)
        notes += said
    if not parts:
        raise refusals[0][1] if refusals else Refusal("", "no data sets", SURFACE)
    notes += [f"{label} was left out: {refusal.got}" for label, refusal in refusals]
    return Scene(parts, notes, fillings[0] if len(parts) == 1 else NO_FILLING)


def list_blocks(data: vtkCompositeDataSet) -> Iterator[tuple[str, vtkDataObject]]:
    """Each data set with the name that the file gives it."""
    walk = data.NewIterator()
    walk.SkipEmptyNodesOn()
    walk.InitTraversal()
    while not walk.IsDoneWithTraversal():
        name = ""
        if walk.HasCurrentMetaData():
            name = walk.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME()) or ""
        yield name, walk.GetCurrentDataObject()
        walk.GoToNextItem()


def read_data(name: str, data: vtkDataObject, notes: list[str]) -> tuple[Part, Filling]:
    """The surface of a data set, and its tetrahedra. Raises Refusal."""
    if not isinstance(data, vtkPolyData | vtkUnstructuredGrid | vtkStructuredGrid):
        kind = data.GetClassName()
        raise Refusal("", *WHAT.get(kind, (kind, SURFACE)))
    if data.GetNumberOfPoints() == 0:
        raise Refusal("", "no points", "a surface made of triangles or polygons")
    filling = NO_FILLING
    if isinstance(data, vtkUnstructuredGrid):
        if data.GetNumberOfCells() == 0:
            raise Refusal("", "points without cells", SURFACE)
        check_cells(name, data.GetCells(), data.GetNumberOfPoints())
        data = choose_cells(data)
        filling = take_filling(data, notes)
    return take_surface(name, data), filling


def take_surface(name: str, data: vtkDataSet) -> Part:
    """The triangles of a data set: its polygons, or the outer faces of its cells."""
    if not isinstance(data, vtkPolyData):
        outside = vtkDataSetSurfaceFilter()
        outside.SetInputData(data)
        outside.SetNonlinearSubdivisionLevel(0)
        outside.Update()
        data = outside.GetOutput()
    for cells in (data.GetPolys(), data.GetStrips()):
        check_cells(name, cells, data.GetNumberOfPoints())
    triangles = vtkTriangleFilter()
    triangles.SetInputData(data)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    flat = triangles.GetOutput()
    if flat.GetNumberOfPolys() == 0:
        raise Refusal("", "no polygons", "a surface made of triangles or polygons")
    corners = vtk_to_numpy(flat.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    colours = find_colours(flat.GetPointData())
    part = cut_out(name, vtk_to_numpy(flat.GetPoints().GetData()), corners, colours)
    return replace(part, colour=find_colour(flat))


def find_colour(data: vtkPolyData) -> tuple[float, ...]:
    """The mean of colours that stand at points or at polygons; none where there are none, or they
    are all white."""
    for of in (data.GetPointData(), data.GetCellData()):
        values = find_colours(of)
        if values is not None:
            mean = values.mean(axis=0) / 255.0
            return () if (mean > 0.998).all() else tuple(mean.tolist())
    return ()


def find_colours(of: vtkDataSetAttributes) -> np.ndarray | None:
    """(n, 3) uint8, where its scalars are three or four bytes each."""
    colours = of.GetScalars()
    if colours is None or colours.GetNumberOfTuples() == 0:
        return None
    values = vtk_to_numpy(colours)
    is_colour = values.dtype == np.uint8 and values.ndim == 2 and values.shape[1] in (3, 4)
    return values[:, :3] if is_colour else None


def take_filling(grid: vtkUnstructuredGrid, notes: list[str]) -> Filling:
    """The tetrahedra, where all cells that fill space are some."""
    types = list_types(grid)
    if len(types) == 0 or measure_dimension(int(types[0])) != 3:
        return NO_FILLING
    if not np.isin(types, TETRAHEDRA).all():
        notes.append(describe_cells(len(types)))
        return NO_FILLING
    notes.append(describe_tetrahedra(len(types)))
    first = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1]
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    points = vtk_to_numpy(grid.GetPoints().GetData())
    return cut_filling(points, corners[first[:, None] + np.arange(4)])


def check_cells(name: str, cells: object, count: int) -> None:
    """Raises Refusal for a corner no point stands for, which VTK itself would follow anywhere."""
    if cells is not None and cells.GetNumberOfCells() > 0:
        check_corners(name, vtk_to_numpy(cells.GetConnectivityArray()), count)


def choose_cells(grid: vtkUnstructuredGrid) -> vtkUnstructuredGrid:
    """The cells that fill space, where there are some, else all: faces drawn on or in them as well
    would be there twice. Cells that have points of their own where they meet share them then."""
    types = list_types(grid)
    fills = [int(kind) for kind in np.unique(types) if measure_dimension(int(kind)) == 3]
    solid = np.flatnonzero(np.isin(types, fills) & ~find_flat(grid, types))
    if len(solid) == 0:
        return grid
    if len(solid) < grid.GetNumberOfCells():
        chosen = vtkExtractCells()
        chosen.SetInputData(grid)
        chosen.SetCellIds(solid.astype(np.int64), len(solid))
        chosen.Update()
        grid = chosen.GetOutput()
    joined = vtkStaticCleanUnstructuredGrid()
    joined.SetInputData(grid)
    joined.SetTolerance(0.0)
    joined.RemoveUnusedPointsOff()
    joined.Update()
    return joined.GetOutput()


def list_types(grid: vtkUnstructuredGrid) -> np.ndarray:
    """(cells,) Of VTK's kinds; those of XDMF have no array of them."""
    types = grid.GetCellTypesArray()
    if types is not None:
        return vtk_to_numpy(types)
    count = grid.GetNumberOfCells()
    return np.fromiter((grid.GetCellType(i) for i in range(count)), np.uint8, count)


def find_flat(grid: vtkUnstructuredGrid, types: np.ndarray) -> np.ndarray:
    """(cells,) bool: tetrahedra that have a corner twice."""
    flat = np.zeros(len(types), bool)
    rows = np.flatnonzero(np.isin(types, TETRAHEDRA))
    first = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[rows]
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())[first[:, None] + np.arange(4)]
    flat[rows] = (np.diff(np.sort(corners, axis=1), axis=1) == 0).any(axis=1)
    return flat


def measure_dimension(kind: int) -> int:
    """3 of a kind of cell that fills space, 2 of a polygon; -1 for one that VTK does not know."""
    cell = vtkGenericCell.InstantiateCell(kind)
    return -1 if cell is None else cell.GetCellDimension()

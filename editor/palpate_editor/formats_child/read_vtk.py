# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from the files of VTK: legacy (.vtk), polygons (.vtp), unstructured grids (.vtu)."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import (
    vtkDataSet,
    vtkGenericCell,
    vtkPolyData,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkExtractCells, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from palpate_editor.formats_child.scene import (
    Part,
    Refusal,
    Scene,
    check_corners,
    cut_out,
    describe_filling,
)

READERS = {
    "VTK": vtkGenericDataObjectReader,
    "VTP": vtkXMLPolyDataReader,
    "VTU": vtkXMLUnstructuredGridReader,
}
WHAT = {
    "vtkImageData": "a volume of voxels",
    "vtkStructuredPoints": "a volume of voxels",
    "vtkRectilinearGrid": "a grid of boxes",
    "vtkTable": "a table",
}
"""Kind of data -> in words, where it is no surface."""


def read_vtk(path: str, form: str) -> Scene:
    """The outside of what a file holds. Raises Refusal."""
    said = vtkStringOutputWindow()
    vtkStringOutputWindow.SetInstance(said)
    reader = READERS[form]()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutputDataObject(0)
    errors, warnings = sort_words(said.GetOutput())
    if data is None or errors:
        got = errors[0] if errors else "no data"
        raise Refusal("", f"content VTK refuses ({got})", f"a readable {form} file")
    if not isinstance(data, vtkPolyData | vtkUnstructuredGrid | vtkStructuredGrid):
        kind = data.GetClassName()
        raise Refusal("", WHAT.get(kind, kind), "polygons, or a grid of cells")
    notes = [f"VTK says: {warning}" for warning in dict.fromkeys(warnings)]
    return Scene([take_surface(Path(path).stem, data, notes)], notes)


def sort_words(text: str) -> tuple[list[str], list[str]]:
    """What VTK said, as errors and warnings, without its own files, lines and addresses."""
    kinds: dict[str, list[str]] = {"ERROR": [], "ERR": [], "WARN": [], "Warning": []}
    pattern = r"(ERROR|Warning|ERR|WARN)[:|].*?(?:\): |\| )(.*?)(?=\n\n|\n(?:ERROR|Warning)|\Z)"
    for kind, words in re.findall(pattern, text, re.DOTALL):
        kinds[kind].append(" ".join(words.split())[:200])
    return kinds["ERROR"] + kinds["ERR"], kinds["WARN"] + kinds["Warning"]


def take_surface(name: str, data: vtkDataSet, notes: list[str]) -> Part:
    """The triangles of a data set: its polygons, or the outer faces of its cells."""
    if data.GetNumberOfPoints() == 0:
        raise Refusal("", "no points", "a surface made of triangles or polygons")
    if isinstance(data, vtkUnstructuredGrid):
        check_cells(name, data.GetCells(), data.GetNumberOfPoints())
        data = choose_cells(data, notes)
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
    return cut_out(name, vtk_to_numpy(flat.GetPoints().GetData()), corners)


def check_cells(name: str, cells: object, count: int) -> None:
    """Raises Refusal for a corner no point stands for, which VTK itself would follow anywhere."""
    if cells is not None and cells.GetNumberOfCells() > 0:
        check_corners(name, vtk_to_numpy(cells.GetConnectivityArray()), count)


def choose_cells(grid: vtkUnstructuredGrid, notes: list[str]) -> vtkUnstructuredGrid:
    """The cells that fill space, where there are some, else all: faces drawn on or in them as well
    would be there twice."""
    types = vtk_to_numpy(grid.GetCellTypesArray())
    fills = [int(kind) for kind in np.unique(types) if measure_dimension(int(kind)) == 3]
    solid = np.flatnonzero(np.isin(types, fills))
    if len(solid) == 0:
        return grid
    notes.append(describe_filling(len(solid)))
    if len(solid) == grid.GetNumberOfCells():
        return grid
    chosen = vtkExtractCells()
    chosen.SetInputData(grid)
    chosen.SetCellIds(solid.astype(np.int64), len(solid))
    chosen.Update()
    return chosen.GetOutput()


def measure_dimension(kind: int) -> int:
    """3 of a kind of cell that fills space, 2 of a polygon; -1 for one that VTK does not know."""
    cell = vtkGenericCell.InstantiateCell(kind)
    return -1 if cell is None else cell.GetCellDimension()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything that can be done to an organ: frozen values, called with an organ, giving a new one.

An edit that cannot be done raises EditError and has changed nothing. No edit writes its own
inverse: documents are values, and to undo is to remember.
"""

from __future__ import annotations

from palpate_editor.edits.appearance import SetAppearance
from palpate_editor.edits.cap import CapHoles
from palpate_editor.edits.clean import CleanUp, DropPieces, Smooth, StitchBorders
from palpate_editor.edits.configure import Configure
from palpate_editor.edits.crossings import RemoveCrossings
from palpate_editor.edits.decimate import (
    Decimate,
    DecimateTo,
    UseImported,
    decimate_organ,
    decimate_within,
)
from palpate_editor.edits.edit import Edit, EditError
from palpate_editor.edits.fill_holes import FillHoles
from palpate_editor.edits.fins import DropFins
from palpate_editor.edits.fix import FixLowest, FixVertices
from palpate_editor.edits.history import read_line, write_down, write_line
from palpate_editor.edits.import_mesh import ImportMesh, import_file, import_read
from palpate_editor.edits.keep_outer import KeepOuter
from palpate_editor.edits.name import SetName, SetTask
from palpate_editor.edits.nested import DropDoubled
from palpate_editor.edits.orient import SetUnit, SetUp
from palpate_editor.edits.paint import PaintStiffness
from palpate_editor.edits.prepare import Prepared, prepare
from palpate_editor.edits.regions import RemoveRegion, SetRegion
from palpate_editor.edits.remesh import Remesh
from palpate_editor.edits.repair import (
    CutCrowdedEdges,
    CutDisagreement,
    KeepLargestShell,
    TurnOutward,
)
from palpate_editor.edits.repair_all import RepairAll
from palpate_editor.edits.set_assessment import SetAssessment
from palpate_editor.edits.set_constant import SetChoice, SetConstant, SetGravity, SetMaterial
from palpate_editor.edits.set_far_field import SetFarField
from palpate_editor.edits.set_reach import SetFineRegion, SetReach
from palpate_editor.edits.set_tissue import SetTissue
from palpate_editor.edits.unite import UniteShells
from palpate_editor.edits.wrap import Wrap

__all__ = [
    "CapHoles",
    "EVERY_EDIT",
    "CleanUp",
    "Configure",
    "CutCrowdedEdges",
    "CutDisagreement",
    "Decimate",
    "DecimateTo",
    "DropDoubled",
    "DropFins",
    "DropPieces",
    "Edit",
    "EditError",
    "FillHoles",
    "FixLowest",
    "FixVertices",
    "ImportMesh",
    "KeepLargestShell",
    "KeepOuter",
    "PaintStiffness",
    "Prepared",
    "Remesh",
    "RemoveCrossings",
    "RemoveRegion",
    "RepairAll",
    "SetAppearance",
    "SetAssessment",
    "SetChoice",
    "SetConstant",
    "SetFarField",
    "SetFineRegion",
    "SetGravity",
    "SetMaterial",
    "SetName",
    "SetReach",
    "SetRegion",
    "SetTask",
    "SetTissue",
    "SetUnit",
    "SetUp",
    "Smooth",
    "StitchBorders",
    "TurnOutward",
    "UniteShells",
    "UseImported",
    "Wrap",
    "decimate_organ",
    "decimate_within",
    "import_file",
    "import_read",
    "prepare",
    "read_line",
    "write_line",
]

EVERY_EDIT: tuple[type, ...] = (
    ImportMesh,
    SetUnit,
    SetUp,
    KeepOuter,
    KeepLargestShell,
    TurnOutward,
    CutCrowdedEdges,
    CutDisagreement,
    UniteShells,
    FillHoles,
    CapHoles,
    CleanUp,
    StitchBorders,
    DropFins,
    DropPieces,
    DropDoubled,
    RemoveCrossings,
    Smooth,
    Wrap,
    RepairAll,
    Remesh,
    Decimate,
    DecimateTo,
    UseImported,
    SetChoice,
    SetConstant,
    SetGravity,
    SetMaterial,
    Configure,
    SetFarField,
    SetReach,
    SetFineRegion,
    SetTissue,
    FixVertices,
    FixLowest,
    PaintStiffness,
    SetRegion,
    RemoveRegion,
    SetName,
    SetTask,
    SetAppearance,
    SetAssessment,
    Prepared,
)
"""Tests hold every one of them to the same laws."""

LINES: dict[str, type] = {
    kind.__name__: kind
    for kind in EVERY_EDIT
    if kind is not Prepared and not hasattr(kind, "repeat")
}
"""What a line of an organ's history may be, by name: those edits that can be done again by their
values. One that holds what it made has `repeat`, the edit that makes it."""

for _kind in EVERY_EDIT:
    if _kind is not Prepared:  # the edit in it leaves the line
        write_down(_kind)

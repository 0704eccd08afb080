# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything that can be done to an organ: frozen values, called with an organ, giving a new one.

An edit that cannot be done raises EditError and has changed nothing. No edit writes its own
inverse: documents are values, and to undo is to remember.
"""

from __future__ import annotations

from palpate_editor.edits.appearance import SetAppearance
from palpate_editor.edits.configure import Configure
from palpate_editor.edits.decimate import Decimate, UseImported, decimate_organ
from palpate_editor.edits.edit import Edit, EditError
from palpate_editor.edits.fill_holes import FillHoles
from palpate_editor.edits.fix import FixLowest, FixVertices
from palpate_editor.edits.import_mesh import ImportMesh, import_file
from palpate_editor.edits.name import SetName, SetTask
from palpate_editor.edits.orient import SetUnit, SetUp
from palpate_editor.edits.paint import PaintStiffness
from palpate_editor.edits.prepare import Prepared, prepare
from palpate_editor.edits.regions import RemoveRegion, SetRegion
from palpate_editor.edits.repair import (
    CutCrowdedEdges,
    CutDisagreement,
    KeepLargestShell,
    TurnOutward,
)
from palpate_editor.edits.set_constant import SetChoice, SetConstant, SetGravity, SetMaterial
from palpate_editor.edits.set_reach import SetReach
from palpate_editor.edits.set_tissue import SetTissue

__all__ = [
    "EVERY_EDIT",
    "Configure",
    "CutCrowdedEdges",
    "CutDisagreement",
    "Decimate",
    "Edit",
    "EditError",
    "FillHoles",
    "FixLowest",
    "FixVertices",
    "ImportMesh",
    "KeepLargestShell",
    "PaintStiffness",
    "Prepared",
    "RemoveRegion",
    "SetAppearance",
    "SetChoice",
    "SetConstant",
    "SetGravity",
    "SetMaterial",
    "SetName",
    "SetReach",
    "SetRegion",
    "SetTask",
    "SetTissue",
    "SetUnit",
    "SetUp",
    "TurnOutward",
    "UseImported",
    "decimate_organ",
    "import_file",
    "prepare",
]

EVERY_EDIT: tuple[type, ...] = (
    ImportMesh,
    SetUnit,
    SetUp,
    KeepLargestShell,
    TurnOutward,
    CutCrowdedEdges,
    CutDisagreement,
    FillHoles,
    Decimate,
    UseImported,
    SetChoice,
    SetConstant,
    SetGravity,
    SetMaterial,
    Configure,
    SetReach,
    SetTissue,
    FixVertices,
    FixLowest,
    PaintStiffness,
    SetRegion,
    RemoveRegion,
    SetName,
    SetTask,
    SetAppearance,
    Prepared,
)
"""Tests hold every one of them to the same laws."""

# SPDX-License-Identifier: GPL-3.0-or-later
"""The command lines that do what was done with the mouse, with its real numbers.

The document is named as the argument and the output: each line changes the file it is given. Every
edit has one; strokes of a brush are lists of vertices.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import degrees
from pathlib import Path
from typing import Any

import numpy as np
from palpate.viewport import View

from palpate_editor.appearance import write_colour
from palpate_editor.argument_text import LAWS, NONE, OPTIONS, write_factors, write_ids
from palpate_editor.document import Organ, Source
from palpate_editor.document.constants import CONSTANTS, SHORT_KINDS
from palpate_editor.edits import (
    Decimate,
    Edit,
    FillHoles,
    FixLowest,
    FixVertices,
    ImportMesh,
    KeepLargestShell,
    PaintStiffness,
    Prepared,
    RemoveRegion,
    SetAppearance,
    SetChoice,
    SetConstant,
    SetGravity,
    SetMaterial,
    SetName,
    SetReach,
    SetRegion,
    SetTask,
    SetUnit,
    SetUp,
    TurnOutward,
    UseImported,
)

KINDS = {kind: short for short, kind in SHORT_KINDS.items()}
ASKED = "as asked"
"""The reason of a unit or an axis that a person chose."""

Words = list[object]


def find_words(edit: Edit, organ: Organ, document: Path | str) -> Words | None:
    """The command line of an edit that led to `organ`; None where there is none."""
    if isinstance(edit, Prepared):
        edit = edit.edit
    find = FINDERS.get(type(edit))
    return None if find is None else find(edit, organ, document)


def import_words(edit: Any, organ: Organ, document: Path | str) -> Words | None:
    del edit
    return None if organ.source is None else source_words(organ.source, document)


def source_words(source: Source, document: Path | str) -> Words:
    words: Words = ["palpate", "import", Path(source.folder) / source.file]
    if source.parts != source.parts_available:
        for part in source.parts:
            words += ["--part", part]
    if source.unit_reason == ASKED:
        words += ["--unit", source.unit]
    if source.up_reason == ASKED:
        words.append(f"--up={source.up}")
    return [*words, "-o", document]


def decimate_words(edit: Decimate, organ: Organ, document: Path | str) -> Words:
    del organ
    count = edit.decimation.vertices
    return ["palpate", "decimate", document, "--vertices", count, "-o", document]


def repair_words(problem: str) -> Callable[[Any, Organ, Path | str], Words]:
    def find(edit: Any, organ: Organ, document: Path | str) -> Words:
        del edit, organ
        return ["palpate", "repair", document, "--problem", problem, "-o", document]

    return find


def hole_words(edit: FillHoles, organ: Organ, document: Path | str) -> Words | None:
    """Which of several holes were clicked on no line can say."""
    del organ
    if edit.holes is not None:
        return None
    return ["palpate", "repair", document, "--fill-holes", "-o", document]


def material_words(document: Path | str, options: Sequence[object]) -> Words:
    return ["palpate", "material", document, *options, "-o", document]


def constant_option(part: str, field: str, value: float | None) -> str:
    """One option with its unit; joined by = so that a negative number is no option itself."""
    option, unit = OPTIONS[f"{part}.{field}"]
    # 1/s is written 8/s, as quantities are read
    ending = "/s" if unit == "1/s" else unit
    return f"{option}={NONE}" if value is None else f"{option}={value:.12g}{ending}"


def constant_words(edit: SetConstant, organ: Organ, document: Path | str) -> Words:
    del organ
    return material_words(document, [constant_option(edit.part, edit.field, edit.value)])


def choice_words(edit: SetChoice, organ: Organ, document: Path | str) -> Words:
    del organ
    option = "--kind" if edit.field == "kind" else LAWS[f"model.{edit.field}"]
    return material_words(document, [option, KINDS.get(edit.value, edit.value)])


def gravity_words(edit: SetGravity, organ: Organ, document: Path | str) -> Words:
    del organ
    return material_words(document, ["--gravity=" + ",".join(f"{g:g}" for g in edit.gravity)])


def reach_words(edit: SetReach, organ: Organ, document: Path | str) -> Words:
    del organ
    return material_words(document, [f"--reach={edit.region or NONE}"])


def lowest_words(edit: FixLowest, organ: Organ, document: Path | str) -> Words:
    del organ
    return material_words(document, [f"--fix-lowest={edit.share:.12g}"])


def appearance_words(edit: SetAppearance, organ: Organ, document: Path | str) -> Words:
    del organ
    words: Words = ["palpate", "appearance", document, "--style", edit.style or NONE]
    if edit.colour is not None:
        words += ["--colour", write_colour(edit.colour)]
    return [*words, "-o", document]


def all_words(edit: SetMaterial, organ: Organ, document: Path | str) -> Words:
    """Everything that a pasted material brings."""
    del edit
    model = organ.model
    options: Words = ["--kind", KINDS[model.kind]]
    for key, option in LAWS.items():
        options += [option, getattr(model, key.removeprefix("model."))]
    for constant in CONSTANTS:
        if constant.part in ("material", "model"):
            value = getattr(getattr(organ, constant.part), constant.field)
            if value is not None or constant.optional:
                options.append(constant_option(constant.part, constant.field, value))
    return material_words(document, options)


def imported_words(edit: UseImported, organ: Organ, document: Path | str) -> Words:
    del edit, organ
    return ["palpate", "decimate", document, "--imported", "-o", document]


def paint_words(document: Path | str, options: Sequence[object]) -> Words:
    return ["palpate", "paint", document, *options, "-o", document]


def stiffness_words(edit: PaintStiffness, organ: Organ, document: Path | str) -> Words:
    del organ
    factors = write_factors(edit.vertices, np.asarray(edit.values))
    return paint_words(document, [f"--stiffness={piece}" for piece in factors])


def fix_words(edit: FixVertices, organ: Organ, document: Path | str) -> Words:
    del organ
    option = "--fix" if edit.fixed else "--free"
    return paint_words(document, [f"{option}={write_ids(np.unique(edit.vertices))}"])


def region_words(edit: SetRegion, organ: Organ, document: Path | str) -> Words:
    del organ
    return paint_words(document, [f"--region={edit.name}={write_ids(np.unique(edit.vertices))}"])


def forget_words(edit: RemoveRegion, organ: Organ, document: Path | str) -> Words:
    del organ
    return paint_words(document, [f"--forget={edit.name}"])


def name_words(edit: SetName, organ: Organ, document: Path | str) -> Words:
    del organ
    return ["palpate", "words", document, f"--name={edit.name}", "-o", document]


def task_words(edit: SetTask, organ: Organ, document: Path | str) -> Words:
    del organ
    words: Words = ["palpate", "words", document]
    if edit.scenario_title is not None:
        words.append(f"--title={edit.scenario_title}")
    if edit.task is not None:
        words.append(f"--task={edit.task}")
    if edit.language:
        words.append(f"--in={edit.language}")
    return [*words, "-o", document]


FINDERS: dict[type, Callable[[Any, Organ, Path | str], Words | None]] = {
    ImportMesh: import_words,
    SetUnit: import_words,
    SetUp: import_words,
    Decimate: decimate_words,
    KeepLargestShell: repair_words("shells"),
    TurnOutward: repair_words("inward"),
    FillHoles: hole_words,
    SetConstant: constant_words,
    SetChoice: choice_words,
    SetGravity: gravity_words,
    SetMaterial: all_words,
    SetReach: reach_words,
    FixLowest: lowest_words,
    SetAppearance: appearance_words,
    FixVertices: fix_words,
    PaintStiffness: stiffness_words,
    SetRegion: region_words,
    RemoveRegion: forget_words,
    SetName: name_words,
    SetTask: task_words,
    UseImported: imported_words,
}


def publish_words(organ: Organ, document: Path | str, out: Path) -> Words:
    words: Words = ["palpate", "publish", document]
    if organ.title:
        words += [f"--title={organ.title}"]
    if organ.task:
        words += [f"--task={organ.task}"]
    return [*words, "-o", out]


def render_words(file: Path | str, out: Path, view: View, theme: str) -> Words:
    camera = view.camera
    words: Words = ["palpate", "render", file, "-o", out, "--theme", theme]
    words += [f"--azimuth={degrees(camera.azimuth):.1f}"]
    words += [f"--elevation={degrees(camera.elevation):.1f}"]
    return words if view.wireframe else [*words, "--no-wireframe"]

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
from palpate_editor.argument_text import LAWS, NONE, write_factors, write_ids
from palpate_editor.document import Assembly, Organ, Segmentation, Source
from palpate_editor.document.constants import (
    CONSTANTS,
    SHORT_KINDS,
    counts_choice,
    find_constant,
)
from palpate_editor.document.far_compliance import wants_far_field
from palpate_editor.document.idle import find_idle
from palpate_editor.edits import (
    CapHoles,
    Configure,
    CutCrowdedEdges,
    CutDisagreement,
    Decimate,
    DecimateTo,
    Edit,
    FillHoles,
    FixLowest,
    FixVertices,
    ImportMesh,
    KeepLargestShell,
    KeepOuter,
    PaintStiffness,
    Prepared,
    RemoveRegion,
    SetAppearance,
    SetChoice,
    SetConstant,
    SetFarField,
    SetFineRegion,
    SetGravity,
    SetMaterial,
    SetName,
    SetReach,
    SetRegion,
    SetTask,
    SetTissue,
    SetUnit,
    SetUp,
    TurnOutward,
    UniteShells,
    UseImported,
)
from palpate_editor.edits.configure import NUMBERS
from palpate_editor.far_field import SolveFarField
from palpate_editor.views.repair_lines import REPAIRS

KINDS = {kind: short for short, kind in SHORT_KINDS.items()}
ASKED = "as asked"
"""The reason of a unit or an axis that a person chose."""

Arguments = list[object]


def find_arguments(edit: Edit, organ: Organ, document: Path | str) -> Arguments | None:
    """The command line of an edit that led to `organ`; None where there is none."""
    if isinstance(edit, Prepared):
        edit = edit.edit
    find = FINDERS.get(type(edit))
    return None if find is None else find(edit, organ, document)


def import_arguments(edit: Any, organ: Organ, document: Path | str) -> Arguments | None:
    del edit
    if organ.source is None:
        return None
    if organ.segmentation is not None:
        return segment_arguments(organ.source, organ.segmentation, document)
    return source_arguments(organ, document)


def segment_arguments(source: Source, done: Segmentation, document: Path | str) -> Arguments:
    arguments: Arguments = ["palpate", "segment", Path(source.folder) / source.file]
    for label in done.labels:
        arguments += ["--label", label]
    if not done.labels:
        ends = ("" if end is None else f"{end:.12g}" for end in (done.low, done.high))
        arguments.append(f"--threshold={':'.join(ends)}")
    arguments += ["--smooth", f"{done.smooth:g}"]
    if done.largest:
        arguments.append("--largest")
    if done.least_volume:
        arguments += ["--least-volume", f"{1e6 * done.least_volume:.12g}ml"]
    if done.series:
        arguments += ["--series", done.series]
    if source.unit_reason == ASKED:
        arguments += ["--unit", source.unit]
    return [*arguments, "-o", document]


def source_arguments(organ: Organ, document: Path | str) -> Arguments:
    source = organ.source
    assert source is not None
    arguments: Arguments = ["palpate", "import", Path(source.folder) / source.file]
    if source.parts != source.parts_available:
        for part in source.parts:
            arguments += ["--part", part]
    if source.unit_reason == ASKED:
        arguments += ["--unit", source.unit]
    if source.up_reason == ASKED:
        arguments.append(f"--up={source.up}")
    return [*arguments, *assembly_options(organ.assembly), "-o", document]


def assembly_options(done: Assembly | None) -> Arguments:
    if done is None:
        return []
    options: Arguments = []
    if done.weld is not None:
        options.append(f"--weld={1e3 * done.weld:.12g}mm")
    if done.unite:
        options.append("--unite")
    for name in done.subtracted:
        options += ["--subtract", name]
    if done.regions:
        options.append("--region-per-part")
    return options


def decimate_arguments(edit: Decimate, organ: Organ, document: Path | str) -> Arguments:
    return count_arguments(edit.repeat, organ, document)


def count_arguments(edit: DecimateTo, organ: Organ, document: Path | str) -> Arguments:
    del organ
    target: Arguments = ["--vertices", edit.vertices]
    if edit.error is not None:
        target = ["--error", f"{edit.error:.12g}m"]
    return ["palpate", "decimate", document, *target, "-o", document]


def repair_arguments(problem: str) -> Callable[[Any, Organ, Path | str], Arguments]:
    def find(edit: Any, organ: Organ, document: Path | str) -> Arguments:
        del edit, organ
        return ["palpate", "repair", document, "--problem", problem, "-o", document]

    return find


def unite_arguments(edit: UniteShells, organ: Organ, document: Path | str) -> Arguments:
    return repair_arguments(edit.problem)(edit, organ, document)


def hole_arguments(edit: FillHoles, organ: Organ, document: Path | str) -> Arguments | None:
    """Which of several holes were clicked on no line can say."""
    del organ
    if edit.holes is not None:
        return None
    return ["palpate", "repair", document, "--fill-holes", "-o", document]


def material_arguments(document: Path | str, options: Sequence[object]) -> Arguments:
    return ["palpate", "material", document, *options, "-o", document]


def constant_option(part: str, field: str, value: float | None) -> str:
    """One option with its unit; joined by = so that a negative number is no option itself."""
    constant = find_constant(part, field)
    assert constant is not None
    option, unit = constant.option, constant.option_unit
    # 1/s is written 8/s, as quantities are read
    ending = "/s" if unit == "1/s" else unit
    return f"{option}={NONE}" if value is None else f"{option}={value:.12g}{ending}"


def constant_arguments(edit: SetConstant, organ: Organ, document: Path | str) -> Arguments:
    constant = find_constant(edit.part, edit.field)
    if constant is not None and find_idle(constant, organ) is not None:
        # no form shows it: it was out of its range, and its check has been answered
        return ["palpate", "repair", document, "--problem", "constant", "-o", document]
    return material_arguments(document, [constant_option(edit.part, edit.field, edit.value)])


def choice_arguments(edit: SetChoice, organ: Organ, document: Path | str) -> Arguments:
    del organ
    option = "--kind" if edit.field == "kind" else LAWS[f"model.{edit.field}"]
    return material_arguments(document, [option, KINDS.get(edit.value, edit.value)])


def gravity_arguments(edit: SetGravity, organ: Organ, document: Path | str) -> Arguments:
    del organ
    return material_arguments(document, ["--gravity=" + ",".join(f"{g:g}" for g in edit.gravity)])


def reach_arguments(edit: SetReach, organ: Organ, document: Path | str) -> Arguments:
    del organ
    return material_arguments(document, [f"--reach={edit.region or NONE}"])


def cap_arguments(edit: CapHoles, organ: Organ, document: Path | str) -> Arguments:
    del edit, organ
    return ["palpate", "fill", document, "--close", "-o", document]


def fine_arguments(edit: SetFineRegion, organ: Organ, document: Path | str) -> Arguments:
    del organ
    return material_arguments(document, [f"--fine={edit.region or NONE}"])


def tissue_arguments(edit: SetTissue, organ: Organ, document: Path | str) -> Arguments:
    del organ
    tissue = edit.tissue
    options: Arguments = [f"--tissue={tissue.region}={tissue.name}"]
    if not tissue.region:
        options = ["--tissue", tissue.name]
    if tissue.status == "recalled":
        options.append("--recalled")
    elif tissue.status == "unknown":
        options.append(constant_option("material", "young_modulus", tissue.young_modulus))
    return material_arguments(document, options)


def lowest_arguments(edit: FixLowest, organ: Organ, document: Path | str) -> Arguments:
    del organ
    return material_arguments(document, [f"--fix-lowest={edit.share:.12g}"])


def appearance_arguments(edit: SetAppearance, organ: Organ, document: Path | str) -> Arguments:
    del organ
    arguments: Arguments = ["palpate", "appearance", document, "--style", edit.style or NONE]
    if edit.colour is not None:
        arguments += ["--colour", write_colour(edit.colour)]
    return [*arguments, "-o", document]


def all_arguments(edit: SetMaterial, organ: Organ, document: Path | str) -> Arguments:
    """Everything that a pasted material brings and that has an effect."""
    del edit
    parts = ("material", "model")
    return counting_arguments(organ, document, [c.key for c in CONSTANTS if c.part in parts])


def far_field_arguments(edit: Any, organ: Organ, document: Path | str) -> Arguments:
    del edit
    return material_arguments(document, say_far_field(organ))


def say_far_field(organ: Organ) -> Arguments:
    return ["--far-field", "fine" if organ.far_field is not None else "mesh"]


def configure_arguments(edit: Configure, organ: Organ, document: Path | str) -> Arguments | None:
    """What of a configuration has an effect; one that decimates takes two lines, which none is."""
    if edit.configuration.vertices:
        return None
    keys = [f"model.{name}" for name in NUMBERS]
    line = counting_arguments(organ, document, [*keys, "fill.tetrahedra", "hand.substeps"])
    return line[:-2] + say_far_field(organ) + line[-2:] if wants_far_field(organ) else line


def counting_arguments(organ: Organ, document: Path | str, keys: Sequence[str]) -> Arguments:
    """Kind, laws, and the constants of these keys that have an effect."""
    model = organ.model
    options: Arguments = ["--kind", KINDS[model.kind]]
    for key, option in LAWS.items():
        field = key.removeprefix("model.")
        if counts_choice(field, model):
            options += [option, getattr(model, field)]
    for constant in CONSTANTS:
        if constant.key in keys and find_idle(constant, organ) is None:
            value = getattr(getattr(organ, constant.part), constant.field)
            if value is not None or constant.optional:
                options.append(constant_option(constant.part, constant.field, value))
    return material_arguments(document, options)


def imported_arguments(edit: UseImported, organ: Organ, document: Path | str) -> Arguments:
    del edit, organ
    return ["palpate", "decimate", document, "--imported", "-o", document]


def paint_arguments(document: Path | str, options: Sequence[object]) -> Arguments:
    return ["palpate", "paint", document, *options, "-o", document]


def stiffness_arguments(edit: PaintStiffness, organ: Organ, document: Path | str) -> Arguments:
    del organ
    factors = write_factors(edit.vertices, np.asarray(edit.values))
    return paint_arguments(document, [f"--stiffness={piece}" for piece in factors])


def fix_arguments(edit: FixVertices, organ: Organ, document: Path | str) -> Arguments:
    del organ
    option = "--fix" if edit.fixed else "--free"
    return paint_arguments(document, [f"{option}={write_ids(np.unique(edit.vertices))}"])


def region_arguments(edit: SetRegion, organ: Organ, document: Path | str) -> Arguments:
    del organ
    return paint_arguments(
        document, [f"--region={edit.name}={write_ids(np.unique(edit.vertices))}"]
    )


def forget_arguments(edit: RemoveRegion, organ: Organ, document: Path | str) -> Arguments:
    del organ
    return paint_arguments(document, [f"--forget={edit.name}"])


def name_arguments(edit: SetName, organ: Organ, document: Path | str) -> Arguments:
    del organ
    return ["palpate", "text", document, f"--name={edit.name}", "-o", document]


def task_arguments(edit: SetTask, organ: Organ, document: Path | str) -> Arguments:
    del organ
    arguments: Arguments = ["palpate", "text", document]
    if edit.scenario_title is not None:
        arguments.append(f"--title={edit.scenario_title}")
    if edit.task is not None:
        arguments.append(f"--task={edit.task}")
    if edit.language:
        arguments.append(f"--in={edit.language}")
    return [*arguments, "-o", document]


FINDERS: dict[type, Callable[[Any, Organ, Path | str], Arguments | None]] = {
    ImportMesh: import_arguments,
    SetUnit: import_arguments,
    SetUp: import_arguments,
    Decimate: decimate_arguments,
    DecimateTo: count_arguments,
    KeepOuter: repair_arguments("inner"),
    KeepLargestShell: repair_arguments("shells"),
    TurnOutward: repair_arguments("inward"),
    CutCrowdedEdges: repair_arguments("non_manifold"),
    CutDisagreement: repair_arguments("one_sided"),
    UniteShells: unite_arguments,
    FillHoles: hole_arguments,
    CapHoles: cap_arguments,
    SetConstant: constant_arguments,
    SetChoice: choice_arguments,
    SetGravity: gravity_arguments,
    SetMaterial: all_arguments,
    Configure: configure_arguments,
    SetFarField: far_field_arguments,
    SolveFarField: far_field_arguments,
    SetReach: reach_arguments,
    SetFineRegion: fine_arguments,
    SetTissue: tissue_arguments,
    FixLowest: lowest_arguments,
    SetAppearance: appearance_arguments,
    FixVertices: fix_arguments,
    PaintStiffness: stiffness_arguments,
    SetRegion: region_arguments,
    RemoveRegion: forget_arguments,
    SetName: name_arguments,
    SetTask: task_arguments,
    UseImported: imported_arguments,
    **REPAIRS,
}


def publish_arguments(
    organ: Organ, document: Path | str, out: Path, slow: bool = False
) -> Arguments:
    arguments: Arguments = ["palpate", "publish", document]
    if organ.title:
        arguments += [f"--title={organ.title}"]
    if organ.task:
        arguments += [f"--task={organ.task}"]
    if slow:
        arguments += ["--slow"]
    return [*arguments, "-o", out]


def render_arguments(file: Path | str, out: Path, view: View, theme: str) -> Arguments:
    camera = view.camera
    arguments: Arguments = ["palpate", "render", file, "-o", out, "--theme", theme]
    arguments += [f"--azimuth={degrees(camera.azimuth):.1f}"]
    arguments += [f"--elevation={degrees(camera.elevation):.1f}"]
    return arguments if view.wireframe else [*arguments, "--no-wireframe"]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Working files, `.organ`: the container of core/scenario/CONTAINER.md with a designer's document.

What is written is what is read, to the last bit. Of a surface that is used as it was imported there
is one copy, and it comes back as one object.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import Field, asdict, fields, replace
from pathlib import Path
from typing import Any

import numpy as np
from palpate.error import FileError
from palpate.files.json_part import json_kind, read_part, read_value
from palpate.files.refusal import Refusal
from palpate.scenario import MOST_LANGUAGES, Container, read_container, write_container
from palpate.scene.scene_parts import LATER, AppearancePart, ModelPart, find_appearance_fault

from palpate_editor.document.far_field import FarField
from palpate_editor.document.history import MOST_LINES, Line
from palpate_editor.document.history_file import Packing, Unpacking
from palpate_editor.document.migrations import (
    NUMBERS,
    VERSION,
    Arrays,
    Json,
    check_parts,
    migrate,
    migrate_begin,
)
from palpate_editor.document.organ import (
    Assembly,
    Decimation,
    History,
    Organ,
    Segmentation,
    Source,
    Translation,
    is_language,
)
from palpate_editor.document.surface import Filling, Surface
from palpate_editor.document.tissue import MOST_TISSUES, STATUSES, AppliedTissue

FORMAT = "organ"
ARRAYS_OF_MODEL = ("fixed", "stiffness_scale")
"""Of the model part; arrays of the file stand for them."""
TEXTS = ("name", "title", "task")
SOMETIMES = {"segmentation": Segmentation, "assembly": Assembly}
"""Parts that a file has where the organ has them; a reader from before them refuses such a file."""
OPTIONAL = {"source": Source, "decimation": Decimation, "appearance": AppearancePart}

OF_FAR_FIELD = ("key", "patch", "tetrahedra")
FAR_FIELD = "far_field/softness"


def list_rare_fields() -> list[tuple[str, Field[Any]]]:
    """(part, field) of every number that a file has only where it is not the usual one: a file of
    before there were any is written as it was, and a reader of before refuses one that has them."""
    return [
        (name, field)
        for name, kind in NUMBERS.items()
        for field in fields(kind)
        if field.metadata.get(LATER)
    ]


def write_organ(path: Path, organ: Organ) -> None:
    """Leaves `path` as it was or writes all of the new file. Raises FileError."""
    content, arrays = pack_organ(organ)
    try:
        write_container(
            os.fspath(path),
            Container(format=FORMAT, version=VERSION, content=json.dumps(content), arrays=arrays),
        )
    except ValueError as problem:
        raise FileError(str(path), "", str(problem), "an organ that a file can hold") from None


def read_organ(path: Path) -> Organ:
    """Reads a file of this or an older version. Raises FileError for whatever is wrong."""
    found = read_container(os.fspath(path), FORMAT, VERSION)
    return unpack_organ(json.loads(found.content), found.arrays, found.version, str(path))


def pack_organ(organ: Organ) -> tuple[Json, Arrays]:
    """What a file keeps of an organ: a JSON object and arrays."""
    content, arrays = pack_parts(organ)
    if organ.history is not None and organ.history.lines:
        packing = Packing(arrays)
        content["history"] = pack_history(organ.history, packing)
        arrays |= packing.list_arrays()
    return content, arrays


def pack_history(history: History, packing: Packing) -> Json:
    begin, kept = pack_parts(history.begin)
    return {
        "begin": {"content": begin, "arrays": packing.pack(kept)},
        "folded": history.folded,
        "lines": [{"edit": row.edit, "values": packing.pack(row.values)} for row in history.lines],
    }


def pack_parts(organ: Organ) -> tuple[Json, Arrays]:
    """The organ without what was done to it."""
    content: Json = {name: getattr(organ, name) for name in TEXTS}
    for name in (*OPTIONAL, *NUMBERS):
        part = getattr(organ, name)
        content[name] = None if part is None else asdict(part)
    for name in ARRAYS_OF_MODEL:
        del content["model"][name]
    for name, rare in list_rare_fields():
        if content[name][rare.name] == rare.default:
            del content[name][rare.name]
    arrays: Arrays = {}
    if organ.imported is not None:
        arrays |= pack_surface("imported", organ.imported)
    if organ.surface is not None:
        if organ.surface is not organ.imported:
            arrays |= pack_surface("surface", organ.surface)
        arrays["fixed"] = np.flatnonzero(organ.fixed).astype(np.int32)
        arrays["stiffness_scale"] = organ.stiffness_scale
    if organ.filling is not None:
        arrays["filling/vertices"] = organ.filling.vertices
        arrays["filling/tetrahedra"] = organ.filling.tetrahedra
    for name in SOMETIMES:
        if getattr(organ, name) is not None:
            content[name] = asdict(getattr(organ, name))
    if organ.far_field is not None:
        content["far_field"] = {name: getattr(organ.far_field, name) for name in OF_FAR_FIELD}
        arrays[FAR_FIELD] = organ.far_field.softness
    if organ.tissues:
        content["tissues"] = [asdict(tissue) for tissue in organ.tissues]
    if organ.assessment:
        content["assessment"] = json.loads(organ.assessment)
    if organ.languages:
        content["languages"] = {code: asdict(said) for code, said in organ.languages.items()}
    # a name may be of any alphabet, that of an array may not
    content["regions"] = list(organ.regions)
    arrays |= {f"regions/{row}": ids for row, ids in enumerate(organ.regions.values())}
    return content, arrays


def write_assessment(assessment: Json) -> str:
    """The same text for the same assessment, whatever it was read from."""
    return json.dumps(assessment, ensure_ascii=False, sort_keys=True)


def pack_surface(name: str, surface: Surface) -> Arrays:
    arrays = {f"{name}/vertices": surface.vertices, f"{name}/triangles": surface.triangles}
    if surface.colours is not None:
        arrays[f"{name}/colours"] = surface.colours
    return arrays


def unpack_organ(content: Any, arrays: Mapping[str, Any], version: int, file: str) -> Organ:
    """The organ that `pack_organ` gave `content` and `arrays` for. Raises FileError."""
    owned = dict(arrays)
    try:
        if version < VERSION:
            check_parts(content, file)
        for step in range(version, VERSION):
            content, owned = migrate(step, content, owned)
            migrate_begin(step, content, file)
        return unpack(content, owned, file)
    except Refusal as refusal:
        raise FileError(file, refusal.where, refusal.got, refusal.expected) from None


def unpack(content: Any, arrays: Arrays, file: str) -> Organ:
    if not isinstance(content, dict) or "history" not in content:
        return unpack_alone(content, arrays, file)
    parts = dict(content)
    section = parts.pop("history")
    unpacking = Unpacking(arrays, file)
    organ = unpack_alone(parts, arrays, file)
    # arrays of the organ itself are named here as it has them: there is one copy
    unpacking.arrays |= pack_parts(organ)[1]
    return replace(organ, history=unpack_history(section, unpacking))


def unpack_history(section: Any, unpacking: Unpacking) -> History:
    file = unpacking.file
    check_fields(section, ("begin", "folded", "lines"), "history", file)
    check_fields(section["begin"], ("content", "arrays"), "history.begin", file)
    folded, lines = section["folded"], section["lines"]
    if type(folded) is not int or folded < 0:
        raise Refusal(file, "history.folded", json_kind(folded), "a whole number of 0 or more")
    if not isinstance(lines, list) or not 1 <= len(lines) <= MOST_LINES:
        expected = f"a list of 1 to {MOST_LINES}"
        raise Refusal(file, "history.lines", json_kind(lines), expected)
    arrays = unpacking.unpack("history.begin.arrays", section["begin"]["arrays"])
    if not isinstance(arrays, dict) or not all(isinstance(a, np.ndarray) for a in arrays.values()):
        raise Refusal(file, "history.begin.arrays", "something else", "arrays by name")
    try:
        begin = unpack_alone(section["begin"]["content"], arrays, file)
    except Refusal as refusal:
        where = f"history.begin.{refusal.where}"
        raise Refusal(file, where, refusal.got, refusal.expected) from None
    rows = tuple(unpack_line(row, at, unpacking) for at, row in enumerate(lines))
    unpacking.finish()
    return History(begin, rows, folded)


def unpack_line(row: Any, at: int, unpacking: Unpacking) -> Line:
    where = f"history.lines[{at}]"
    check_fields(row, ("edit", "values"), where, unpacking.file)
    edit = read_value(unpacking.file, f"{where}.edit", str, row["edit"])
    if not isinstance(row["values"], dict):
        got = json_kind(row["values"])
        raise Refusal(unpacking.file, f"{where}.values", got, "an object")
    values = row["values"].items()
    return Line(edit, {name: unpacking.unpack(f"{where}.{name}", v) for name, v in values})


def check_fields(section: Any, names: tuple[str, ...], where: str, file: str) -> None:
    """Refuses what is no object of exactly these fields."""
    if not isinstance(section, dict) or set(section) != set(names):
        raise Refusal(file, where, json_kind(section), "an object of " + ", ".join(names))


def unpack_alone(content: Any, arrays: Arrays, file: str) -> Organ:
    """Without its history."""
    known = {*TEXTS, *OPTIONAL, *NUMBERS, "regions"}
    if not isinstance(content, dict):
        raise Refusal(file, "", json_kind(content), "an object")
    needed = set(content) - {"languages", "tissues", "far_field", "assessment", *SOMETIMES}
    if needed != known:
        odd = sorted(needed ^ known)[0]
        found = "an unknown field" if odd in content else "nothing"
        raise Refusal(file, odd, found, "exactly " + ", ".join(sorted(known)))
    parts: Json = {name: read_value(file, name, str, content[name]) for name in TEXTS}
    for name, kind in OPTIONAL.items():
        section = content[name]
        parts[name] = None if section is None else read_part(file, name, kind, section, whole=True)
    for name, kind in SOMETIMES.items():
        if name in content:
            parts[name] = read_part(file, name, kind, content[name], whole=True)
    for name, kind in NUMBERS.items():
        without = ARRAYS_OF_MODEL if kind is ModelPart else ()
        section = content[name]
        if isinstance(section, dict):
            section = {f.name: f.default for of, f in list_rare_fields() if of == name} | section
        parts[name] = read_part(file, name, kind, section, without=without, whole=True)
    fault = find_appearance_fault(parts["appearance"]) if parts["appearance"] else None
    if fault is not None:
        raise Refusal(file, f"appearance.{fault[0]}", *fault[1:])
    parts["tissues"] = unpack_tissues(content.get("tissues", []), file)
    parts["languages"] = unpack_languages(content.get("languages", {}), file)
    if "assessment" in content:
        parts["assessment"] = unpack_assessment(content["assessment"], file)
    regions = read_value(file, "regions", tuple[str, ...], content["regions"])
    if "far_field" in content:
        parts["far_field"] = unpack_far_field(content["far_field"], arrays, file)
    parts |= unpack_arrays(arrays, regions, file)
    if "far_field" in content:
        check_far_field(parts["far_field"], parts["surface"], file)
    return Organ(**parts)


def unpack_assessment(section: Any, file: str) -> str:
    """As text again; whether it can be judged is for the checks to say."""
    if not isinstance(section, dict) or "palpate_scenario" not in section:
        expected = "an object that says palpate_scenario"
        raise Refusal(file, "assessment", json_kind(section), expected)
    return write_assessment(section)


def unpack_far_field(section: Any, arrays: Arrays, file: str) -> FarField:
    softness = take(arrays, FAR_FIELD, np.float64, (None,), file)
    found: FarField = read_part(
        file, "far_field", FarField, section, without=("softness",), whole=True
    )
    return replace(found, softness=softness)


def check_far_field(found: FarField, surface: Surface | None, file: str) -> None:
    """Refuses one of another surface than the file's."""
    count = 0 if surface is None else len(surface.vertices)
    if len(found.softness) != 6 * count:
        expected = f"{6 * count}, six per vertex"
        raise Refusal(file, FAR_FIELD, f"{len(found.softness)} numbers", expected)


def unpack_tissues(rows: Any, file: str) -> tuple[AppliedTissue, ...]:
    if not isinstance(rows, list) or len(rows) > MOST_TISSUES:
        raise Refusal(file, "tissues", json_kind(rows), f"a list of at most {MOST_TISSUES}")
    found = tuple(
        read_part(file, f"tissues[{row}]", AppliedTissue, part, whole=True)
        for row, part in enumerate(rows)
    )
    for row, tissue in enumerate(found):
        if tissue.status not in STATUSES:
            expected = f"one of {', '.join(STATUSES)}"
            raise Refusal(file, f"tissues[{row}].status", json_kind(tissue.status), expected)
    if len({tissue.region for tissue in found}) != len(found):
        raise Refusal(file, "tissues", "a region twice", "one tissue for each")
    return found


def unpack_languages(content: Any, file: str) -> dict[str, Translation]:
    if not isinstance(content, dict):
        raise Refusal(file, "languages", json_kind(content), "an object")
    if len(content) > MOST_LANGUAGES:
        raise Refusal(file, "languages", f"{len(content)} languages", f"at most {MOST_LANGUAGES}")
    for code in content:
        if not is_language(code):
            raise Refusal(file, "languages", f"the code {code!r}", "a code such as tr or pt-BR")
    return {
        code: read_part(file, f"languages.{code}", Translation, translation, whole=True)
        for code, translation in content.items()
    }


def unpack_arrays(arrays: Arrays, regions: tuple[str, ...], file: str) -> Json:
    parts: Json = {}
    for name in ("imported", "surface"):
        if f"{name}/vertices" in arrays or f"{name}/triangles" in arrays:
            parts[name] = unpack_surface(arrays, name, file)
    parts.setdefault("surface", parts.get("imported"))
    if "filling/vertices" in arrays or "filling/tetrahedra" in arrays:
        parts["filling"] = unpack_filling(arrays, file)
    surface = parts["surface"]
    count = 0 if surface is None else len(surface.vertices)
    if surface is not None:
        parts["fixed"] = np.zeros(count, bool)
        parts["fixed"][take_ids(arrays, "fixed", count, file)] = True
        parts["stiffness_scale"] = take(arrays, "stiffness_scale", np.float64, (count,), file)
    if len(set(regions)) != len(regions):
        raise Refusal(file, "regions", "a name twice", "every name once")
    parts["regions"] = {
        name: take_ids(arrays, f"regions/{row}", count, file) for row, name in enumerate(regions)
    }
    if arrays:
        raise Refusal(file, sorted(arrays)[0], "an unknown array", "those of an organ")
    return parts


def take_ids(arrays: Arrays, name: str, count: int, file: str) -> np.ndarray:
    ids = take(arrays, name, np.int32, (None,), file)
    if ids.size and (ids.min() < 0 or ids.max() >= count or (np.diff(ids) <= 0).any()):
        raise Refusal(file, name, "other numbers", f"ascending ones from 0 to {count - 1}")
    return ids


def unpack_surface(arrays: Arrays, name: str, file: str) -> Surface:
    vertices = take(arrays, f"{name}/vertices", np.float64, (None, 3), file)
    triangles = take(arrays, f"{name}/triangles", np.int32, (None, 3), file)
    if triangles.size and (triangles.min() < 0 or triangles.max() >= len(vertices)):
        raise Refusal(
            file,
            f"{name}/triangles",
            f"vertex numbers {triangles.min()} to {triangles.max()}",
            f"0 to {len(vertices) - 1}",
        )
    if f"{name}/colours" not in arrays:
        return Surface(vertices, triangles)
    colours = take(arrays, f"{name}/colours", np.uint8, (None, 3), file)
    if len(colours) != len(vertices):
        expected = f"{len(vertices)}, one for each vertex"
        raise Refusal(file, f"{name}/colours", f"{len(colours)} colours", expected)
    return Surface(vertices, triangles, colours)


def unpack_filling(arrays: Arrays, file: str) -> Filling:
    vertices = take(arrays, "filling/vertices", np.float64, (None, 3), file)
    tetrahedra = take(arrays, "filling/tetrahedra", np.int32, (None, 4), file)
    if tetrahedra.size and (tetrahedra.min() < 0 or tetrahedra.max() >= len(vertices)):
        raise Refusal(
            file,
            "filling/tetrahedra",
            f"vertex numbers {tetrahedra.min()} to {tetrahedra.max()}",
            f"0 to {len(vertices) - 1}",
        )
    return Filling(vertices, tetrahedra)


def take(
    arrays: Arrays, name: str, dtype: type, shape: tuple[int | None, ...], file: str
) -> np.ndarray:
    """Takes an array out of those of a file, so that what nobody takes can be refused."""
    found = arrays.pop(name, None)
    extents = ", ".join("n" if extent is None else str(extent) for extent in shape)
    wanted = f"{np.dtype(dtype).str} of shape ({extents})"
    if found is None:
        raise Refusal(file, name, "no such array", wanted)
    fits = len(found.shape) == len(shape) and all(
        n in (None, m) for n, m in zip(shape, found.shape, strict=True)
    )
    if found.dtype != dtype or not fits:
        raise Refusal(file, name, f"{found.dtype.str} of shape {found.shape}", wanted)
    return found

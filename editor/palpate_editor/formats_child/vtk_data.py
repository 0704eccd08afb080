# SPDX-License-Identifier: GPL-3.0-or-later
"""The data set in a file of VTK, read by VTK itself; without what nobody can draw, where that
alone is wrong with a file."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib import import_module
from types import ModuleType
from typing import NoReturn
from xml.etree.ElementTree import ParseError, parse

from vtkmodules.vtkCommonCore import vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader

from palpate_editor.formats_child.gmsh_values import NOWHERE
from palpate_editor.formats_child.scene import Refusal

ATTRIBUTES = rb"\r?\n[ \t]*(?:POINT_DATA|CELL_DATA)\b"
"""What begins the values at points and cells, which stand behind all cells."""
OTHERS = {"XDMF": ("vtkIOXdmf2", "vtkXdmfReader")}
"""Format that is not VTK's own -> module and class that read it."""
LEGACY = "# vtk DataFile"


def open_vtk(path: str, form: str) -> tuple[vtkDataObject, list[str]]:
    """With what is to be noted of it. Raises Refusal."""
    with open(path, "rb") as file:
        content = file.read()
    head = content[:4096].lstrip(b"\xef\xbb\xbf \t\r\n")
    if head.lower().startswith(LEGACY.lower().encode()):
        return open_legacy(path, content, form)
    if b"<VTKFile" not in head:
        line = head[:40].decode(errors="replace").split("\n")[0].strip()
        words = "".join(letter if letter.isprintable() else "?" for letter in line)
        raise Refusal("header", f"'{words}'", f"'{LEGACY}', or <VTKFile>")
    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(path)
    data, errors, warnings = run(reader)
    if data is None or errors:
        refuse(errors, form)
    return data, note_warnings(warnings)


def open_legacy(path: str, content: bytes, form: str) -> tuple[vtkDataObject, list[str]]:
    reader = vtkGenericDataObjectReader()
    reader.SetFileName(path)
    data, errors, warnings = run(reader)
    if data is not None and not errors:
        return data, note_warnings(warnings)
    for repaired, said in repair(content, errors):
        reader = vtkGenericDataObjectReader()
        reader.ReadFromInputStringOn()
        reader.SetBinaryInputString(repaired, len(repaired))
        data, still, warnings = run(reader)
        if data is not None and not still:
            return data, [said, *note_warnings(warnings)]
    refuse(errors, form)


def repair(content: bytes, errors: list[str]) -> Iterator[tuple[bytes, str]]:
    """The file without what cannot be drawn anyway, and what is said of that."""
    said = errors[0] if errors else "no data"
    number = re.sub(NOWHERE, b"nan", content, flags=re.IGNORECASE)
    if number != content:
        yield number, "some of its coordinates are no numbers"
    for text in dict.fromkeys((content, number)):
        values = re.search(ATTRIBUTES, text, re.IGNORECASE)
        if values:
            yield (
                text[: values.start()] + b"\n",
                f"its values were passed over, as VTK says: {said}",
            )
    word = re.search(r"Unrecognized keyword: ([A-Za-z_]\w*)", said)
    if word:
        line = rb"\r?\n[ \t]*" + word.group(1).encode() + rb"\b"
        rest = re.search(line, content, re.IGNORECASE)
        if rest:
            yield content[: rest.start()] + b"\n", f"its end was passed over, as VTK says: {said}"


def load_reader(form: str) -> ModuleType | None:
    """The module that reads a format; None where it is loaded already."""
    return import_module(f"vtkmodules.{OTHERS[form][0]}") if form in OTHERS else None


def open_other(path: str, form: str) -> tuple[vtkDataObject, list[str]]:
    """The same of a file that is not VTK's own; all of them are XML."""
    try:
        parse(path)
    except ParseError as problem:
        where = f"line {problem.position[0]}"
        raise Refusal(where, f"no XML ({problem.msg})", f"a readable {form} file") from None
    reader = getattr(load_reader(form), OTHERS[form][1])()
    reader.SetFileName(path)
    data, errors, warnings = run(reader)
    if data is None or errors:
        refuse(errors, form)
    return data, note_warnings(warnings)


def run(reader: object) -> tuple[vtkDataObject | None, list[str], list[str]]:
    """What a reader has read, its errors and its warnings."""
    said = vtkStringOutputWindow()
    vtkStringOutputWindow.SetInstance(said)
    reader.Update()  # type: ignore[attr-defined]
    data = reader.GetOutputDataObject(0)  # type: ignore[attr-defined]
    return data, *sort_words(said.GetOutput())


def sort_words(text: str) -> tuple[list[str], list[str]]:
    """What VTK said, as errors and warnings, without its own files, lines and addresses."""
    kinds: dict[str, list[str]] = {"ERROR": [], "ERR": [], "WARN": [], "Warning": []}
    pattern = r"(ERROR|Warning|ERR|WARN)[:|].*?(?:\): |\| )(.*?)(?=\n\n|\n(?:ERROR|Warning)|\Z)"
    for kind, words in re.findall(pattern, text, re.DOTALL):
        without_file = re.sub(r" for file: \S*", "", " ".join(words.split()))
        kinds[kind].append(without_file[:200])
    return kinds["ERROR"] + kinds["ERR"], kinds["WARN"] + kinds["Warning"]


def note_warnings(warnings: list[str]) -> list[str]:
    return [f"VTK says: {warning}" for warning in dict.fromkeys(warnings)]


def refuse(errors: list[str], form: str) -> NoReturn:
    got = errors[0] if errors else "no data"
    raise Refusal("", f"content VTK refuses ({got})", f"a readable {form} file")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Which program reads a mesh file: by its extension, and by its content where that says more.

palpate-read-mesh reads what assimp knows, and OBJ, STL, PLY and OFF; a glTF that is packed is
unpacked for it before. All else is read by a Python
that imports nothing from where the user stands, limits its memory and time, opens nothing but the
file (and, where files of the format name others, those beside it), and writes what it found in the
words of palpate-read-mesh (core/authoring/scene_stream.h). This module only says how it is started:
nothing of VTK is ever imported by a program that opens windows.
"""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from palpate import FileError
from palpate.files.whole_file import write_whole
from palpate.system.isolated import build_isolated

from palpate_editor.formats_child.packed import unpack
from palpate_editor.formats_child.scene import Refusal, decode_refusal

PROGRAM = ("obj", "stl", "ply", "off", "glb", "gltf", "3ds", "fbx", "dae", "x3d", "3mf", "amf",
           "ac", "x", "lwo")  # fmt: skip
"""Extensions of what palpate-read-mesh reads; each is the name of its format."""
VTK = {
    **{"vtk": "VTK", "vtp": "VTP", "vtu": "VTU", "vts": "VTS", "vtm": "VTM"},
    **{"xdmf": "XDMF", "xmf": "XDMF"},
}
"""Extension -> format, of what VTK reads."""
OURS = {
    **{"msh": "MSH", "mesh": "MEDIT", "meshb": "MEDIT", "vol": "NETGEN", "veg": "VEGA"},
    **dict.fromkeys(("node", "ele", "face", "smesh", "poly"), "TETGEN"),
    **{
        "pts": "CARP",
        "elem": "CARP",
        "inp": "ABAQUS",
        "unv": "UNV",
        "feb": "FEBIO",
        "cas": "FLUENT",
    },
    **{"neu": "GAMBIT"},
    **dict.fromkeys(("bdf", "nas", "fem"), "NASTRAN"),
    **dict.fromkeys(("k", "key", "dyn"), "DYNA"),
    **{"gii": "GIFTI", "mz3": "MZ3", "wrl": "VRML", "wrz": "VRML", "iv": "VRML"},
    **dict.fromkeys(("pial", "white", "inflated", "orig", "smoothwm"), "FREESURFER"),
}
"""Extension -> format, of what is read in Python without VTK."""
EXTENSIONS = (*PROGRAM, *VTK, *OURS)
"""All that are offered where a file is chosen; each may stand before .gz as well."""
HEADS = (
    (rb"\xff\xff\xfe", "FREESURFER"),
    (rb"\s*# vtk DataFile", "VTK"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)?<VTKFile", "VTP"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)?<febio_spec", "FEBIO"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!.*?>\s*)*<GIFTI", "GIFTI"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!.*?>\s*)*<Xdmf", "XDMF"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)?<COLLADA", "DAE"),
    (rb"\s*(<\?xml[^>]*>\s*)?(<!.*?>\s*)*<X3D", "X3D"),
    (rb"#(VRML|Inventor|X3D) V", "VRML"),
    (rb"\s*\$(MeshFormat|NOD|Comments|PhysicalNames)\b", "MSH"),
    (rb"\s*(#[^\n]*\n\s*)*MeshVersionFormatted", "MEDIT"),
    (rb"\s*(#[^\n]*\n\s*)*mesh3d\b", "NETGEN"),
    (rb"\s*CONTROL INFO\b", "GAMBIT"),
    (rb"\s*\((0|2|10|37) ", "FLUENT"),
    (rb"(\$[^\n]*\n)*\*KEYWORD\b", "DYNA"),
    (rb"ply\s", "PLY"),
    (rb"glTF", "GLB"),
    (rb"Kaydara FBX Binary|; FBX ", "FBX"),
    (rb"\s*(ST)?C?N?4?OFF\b", "OFF"),
    (rb"\s*solid\b[^\n]*\n\s*facet\b", "STL"),
    (rb"\s*(#[^\n]*\n\s*)*(mtllib [^\n]*\n\s*)?([og] [^\n]*\n\s*)?v\s+[-+.\d]", "OBJ"),
)
"""How a file of a format begins."""
HEAD_BYTES = 8192
VOLUMES = ("vti", "nii", "gz", "nrrd", "nhdr", "mha", "mhd", "dcm")
"""Extensions of voxels, of which a surface is yet to be cut."""
AMBIGUOUS = ("MSH", "MEDIT", "GAMBIT", "ABAQUS", "CARP", "NASTRAN")
"""Formats whose extensions are those of others as well."""
PACKAGES = {"vtkmodules": "vtk", "numpy": "numpy", "DracoPy": "DracoPy"}
"""Module -> the package that has it."""
PACKED = {b"KHR_draco_mesh_compression": "DracoPy", b"KHR_mesh_quantization": "numpy"}
"""Extension of glTF that packs meshes in ways that assimp misreads -> module that unpacks it."""
MOST_TEXT = 100_000_000
"""[bytes] Of a glTF, among which the names of its extensions are looked for."""
MEMORY_LIMIT = 1_500_000_000
"""[bytes] A reader may use."""
TIME_LIMIT = 10.0
"""[s] A file may take to read before its reader is stopped."""
PATIENCE = 6.0
"""[-] How much longer than its processor time it may take on a clock."""

CHILD = Path(__file__).parent / "formats_child" / "child.py"


def is_mesh(path: Path) -> bool:
    """Whether a file is one that is read here, as far as its name and its beginning tell."""
    plain = path.with_suffix("") if path.suffix.lower() == ".gz" else path
    return find_named(plain) is not None or find_format(path) is not None


def find_format(path: Path) -> str | None:
    """The format of a file; None for an extension and a content that nobody here knows."""
    named = find_named(path)
    is_volume = path.suffix.lower().removeprefix(".") in VOLUMES
    if is_volume or (named is not None and named not in AMBIGUOUS):
        return named
    found = find_by_content(path, named)
    return named if found is None else found


def find_named(path: Path) -> str | None:
    """By its extension."""
    extension = path.suffix.lower().removeprefix(".")
    if extension in PROGRAM:
        return extension.upper()
    return VTK.get(extension) or OURS.get(extension)


def find_by_content(path: Path, named: str | None) -> str | None:
    """By how it begins; None where that tells nothing, or nothing better than its extension."""
    if not path.is_file():
        return None
    try:
        with path.open("rb") as file:
            head = file.read(HEAD_BYTES)
        size = path.stat().st_size
    except OSError:
        return None
    plain = head.removeprefix(b"\xef\xbb\xbf")
    for pattern, form in HEADS:
        if re.match(pattern, plain, re.DOTALL):
            return form
    if named == "ABAQUS" and re.match(rb"\s*(#[^\n]*\n\s*)*\d+\s+\d+\s+\d+\s+\d+\s+\d+\s", plain):
        return "UCD"
    if named is None and size > 84 and size == 84 + 50 * int.from_bytes(head[80:84], "little"):
        return "STL"
    return None


def find_needed(form: str | None) -> str | None:
    """The module that reads a format in Python; None for palpate-read-mesh."""
    if form is None or form.lower() in PROGRAM:
        return None
    return "numpy" if form in OURS.values() or form == "UCD" else "vtkmodules"


def find_missing(form: str | None) -> str | None:
    """The package that is missing to read a format; None where nothing is, or none is needed."""
    module = find_needed(form)
    if module is None or find_spec(module) is not None:
        return None
    return PACKAGES[module]


def build_words(form: str | None) -> list[str] | None:
    """What starts a reader of a format, up to the file's name; None where palpate-read-mesh is it.

    The interpreter is isolated (-I); the folders its modules are in are told it, as a user may have
    installed some of them for himself alone.
    """
    module = find_needed(form)
    if module is None:
        return None
    return build_isolated(CHILD, find_folders(module))


def find_folders(module: str) -> str:
    """Where a reader's modules are."""
    folders = []
    for name in ("palpate_editor", module, "numpy"):
        found = find_spec(name)
        if found is not None and found.origin is not None:
            folders.append(str(Path(found.origin).parent.parent))
    return os.pathsep.join(dict.fromkeys(folders))


# ---------------------------------------------------------------- packed files


@contextmanager
def open_plain(path: Path) -> Iterator[Path]:
    """The file under a name and with content that its reader takes, for as long as this is open:
    unpacked where gzip packed it, with the extension of its format where assimp knows formats by
    that alone; else the file itself. Raises FileError, which names the file that was given."""
    is_packed = path.suffix.lower() == ".gz" and find_named(path.with_suffix("")) is not None
    form = None if is_packed or find_named(path) is not None else find_format(path)
    is_renamed = form is not None and form.lower() in PROGRAM
    if not is_packed and not is_renamed:
        with open_gltf(path) as plain:
            yield plain
        return
    with TemporaryDirectory(prefix="palpate-mesh-") as folder, naming(path):
        if is_renamed:
            plain = Path(folder) / f"{path.name}.{str(form).lower()}"
            plain.symlink_to(path.resolve())
        else:
            plain = Path(folder) / path.with_suffix("").name
            write_unpacked(path, plain)
        with open_gltf(plain) as gltf:
            yield gltf


@contextmanager
def open_gltf(path: Path) -> Iterator[Path]:
    """The file itself, or a plain .glb of what a .glb or .gltf has packed, for as long as this is
    open. Raises FileError."""
    module = find_unpacker(path)
    if module is None:
        yield path
        return
    if find_spec(module) is None:
        got = f"meshes that the package {PACKAGES[module]} unpacks, and it is not there"
        need = "that package: pip install palpate-editor[formats]"
        raise FileError(str(path), "", got, need)
    with TemporaryDirectory(prefix="palpate-mesh-") as folder, naming(path):
        plain = Path(folder) / f"{path.stem}.glb"
        write_whole(plain, run_unpacker(path, module))
        yield plain


def find_unpacker(path: Path) -> str | None:
    """The module that unpacks the meshes of a glTF; None where they are plain, and of all else."""
    if path.suffix.lower() not in (".glb", ".gltf"):
        return None
    try:
        with path.open("rb") as file:
            head = file.read(20)
            size = int.from_bytes(head[12:16], "little") if head[:4] == b"glTF" else MOST_TEXT
            text = head + file.read(min(size, MOST_TEXT))
    except OSError:
        return None
    return next((module for name, module in PACKED.items() if name in text), None)


def run_unpacker(path: Path, module: str) -> bytes:
    """What a Python of its own makes of it. Raises FileError."""
    words = build_isolated(CHILD, find_folders(module), path, "PACKED_GLTF")
    limits = [str(MEMORY_LIMIT), str(int(TIME_LIMIT))]
    wanted = "a glTF that is whole"
    try:
        child = subprocess.run([*words, *limits], stdin=subprocess.DEVNULL, capture_output=True,
                               check=False, timeout=PATIENCE * TIME_LIMIT)  # fmt: skip
    except subprocess.TimeoutExpired:
        raise FileError(str(path), "", "meshes that take too long to unpack", wanted) from None
    refusal = decode_refusal(child.stdout)
    if refusal is not None:
        raise FileError(str(path), *refusal)
    if child.returncode != 0 or not child.stdout:
        got = f"meshes that end what unpacks them ({child.returncode})"
        raise FileError(str(path), "", got, wanted)
    return child.stdout


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Whatever is refused within is said of `path`."""
    try:
        yield
    except FileError as refusal:
        where, got, expected = refusal.where, refusal.got, refusal.expected
        raise FileError(str(path), where, got, expected) from None


def write_unpacked(path: Path, plain: Path) -> None:
    """Raises FileError."""
    try:
        write_whole(plain, unpack(path.read_bytes()))
    except Refusal as refusal:
        raise FileError(str(path), refusal.where, refusal.got, refusal.expected) from None
    except OSError as problem:
        raise FileError(str(path), "", problem.strerror or "", "a readable mesh file") from None

# SPDX-License-Identifier: GPL-3.0-or-later
"""The process that reads a mesh file in Python: child.py FOLDERS FILE FORMAT BYTES SECONDS.

Started by path with `python -I`; FOLDERS are where its modules are. Once they are loaded it may
open nothing but them and the file; where files of the format name others, its folder as well.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from importlib import import_module

READERS = {
    "MSH": ("read_gmsh", "read_gmsh"),
    "MEDIT": ("read_medit", "read_medit"),
    "TETGEN": ("read_tetgen", "read_tetgen"),
    "VEGA": ("read_tetgen", "read_vega"),
    "CARP": ("read_tetgen", "read_carp"),
    "NETGEN": ("read_netgen", "read_netgen"),
    "ABAQUS": ("read_abaqus", "read_abaqus"),
    "NASTRAN": ("read_nastran", "read_nastran"),
    "UNV": ("read_universal", "read_universal"),
    "FEBIO": ("read_febio", "read_febio"),
    "DYNA": ("read_dyna", "read_dyna"),
    "GIFTI": ("read_brain", "read_gifti"),
    "FREESURFER": ("read_brain", "read_freesurfer"),
    "MZ3": ("read_brain", "read_mz3"),
    "FLUENT": ("read_fluent", "read_fluent"),
    "GAMBIT": ("read_gambit", "read_gambit"),
    "UCD": ("read_gambit", "read_ucd"),
    "VRML": ("read_vrml", "read_vrml"),
    "PACKED_GLTF": ("unpack_gltf", "unpack_gltf"),
}
"""Format -> module and function that read it; VTK reads all others. The last one's answer is a file
that another program reads."""


FOLLOWS = ("TETGEN", "VEGA", "CARP", "VTM", "XDMF", "PACKED_GLTF")
"""Formats whose files name others, which lie beside or below them."""


def choose_reader(form: str) -> Callable[[str], object]:
    """The function that reads a format; its library is loaded by that."""
    if form in READERS:
        module, name = READERS[form]
        read = getattr(import_module(f"palpate_editor.formats_child.{module}"), name)
        return lambda path: read(path)
    from palpate_editor.formats_child.read_vtk import read_vtk
    from palpate_editor.formats_child.vtk_data import load_reader

    load_reader(form)
    return lambda path: read_vtk(path, form)


def main(folders: str, path: str, form: str, memory: str, seconds: str) -> int:
    sys.path += folders.split(os.pathsep)
    # a library that starts threads of its own would need memory for each
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "VTK_SMP_MAX_THREADS"):
        os.environ[name] = "1"
    from palpate_editor.formats_child.confine import confine
    from palpate_editor.formats_child.scene import Refusal, encode_refusal, encode_scene

    read = choose_reader(form)
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # VTK prints what it thinks of a file
    libraries = [*folders.split(os.pathsep), os.path.dirname(os.__file__)]
    folders_read = [os.path.dirname(os.path.abspath(path))] if form in FOLLOWS else []
    confine(path, [*libraries, *folders_read], int(memory), int(seconds))
    try:
        found = read(path)
        answer = found if isinstance(found, bytes) else encode_scene(found)
    except Refusal as refusal:
        answer = encode_refusal(refusal)
    except MemoryError:
        most = f"content that needs more than {int(memory) // 1_000_000} MB to read"
        answer = encode_refusal(Refusal("", most, "a mesh that fits"))
    except Exception as problem:  # whatever a foreign reader stumbles over is the file's fault
        said = " ".join(str(problem).split())[:200] or type(problem).__name__
        answer = encode_refusal(
            Refusal("", f"content the reader fails on ({said})", f"a readable {form} file")
        )
    answers.write(answer)
    answers.flush()
    return 0


if __name__ == "__main__":
    # nothing of what was loaded has anything to tidy up
    code = main(*sys.argv[1:])
    os._exit(code)

# SPDX-License-Identifier: GPL-3.0-or-later
"""The process that reads a file of VTK or Gmsh: child.py FOLDERS FILE FORMAT BYTES SECONDS.

Started by path with `python -I`; FOLDERS are where its modules are. Once they are loaded it may
open nothing but them and the file.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable


def choose_reader(form: str) -> Callable[[str], object]:
    """The function that reads a format; its library is loaded by that."""
    if form == "MSH":
        from palpate_editor.formats_child.read_gmsh import read_gmsh

        return read_gmsh
    from palpate_editor.formats_child.read_vtk import read_vtk

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
    confine(path, libraries, int(memory), int(seconds))
    try:
        answer = encode_scene(read(path))
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

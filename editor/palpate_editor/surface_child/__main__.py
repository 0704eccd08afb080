# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m palpate_editor.surface_child FOLDER: does the job that FOLDER asks for."""

from __future__ import annotations

import ctypes
import json
import resource
import signal
import sys
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import palpate
from palpate.files.whole_file import write_whole

from palpate_editor.surface_child.jobs import JOBS

SET_DEATH_SIGNAL = 1
"""Of prctl."""


def keep(folder: Path, mesh: palpate.SurfaceMesh, told: dict[str, Any]) -> None:
    """Leaves what is found so far: whole, or what was there before."""
    content = BytesIO()
    np.savez(
        content,
        vertices=np.asarray(mesh.vertices),
        triangles=np.asarray(mesh.triangles),
        told=np.frombuffer(json.dumps(told).encode(), np.uint8),
    )
    write_whole(folder / "found.npz", content.getvalue())


def main(folder: Path) -> int:
    ctypes.CDLL(None).prctl(SET_DEATH_SIGNAL, signal.SIGKILL, 0, 0, 0)
    request = json.loads((folder / "request.json").read_text(encoding="utf-8"))
    memory = int(request["memory"])
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with np.load(folder / "surface.npz", allow_pickle=False) as arrays:
        mesh = palpate.SurfaceMesh(arrays["vertices"], arrays["triangles"])
    try:
        JOBS[request["job"]](mesh, request["numbers"], lambda m, told: keep(folder, m, told))
    except (ValueError, MemoryError) as refused:
        said = json.dumps([type(refused).__name__, str(refused)])
        write_whole(folder / "refused.json", said.encode())
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))

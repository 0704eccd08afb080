# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a request, limits itself, answers."""

from __future__ import annotations

import json
import os
import resource
import sys
from pathlib import Path
from typing import Any


def limit(request: dict[str, Any]) -> None:
    """Before anything of the data is looked at: memory, processor time, size of files, no core."""
    for name, most in (
        (resource.RLIMIT_AS, request["memory_limit"]),
        (resource.RLIMIT_CPU, int(request["time_limit"]) + 1),
        (resource.RLIMIT_FSIZE, request["memory_limit"]),
        (resource.RLIMIT_CORE, 0),
    ):
        resource.setrlimit(name, (most, most))
    # axes of a NIfTI file that are not perpendicular are read, and found again in its header
    os.environ["ITK_NIFTI_SFORM_PERMISSIVE"] = "YES"
    os.environ["ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS"] = "1"


def answer(request: dict[str, Any], folder: Path) -> dict[str, Any]:
    """What is said of a scan; its arrays are left in `folder`. Raises Refused."""
    import SimpleITK

    from palpate_editor.scan_child.describe import describe_volume, read_scan, save

    SimpleITK.ProcessObject.SetGlobalWarningDisplay(False)
    path = Path(request["path"])
    volume = read_scan(path, request["series"])
    said = describe_volume(volume)
    if request["voxels"]:
        save(folder / "voxels.npy", volume.voxels)
    if request["choice"] is None:
        return said
    from palpate_editor.scan_child.choice import Choice
    from palpate_editor.scan_child.surface import extract_surface

    choice = request["choice"]
    found = extract_surface(volume, Choice(**choice | {"labels": tuple(choice["labels"])}))
    save(folder / "vertices.npy", found.vertices)
    save(folder / "triangles.npy", found.triangles)
    kept = ("voxel_volume", "volume", "change", "pieces_dropped", "shells_dropped", "cut_sides")
    return said | {"surface": {name: getattr(found, name) for name in kept}}


def main() -> int:
    folder = Path(sys.argv[1])
    request = json.load(sys.stdin)
    limit(request)
    from palpate_editor.scan_child.refused import Refused, SeveralSeries

    said: dict[str, Any]
    try:
        said = {"answer": answer(request, folder)}
    except SeveralSeries as several:
        said = {
            "refused": [several.where, several.got, several.expected],
            "series": several.series,
        }
    except Refused as refused:
        said = {"refused": [refused.where, refused.got, refused.expected]}
    except MemoryError:
        most = f"at most {request['memory_limit'] / 1e9:.3g} GB"
        said = {"refused": ["", "a volume that takes more memory than it may", most]}
    except ModuleNotFoundError as problem:
        said = {"missing": problem.name}
    except OSError as problem:
        said = {"failed": [problem.errno, problem.strerror, str(problem.filename or "")]}
    print(json.dumps(said, allow_nan=False), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())

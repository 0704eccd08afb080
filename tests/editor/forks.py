# SPDX-License-Identifier: GPL-3.0-or-later
"""The same code on one file after the other, each in a process of its own with limits.

All are forked from one that has imported what they need: imports take longer than most files.
"""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

End = tuple[int, str, str]
"""Exit code, or minus the signal, and what was written to stdout and stderr."""


def run_in_forks(
    prepare: str, each: str, files: Sequence[Path], folder: Path, limits: dict[str, int]
) -> dict[str, End]:
    """How `each` ended for every file, by its path.

    Args:
        prepare: Source, run once before the first fork.
        each: Source, run in each process, where `file` is the path.
        files: What it is run on.
        folder: For what they write.
        limits: memory [bytes] that may be mapped, processor [s], wall [s] of each.
    """
    order = {"prepare": prepare, "each": each, "files": list(map(str, files)), "limits": limits}
    # every thread of a numerics library sets an address range aside, which is not memory used
    alone = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    done = subprocess.run(
        [sys.executable, __file__],
        input=json.dumps(order),
        capture_output=True,
        encoding="utf-8",  # whatever a window in this process has made of the locale
        cwd=folder,
        env=os.environ | alone,
    )
    assert done.returncode == 0, done.stderr
    return json.loads((folder / "ends.json").read_text(encoding="utf-8"))


def fork(each: str, names: dict[str, Any], file: str, limits: dict[str, int]) -> End:
    places = [os.open(name, os.O_RDWR | os.O_CREAT | os.O_TRUNC) for name in ("out", "err")]
    child = os.fork()
    if child == 0:
        os.dup2(places[0], 1)
        os.dup2(places[1], 2)
        resource.setrlimit(resource.RLIMIT_AS, (limits["memory"],) * 2)
        resource.setrlimit(resource.RLIMIT_CPU, (limits["processor"],) * 2)
        signal.alarm(limits["wall"])
        exec(each, names | {"file": file})
        sys.exit(0)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    for place in places:
        os.close(place)
    out, err = (Path(name).read_text(encoding="utf-8") for name in ("out", "err"))
    return code, out, err


def main() -> None:
    order = json.load(sys.stdin)
    names: dict[str, Any] = {}
    exec(order["prepare"], names)
    ends = {file: fork(order["each"], names, file, order["limits"]) for file in order["files"]}
    Path("ends.json").write_text(json.dumps(ends), encoding="utf-8")


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""Reads published files one by one, each in a process with 1 GB of memory and 5 s of processor.

python read_in_limits.py FILE ...        prints one JSON object: file -> what came of it
"""

from __future__ import annotations

import json
import os
import resource
import sys

import palpate
import palpate.scenario

MEMORY = 1 << 30
"""[bytes] All that the process may have mapped, the interpreter and its libraries included."""
SECONDS = 5


def read_in_child(path: str) -> str:
    ours, theirs = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(ours)
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
        try:
            palpate.scenario.read(path)
            words = "read"
        except palpate.FileError as refused:
            words = f"refused: {refused}"
        except BaseException as other:
            words = f"failed: {type(other).__name__}: {other}"
        os.write(theirs, words.encode())
        os._exit(0)
    os.close(theirs)
    with os.fdopen(ours, "rb") as pipe:
        words = pipe.read().decode(errors="replace")
    _, status = os.waitpid(child, 0)
    return words if status == 0 else f"died: {os.waitstatus_to_exitcode(status)}"


if __name__ == "__main__":
    print(json.dumps({path: read_in_child(path) for path in sys.argv[1:]}))

# SPDX-License-Identifier: BSD-3-Clause
"""Children that save over one file without end, each killed at a moment of its own.

    python save_again_and_again.py FILE OLD NEW MOMENTS...        prints one JSON list

FILE is a published one where its name ends in .palpate, else the container of a working one. Every
child writes OLD's and NEW's contents over FILE in turn. Every second kill waits until part of a
file stands beside FILE: where a disk is fast, moments alone seldom meet one. After each kill the
list gains what FILE is, "old", "new" or what is wrong with it, and whether the kill came in the
middle of a file: then part of one stands beside FILE, and is removed.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from pathlib import Path

import palpate.scenario as scenario

Content = scenario.Scenario | scenario.Container
# of the organs that the editor writes: their version is its own
NEWEST = 1000
LONGEST_SAVE = 10.0
"""[s]"""


def read(path: str, published: bool) -> Content:
    return scenario.read(path) if published else scenario.read_container(path, "organ", NEWEST)


def save(path: str, content: Content) -> None:
    if isinstance(content, scenario.Scenario):
        scenario.write(path, content)
    else:
        scenario.write_container(path, content)


def save_for_ever(path: str, contents: list[Content], started: int) -> None:
    save(path, contents[0])
    os.write(started, b".")
    while True:
        for content in reversed(contents):
            save(path, content)


def wait_for_a_part(path: Path) -> None:
    """Until part of a file stands beside it."""
    until = time.monotonic() + LONGEST_SAVE
    while time.monotonic() < until and len(os.listdir(path.parent)) < 2:
        pass


def kill_while_saving(
    path: str, contents: list[Content], moment: float, in_the_middle: bool
) -> None:
    ours, theirs = os.pipe()
    child = os.fork()
    if child == 0:
        save_for_ever(path, contents, theirs)
    os.read(ours, 1)
    time.sleep(moment)
    if in_the_middle:
        wait_for_a_part(Path(path))
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    os.close(ours)
    os.close(theirs)


def remove_parts(path: Path) -> bool:
    parts = [part for part in path.parent.iterdir() if part != path]
    for part in parts:
        part.unlink()
    return bool(parts)


def main(path: str, old: str, new: str, *moments: str) -> list[tuple[str, bool]]:
    published = path.endswith(".palpate")
    contents = [read(old, published), read(new, published)]
    whole = {Path(old).read_bytes(): "old", Path(new).read_bytes(): "new"}
    found = []
    for number, moment in enumerate(moments):
        kill_while_saving(path, contents, float(moment), number % 2 == 1)
        try:
            read(path, published)
            words = whole.get(Path(path).read_bytes(), "neither")
        except OSError as problem:
            words = str(problem)
        found.append((words, remove_parts(Path(path))))
    return found


if __name__ == "__main__":
    print(json.dumps(main(*sys.argv[1:])))

# SPDX-License-Identifier: BSD-3-Clause
"""The source tree as the tests of this folder see it."""

from __future__ import annotations

import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]


@cache
def source_files() -> tuple[str, ...]:
    """Every file that is or may become part of the repository, ascending."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=CHECKOUT,
        capture_output=True,
        encoding="utf-8",
        check=True,
    ).stdout
    files = (name for name in listed.split("\0") if name)
    return tuple(sorted(name for name in files if is_plain_file(CHECKOUT / name)))


def is_plain_file(path: Path) -> bool:
    """A symbolic link only repeats what stands elsewhere."""
    return path.is_file() and not path.is_symlink()


def files_under(folder: str, *endings: str) -> list[str]:
    prefix = folder.rstrip("/") + "/"
    return [name for name in source_files() if name.startswith(prefix) and name.endswith(endings)]


@cache
def read(name: str) -> str:
    return (CHECKOUT / name).read_text(encoding="utf-8")


@cache
def read_code(name: str) -> str:
    """A C or C++ file without its comments; lines keep their numbers."""
    pattern = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.DOTALL)

    def keep_strings(match: re.Match[str]) -> str:
        text = match[0]
        return text if text.startswith('"') else "\n" * text.count("\n")

    return pattern.sub(keep_strings, read(name))


def install(build: Path, name: str) -> Path:
    """What a build folder installs, under a name in build/ that stays the same: what is compiled
    against it is compiled again only where it has changed. Nothing of an earlier one is left."""
    prefix = CHECKOUT / "build" / name
    shutil.rmtree(prefix, ignore_errors=True)
    done = subprocess.run(
        ["cmake", "--install", build, "--prefix", prefix], capture_output=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return prefix

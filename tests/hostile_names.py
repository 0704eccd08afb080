# SPDX-License-Identifier: BSD-3-Clause
"""A current folder full of files named like modules, which tell when one of them was run."""

from __future__ import annotations

from pathlib import Path

NAMES = (
    *("PySide6", "numpy", "scipy", "matplotlib", "moderngl", "pyqtgraph", "palpate"),
    *("palpate_editor", "palpate_meshes", "json", "argparse", "subprocess", "importlib"),
    *("pathlib", "typing", "sitecustomize", "usercustomize", "ruff", "runpy", "cli", "_sim"),
)
MARK = "was-run"
CODE = """
with open({mark!r}, "a") as file:
    file.write(__name__)
raise SystemExit(99)
"""


def make_hostile_folder(folder: Path) -> Path:
    """The folder with a file and a package under every name."""
    folder.mkdir()
    code = CODE.format(mark=str(folder / MARK))
    for name in NAMES:
        (folder / f"{name}.py").write_text(code, encoding="utf-8")
        (folder / name).mkdir()
        (folder / name / "__init__.py").write_text(code, encoding="utf-8")
    return folder


def list_run(folder: Path) -> str:
    """The names of what was run, "" where nothing was."""
    mark = folder / MARK
    return mark.read_text(encoding="utf-8") if mark.exists() else ""

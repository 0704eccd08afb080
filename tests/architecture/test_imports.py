# SPDX-License-Identifier: BSD-3-Clause
"""Who may import whom in Python: the arrows of core/README.md, and no others."""

from __future__ import annotations

import ast
import sys
import tomllib
from dataclasses import dataclass

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from tree import files_under, read

QT = ("PySide6", "shiboken6", "pyqtgraph")

RENDER = ("palpate", "numpy", "moderngl")
FILES = (
    "palpate.error",
    "palpate.files.json_part",
    "palpate.files.refusal",
    "palpate.scenario",
)
DOCUMENT = (
    "palpate_editor.document",
    "palpate.scene.scene_parts",
    "palpate.scene.tick_cost",
    *FILES,
    "numpy",
)
EDITS = (
    "palpate_editor.edits",
    "palpate_editor.appearance",
    "palpate_editor.authoring",
    "palpate_editor.document",
    "palpate_editor.guarded",
    "palpate_editor.pictures",
    "palpate_editor.vertex_colours",
    "palpate",
    "numpy",
)
APP = (
    "palpate_editor.app",
    "palpate_editor.compile",
    "palpate_editor.check",
    "palpate_editor.open_organ",
    *EDITS,
)

ARROWS = {
    "bindings/palpate/files": ("palpate.files", "palpate.error"),
    "bindings/palpate/system": ("palpate.system",),
    "bindings/palpate/command": ("palpate.command", "palpate.files"),
    "bindings/palpate/mesh_files": (
        "palpate.mesh_files",
        "palpate.files",
        "palpate.error",
        "palpate._sim",
        "numpy",
    ),
    "bindings/palpate/render": (*RENDER, "matplotlib"),
    "bindings/palpate/viewport": (*RENDER, "PySide6"),
    "bindings/palpate/translation": ("palpate.translation", "PySide6"),
    "bindings/palpate/records": ("palpate", "numpy", "sqlalchemy"),
    "bindings/palpate/player": ("palpate", "numpy", "PySide6"),
    "bindings/palpate/device_window": ("palpate", "numpy", "PySide6"),
    "bindings/palpate": ("palpate", "numpy", "scipy", "matplotlib"),
    "editor/palpate_editor/document": DOCUMENT,
    "editor/palpate_editor/edits": EDITS,
    "editor/palpate_editor/app": (*APP, "PySide6.QtCore", "PySide6.QtGui"),
    "editor/palpate_editor/views": ("palpate_editor", "palpate", "numpy", *QT),
    "editor/palpate_editor/truth": (
        "palpate_editor",
        "palpate",
        "numpy",
        "scipy",
        "skfem",
        "cvxopt",
        "pymetis",
    ),
    "editor/palpate_editor/formats_child": (
        "palpate_editor.formats_child",
        "PIL",
        "numpy",
        "vtkmodules",
        "DracoPy",
    ),
    "editor/palpate_editor/scan": (
        "palpate_editor.scan",
        "palpate_editor.scan_child.choice",
        "palpate.error",
        "palpate.files.refusal",
        "palpate.system.isolated",
        "numpy",
    ),
    "editor/palpate_editor/scan_child": (
        "palpate_editor.scan_child",
        "numpy",
        "scipy",
        "skimage",
        "SimpleITK",
    ),
    "editor/palpate_editor": ("palpate_editor", "palpate_meshes", "palpate", "numpy", "scipy"),
    "meshes/generate": (
        "palpate_meshes.generate",
        "palpate_editor.authoring",
        "palpate.files.whole_file",
        "numpy",
        "scipy",
        "skimage",
    ),
    "meshes": ("palpate_meshes", "palpate_editor", "palpate", "numpy", "scipy"),
}
"""Folder -> what its modules may import beside the standard library; the longest match counts."""

GUARDED = {
    ("bindings/palpate/bench/meshes.py", "palpate_meshes.catalogue"),
    ("bindings/palpate/bench/meshes.py", "palpate_meshes.generate.ellipsoid"),
    ("editor/palpate_editor/chart_cluster.py", "distributed"),
}
"""Imports that stand in a function and say what to install where they fail."""

NAME_ON_INDEX = {
    "PIL": "pillow",
    "vtkmodules": "vtk",
    "skfem": "scikit-fem",
    "skimage": "scikit-image",
    "PySide6": "pyside6-essentials",
}


def module_of(name: str) -> str:
    """The dotted module of a source file, with __init__ kept so that levels count alike."""
    for folder, root in (("bindings/", ""), ("editor/", ""), ("meshes/", "palpate_meshes/")):
        if name.startswith(folder):
            name = root + name.removeprefix(folder)
    return name.removesuffix(".py").replace("/", ".")


OUR_FILES = [
    name
    for folder in ("bindings/palpate", "editor/palpate_editor", "meshes")
    for name in files_under(folder, ".py")
]
OUR_MODULES = {module_of(name).removesuffix(".__init__") for name in OUR_FILES}
Graph = dict[str, set[str]]
"""Module -> what it imports, of our own."""


@dataclass(frozen=True)
class Import:
    """One imported module and where."""

    file: str
    line: int
    module: str
    in_function: bool


def imports(name: str) -> list[Import]:
    """Every import of a file, relative ones made absolute."""
    found: list[Import] = []
    package = module_of(name).split(".")

    def visit(node: ast.AST, in_function: bool) -> None:
        modules: list[str] = []
        if isinstance(node, ast.Import):
            modules = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            start = ".".join(package[: len(package) - node.level]) if node.level else ""
            module = ".".join(part for part in (start, node.module) if part)
            modules = sorted({name_import(module, alias.name) for alias in node.names})
        found.extend(Import(name, node.lineno, module, in_function) for module in modules)
        inside = in_function or isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        for child in ast.iter_child_nodes(node):
            visit(child, inside)

    visit(ast.parse(read(name)), False)
    return found


def name_import(module: str, name: str) -> str:
    """`from palpate_editor import authoring` imports a module of ours, not a name in one."""
    return f"{module}.{name}" if f"{module}.{name}" in OUR_MODULES else module


def build_graph(packages: bool = False) -> Graph:
    """Who imports whom, in functions and for annotations too; of modules, or of our packages."""
    graph: Graph = {}
    for name in OUR_FILES:
        here = module_of(name).removesuffix(".__init__")
        there = {i.module for i in imports(name) if i.module in OUR_MODULES}
        if packages:
            here, there = package_of(here), {package_of(module) for module in there}
        graph.setdefault(here, set()).update(there - {here})
    return graph


def package_of(module: str) -> str:
    """The part of a distribution that a module belongs to: palpate.runs of palpate.runs.live."""
    return ".".join(module.split(".")[:2])


def find_circles(graph: Graph) -> list[list[str]]:
    """The strongly connected components of more than one node, each sorted."""
    reached = {node: find_reached(graph, node) for node in graph}
    circles = {
        tuple(sorted(other for other in reached[node] if node in reached.get(other, ())))
        for node in graph
    }
    return sorted(list(circle) for circle in circles if circle)


def find_reached(graph: Graph, start: str) -> set[str]:
    """What is imported by way of any number of others; `start` itself only in a circle."""
    reached: set[str] = set()
    waiting = [start]
    while waiting:
        new = graph.get(waiting.pop(), set()) - reached
        reached |= new
        waiting += new
    return reached


def within(module: str, names: tuple[str, ...]) -> bool:
    return any(module == name or module.startswith(name + ".") for name in names)


def is_standard(module: str) -> bool:
    return module.split(".")[0] in sys.stdlib_module_names


def folder_of(name: str) -> str:
    return max((folder for folder in ARROWS if name.startswith(folder + "/")), key=len)


@pytest.mark.parametrize("folder", ARROWS)
def test_a_package_imports_only_what_its_arrow_allows(folder):
    files = [name for name in files_under(folder, ".py") if folder_of(name) == folder]
    assert files

    wrong = [
        f"{i.file}:{i.line} imports {i.module}"
        for name in files
        for i in imports(name)
        if not is_standard(i.module)
        and not within(i.module, ARROWS[folder])
        and not (i.in_function and (i.file, i.module) in GUARDED)
    ]

    assert wrong == []


def test_circles_are_found_where_there_are_some():
    graph = {"a": {"b"}, "b": {"c"}, "c": {"a"}, "d": {"a", "e"}, "e": {"d"}, "f": {"a"}}

    assert find_circles(graph) == [["a", "b", "c"], ["d", "e"]]


def test_an_import_within_a_function_or_for_annotations_alone_counts_in_a_circle():
    graph = build_graph()

    assert "palpate.cli.verbs" in graph["palpate.cli.main"], "in load_verbs"
    assert "palpate.study.accuracy" in graph["palpate.study.findings"]


def test_no_modules_import_each_other_in_a_circle():
    assert find_circles(build_graph()) == []


def test_packages_import_each_other_in_one_direction():
    graph = build_graph(packages=True)

    assert find_circles(graph) == []


@pytest.mark.parametrize(
    ("project", "folders"),
    [("pyproject.toml", ("bindings/palpate",)),
     ("editor/pyproject.toml", ("editor/palpate_editor", "meshes"))],
    ids=["palpate", "palpate-editor"],
)  # fmt: skip
def test_a_distribution_declares_every_package_it_imports(project, folders):
    about = tomllib.loads(read(project))["project"]
    extras = about.get("optional-dependencies", {}).values()
    declared = {
        canonicalize_name(Requirement(text).name)
        for text in [*about["dependencies"], *(text for extra in extras for text in extra)]
    }
    ours = ("palpate", "palpate_editor", "palpate_meshes")

    missing = {
        f"{i.module} ({name})"
        for folder in folders
        for name in files_under(folder, ".py")
        for i in imports(name)
        if not is_standard(i.module) and not within(i.module, ours)
        and canonicalize_name(NAME_ON_INDEX.get(i.module.split(".")[0], i.module.split(".")[0]))
        not in declared
    }  # fmt: skip

    assert missing == set()

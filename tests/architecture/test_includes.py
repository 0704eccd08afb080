# SPDX-License-Identifier: BSD-3-Clause
"""Who may include whom in C++: the arrows of core/README.md, and no others."""

from __future__ import annotations

import re

import pytest
from tree import files_under, read, read_code

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD = re.compile(r"[a-z_0-9]+")
"""A header of the C++ library has neither folder nor ending."""

ROOMS = {
    "base": (),
    "mesh": ("base",),
    "model": ("base", "mesh"),
    "dynamics": ("base", "mesh", "model"),
    "implicit": ("base", "model", "dynamics"),
    "packed": ("base", "model", "dynamics"),
    "response": ("base", "model", "dynamics"),
    "tree": ("base", "mesh"),
    # the tool writes what it does to the tissue into a Load, and knows nothing of dynamics
    "contact": ("base", "mesh", "model", "response", "tree"),
    # what two jaws touch and hold, by the contacts of each and the particles under a skin, and what
    # tears of it, by its laws
    "grasp": ("base", "model", "dynamics", "contact"),
    # surfaces of tissues that touch each other, and never a tool
    "collision": ("base", "mesh", "model", "tree"),
    "device": ("base",),
    "tick": (
        "base",
        "mesh",
        "model",
        "dynamics",
        "implicit",
        "packed",
        "response",
        "tree",
        "contact",
        "grasp",
        "collision",
        "device",
    ),
    "task": ("base", "mesh", "model", "tree", "contact", "device", "tick"),
    "multirate": (
        "base",
        "model",
        "dynamics",
        "packed",
        "response",
        "tree",
        "contact",
        "device",
        "tick",
    ),
    "loop": ("base", "model", "packed", "tree", "contact", "device", "tick", "task", "multirate"),
    "arm": ("base", "device"),
    "session": ("base", "device", "tick", "task", "multirate", "loop"),
}
"""Room of core/sim -> the other rooms that it may include."""

MOST_FILES = 36
"""in a room: with more it holds two."""

MORE_FILES = {"tick": 56, "contact": 39}
"""Room -> how many it has for now: scene and world are to have a room of their own below it, and so
is the near field below contact."""

MOST_PUBLIC_HEADERS = 49

POSIX = ("fcntl.h", "poll.h", "pthread.h", "sched.h", "sys/", "time.h", "unistd.h")
SYSTEM = {
    "core/sim/base/private/whole_file.cpp": POSIX,
    "core/sim/arm/serial_transport.cpp": ("asio/", "termios.h", "linux/serial.h", *POSIX),
    "core/sim/arm/pty_device.cpp": ("termios.h", *POSIX),
    "core/sim/base/private/realtime.cpp": POSIX,
    "core/sim/session/": ("openssl/", "zlib.h", *POSIX),
    "core/sim/packed/": ("hwy/",),
    "core/sim/collision/held_kernels.cpp": ("hwy/",),
    "core/sim/contact/contact_lanes": ("hwy/",),
    "core/sim/contact/private/capsule_lanes": ("hwy/",),
    "core/sim/tree/private/four-inl.h": ("hwy/",),
    "core/sim/tree/private/tree_kernels.cpp": ("hwy/",),
}
"""Private parts of palpate::sim that may need more than Eigen and the C++ library."""

FIRMWARE = ("protocol/", "board/host.h")
"""Of the firmware: what goes over the wire and, for the simulated device, all of it."""

SCENARIO = {
    "core/scenario/archive.cpp": ("zip.h",),
    "core/scenario/json_fields.h": ("nlohmann/",),
    "core/scenario/whole_file.cpp": ("fcntl.h",),
}
"""The files of palpate::scenario that need more than the C++ library."""

FOREIGN = {
    "assimp": "core/authoring/read_mesh_child/",
    "OpenMesh": "core/authoring/",
    "CGAL": "core/authoring/cgal/",
    "boost": "core/authoring/cgal/",
}
"""Library -> the only folder whose sources may include it."""


def includes(name: str) -> list[tuple[str, str]]:
    """(bracket, path) of every include of a file."""
    return INCLUDE.findall(read_code(name))


def own(name: str) -> list[str]:
    return [path for _, path in includes(name) if path.startswith("palpate/")]


def foreign(name: str) -> list[str]:
    return [path for bracket, path in includes(name) if bracket == "<"]


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_of_sim_includes_only_the_rooms_below_it(room):
    allowed = ("palpate/version.h", *(f"palpate/sim/{part}/" for part in (room, *ROOMS[room])))
    files = files_under(f"core/sim/{room}", ".h", ".cpp")
    assert files

    wrong = [(name, path) for name in files for path in own(name) if not path.startswith(allowed)]

    assert wrong == []


def test_the_firmware_is_included_by_the_arm_only_and_by_no_header_that_is_installed():
    found = {
        (name, path)
        for name in files_under("core/sim", ".h", ".cpp")
        for bracket, path in includes(name)
        if bracket == '"' and not path.startswith("palpate/")
    }

    assert found
    assert {name for name, _ in found if not name.startswith("core/sim/arm/")} == set()
    assert {path for _, path in found if not path.startswith(FIRMWARE)} == set()
    assert {name for name, _ in found if name.endswith(".h") and "/private/" not in name} == set()


def test_arrows_between_rooms_only_point_downwards():
    below: list[str] = []
    for room, used in ROOMS.items():
        assert set(used) <= set(below)
        below.append(room)


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_has_no_more_files_than_a_reader_can_keep_apart(room):
    assert len(files_under(f"core/sim/{room}", ".h", ".cpp")) <= MORE_FILES.get(room, MOST_FILES)


def test_public_headers_are_few_enough_to_be_read_as_documentation():
    headers = [name for name in files_under("core/sim", ".h") if "/private/" not in name]

    assert len(headers) + len(["sim.h", "version.h"]) <= MOST_PUBLIC_HEADERS


def test_no_public_header_includes_a_private_one():
    headers = [name for name in files_under("core/sim", ".h") if "/private/" not in name]
    assert headers

    wrong = [(name, path) for name in headers for path in own(name) if "/private/" in path]

    assert wrong == []


def test_every_folder_of_sim_is_a_room_with_arrows():
    assert {name.split("/")[2] for name in files_under("core/sim", ".h", ".cpp")} == set(ROOMS)


def test_headers_of_sim_include_eigen_and_the_standard_library_only():
    # -inl.h is compiled once for every vector target and never installed
    headers = [name for name in files_under("core/sim", ".h") if not name.endswith("-inl.h")]
    assert headers

    wrong = [
        (name, path)
        for name in headers
        for path in foreign(name)
        if not path.startswith("Eigen/") and not STANDARD.fullmatch(path)
    ]

    assert wrong == []


def test_sources_of_sim_include_system_headers_only_where_that_is_stated():
    wrong = []
    for name in files_under("core/sim", ".cpp"):
        allowed = next((SYSTEM[folder] for folder in SYSTEM if name.startswith(folder)), ())
        wrong += [
            (name, path)
            for path in foreign(name)
            if not path.startswith(("Eigen/", *allowed)) and not STANDARD.fullmatch(path)
        ]

    assert wrong == []


def test_scenario_sees_sim_and_itself():
    files = files_under("core/scenario", ".h", ".cpp")
    assert files

    wrong = [
        (name, path)
        for name in files
        for path in own(name)
        if not path.startswith(("palpate/scenario/", "palpate/sim/"))
    ]

    assert wrong == []


def test_scenario_includes_foreign_headers_only_where_that_is_stated():
    wrong = [
        (name, path)
        for name in files_under("core/scenario", ".h", ".cpp")
        for path in foreign(name)
        if not STANDARD.fullmatch(path) and not path.startswith(SCENARIO.get(name, ()))
    ]

    assert wrong == []


def test_no_installed_header_of_scenario_includes_one_that_is_not_installed():
    listed = re.search(r"install\(FILES ((?:scenario/\w+\.h\s+)+)", read("core/CMakeLists.txt"))
    installed = {f"core/{name}" for name in listed[1].split()}
    assert installed <= set(files_under("core/scenario", ".h"))

    needed = {path.replace("palpate/", "core/", 1) for name in installed for path in own(name)}

    assert {name for name in needed if "scenario/" in name} <= installed


def test_nothing_of_sim_includes_scenario():
    wrong = [name for name in files_under("core/sim", ".h", ".cpp")
             for path in own(name) if "scenario" in path]  # fmt: skip

    assert wrong == []


def test_authoring_sees_only_base_mesh_model_and_tree_of_sim():
    allowed = (
        "palpate/authoring/",
        *(f"palpate/sim/{room}/" for room in ("model", "tree", *ROOMS["model"])),
    )
    files = files_under("core/authoring", ".h", ".cpp")
    assert files

    wrong = [(name, path) for name in files for path in own(name) if not path.startswith(allowed)]

    assert wrong == []


def test_nothing_outside_authoring_includes_authoring():
    files = files_under("core/sim", ".h", ".cpp") + files_under("bindings", ".h", ".cpp")

    wrong = [name for name in files for path in own(name) if "authoring" in path]

    assert wrong == []


@pytest.mark.parametrize("library", FOREIGN)
def test_a_library_of_authoring_is_included_in_its_folder_only(library):
    everywhere = [*files_under("core", ".h", ".cpp"), *files_under("bindings", ".h", ".cpp"),
                  *files_under("editor", ".h", ".cpp")]  # fmt: skip

    wrong = [
        name
        for name in everywhere
        for _, path in includes(name)
        if path.startswith(library + "/") and not name.startswith(FOREIGN[library])
    ]

    assert wrong == []


def test_no_header_of_authoring_mentions_a_type_of_a_library_behind_it():
    word = re.compile(r"\b(assimp|Assimp|aiScene|aiMesh|aiNode|OpenMesh|CGAL|boost)\b")
    # private headers are for the folder that compiles the library
    headers = [n for n in files_under("core/authoring", ".h") if "/private/" not in n]
    assert headers

    wrong = [name for name in headers if word.search(read_code(name))]

    assert wrong == []

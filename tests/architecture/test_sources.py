# SPDX-License-Identifier: BSD-3-Clause
"""What every source file owes: its licence, the names of the house, and no loose ends."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from tree import CHECKOUT, files_under, read, read_code, source_files

SOURCES = (".cpp", ".h", ".c", ".py", ".pyi", ".scad")
SCRIPTS = ("run", ".ci/run")
TEXTS = (*SOURCES, *SCRIPTS, ".txt", ".toml", ".json", ".md", ".in", ".lock")
GPL_FOLDERS = (
    "core/authoring/",
    "core/simavr/",
    "editor/",
    "tests/core/authoring/",
    "tests/core/simavr/",
    "tests/editor/",
    "tests/examples/add_a_stage/",
    "tests/firmware/test_mechanics.py",
)
HERE = "tests/architecture/test_sources.py"
"""This file, which names what must not be named."""


def sources() -> list[str]:
    return [name for name in source_files() if name.endswith(SOURCES) or name in SCRIPTS]


def texts() -> list[str]:
    return [name for name in source_files() if name.endswith(TEXTS) and name != HERE]


def test_every_source_file_names_its_licence_on_top():
    wrong = []
    for name in sources():
        licence = "GPL-3.0-or-later" if name.startswith(GPL_FOLDERS) else "BSD-3-Clause"
        first_lines = read(name).splitlines()[:2]
        if not any(line.endswith(f"SPDX-License-Identifier: {licence}") for line in first_lines):
            wrong.append(f"{name}: expected {licence}")

    assert wrong == []


def test_no_file_names_a_place_of_one_machine():
    pattern = re.compile(r"(?<![\w.$}])(?:/home/|/root/|/work/|/tmp/|[A-Z]:\\\\Users)")

    wrong = [name for name in texts() if pattern.search(read(name))]

    assert wrong == []


def test_no_source_promises_work_for_later():
    pattern = re.compile(r"\b(?:TODO|FIXME|XXX|NotImplementedError)\b")

    wrong = [name for name in sources() if name != HERE and pattern.search(read(name))]

    assert wrong == []


def test_no_name_of_ours_begins_with_get():
    pattern = re.compile(r"\b(?:def|[\w:>&*]+)\s+[&*]?get_\w+\s*\(")

    wrong = [
        name
        for name in files_under("core", ".h") + [n for n in source_files() if n.endswith(".py")]
        if pattern.search(read_code(name) if name.endswith(".h") else read(name))
    ]

    assert wrong == []


@pytest.mark.parametrize("word", ["utils", "util", "helper", "helpers", "manager", "common"])
def test_every_file_has_found_its_place(word):
    wrong = [name for name in sources() if re.search(rf"(?:^|/){word}(?:/|\.)", name)]

    assert wrong == []


def test_nothing_is_compiled_with_arithmetic_that_is_not_written():
    files = [
        name
        for name in source_files()
        if name.endswith("CMakeLists.txt") and name != "tests/bench/peers/CMakeLists.txt"
    ]  # the loop that other engines are measured against has the flags theirs were measured with
    words = "\n".join(read(name) for name in [*files, "CMakePresets.json"])

    assert "-ffast-math" not in words
    assert "-ffp-contract=off" in words


def test_every_link_in_the_tree_leads_somewhere():
    links = [path for folder in ("editor",) for path in (CHECKOUT / folder).iterdir()
             if path.is_symlink()]  # fmt: skip

    assert {path.name for path in links} == {"LICENSE", "palpate_meshes"}
    assert all(path.exists() for path in links)


PAPER = r"([A-Z][A-Za-z]+\d{2,4}|Appleby|HdrHistogram|IEC [\d-]+)"
CITED_PAPER = rf"\[{PAPER}(?:[ ,][^\]]{{0,40}})?\]"
CITED_SECTION = r"\[([a-z]+: [a-z0-9 -]+)\]"
KEYED_HEADING = rf"^#+ .*{CITED_SECTION}$"
OUTSIDE = (
    "SCIENCE|TOOLS|PERFORMANCE|DEVICE|EDITOR|MESHES|ASSESSMENT|FIELD|PEERS|MODELS|ARCHITECTURE"
)
"""Pages that were written before the code and are not in the repository."""


def join_lines(text: str) -> str:
    """For a key may be broken between two lines of a comment."""
    return re.sub(r"\n[ \t]*(?://[/!]?|#(?!#)|\*)?[ \t]*", " ", text)


def pages() -> list[str]:
    return [name for name in texts() if name.endswith(".md")]


def list_sections() -> list[str]:
    """Keys of all sections that a heading defines, each as often as it does."""
    return [key for name in pages() for key in re.findall(KEYED_HEADING, read(name), re.MULTILINE)]


def read_citing(name: str) -> str:
    """Without what defines keys."""
    text = read(name)
    if name == "core/README.md":
        text = text.partition("## 5. Sources")[0]
    if name.endswith(".md"):
        text = re.sub(KEYED_HEADING, "", text, flags=re.MULTILINE)
    return join_lines(text)


def list_cited(pattern: str) -> set[str]:
    names = [name for name in (*sources(), *pages()) if name != HERE]
    return {key for name in names for key in re.findall(pattern, read_citing(name))}


def test_every_paper_that_is_cited_stands_in_the_list_and_every_one_listed_is_cited():
    listed = re.findall(rf"^\| \[{PAPER}\] \|", read("core/README.md"), re.MULTILINE)

    assert len(listed) == len(set(listed))
    assert list_cited(CITED_PAPER) ^ set(listed) == set()


def test_every_section_that_is_cited_is_the_heading_of_a_page_and_every_one_keyed_is_cited():
    keyed = list_sections()

    assert len(keyed) > 20
    assert len(keyed) == len(set(keyed))
    assert list_cited(CITED_SECTION) ^ set(keyed) == set()


def test_the_key_of_a_section_begins_with_the_name_of_its_page():
    wrong = [
        f"{name}: {key}"
        for name in pages()
        for key in re.findall(KEYED_HEADING, read(name), re.MULTILINE)
        if key.partition(":")[0] != Path(name).stem.lower()
    ]

    assert wrong == []


def test_no_file_cites_a_page_that_is_not_in_the_repository():
    """As a bare word in prose and C++; elsewhere, where it may be a constant, with its section."""
    word = re.compile(rf"\b(?:{OUTSIDE})\b|design notes?\b")
    cited = re.compile(rf"\b(?:{OUTSIDE})(?:\.md\b|'s\b|,? (?:section )?\d)|design notes?\b")

    wrong = []
    for name in source_files():
        if name == HERE or "LICENSE" in name:
            continue
        try:
            text = join_lines(read(name))
        except UnicodeDecodeError:  # a picture, an organ, a record
            continue
        prose = name.endswith((".md", ".cpp", ".h", ".c", ".scad"))
        wrong += [f"{name}: {found}" for found in (word if prose else cited).findall(text)]

    assert wrong == []


def test_every_file_that_a_page_names_by_its_path_is_there():
    """DECISIONS.md and CHANGELOG.md tell of their day, when it may have stood elsewhere."""
    path = re.compile(
        r"`((?:core|bindings|editor|firmware|meshes|tests)/[\w./-]+\.(?:h|c|cpp|py|md|json|toml))`"
    )

    wrong = [
        f"{name}: {found}"
        for name in pages()
        if name not in ("DECISIONS.md", "CHANGELOG.md")
        for found in path.findall(read(name))
        if not (CHECKOUT / found).is_file()
    ]

    assert wrong == []


def test_every_python_that_is_started_is_isolated_from_the_current_folder():
    """Only isolated.py names the interpreter; see tests/bindings/test_isolated.py."""
    started = re.compile(r"sys\.executable|multiprocessing|ProcessPoolExecutor")
    own = [
        n for n in source_files() if n.startswith(("bindings/", "editor/")) and n.endswith(".py")
    ]

    named = [name for name in own if started.search(read(name))]

    assert named == ["bindings/palpate/system/isolated.py"]


def test_only_one_file_of_each_language_writes_files():
    """All others go through them: a new name, unforeseeable, synced, renamed."""
    creates = re.compile(r"O_CREAT|std::ofstream \w+\(|fopen\([^)]*\"w")
    opens = re.compile(r"O_CREAT|\.open\(\"[wax]|open\([^)]*, \"[wax]|write_(?:text|bytes)\(")
    own = [name for name in source_files() if name.startswith(("core/", "bindings/", "editor/"))]

    cpp = [n for n in own if n.endswith((".cpp", ".h")) and creates.search(read_code(n))]
    python = [n for n in own if n.endswith(".py") and opens.search(read(n))]

    # the recorder writes as the run goes; low latency is asked for by a word into sysfs
    assert cpp == [
        "core/sim/arm/serial_transport.cpp",
        "core/sim/base/private/whole_file.cpp",
        "core/sim/session/record.cpp",
    ]
    # the other is run by a developer and rewrites sources
    assert python == ["bindings/palpate/files/whole_file.py", "bindings/write_stub.py"]

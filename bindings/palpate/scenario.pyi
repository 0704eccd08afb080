# SPDX-License-Identifier: BSD-3-Clause
"""Written by bindings/write_stub.py from what the compiled module says of itself."""

import os
from typing import Any

from numpy.typing import NDArray

from palpate._sim import Scene

MOST_FILE_BYTES: int
MOST_ARRAY_BYTES: int
MOST_MANIFEST_BYTES: int
MOST_ARRAYS: int
MOST_DIMENSIONS: int
MOST_NAME_BYTES: int
MOST_DEPTH: int
MOST_TITLE_BYTES: int
MOST_TASK_BYTES: int
MOST_LANGUAGES: int
MOST_BODIES: int
MOST_BODY_PAIRS: int
MOST_INSTRUMENTS: int
MOST_RIGID: int
MOST_SCENERY: int
MOST_HARD_VERTICES: int
MOST_HARD_TRIANGLES: int
MOST_PARTICLES: int
MOST_TRIANGLES: int
MOST_LINKS: int
MOST_TETRAHEDRA: int
MOST_ELASTIC: int

class Container:
    """All that a .palpate or .organ file holds: a JSON document and arrays by name."""
    def __init__(
        self, *, format: str, version: int, content: str = ..., arrays: dict[str, Any] = ...
    ) -> None:
        """Copies its arrays, which are of bytes, 4 or 8 byte integers or floats.

        Arguments are the fields of these names, with their shapes and units.
        """
    format: str
    """"palpate" or "organ"."""
    version: int
    """Of the format."""
    content: str
    """JSON: one object."""
    @property
    def written_by(self) -> str:
        """Filled by the reader: which program and version wrote the file."""
    @property
    def arrays(self) -> dict[str, NDArray[Any]]:
        """By name, of the shapes and units that content says, in a new dict; views, read-only."""
    def __copy__(self) -> Container:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Container:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[str, int, str, dict[int, object], str]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def read_container(
    path: os.PathLike[str] | str | bytes, format: str, newest_version: int
) -> Container:
    """Reads a file of format whose version is newest_version or older; older ones come as they
    are. Raises FileError for everything else and for everything that is wrong.
    """

def write_container(path: os.PathLike[str] | str | bytes, container: Container) -> None:
    """Writes to a temporary name beside path, syncs, renames: whatever happens, path is what it
    was or all of the new file. Raises ValueError for what a reader would refuse, FileError
    where the disk refuses.
    """

def unpack_container(bytes: bytes, file: str, format: str, newest_version: int) -> Container:
    """The same from bytes; file is what refusals call them."""

def pack_container(container: Container) -> bytes:
    """The bytes of the file. Equal containers give equal bytes."""

class Words:
    """Title and task of a scenario in one language."""
    def __init__(self, title: str = ..., task: str = ...) -> None:
        """Arguments are the fields of these names, with their shapes and units."""
    @property
    def title(self) -> str:
        """Empty where it is not translated."""
    @property
    def task(self) -> str:
        """Empty where it is not translated."""
    def __copy__(self) -> Words:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Words:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class Scenario:
    """What a trainee opens: a scene that ticks, what to do with it, and what it was made from."""
    def __init__(
        self,
        *,
        scene: Scene,
        title: str = ...,
        task: str = ...,
        authored: str = ...,
        authored_arrays: dict[str, Any] = ...,
        languages: dict[str, Words] = ...,
        assessment: str = ...,
        assessment_arrays: dict[str, Any] = ...,
    ) -> None:
        """Copies the scene, which build_scene made.

        Arguments are the fields of these names, with their shapes and units.
        """
    title: str
    """What a trainee sees it called."""
    task: str
    """What the trainee is asked to do, in words."""
    @property
    def scene(self) -> Scene:
        """The scene, ready to tick."""
    authored: str
    """JSON: the designer's document, which only the editor reads."""
    assessment: str
    """JSON: what is asked of a trainee and judged; empty where nothing is."""
    @property
    def version(self) -> int:
        """Filled by the reader: of the format, as the file had it."""
    @property
    def written_by(self) -> str:
        """Filled by the reader: which program and version wrote the file."""
    @property
    def authored_arrays(self) -> dict[str, NDArray[Any]]:
        """What belongs to the document, of the shapes and units it says, in a new dict; views,
        read-only.
        """
    @property
    def assessment_arrays(self) -> dict[str, NDArray[Any]]:
        """Of the assessment: places/ID, the vertices of a region, of shape (n,), in a new dict;
        views, read-only.
        """
    @property
    def languages(self) -> dict[str, Words]:
        """Title and task in further languages, by code such as "tr" or "pt-BR", in a new dict."""
    def __copy__(self) -> Scenario:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> Scenario:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        str, str, Scene, str, dict[int, object], int, str, dict[str, Words], str, dict[int, object]
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def find_words(scenario: Scenario, language: str) -> Words:
    """Title and task in a language: those of its code, else of the same language elsewhere
    ("tr" for "tr-TR"), else those of the scenario itself, each by itself.
    """

def read(path: os.PathLike[str] | str | bytes) -> Scenario:
    """Reads a .palpate file of this or an older version: a scene that ticks with the very
    forces of the one that was written. Raises FileError for whatever is wrong, in a
    sentence.
    """

def write(path: os.PathLike[str] | str | bytes, scenario: Scenario) -> None:
    """Writes a .palpate file, whole or not at all. Raises ValueError for what read() would
    refuse, FileError where the disk refuses.
    """

def check_ranges(scene: Scene) -> None:
    """Raises ValueError where a number of a scene is smaller or larger than one of a file may
    be.
    """

def list_ranges() -> list[tuple[str, str, float, float]]:
    """Of every number of a file: its name, i for the number of a body or an instrument, its
    unit, least and most.
    """

def unpack(container: Container, file: str) -> Scenario:
    """The scenario in a container; file is what refusals call it."""

def pack(scenario: Scenario) -> Container:
    """What the file holds."""

MOST_PARAMETERS: int
MOST_LEVELS: int
MOST_TEXTS: int

class DrawnValue:
    """A parameter of an attempt."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def name(self) -> str:
        """As the assessment calls it."""
    @property
    def unit(self) -> str:
        """N, m, s, rad, m3, place, or 1 for none."""
    @property
    def value(self) -> float:
        """[N], [m] ... in that unit; 0 of a place."""
    @property
    def place(self) -> str:
        """Its id; else empty."""
    def __copy__(self) -> DrawnValue:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> DrawnValue:
        """A copy of its own."""
    def __getstate__(self, /) -> tuple[object, object, object, object]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

class DrawnTask:
    """What is judged in one attempt, and the names of its rows."""
    def __init__(self) -> None:
        """Every field at its first value."""
    @property
    def task(self) -> object:
        """The Task, of build_task."""
    @property
    def id(self) -> str:
        """Of the assessment."""
    @property
    def version(self) -> str:
        """Of the assessment."""
    @property
    def level(self) -> str:
        """Empty where there are none."""
    @property
    def seed(self) -> int:
        """Of the parameters that are drawn."""
    @property
    def sha256(self) -> str:
        """Of the assessment, whatever level and seed."""
    @property
    def steps(self) -> list[str]:
        """Their ids, in order of the task's."""
    @property
    def limits(self) -> list[str]:
        """Likewise."""
    @property
    def places(self) -> list[str]:
        """Likewise; of a path with another width, once more."""
    @property
    def values(self) -> list[DrawnValue]:
        """A DrawnValue each, by name."""
    @property
    def inclusion(self) -> str:
        """Id of the place whose inclusion, a stiff spot, this attempt has; else empty."""
    def __copy__(self) -> DrawnTask:
        """A copy of its own."""
    def __deepcopy__(self, memo: dict[int, object]) -> DrawnTask:
        """A copy of its own."""
    def __getstate__(
        self, /
    ) -> tuple[
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
        object,
    ]: ...
    def __setstate__(self, arg0: tuple) -> None: ...
    def __repr__(self) -> str:
        """The value on one line."""

def draw(seed: int, id: str, name: str) -> float:
    """[-] A number from 0 to below 1 for a parameter of a scenario, the same wherever it is
    drawn: of the first 53 bits of the SHA-256 of seed, id and name, in text with a line feed
    between them.
    """

def list_levels(scenario: Scenario) -> list[str]:
    """The levels of a scenario's assessment; empty where there are none."""

def draw_task(scenario: Scenario, level: str = ..., seed: int = ...) -> DrawnTask:
    """The task of an attempt. An empty level is normal, or the first where there is no such.
    Raises ValueError for a level that is not there, a scenario without an assessment, and
    one that cannot be judged, naming the place in it, what it got and what was expected.
    """

def draw_scene(scenario: Scenario, drawn: DrawnTask) -> Scene:
    """The scene of an attempt: the scenario's, with the constants of the inclusion that was
    drawn, and as many substeps as those need. Raises ValueError for constants that cannot be
    built.
    """

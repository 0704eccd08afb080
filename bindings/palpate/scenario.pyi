# SPDX-License-Identifier: BSD-3-Clause
"""Written by bindings/write_stub.py; the words are in the module: help(palpate.scenario)."""

import os
from typing import Any

from numpy.typing import NDArray

from palpate._sim import Scene

kMostFileBytes: int
kMostArrayBytes: int
kMostManifestBytes: int
kMostArrays: int
kMostDimensions: int
kMostNameBytes: int
kMostDepth: int
kMostTitleBytes: int
kMostTaskBytes: int
kMostParticles: int
kMostTriangles: int
kMostLinks: int
kMostTetrahedra: int
kMostElastic: int

class Container:
    def __init__(
        self, *, format: str, version: int, content: str = ..., arrays: dict[str, Any] = ...
    ) -> None: ...
    format: str
    version: int
    content: str
    @property
    def written_by(self) -> str: ...
    @property
    def arrays(self) -> dict[str, NDArray[Any]]: ...
    def __copy__(self) -> Container: ...
    def __deepcopy__(self, memo: dict[int, object]) -> Container: ...

def read_container(
    path: os.PathLike[str] | str | bytes, format: str, newest_version: int
) -> Container: ...
def write_container(path: os.PathLike[str] | str | bytes, container: Container) -> None: ...
def unpack_container(bytes: bytes, file: str, format: str, newest_version: int) -> Container: ...
def pack_container(container: Container) -> bytes: ...

class Scenario:
    def __init__(
        self,
        *,
        scene: Scene,
        title: str = ...,
        task: str = ...,
        authored: str = ...,
        authored_arrays: dict[str, Any] = ...,
    ) -> None: ...
    title: str
    task: str
    @property
    def scene(self) -> Scene: ...
    authored: str
    @property
    def version(self) -> int: ...
    @property
    def written_by(self) -> str: ...
    @property
    def authored_arrays(self) -> dict[str, NDArray[Any]]: ...
    def __copy__(self) -> Scenario: ...
    def __deepcopy__(self, memo: dict[int, object]) -> Scenario: ...

def read(path: os.PathLike[str] | str | bytes) -> Scenario: ...
def write(path: os.PathLike[str] | str | bytes, scenario: Scenario) -> None: ...
def unpack(container: Container, file: str) -> Scenario: ...
def pack(scenario: Scenario) -> Container: ...

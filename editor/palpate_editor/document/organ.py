# SPDX-License-Identifier: GPL-3.0-or-later
"""An organ as its designer sees it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

import numpy as np
from palpate.scene.scene_parts import (
    AppearancePart,
    FillPart,
    HandPart,
    MaterialPart,
    ModelPart,
    ToolPart,
)

from palpate_editor.document.defaults import FILL, HAND, MATERIAL, MODEL, TOOL
from palpate_editor.document.far_field import FarField
from palpate_editor.document.history import Line
from palpate_editor.document.surface import Filling, Surface, freeze
from palpate_editor.document.tissue import AppliedTissue

LANGUAGE = re.compile(r"(?=.{2,35}$)[a-z]{2,3}(-[A-Za-z0-9]{1,8})*")


def is_language(code: str) -> bool:
    """Whether a text is the code of a language [BCP 47]: two or three small letters, then parts of
    1 to 8 letters or digits behind hyphens."""
    return LANGUAGE.fullmatch(code) is not None


@dataclass(frozen=True)
class Translation:
    """Title and task of the scenario in one more language; an empty one is not translated."""

    title: str = ""
    task: str = ""


NO_LANGUAGES: Mapping[str, Translation] = MappingProxyType({})
NO_REGIONS: Mapping[str, np.ndarray] = MappingProxyType({})


@dataclass(frozen=True)
class Repairs:
    """What was done to a foreign surface so that a tissue can be built on it."""

    welded_vertices: int = 0
    duplicate_triangles: int = 0
    degenerate_triangles: int = 0
    unused_vertices: int = 0
    split_vertices: int = 0
    turned_triangles: int = 0

    @property
    def total(self) -> int:
        return sum(getattr(self, name) for name in self.__dataclass_fields__)


@dataclass(frozen=True)
class Source:
    """Where a surface came from and how its file was understood."""

    file: str
    """The file's name."""
    folder: str
    """Where it lay, for reading it again; empty where that is nobody's business."""
    sha256: str
    """Of the file's bytes."""
    format: str
    parts_available: tuple[str, ...]
    parts: tuple[str, ...]
    """Those that were used, welded into one surface."""
    unit: str
    """m, cm, mm or in: what 1 in the file was taken to be."""
    unit_guessed: bool
    unit_reason: str
    up: str
    """x, y, z, -x, -y or -z: the file's axis that points up."""
    up_guessed: bool
    up_reason: str
    repairs: Repairs = field(default_factory=Repairs)
    notes: tuple[str, ...] = ()
    """What was odd about the file but could be read all the same."""


@dataclass(frozen=True)
class Assembly:
    """How the parts of a file were put together, where they were not only taken side by side."""

    weld: float | None
    """[m] Vertices of different parts that were closer became one; None for the same points."""
    unite: bool
    """As solids, one out of all."""
    subtracted: tuple[str, ...]
    """Parts whose inside was taken away from the others."""
    regions: bool
    """Each part is a region of its name."""


@dataclass(frozen=True)
class Segmentation:
    """How a surface was cut out of the scan that `Source` names, so that it can be done again."""

    series: str
    """UID of the one series of a DICOM folder that was asked for; empty where there was one."""
    labels: tuple[int, ...]
    """Empty where it was cut by a range."""
    low: float | None
    """Least grey level, itself included."""
    high: float | None
    smooth: float
    """[voxel]"""
    largest: bool
    """Its largest piece alone, without cavities."""
    least_volume: float
    """[m³] Of a piece that is kept."""
    size: tuple[int, ...]
    """Columns, rows and slices of the volume."""
    spacing: tuple[float, ...]
    """[m]"""
    tilt: float
    """[degree] Of the gantry."""
    voxel_volume: float
    """[m³] Of the chosen voxels."""
    volume: float
    """[m³] Inside the surface that was cut."""
    volume_change: float
    """[-] By smoothing."""
    pieces_dropped: int
    shells_dropped: int


@dataclass(frozen=True)
class Decimation:
    """How a surface was made coarser, and how far it is from the one it was made of."""

    vertices_before: int
    triangles_before: int
    vertices: int
    triangles: int
    smallest_angle_deg: float
    mean_distance: float
    """[m]"""
    max_distance: float
    """[m]"""


@dataclass(frozen=True, eq=False)
class History:
    """What was done to an organ since it began, so that it can be done again."""

    begin: Organ
    """Without a history of its own. Nothing, before a file was imported; else the organ as it came
    from where no history is kept."""
    lines: tuple[Line, ...] = ()
    """The first first."""
    folded: int = 0
    """Lines before these that there was no room for: `begin` is what they had led to."""


@dataclass(frozen=True, eq=False)
class Organ:
    """All that a designer has decided. Half done is allowed; `check` says what is missing."""

    name: str = ""
    source: Source | None = None
    segmentation: Segmentation | None = None
    """None where the source is no scan."""
    assembly: Assembly | None = None
    """None where the parts of the file lie side by side, or there is one."""
    imported: Surface | None = None
    """As the file gave it, repaired; what is decimated."""
    filling: Filling | None = None
    """The file's own tetrahedra; they fill the organ as long as its surface is their outside."""
    surface: Surface | None = None
    """What a tissue is built on."""
    decimation: Decimation | None = None
    """None where the imported surface is used as it is."""
    material: MaterialPart = MATERIAL
    model: ModelPart = MODEL
    """Its `fixed` and `stiffness_scale` are not used: the arrays below stand for them."""
    tissues: tuple[AppliedTissue, ...] = ()
    """Of the library, at most one for all of it and one for each region."""
    fill: FillPart = FILL
    """Of a solid; a surface has no use for it."""
    far_field: FarField | None = None
    """None where that of the mesh is felt."""
    fixed: np.ndarray = field(default_factory=lambda: np.empty(0, bool))
    """(n,) bool per vertex of the surface, held at rest; read-only"""
    stiffness_scale: np.ndarray = field(default_factory=lambda: np.empty(0))
    """[-] (n,) factor of the stiffness at each vertex; read-only"""
    regions: Mapping[str, np.ndarray] = field(default_factory=lambda: NO_REGIONS)
    """Named sets of vertices: (k,) int32 each, ascending, read-only."""
    tool: ToolPart = TOOL
    hand: HandPart = HAND
    appearance: AppearancePart | None = None
    """None for plain tissue."""
    title: str = ""
    """Of the published scenario."""
    task: str = ""
    """What the trainee is asked to do, in words."""
    languages: Mapping[str, Translation] = field(default_factory=lambda: NO_LANGUAGES)
    """Title and task in further languages, by code such as "tr"; read-only."""
    assessment: str = ""
    """JSON: what is asked of a trainee and judged (palpate.assessment); empty where nothing is."""
    history: History | None = None
    """None where nothing has been done yet: the first edit begins it."""

    def __post_init__(self) -> None:
        count = 0 if self.surface is None else len(self.surface.vertices)
        object.__setattr__(self, "fixed", freeze(self.fixed, np.bool_, (count,)))
        scale = freeze(self.stiffness_scale, np.float64, (count,))
        object.__setattr__(self, "stiffness_scale", scale)
        regions = {name: freeze_region(ids, count) for name, ids in self.regions.items()}
        if any(regions[name] is not ids for name, ids in self.regions.items()) or not isinstance(
            self.regions, MappingProxyType
        ):
            object.__setattr__(self, "regions", MappingProxyType(regions))
        if not isinstance(self.languages, MappingProxyType):
            object.__setattr__(self, "languages", MappingProxyType(dict(self.languages)))

    @property
    def vertex_count(self) -> int:
        return len(self.fixed)

    def with_surface(self, surface: Surface) -> Organ:
        """This organ on another surface, on which nothing is fixed, stiffened, named or
        solved yet."""
        count = len(surface.vertices)
        return replace(
            self,
            surface=surface,
            fixed=np.zeros(count, bool),
            stiffness_scale=np.ones(count),
            regions=NO_REGIONS,
            far_field=None,
        )


def freeze_region(ids: np.ndarray, count: int) -> np.ndarray:
    """Vertex numbers that cannot be written. Raises ValueError unless they ascend below `count`."""
    frozen = freeze(ids, np.int32, (None,))
    if frozen.size and (frozen[0] < 0 or frozen[-1] >= count or (np.diff(frozen) <= 0).any()):
        raise ValueError(
            f"region: got vertices {frozen.min()} to {frozen.max()}, expected ascending ones "
            f"from 0 to {count - 1}"
        )
    return frozen


EMPTY = Organ()
"""Nothing imported yet."""

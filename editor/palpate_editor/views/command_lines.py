# SPDX-License-Identifier: GPL-3.0-or-later
"""The command lines that do what was done with the mouse, with its real numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from palpate.viewport import View

from palpate_editor.document import Organ
from palpate_editor.document.constants import CONSTANTS

KINDS = {"mass_spring": "mss", "molecular": "mms"}
OPTIONS = {
    "model.stiffness": ("--stiffness", "N/m"),
    "model.bend_stiffness": ("--bend", "J"),
    "model.stretch_coupling": ("--stretch-bend", "N"),
    "model.home_stiffness": ("--home", "N/m3"),
    "model.drag": ("--drag", "/s"),
    "model.pressure": ("--pressure", "Pa"),
    "material.wall_thickness": ("--wall", "m"),
    "material.density": ("--density", "kg/m3"),
    "material.damping_ratio": ("--damping", ""),
    "tool.radius": ("--tool-radius", "m"),
    "hand.coupling": ("--coupling", "N/m"),
}
"""Those constants that `palpate material` takes, and the unit it wants with them."""


def import_words(
    path: Path, parts: Sequence[str], unit: str | None, up: str | None, stem: str
) -> list[object]:
    words: list[object] = ["palpate", "import", path]
    for part in parts:
        words += ["--part", part]
    if unit:
        words += ["--unit", unit]
    if up:
        words += [f"--up={up}"]
    return [*words, "-o", f"{stem}.obj"]


def decimate_words(stem: str, vertices: int) -> list[object]:
    return ["palpate", "decimate", f"{stem}.obj", "--vertices", vertices] + [
        "-o",
        f"{stem}{vertices}.obj",
    ]


def material_words(organ: Organ, stem: str) -> list[object]:
    """All constants that are not what `palpate material` takes by itself."""
    mesh = f"{stem}{organ.vertex_count}.obj" if organ.decimation else f"{stem}.obj"
    words: list[object] = ["palpate", "material", mesh]
    words += ["--kind", KINDS.get(organ.model.kind, organ.model.kind)]
    plain = Organ()
    for constant in CONSTANTS:
        option = OPTIONS.get(constant.key)
        value = getattr(getattr(organ, constant.part), constant.field)
        default = getattr(getattr(plain, constant.part), constant.field)
        if option is None or value is None or value == default:
            continue
        # a negative number must not be taken for an option
        words.append(f"{option[0]}={value:.9g}{option[1]}")
    return [*words, "-o", f"{stem}.scene.json"]


def render_words(file: Path | str, out: Path, view: View, theme: str) -> list[object]:
    camera = view.camera
    words: list[object] = ["palpate", "render", file, "-o", out, "--theme", theme]
    azimuth, elevation = math.degrees(camera.azimuth), math.degrees(camera.elevation)
    words += [f"--azimuth={azimuth:.1f}", f"--elevation={elevation:.1f}"]
    if not view.wireframe:
        words.append("--no-wireframe")
    return words

# SPDX-License-Identifier: BSD-3-Clause
"""Which constant asks for more substeps than a tick has time for, and the nearest value that fits.

A constant is suspected first that is farther from what is usual than tissues differ; of it that
value is found, between what it is and what is usual, with which the tissue needs no more substeps
than there are.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import palpate
from palpate.scene.scene_parts import FILLED, ModelPart, SceneFile


@dataclass(frozen=True)
class Usual:
    """What a constant is in tissues."""

    value: float
    """[SI]"""
    decades: float
    """[-] by which tissues, and models of them, differ from it either way."""
    low_is_hard: bool = False
    """Whether it is too little of it that needs substeps."""
    beyond: float = 100.0
    """[-] Times easier than usual that it is tried at: a fine mesh may need that."""


USUAL = {
    "material.density": Usual(1060.0, 0.3, low_is_hard=True, beyond=3.0),
    "material.young_modulus": Usual(1e4, 2.0),
    "material.damping_ratio": Usual(0.2, 1.0),
    "material.wall_thickness": Usual(2e-3, 1.0, low_is_hard=True, beyond=1.25),
    "model.stiffness": Usual(50.0, 1.5),
    "model.bend_stiffness": Usual(1e-4, 2.0),
    "model.stretch_coupling": Usual(1e-2, 2.0),
    "model.home_stiffness": Usual(3e5, 2.0),
    "model.drag": Usual(8.0, 1.5),
}
"""By its key: Young's modulus from that of a stomach's wall to that of a gallbladder's, springs and
home springs of the organs that ever shipped."""
SHARPNESS = 0.02
"""[-] by which the value that is found may miss the farthest that fits."""
TURNS = 16
"""Builds of a tissue at most for one constant."""

Build = Callable[[SceneFile], palpate.TissueModel]


@dataclass(frozen=True)
class Nearest:
    """A constant that asks for too much, and a value that does not."""

    key: str
    """As in palpate.scene.scene_parts: "model.stiffness"."""
    value: float
    """[SI] as it is."""
    limit: float
    """[SI] the nearest that fits, in two digits."""
    needed: int
    """Substeps a tick at rest, as it is."""
    most: int
    """That there are."""
    excess: float
    """[-] decades by which it is farther from what is usual than tissues differ."""


def find_nearest(scene: SceneFile, build: Build, most: int) -> Nearest | None:
    """The one constant that, nearer to what is usual, lets the tissue do with `most` substeps at
    rest; None where there is none, or nothing is wrong. Builds the tissue some ten times.

    Args:
        scene: What was chosen.
        build: Makes the tissue of it. Where it raises ValueError a value is taken not to fit.
        most: Substeps a tick.
    """
    rate, integrator = scene.hand.rate, scene.model.integrator

    def count(value: float | None, key: str) -> float:
        """Substeps, as a number that need not be whole."""
        parts = scene if value is None else put(scene, key, value)
        try:
            step = find_step(build(parts), integrator)
        except ValueError:
            return math.inf
        return math.inf if step <= 0.0 else 1.0 / (rate * step)

    needed = count(None, "")
    if scene.model.kind == "linear_solid" or most < 1 or not most < needed < math.inf:
        return None
    for key in rank_constants(scene):
        usual, value = USUAL[key], read(scene, key)
        sign = math.copysign(1.0, value)

        def count_at(size: float, key: str = key, sign: float = sign) -> float:
            return count(sign * size, key)

        nearest = find_fitting(count_at, abs(value), usual, needed, most)
        if nearest is not None:
            excess = find_excess(abs(value), usual)
            return Nearest(key, value, sign * nearest, math.ceil(needed), most, excess)
    return None


def find_step(tissue: palpate.TissueModel, integrator: str) -> float:
    """[s] as build_scene asks for it: of XPBD, which is too soft in longer ones, that of the usual
    integrator."""
    kind = palpate.Integrator.__members__[integrator]
    if kind in (palpate.Integrator.symplectic_euler, palpate.Integrator.xpbd):
        return float(palpate.stable_step(tissue))
    return float(palpate.stable_step(tissue, kind))


def read(scene: SceneFile, key: str) -> float:
    part, field = key.split(".")
    return float(getattr(getattr(scene, part), field) or 0.0)


def put(scene: SceneFile, key: str, value: float) -> SceneFile:
    part, field = key.split(".")
    return replace(scene, **{part: replace(getattr(scene, part), **{field: value})})


def rank_constants(scene: SceneFile) -> list[str]:
    """Constants that count for this model and are not 0, the least usual first."""
    keys = [key for key in list_stiffening(scene.model) if read(scene, key) != 0.0]
    return sorted(keys, key=lambda key: -find_excess(abs(read(scene, key)), USUAL[key]))


def list_stiffening(model: ModelPart) -> list[str]:
    """What substeps may be needed for, what is most often wrong first."""
    surface = model.kind in ("mass_spring", "molecular")
    chosen = surface and model.constants == "chosen"
    keys = ["model.stiffness"] if chosen else ["material.young_modulus"]
    if chosen and model.kind == "molecular":
        keys += ["model.bend_stiffness", "model.stretch_coupling"]
    if model.kind not in FILLED:
        keys.append("model.home_stiffness")
    if model.kind == "shell":
        keys.append("material.wall_thickness")
    return [*keys, "material.damping_ratio", "model.drag", "material.density"]


def find_excess(value: float, usual: Usual) -> float:
    """[-] decades beyond what tissues have, on the side that needs substeps; 0 within."""
    beyond = math.log10(value / usual.value) * (-1.0 if usual.low_is_hard else 1.0)
    return max(0.0, beyond - usual.decades)


def find_fitting(
    count: Callable[[float], float], value: float, usual: Usual, needed: float, most: int
) -> float | None:
    """The value nearest to `value` with which `count` gives at most `most`; None where none does
    that is not far easier than usual.

    Substeps go with a power of a constant, which follows from two of its values; so a few builds
    find it.
    """
    sense = 1.0 if usual.low_is_hard else -1.0
    hardest = max(value, usual.value) if usual.low_is_hard else min(value, usual.value)
    easy = hardest * usual.beyond**sense
    # in e-folds by which the value is eased
    bad, bad_count = 0.0, needed
    good, good_count = abs(math.log(easy / value)), count(easy)
    if good_count > most or good == 0.0:
        return None
    for _ in range(TURNS):
        if good - bad < SHARPNESS or good_count > (1.0 - 0.5 * SHARPNESS) * most:
            break
        slope = math.log(bad_count / good_count) / (good - bad)
        guess = bad + math.log(bad_count / ((1.0 - 0.25 * SHARPNESS) * most)) / max(slope, 1e-9)
        width = good - bad
        guess = min(max(guess, bad + 0.02 * width), good - 0.02 * width)
        found = count(value * math.exp(sense * guess))
        if found <= most:
            good, good_count = guess, found
        else:
            bad, bad_count = guess, found
    return round_away(value * math.exp(sense * good), up=usual.low_is_hard)


def round_away(value: float, up: bool) -> float:
    """In two digits, on the side that needs less."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    digits = math.ceil(value / unit - 1e-9) if up else math.floor(value / unit + 1e-9)
    return float(f"{digits * unit:.2g}")

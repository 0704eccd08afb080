# SPDX-License-Identifier: BSD-3-Clause
"""What a hand feels of a published scene, beside a ball in the same body solved offline.

The scene's own tick is pressed at the places of a contact reference, with its own ball and with the
others, to the same depths; at rest there, the force on the hand is held against the reference's
[accuracy: tool].
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import palpate
from palpate.files.refusal import Refusal
from palpate.runs.press import Place, take_surface
from palpate.scene.authored import read_constants
from palpate.scene.scene_parts import ModelPart
from palpate.study.contact_reference import (
    Case,
    ContactReference,
    Spot,
    list_contact_references,
    read_contact_reference,
)
from palpate.study.indent import OutOfReach, measure_indentation
from palpate.study.tables import write_table

KINDS = {"solid": "springs + volumes", "shell": "shell of prisms"}
"""Where what a kind is called says less than what it is."""
SURFACES = ("mass_spring", "molecular")
"""Kinds whose constants may be chosen."""
MOST_STEPS, TOUCHING = 1000, 1e-9
"""Of a ball on its way down to a surface, and how near [m] it touches."""


@dataclass(frozen=True)
class ToolRow:
    """A ball at one depth of one place."""

    body: str
    place: str
    law: str
    """Of the truth: linear or neo_hookean."""
    radius: float
    """[m] of the ball."""
    own: bool
    """Whether it is the scene's own."""
    thickness: float
    """[m]"""
    depth: float
    """[m] of the ball beyond its first touch."""
    contact_radius: float
    """[m] of the truth's contact."""
    truth: float
    """[N] at the Young's modulus that the scene states."""
    truth_error: float
    felt: float | None
    """[N]; None where the tool does not get there."""
    ratio: float | None
    """[-] felt over truth."""
    note: str = ""
    """Why nothing is felt."""


@dataclass(frozen=True)
class PressedScene:
    """A scene with the reference of its body."""

    name: str
    file: str
    """"" for a scene that is built here."""
    kind: str
    """Of its model, in words."""
    derived: bool
    """Whether the model's constants come from the Young's modulus."""
    young_modulus: float
    """[Pa] that the scene states."""
    radius: float
    """[m] of its own ball."""
    reference: ContactReference
    load: Callable[[], palpate.Scene]
    """A scene that may be changed."""


def open_pressed(path: Path) -> PressedScene:
    """A published scene of a surface that has a contact reference, held where that is held.

    Raises Refusal or OSError.
    """
    scenario = palpate.scenario.read(path)
    constants = read_constants(path, scenario)
    try:
        made_of = json.loads(scenario.authored)["content"]["source"]["sha256"]
    except (ValueError, LookupError, TypeError):
        raise Refusal(path, "authored.source", "no hash", "what `palpate publish` writes") from None
    reference = find_reference(path, made_of)
    require_same(path, scenario, constants.material.poisson_ratio, reference)
    return PressedScene(
        name=reference.name,
        file=str(path),
        kind=describe_kind(constants.model.kind, scenario.scene.bodies[0]),
        derived=derives_constants(constants.model),
        young_modulus=constants.material.young_modulus,
        radius=constants.tool.radius,
        reference=reference,
        load=lambda: palpate.scenario.read(path).scene,
    )


def describe_kind(kind: str, body: palpate.SoftBody) -> str:
    """Its words, with the law that a tool touches it by."""
    words = KINDS.get(kind, kind.replace("_", " "))
    if body.near_field is None:
        return f"{words} under the hard law"
    far = ", its far field of a finer mesh" if len(body.far_compliance) else ""
    return f"{words} under the near field{far}"


def find_reference(path: Path, made_of: str) -> ContactReference:
    """Of the surface with this hash. Raises Refusal."""
    known = [read_contact_reference(name) for name in list_contact_references()]
    shaped = [reference for reference in known if reference.shape is not None]
    for reference in shaped:
        if reference.shape.sha256 == made_of:
            return reference
    expected = "the surface of one of " + ", ".join(reference.name for reference in shaped)
    raise Refusal(path, "source.sha256", f"{str(made_of)[:12]}...", expected)


def derives_constants(model: ModelPart) -> bool:
    """Whether they follow from Young's modulus and Poisson's ratio."""
    return model.kind not in SURFACES or model.constants == "tissue"


def require_same(
    path: Path, scenario: palpate.scenario.Scenario, poisson_ratio: float, ref: ContactReference
) -> None:
    """The reference is of the same Poisson's ratio, held at the same vertices. Raises Refusal."""
    bodies = scenario.scene.bodies
    if len(bodies) != 1:
        raise Refusal(path, "scene.bodies", str(len(bodies)), "one body")
    # of the surface, as the document has them: a solid's own particles have other numbers
    fixed = sorted(np.asarray(scenario.authored_arrays.get("fixed", ())).tolist())
    held = find_held(scenario.authored_arrays, ref)
    if fixed != held:
        expected = f"the {len(held)} that {ref.name} is held at"
        raise Refusal(path, "fixed", f"{len(fixed)} vertices", expected)
    if poisson_ratio != ref.poisson_ratio:
        raise Refusal(
            path, "material.poisson_ratio", f"{poisson_ratio:g}", f"{ref.poisson_ratio:g}"
        )


def find_held(arrays: Mapping[str, np.ndarray], reference: ContactReference) -> list[int]:
    """What of a document's surface the reference is held at: of a decimated one, the vertices whose
    place on the imported surface is mostly held there."""
    if "surface/vertices" not in arrays:
        return list(reference.fixed or ())
    x, triangles = arrays["imported/vertices"], arrays["imported/triangles"]
    tree, is_held = palpate.AabbTree(x, triangles), np.zeros(len(x))
    is_held[list(reference.fixed or ())] = 1.0
    found = [palpate.find_closest_point(tree, x, point) for point in arrays["surface/vertices"]]
    shares = [is_held[triangles[near.triangle]] @ np.asarray(near.weights) for near in found]
    return np.flatnonzero(np.array(shares) >= 0.5).tolist()


def tell_apart(scenes: Sequence[PressedScene]) -> list[PressedScene]:
    """The same, those of one body by the names of their files."""
    names = [scene.name for scene in scenes]
    return [
        replace(scene, name=f"{scene.name}, {scene.file}")
        if scene.file and names.count(scene.name) > 1
        else scene
        for scene in scenes
    ]


def compare_tool(
    pressed: PressedScene, law: str, radii: Iterable[float] | None = None
) -> list[ToolRow]:
    """Every case of a law, or of some balls [m]; rows in the order of the reference."""
    cases = pressed.reference.list_cases(law)
    if radii is not None:
        cases = [case for case in cases if case.radius in set(radii)]
    return [row for case in cases for row in compare_case(pressed, case)]


def compare_case(pressed: PressedScene, case: Case) -> list[ToolRow]:
    reference = pressed.reference
    spot = reference.find_place(case.place)
    scale = pressed.young_modulus / reference.young_modulus
    felt, note = press_case(pressed, spot, case)
    own = abs(case.radius - pressed.radius) < 1e-9
    rows = []
    for result, force in zip(case.results, felt, strict=True):
        truth = scale * result.force
        rows.append(
            ToolRow(
                pressed.name, case.place, case.law, case.radius, own, spot.thickness,
                result.depth, result.contact_radius, truth, result.force_error,
                force, None if force is None else force / truth, note if force is None else "",
            )
        )  # fmt: skip
    return rows


def press_case(pressed: PressedScene, spot: Spot, case: Case) -> tuple[list[float | None], str]:
    """Forces [N] at the depths of a case as far as the tool gets, and why not farther."""
    scene = load_with_ball(pressed, case.radius)
    outward = np.array(spot.direction)
    # the tip is at the place of this when the ball first touches
    start = np.array(spot.point) + (find_touch(scene, spot, case.radius) - case.radius) * outward
    depths = np.array([result.depth for result in case.results])
    note = ""
    for count in range(len(depths), 0, -1):
        try:
            found = measure_indentation(scene, Place(start, outward), depths[:count])
        except (OutOfReach, RuntimeError) as problem:
            note = note or str(problem)
            continue
        return [*found.tolist(), *[None] * (len(depths) - count)], note
    return [None] * len(depths), note


def find_touch(scene: palpate.Scene, spot: Spot, radius: float) -> float:
    """[m] of the ball's centre over the place when it first touches the scene's surface, which may
    be coarser than the reference's: down by what is free all around it, until nothing is."""
    x, triangles = take_surface(scene, 0)
    tree, outward = palpate.AabbTree(x, triangles), np.array(spot.direction)
    height = float(np.ptp(x, axis=0).max())
    for _ in range(MOST_STEPS):
        centre = np.array(spot.point) + height * outward
        free = palpate.find_closest_point(tree, x, centre).distance - radius
        if free <= TOUCHING:
            break
        height -= free
    return height


def load_with_ball(pressed: PressedScene, radius: float) -> palpate.Scene:
    scene = pressed.load()
    if radius != scene.instruments[0].tool.radius:
        scene.instruments[0].tool.radius = radius
        # the near field reaches as far as the ball does
        scene = palpate.build_scene(scene)
    return scene


def write_tool_tables(scenes: Sequence[dict], rows: Sequence[ToolRow]) -> str:
    """A table of balls for every scene, and what each scene's constants are."""
    parts = [
        "Force on the hand over that of a rigid, frictionless ball in the same body, by finite "
        "elements: mean of the places and depths (least to most). Depths from the first touch."
    ]
    for scene in scenes:
        mine = [row for row in rows if row.body == scene["body"]]
        parts += [describe_scene(scene), write_table(HEAD, list_balls(mine))]
    return "\n\n".join(parts)


HEAD = ("ball", "truth", "depth", "contact radius", "truth's force", "felt over truth", "deepest")


def describe_scene(scene: dict) -> str:
    modulus = f"E {1e-3 * scene['young_modulus_Pa']:g} kPa"
    how = (
        f"constants derived from its {modulus}"
        if scene["constants_derived"]
        else f"constants chosen, and not derived from the {modulus} that it states"
    )
    places = ", ".join(
        f"{place['name']} {1e3 * place['thickness_m']:.0f} mm" for place in scene["places"]
    )
    return f"**{scene['title']}**: {scene['kind']}, {how}; places (thickness): {places}"


def list_balls(rows: Sequence[ToolRow]) -> list[list[str]]:
    keys = dict.fromkeys((row.radius, row.law, row.own) for row in rows)
    return [
        describe_ball([row for row in rows if (row.radius, row.law, row.own) == key])
        for key in sorted(keys)
    ]


def describe_ball(rows: Sequence[ToolRow]) -> list[str]:
    first = rows[0]
    deepest = [max((r for r in rows if r.place == p), key=lambda r: r.depth)
               for p in dict.fromkeys(row.place for row in rows)]  # fmt: skip
    lost = sum(row.felt is None for row in rows)
    return [
        f"{1e3 * first.radius:g} mm" + (", the scene's own" if first.own else ""),
        first.law.replace("_", "-"),
        write_range([1e3 * row.depth for row in rows], "mm"),
        write_range([1e3 * row.contact_radius for row in rows], "mm"),
        write_range([1e3 * row.truth for row in rows], "mN"),
        write_ratios(rows) + (f"; {lost} of {len(rows)} not reached" if lost else ""),
        write_ratios(deepest),
    ]


def write_range(values: Sequence[float], unit: str) -> str:
    return f"{min(values):.3g} to {max(values):.3g} {unit}"


def write_ratios(rows: Sequence[ToolRow]) -> str:
    ratios = [row.ratio for row in rows if row.ratio is not None]
    if not ratios:
        return "-"
    mean = sum(ratios) / len(ratios)
    return f"{mean:.2f} ({min(ratios):.2f} to {max(ratios):.2f})"

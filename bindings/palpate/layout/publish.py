# SPDX-License-Identifier: BSD-3-Clause
"""What a trainee opens: the scene of a layout with what it was made from."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate import scenario
from palpate.assessment.author import make_ids
from palpate.assessment.publish import find_regions, with_assessment
from palpate.files.refusal import Refusal
from palpate.layout.assemble import Assembly
from palpate.layout.document import FORMAT, VERSION, Layout
from palpate.layout.placed import Organ
from palpate.layout.task import find_task, has_steps
from palpate.render.authored_appearance import find_appearance, find_colours
from palpate.render.theme import TISSUE


def make_scenario(layout: Layout, assembly: Assembly, scene: palpate.Scene) -> scenario.Scenario:
    """The scene, its words, its task, and in the designer's document the layout and how its organs
    look. Raises Refusal for a task that cannot be judged."""
    content: dict[str, Any] = {"layout": asdict(layout)}
    appearance = read_appearance(assembly.organs[0])
    if appearance is not None:
        content["appearance"] = appearance
    regions = join_regions(layout, assembly.organs)
    content["regions"] = list(regions)
    words = {"tr": scenario.Words(layout.title_tr, layout.task_tr)}
    made = scenario.Scenario(
        scene=scene,
        title=name_scene(layout),
        task=layout.task,
        authored=json.dumps({"format": FORMAT, "version": VERSION, "content": content}),
        authored_arrays={
            "colours": join_colours(assembly.organs),
            **{f"regions/{number}": rows for number, rows in enumerate(regions.values())},
        },
        languages=words if layout.title_tr or layout.task_tr else {},
    )
    task = find_task(layout)
    return with_assessment("task", task, made) if task is not None and has_steps(task) else made


def name_scene(layout: Layout) -> str:
    """What a trainee reads."""
    return layout.title or " + ".join(body.name for body in layout.bodies)


def join_regions(layout: Layout, organs: list[Organ]) -> dict[str, NDArray[np.int32]]:
    """By `organ/region`, as a task names them, the organ by the id of its name in the layout:
    the vertices of its body's surface."""
    joined: dict[str, NDArray[np.int32]] = {}
    names = make_ids(body.name for body in layout.bodies)
    for name, organ in zip(names, organs, strict=True):
        try:
            regions = find_regions(organ.path, organ.published)
        except Refusal:
            continue  # an organ from code has none
        joined |= {f"{name}/{region}": rows for region, rows in regions.items()}
    return joined


def read_appearance(organ: Organ) -> object:
    """As the organ's own document has it."""
    try:
        return json.loads(organ.published.authored)["content"]["appearance"]
    except (ValueError, LookupError, TypeError):
        return None


def join_colours(organs: list[Organ]) -> NDArray[np.uint8]:
    """(n, 3) sRGB of the surfaces' vertices, body after body: those of its designer, else the one
    colour of its appearance."""
    return np.vstack([find_organ_colours(organ) for organ in organs])


def find_organ_colours(organ: Organ) -> NDArray[np.uint8]:
    tissue = organ.body.tissue
    count = len(palpate.compute_surface(tissue, tissue.rest_position))
    colours = find_colours(organ.published)
    if colours is not None and len(colours) == count:
        return colours
    appearance = find_appearance(organ.published)
    colour = TISSUE if appearance is None else appearance.colour
    return np.tile(np.rint(255.0 * np.asarray(colour)).astype(np.uint8), (count, 1))

# SPDX-License-Identifier: BSD-3-Clause
"""How high a tip is over the tissue is seen at once: by a ring that closes, and by its shadow."""

from __future__ import annotations

import itertools
import math
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate.render.authored_appearance import find_appearance
from palpate.render.renderer import KEY, lamp
from palpate.runs.press import find_top
from palpate.scene.surfaces import join_rest_surfaces, join_triangles
from palpate.viewport import SeenInstrument, canvas, make_view
from palpate.viewport import instruments as viewport_instruments
from tiers import keep_everyday
from windows import grab

MESHES = Path(__file__).resolve().parents[2] / "meshes"
HEIGHTS = (2e-3, 5e-3, 10e-3)
"""[m] of the tip over the tissue."""
LEAST = 15.0
"""[px] that the cue moves by between two of them."""
LOOKS = {"from above": 75.0, "aslant": 40.0, "along the surface": 12.0}
ORGANS = ("spleen", "gallbladder", "stomach")


@pytest.fixture(autouse=True)
def whole_frames(monkeypatch):
    """Every frame is as large as the view: pixels are counted."""
    monkeypatch.setattr(canvas, "QUICK_SIZES", (1.0,) * len(canvas.QUICK_SIZES))


class Stage:
    """A view of 1280 by 800 pixels with an organ, and a tip over its top."""

    def __init__(self, organ, qtbot):
        scenario = palpate.scenario.read(MESHES / "published" / f"{organ}.palpate")
        self.view = make_view()
        qtbot.addWidget(self.view)
        self.view.resize(1280, 800)
        self.view.wireframe = False
        self.view.use_appearance(find_appearance(scenario))
        self.view.show_surface(join_rest_surfaces(scenario.scene), join_triangles(scenario.scene))
        top = find_top(scenario.scene)
        self.point, self.outward = np.array(top.point), np.array(top.outward)
        self.tool = palpate.Tool(radius=0.003)
        grab(self.view)

    def look(self, elevation):
        self.view.look_from(math.radians(-60.0), math.radians(elevation))

    def show(self, height):
        tip = self.point + (self.tool.radius + height) * self.outward
        self.view.show_instruments([SeenInstrument(self.tool, tip)])

    def find_ring(self, height, monkeypatch):
        """[px] (n, 2) what the ring alone changes."""
        self.show(height)
        with_ring = grab(self.view)
        with monkeypatch.context() as patch:
            patch.setattr(viewport_instruments, "HIGHEST", 0.0)
            self.show(height)
            without = grab(self.view)
        changed = np.abs(with_ring - without).sum(axis=-1) > 120
        return np.argwhere(changed)[:, ::-1].astype(float)

    def find_pixel(self, point):
        at = self.view.world_to_pixel(point)
        return np.array([at.x(), at.y()])

    def measure_line(self, height):
        """[px] from the tip's skin to the nearest point of the tissue."""
        return self.measure(self.point + height * self.outward, self.point)

    def measure_shadow(self, height):
        """[px] from the tip's skin to where its shadow falls, under the key lamp."""
        tip = self.point + height * self.outward
        away = -lamp(self.view.camera, KEY)
        hit = self.view.scenery.pick(tip, away)
        return math.nan if hit is None else self.measure(tip, np.array(hit.point))

    def measure(self, a, b):
        return float(np.linalg.norm(self.find_pixel(a) - self.find_pixel(b)))


def measure_radius(pixels):
    """[px] half of the longest way across."""
    angles = np.linspace(0.0, math.pi, 36, endpoint=False)
    along = pixels @ np.stack([np.cos(angles), np.sin(angles)])
    return 0.5 * float((along.max(axis=0) - along.min(axis=0)).max())


CASES = list(itertools.product(ORGANS, LOOKS))


@pytest.mark.window
@pytest.mark.parametrize("case", keep_everyday(CASES, (("spleen", "aslant"),)))
def test_the_ring_closes_by_15_pixels_between_heights_of_10_5_and_2_mm(case, qtbot, monkeypatch):
    stage = Stage(case[0], qtbot)
    stage.look(LOOKS[case[1]])
    radii = [measure_radius(stage.find_ring(height, monkeypatch)) for height in HEIGHTS]
    print(*case, "ring", np.round(radii, 1))
    assert np.diff(radii).min() >= LEAST


@pytest.mark.window
@pytest.mark.landing
def test_neither_a_shadow_nor_a_line_to_the_tissue_moves_so_far_at_every_angle(qtbot):
    """The two cues that were tried beside the ring. The shadow is drawn all the same."""
    least = {"shadow": math.inf, "line": math.inf}
    for organ in ORGANS:
        stage = Stage(organ, qtbot)
        for name, elevation in LOOKS.items():
            stage.look(elevation)
            for cue, measure in (("shadow", stage.measure_shadow), ("line", stage.measure_line)):
                lengths = [measure(height) for height in HEIGHTS]
                print(organ, name, cue, np.round(lengths, 1))
                moved = float(np.diff(lengths).min())
                least[cue] = min(least[cue], 0.0 if math.isnan(moved) else moved)
    assert least["shadow"] < LEAST and least["line"] < LEAST


@pytest.mark.window
def test_what_is_touched_glows_and_has_no_ring(qtbot):
    stage = Stage("spleen", qtbot)
    stage.look(60.0)
    stage.show(0.0)
    at = stage.find_pixel(stage.point + 0.004 * np.cross(stage.outward, (0.0, 1.0, 0.0)))
    x, y = (round(float(c)) for c in at)
    near = slice(y - 3, y + 4), slice(x - 3, x + 4)
    tip = stage.point + stage.tool.radius * stage.outward
    seen = [
        SeenInstrument(stage.tool, tip, touching=touching, force=force)
        for touching, force in ((False, 0.0), (True, 0.1), (True, 3.0))
    ]
    light = []
    for one in seen:
        stage.view.show_instruments([one])
        light.append(grab(stage.view)[near].sum(axis=-1).mean())
    assert light[1] > light[0] + 10 and light[2] > light[1] + 10
    assert stage.view.scenery.shades[0].ring is None
    stage.view.show_instruments(())
    grab(stage.view)
    assert stage.view.scenery.shades == ()

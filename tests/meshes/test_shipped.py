# SPDX-License-Identifier: BSD-3-Clause
"""What a user gets: files to edit and to play, a list, pictures."""

from __future__ import annotations

import json

import numpy as np
import palpate
import pytest
from matplotlib.image import imread
from palpate.cli.main import main
from palpate.render import build_appearance
from palpate.runs.press import find_top, take_surface
from palpate.runs.run import read_scene
from palpate.runs.script_file import write_script_file
from palpate_editor.check import assess
from palpate_editor.gallery import draw_organ, draw_tool
from palpate_editor.open_organ import open_organ
from palpate_editor.shipped import find_mesh, list_organs, make_organ
from palpate_meshes.catalogue import (
    PUBLISHED,
    Tissue,
    find_entry,
    read_organ_mesh,
    read_regions,
    read_tissues,
)
from palpate_meshes.tools import read_tool
from tiers import keep_everyday

ORGANS = [entry.name for entry, _ in list_organs()]
BUILT = keep_everyday(ORGANS, ("gallbladder", "simple_tissue", "spleen"))
"""Where each is built: a wall, springs and a solid every day, the others at a landing."""


def run(capsys, *words):
    code = main([*map(str, words)])
    return code, capsys.readouterr()


@pytest.mark.parametrize("name", BUILT)
def test_a_designer_is_warned_of_nothing_in_an_organ_as_it_ships(name):
    problems = assess(make_organ(name), tested=True).problems

    assert [p.key for p in problems if p.severity != "note"] == []


@pytest.mark.parametrize("name", BUILT)
def test_constants_that_ship_follow_from_what_the_tissue_is_made_of(name):
    organ, tissue = make_organ(name), find_tissue(name)

    kinds = {"solid": "solid", "hollow": "shell", "sheet": "shell", "rigid": "mass_spring"}
    assert organ.model.kind == kinds[tissue.kind]
    # the patch, of which there is no truth, is touched by the hard law [contact: walls]
    law = {"contact_law"} if tissue.kind in ("hollow", "sheet") else set()
    assert tissue.kind == "rigid" or set(tissue.model) == {"kind", "drag"} | law
    scene = read_scene(PUBLISHED / f"{name}.palpate")
    assert len(scene.bodies[0].tissue.home) == 0 or tissue.kind == "rigid"
    plane_strain = organ.material.young_modulus / (1.0 - organ.material.poisson_ratio**2)
    modulus = plane_strain if tissue.kind in ("solid", "hollow") else 0.0
    assert scene.bodies[0].contact_modulus == pytest.approx(modulus)


def find_tissue(name: str) -> Tissue:
    return read_tissues()[find_entry(name).tissue]


@pytest.mark.parametrize("name", ORGANS)
def test_a_document_brings_its_anatomy_and_is_held_by_its_attachment(name):
    organ = make_organ(name)

    regions = read_regions(name)
    assert set(organ.regions) == set(regions)
    assert np.array_equal(np.flatnonzero(organ.fixed), organ.regions["attachment"])
    if organ.decimation is None:
        assert all(np.array_equal(organ.regions[region], regions[region]) for region in regions)
    assert organ.title and organ.task and not organ.source.unit_guessed


@pytest.mark.parametrize("name", BUILT)
def test_the_shipped_files_open_and_are_the_organs_of_the_catalogue(name):
    organ = open_organ(PUBLISHED / f"{name}.organ")
    scene = read_scene(PUBLISHED / f"{name}.palpate")

    made, entry = make_organ(name), find_entry(name)
    for found, expected in (
        ((organ.imported.vertices, organ.imported.triangles), read_organ_mesh(name)),
        ((organ.surface.vertices, organ.surface.triangles),
         (made.surface.vertices, made.surface.triangles)),
    ):  # fmt: skip
        assert all(np.array_equal(one, other) for one, other in zip(found, expected, strict=True))
    assert organ.vertex_count == (entry.wall_vertices or entry.vertices)
    vertices, triangles = take_surface(scene, 0)
    # a skin is where its tetrahedra have it; the inner face of a wall comes after the outer
    assert np.abs(vertices[: made.vertex_count] - made.surface.vertices).max() < 1e-9
    assert np.array_equal(triangles, made.surface.triangles)
    for part in ("material", "model", "fill", "tool", "appearance"):
        assert getattr(organ, part) == getattr(made, part)
    assert {n: r.tolist() for n, r in organ.regions.items()} == {
        n: r.tolist() for n, r in made.regions.items()
    }
    assert np.array_equal(organ.fixed, made.fixed)
    assert len(scene.bodies[0].tissue.fixed)


@pytest.mark.parametrize("name", BUILT)
def test_a_shipped_scenario_is_played_and_pushes_back(capsys, tmp_path, name):
    path, press = PUBLISHED / f"{name}.palpate", tmp_path / "press.json"
    scene = read_scene(path)
    place, radius = find_top(scene), scene.instruments[0].tool.radius
    heights = ((0.0, radius + 2e-3), (0.2, radius - 2e-3), (0.3, radius + 2e-3))
    write_script_file(
        press,
        [
            palpate.KeyFrame(time=time, position=place.point + height * place.outward)
            for time, height in heights
        ],
    )

    code, said = run(
        capsys, "play", path, "--headless", "--device", f"script:{press}", "--json",
        "--record", tmp_path / "run.prec",
    )  # fmt: skip

    report = json.loads(said.out)
    assert code == 0 and report["title"] == find_entry(name).title
    assert report["peak_force_N"] > 0.005 and report["time_in_touch_s"] > 0.05


def test_another_resolution_is_made_where_it_is_asked_for():
    organ = make_organ("simple_tissue", 80)

    assert organ.vertex_count == 80 and organ.fixed.any()
    assert organ.source is None


def test_a_stone_does_not_give_at_all_and_pushes_back():
    scene = read_scene(PUBLISHED / "kidney_stone.palpate")
    place, world = find_top(scene), palpate.World(scene)
    rest = np.array(world.bodies[0].tissue.position)
    sample = palpate.HapticSample()

    for k in range(400):
        sample.time = 1e-3 * k
        # from above it to 3 mm deep, in 0.3 s
        sample.position = place.point + place.outward * (
            scene.instruments[0].tool.radius - 1e-5 * min(k, 300)
        )
        command = palpate.tick(scene, sample, 1e-3, world)

    assert np.array_equal(np.array(world.bodies[0].tissue.position), rest)
    assert np.dot(command.force, place.outward) > 0.5
    assert scene.bodies[0].substeps == 1


def test_the_list_says_where_everything_comes_from(capsys):
    code, said = run(capsys, "organs", "--json")

    report = json.loads(said.out)
    assert code == 0 and report["licence"] == "BSD-3-Clause" and report["unit"] == "m"
    assert [organ["name"] for organ in report["organs"]] == ORGANS
    for organ in report["organs"]:
        assert organ["published"] and all(row["source"] for row in organ["published"])
        assert organ["regions"]["attachment"] > 0
    assert [tool["name"] for tool in report["tools"]] == ["grasper", "laparoscope", "syringe"]


@pytest.mark.usefixtures("little_sky")
def test_the_verb_writes_files_to_edit_and_to_play_and_pictures(capsys, tmp_path):
    code, said = run(
        capsys, "organs", "kidney_stone", "--write", tmp_path, "--pictures", tmp_path / "pictures"
    )

    assert code == 0, said.err
    assert open_organ(tmp_path / "kidney_stone.organ").vertex_count == 120
    assert len(read_scene(tmp_path / "kidney_stone.palpate").bodies[0].tissue.mass) == 120
    assert imread(tmp_path / "pictures" / "kidney_stone.png").shape[:2] == (960, 1280)


def test_the_verb_writes_one_organ_at_another_resolution(capsys, tmp_path):
    out = tmp_path / "coarse.organ"

    code, _ = run(capsys, "organs", "spleen", "--vertices", 300, "--out", out)

    assert code == 0 and open_organ(out).vertex_count == 300


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["heart"], "got heart, expected one of simple_tissue"),
        (["spleen", "--vertices", "300"], "expected --out FILE"),
        (["spleen", "--vertices", "5", "--out", "x.organ"], "--vertices: got"),
        (["--out", "x.organ"], "one NAME"),
    ],
)
def test_a_call_that_cannot_be_is_refused_in_a_sentence(
    capsys, tmp_path, monkeypatch, words, reason
):
    monkeypatch.chdir(tmp_path)
    code, said = run(capsys, "organs", *words)

    assert code == 1 and reason in said.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ORGANS)
def test_inspect_gives_the_counts_of_the_catalogue(capsys, name):
    entry = find_entry(name)

    code, said = run(capsys, "inspect", find_mesh(name), "--json")

    report = json.loads(said.out)
    assert code == 0
    assert (report["vertices"], report["triangles"]) == (entry.vertices, entry.triangles)
    assert report["border_loops"] == list(entry.border)


@pytest.mark.usefixtures("little_sky")
def test_a_published_organ_is_rendered_as_its_tissue(capsys, tmp_path):
    for name in ("spleen.palpate", "spleen.obj"):
        out = tmp_path / f"{name}.png"
        words = ("render", PUBLISHED / name, "--out", out, "--size", "160x120", "--no-wireframe")
        assert run(capsys, *words)[0] == 0

    tissue, plain = (imread(tmp_path / f"spleen.{kind}.png") for kind in ("palpate", "obj"))
    assert np.abs(tissue - plain)[40:80, 60:100].mean() > 0.05


@pytest.mark.usefixtures("little_sky")
def test_pictures_show_tissue_that_is_neither_flat_nor_alike():
    colours = {}
    for entry, tissue in list_organs():
        if entry.vertices < 3000:
            pixels = draw_organ(entry, tissue, size=(160, 140)).astype(float)
            middle = pixels[60:80, 70:90].reshape(-1, 3)
            assert middle.std(axis=0).max() > 2.0, entry.name
            colours[entry.name] = middle.mean(axis=0)
    names = list(colours)
    for i, one in enumerate(names):
        for other in names[i + 1 :]:
            assert np.abs(colours[one] - colours[other]).max() > 8.0, (one, other)


@pytest.mark.usefixtures("little_sky")
def test_a_grasper_is_drawn_with_its_jaws_apart():
    assert draw_tool(read_tool("grasper"), size=(160, 140)).std() > 10.0


def test_every_tissue_has_an_appearance_the_renderer_takes():
    for tissue in read_tissues().values():
        appearance = build_appearance(tissue.appearance)
        assert 0.0 <= appearance.gloss <= 1.0 and 0.0 < appearance.roughness <= 1.0
        assert appearance.pattern is not None and appearance.pattern.size > 0.0


def test_the_laws_take_every_organ_of_either_kind():
    for name in ("simple_tissue", "spleen"):
        scene = read_scene(PUBLISHED / f"{name}.palpate")
        assert palpate.stable_step(scene.bodies[0].tissue) > 0.0

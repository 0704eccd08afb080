# SPDX-License-Identifier: GPL-3.0-or-later
"""From the editor to the trainee and back: what is published, and what is refused."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import palpate
import pytest
from organs import make_organ, same, untitled
from palpate import scenario
from palpate.cli.main import main
from palpate_editor.check import assess
from palpate_editor.compile import compile_organ
from palpate_editor.document import EMPTY
from palpate_editor.document.files import read_organ, write_organ
from palpate_editor.open_organ import open_organ, read_authored
from palpate_editor.publish import PublishError, publish

SPLEEN = make_organ()


def run(capsys, *words: object, code: int = 0) -> dict:
    assert main([*map(str, words), "--json"]) == code
    return json.loads(capsys.readouterr().out)


@pytest.fixture(scope="module")
def source(tmp_path_factory, shared_data):
    return shared_data("organs/VH_F_Spleen.glb")


def test_a_published_organ_ticks_as_it_was_compiled(tmp_path):
    report = publish(SPLEEN, tmp_path / "spleen.palpate")

    found = scenario.read(tmp_path / "spleen.palpate")
    compiled = compile_organ(SPLEEN)
    assert (found.title, found.task) == ("Press the spleen", "Bas ve bırak.")
    for name in ("rest_position", "mass", "fixed", "home"):
        one, other = (
            getattr(found.scene.bodies[0].tissue, name),
            getattr(compiled.bodies[0].tissue, name),
        )
        assert np.asarray(one).tobytes() == np.asarray(other).tobytes(), name
    one, other = (
        found.scene.bodies[0].tissue.springs.stiffness,
        compiled.bodies[0].tissue.springs.stiffness,
    )
    assert np.asarray(one).tobytes() == np.asarray(other).tobytes()
    assert report["bytes"] == (tmp_path / "spleen.palpate").stat().st_size
    assert report["vertices"] == 60


def test_what_is_late_is_published_only_as_slow(tmp_path, capsys):
    model = replace(SPLEEN.model, kind="mass_spring", stiffness=2e6)
    write_organ(tmp_path / "a.organ", replace(make_organ(600), model=model))
    words = ["publish", str(tmp_path / "a.organ"), "-o", str(tmp_path / "a.palpate")]

    report = run(capsys, *words, code=1)

    assert [p["problem"] for p in report["problems"]] == ["late_tick"]
    assert not (tmp_path / "a.palpate").exists()
    assert main(words) == 1
    said = capsys.readouterr().out
    assert "% of the time there is" in said and "--slow publishes it" in said
    assert run(capsys, *words, "--slow")["published"]
    assert (tmp_path / "a.palpate").is_file()


def test_slow_lets_no_other_error_pass(tmp_path):
    with pytest.raises(PublishError, match="no title"):
        publish(untitled(SPLEEN), tmp_path / "a.palpate", slow=True)


def test_a_published_file_opens_again_with_all_that_was_authored(tmp_path):
    publish(SPLEEN, tmp_path / "spleen.palpate")

    found = open_organ(tmp_path / "spleen.palpate")

    assert same(found, replace(SPLEEN, source=replace(SPLEEN.source, folder="")))


def test_a_published_file_does_not_tell_where_the_mesh_lay(tmp_path):
    publish(SPLEEN, tmp_path / "spleen.palpate")

    assert SPLEEN.source.folder == "/organs"
    assert b"/organs" not in (tmp_path / "spleen.palpate").read_bytes()


def test_publishing_twice_gives_the_same_bytes(tmp_path):
    for name in ("a", "b"):
        publish(SPLEEN, tmp_path / f"{name}.palpate", assess(SPLEEN))

    assert (tmp_path / "a.palpate").read_bytes() == (tmp_path / "b.palpate").read_bytes()


def test_an_assessment_of_another_organ_is_not_believed(tmp_path):
    with pytest.raises(PublishError):
        publish(untitled(SPLEEN), tmp_path / "a.palpate", assess(SPLEEN))


def test_what_has_errors_is_refused_with_all_of_them_and_leaves_the_old_file(tmp_path):
    path = tmp_path / "a.palpate"
    publish(SPLEEN, path)
    before = path.read_bytes()
    bad = replace(
        untitled(SPLEEN),
        material=replace(SPLEEN.material, density=-1.0),
        tool=replace(SPLEEN.tool, radius=0.0),
    )

    with pytest.raises(PublishError) as refusal:
        publish(bad, path)

    assert [p.where for p in refusal.value.problems] == ["material.density", "tool.radius", "title"]
    assert "material.density: got -1 kg/m³" in str(refusal.value)
    assert path.read_bytes() == before


def test_an_empty_document_cannot_be_published(tmp_path):
    with pytest.raises(PublishError, match="no surface"):
        publish(EMPTY, tmp_path / "a.palpate")

    assert list(tmp_path.iterdir()) == []


def test_a_file_no_editor_made_has_nothing_to_open(tmp_path):
    made = scenario.Scenario(scene=compile_organ(SPLEEN), title="by hand")
    scenario.write(str(tmp_path / "a.palpate"), made)

    with pytest.raises(palpate.FileError, match="no document of an editor"):
        read_authored(tmp_path / "a.palpate")


def test_a_published_layout_is_no_organ_and_says_so(tmp_path):
    made = scenario.Scenario(scene=compile_organ(SPLEEN), title="two")
    made.authored = json.dumps({"format": "palpate layout", "version": 3, "content": {}})
    scenario.write(str(tmp_path / "a.palpate"), made)

    with pytest.raises(palpate.FileError, match="a scene of several parts"):
        read_authored(tmp_path / "a.palpate")


@pytest.mark.parametrize(
    ("change", "words"),
    [({"version": 99}, "authored.version"), ({"version": "1"}, "authored.version"),
     ({"version": True}, "authored.version"), ({"content": None}, "got null"),
     ({"content": {}}, "got nothing")],
)  # fmt: skip
def test_a_document_that_was_meddled_with_is_refused(tmp_path, change, words):
    publish(SPLEEN, tmp_path / "a.palpate")
    found = scenario.read(str(tmp_path / "a.palpate"))
    found.authored = json.dumps(json.loads(found.authored) | change)
    scenario.write(str(tmp_path / "a.palpate"), found)

    with pytest.raises(palpate.FileError) as refusal:
        read_authored(tmp_path / "a.palpate")

    assert words in str(refusal.value)


# --- the verbs -------------------------------------------------------------------------------


def test_a_chain_of_verbs_makes_a_published_file_out_of_a_mesh(source, tmp_path, capsys):
    organ, out = tmp_path / "spleen.organ", tmp_path / "spleen.palpate"

    imported = run(capsys, "import", source, "-o", organ)
    decimated = run(capsys, "decimate", organ, "--vertices", 600, "-o", organ)
    run(capsys, "material", organ, "--kind", "mms", "--bend", "1mJ", "--stretch-bend", "0.1N",
        "--home", "1e6N/m3", "--fix-lowest", "0.1", "--tool-radius", "4mm",
        "-o", organ)  # fmt: skip
    made = run(capsys, "material", organ, "--stiffness", "150N/m", "-o", organ)
    checked = run(capsys, "check", organ, code=1)
    published = run(capsys, "publish", organ, "--title", "Dalak", "--task", "Bas.", "-o", out)

    assert imported["mesh"]["vertices"] == 4274
    assert (decimated["vertices"], decimated["triangles"]) == (600, 1196)
    assert made["bonds"] == 1794 and made["fixed"] > 0  # what a call does not name stays
    assert [p["problem"] for p in checked["problems"] if p["severity"] == "error"] == ["no_title"]
    assert published["published"]
    assert [p["problem"] for p in published["problems"]] == ["home_share"]
    found = read_organ(organ)
    assert len(found.imported.vertices) == 4274 and found.vertex_count == 600
    assert scenario.read(str(out)).title == "Dalak"
    assert open_organ(out).model == found.model


def test_check_says_what_a_press_comes_to(tmp_path, capsys):
    write_organ(tmp_path / "a.organ", SPLEEN)

    checked = run(capsys, "check", tmp_path / "a.organ")

    shares = [place["home_share"] for place in checked["places"]]
    assert len(shares) == 5 and all(0.5 < share < 1.1 for share in shares)
    assert checked["press_depth_m"] == 3e-3 and checked["substeps_in_touch"] >= 3
    assert 0.0 < checked["tick_share_in_touch"] < 0.1
    assert main(["check", str(tmp_path / "a.organ")]) == 0
    said = capsys.readouterr().out
    low, high = (f"{100 * share:.0f}%" for share in (min(shares), max(shares)))
    assert f"home springs: {low} to {high} of the felt force at 5 places pressed 3 mm" in said
    assert f"in touch: {checked['substeps_in_touch']} substeps, about 0% of a tick" in said


def test_check_says_of_a_solid_what_its_tetrahedra_are_for_the_tip_place_by_place(tmp_path, capsys):
    organ = replace(SPLEEN, model=replace(SPLEEN.model, kind="solid"))
    write_organ(tmp_path / "a.organ", organ)

    checked = run(capsys, "check", tmp_path / "a.organ")

    assert len(checked["places"]) == 5
    for place in checked["places"]:
        assert place["home_share"] is None and len(place["point_m"]) == 3
        assert place["contact_radius_m"] == pytest.approx((0.012 * 0.003) ** 0.5)
        ratio = 0.85 * place["edge_m"] / place["contact_radius_m"]
        assert place["times_too_stiff"] == pytest.approx((1.0 + ratio**2) ** 0.5)


@pytest.mark.parametrize(
    ("options", "refusal"),
    [
        ("--fix-lowest 1", "fixed: got every vertex fixed, expected some that can move"),
        ("--stiffness 5e8N/m", "steps a tick, of 0."),
        pytest.param(
            "--kind solid --tetrahedra 12000 --young-modulus 9MPa",
            "of the time there is",
            marks=pytest.mark.landing,
        ),
    ],
)
def test_what_publish_would_refuse_of_a_tissue_is_refused_when_it_is_chosen(
    options, refusal, tmp_path, capsys
):
    write_organ(tmp_path / "a.organ", SPLEEN)

    assert main(["material", str(tmp_path / "a.organ"), *options.split(), "-o",
                 str(tmp_path / "b.organ")]) == 1  # fmt: skip

    assert refusal in capsys.readouterr().err
    assert not (tmp_path / "b.organ").exists()


def test_a_surface_too_slow_for_any_machine_is_refused_when_it_is_chosen(tmp_path, capsys):
    write_organ(tmp_path / "a.organ", make_organ(600))
    words = ["--stiffness", "2e7N/m", "-o", str(tmp_path / "b.organ")]

    assert main(["material", str(tmp_path / "a.organ"), *words]) == 1

    assert "923 steps a tick, of 1.1 us at most: about 5" in capsys.readouterr().err
    assert not (tmp_path / "b.organ").exists()


def test_what_is_doubtful_about_a_tissue_is_said_when_it_is_chosen(tmp_path, capsys):
    organ = tmp_path / "a.organ"
    write_organ(organ, SPLEEN)

    made = run(capsys, "material", organ, "--gravity", "0,0,-981", "-o", organ)

    assert [p["problem"] for p in made["problems"]] == ["gravity", "home_share"]
    assert main(["material", str(organ), "--gravity", "0,0,-981", "-o", str(organ)]) == 0
    assert "warning hand.gravity: got 981 m/s², 100 times" in capsys.readouterr().out


def test_publishing_what_is_not_ready_exits_1_with_the_list(tmp_path, capsys):
    write_organ(tmp_path / "a.organ", untitled(SPLEEN))

    report = run(capsys, "publish", tmp_path / "a.organ", "-o", tmp_path / "a.palpate", code=1)

    assert report["published"] is False
    assert [p["problem"] for p in report["problems"]] == ["no_title"]
    assert report["problems"][0]["fix"] == "Title: dalak"
    assert not (tmp_path / "a.palpate").exists()
    assert main(["publish", str(tmp_path / "a.organ"), "-o", str(tmp_path / "a.palpate")]) == 1
    assert "title: got no title" in capsys.readouterr().out


def test_a_scene_file_can_be_published_too(tmp_path, capsys):
    mesh, scene = tmp_path / "a.obj", tmp_path / "a.scene.json"
    write_organ(tmp_path / "a.organ", SPLEEN)
    run(capsys, "material", tmp_path / "a.organ", "-o", scene)

    run(capsys, "publish", scene, "--title", "A", "-o", tmp_path / "a.palpate")

    assert mesh.is_file()
    one = scenario.read(str(tmp_path / "a.palpate")).scene.bodies[0].tissue
    assert (
        np.asarray(one.mass).tobytes()
        == np.asarray(compile_organ(SPLEEN).bodies[0].tissue.mass).tobytes()
    )


@pytest.mark.parametrize(
    ("words", "sentence"),
    [(("publish", "a.organ", "-o", "b.zip"), "a name ending in '.zip'"),
     (("publish", "a.organ", "--title", "x" * 201, "-o", "b.palpate"), "201 bytes"),
     (("publish", "none.organ", "-o", "b.palpate"), "No such file"),
     (("publish", "a.stl", "-o", "b.palpate"), ".organ, .palpate or .scene.json"),
     (("material", "a.organ", "--density=-1kg/m3", "-o", "b.organ"), "Density must be"),
     (("material", "a.organ", "--fix-lowest=2", "-o", "b.organ"), "--fix-lowest"),
     (("decimate", "a.organ", "--vertices", "9999", "-o", "b.organ"), "cannot be decimated to"),
     (("repair", "a.organ", "--problem", "shells", "-o", "b.organ"), "that can be repaired")],
)  # fmt: skip
def test_a_verb_refuses_with_a_sentence(tmp_path, capsys, monkeypatch, words, sentence):
    monkeypatch.chdir(tmp_path)
    write_organ(tmp_path / "a.organ", SPLEEN)

    error = run(capsys, *words, code=1)["error"]

    assert sentence in " ".join(str(value) for value in error.values())
    assert not list(tmp_path.glob("b.*"))


def test_repair_fixes_what_needs_no_choice(tmp_path, capsys):
    bad = replace(
        untitled(SPLEEN),
        material=replace(SPLEEN.material, density=-1.0),
        model=replace(SPLEEN.model, kind="molecular", bend_stiffness=1e-3, stretch_coupling=1e4),
        tool=replace(SPLEEN.tool, radius=1e-3),
    )
    write_organ(tmp_path / "a.organ", bad)

    report = run(capsys, "repair", tmp_path / "a.organ", "-o", tmp_path / "b.organ")

    repaired = read_organ(tmp_path / "b.organ")
    assert report["done"] == [
        f"Density: {repaired.material.density:g} kg/m³",
        f"Stretch-bend: {repaired.model.stretch_coupling:g} N",
        "Title: dalak",
    ]
    assert {p["severity"] for p in report["problems"]} <= {"warning", "note"}
    assert repaired.title == "dalak" and repaired.tool.radius == 1e-3  # a warning was not asked for
    run(capsys, "repair", tmp_path / "b.organ", "--problem", "small_tip", "-o",
        tmp_path / "b.organ")  # fmt: skip
    assert read_organ(tmp_path / "b.organ").tool.radius > 1e-3


def test_the_word_none_takes_a_constant_away(tmp_path, capsys):
    walled = replace(SPLEEN, material=replace(SPLEEN.material, wall_thickness=2e-3))
    write_organ(tmp_path / "a.organ", walled)

    run(capsys, "material", tmp_path / "a.organ", "--wall", "none", "--home", "none", "-o",
        tmp_path / "a.organ")  # fmt: skip

    found = read_organ(tmp_path / "a.organ")
    assert found.material.wall_thickness is None and found.model.home_stiffness is None


def test_every_constant_of_the_table_has_its_option(tmp_path, capsys):
    write_organ(tmp_path / "a.organ", SPLEEN)

    run(capsys, "material", tmp_path / "a.organ", "--young", "6kPa", "--poisson", "0.4",
        "--tool-stiffness", "2e7N/m3", "--force-max", "3N", "--grip", "400N/m", "--friction", "0.2",
        "--rate", "1000", "--gravity", "0,0,-9.81", "--damping-law", "isotropic",
        "--kind", "solid", "-o", tmp_path / "a.organ")  # fmt: skip

    found = read_organ(tmp_path / "a.organ")
    assert (found.material.young_modulus, found.material.poisson_ratio) == (6e3, 0.4)
    assert (found.tool.stiffness, found.hand.force_max, found.hand.hold_stiffness) == (2e7, 3, 400)
    assert found.tool.friction == 0.2
    assert found.hand.gravity == (0.0, 0.0, -9.81) and found.model.damping_law == "isotropic"

# SPDX-License-Identifier: BSD-3-Clause
"""palpate.scenario: what is written comes back, and what is hostile is refused."""

from __future__ import annotations

import gc
import json
import os
import random
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import palpate
import pytest
from english import say_in_turkish
from headers import read_header
from hostile_scenarios import HOSTILE, with_manifest
from palpate import scenario
from surfaces import ellipsoid, organ_scene, press_frames, run_frames
from test_mirror import overloads

HERE = Path(__file__).parent
ROOM = HERE.parents[1] / "core" / "scenario"
PUBLIC = ("container.h", "read.h", "scenario.h", "write.h")

ARRAYS = {
    "mesh/vertices": np.array([[0.5, -1.25, 3.0]]),
    "mesh/triangles": np.array([[0, 1, 2]], np.int32),
    "ids": np.array([-(2**62), 2**62]),
    "weights": np.array([0.1, 0.2], np.float32),
    "source.obj": np.frombuffer(b"v 0 0 0\n", np.uint8),
    "nothing": np.empty((0, 3)),
}


def molecular_scene(subdivisions: int = 1) -> palpate.Scene:
    material = palpate.Material(damping_ratio=0.2)
    constants = palpate.MolecularConstants(
        bond_stiffness=60.0, bend_stiffness=1e-3, stretch_coupling=0.02
    )
    mesh = ellipsoid((0.05, 0.035, 0.02), subdivisions)
    return palpate.build_scene(
        palpate.make_scene(palpate.build_molecular(mesh, material, constants))
    )


def run_python(script: str, *arguments: object) -> str:
    """A script of this folder in an interpreter of its own."""
    alone = {"OPENBLAS_NUM_THREADS": "1", "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, HERE / script, *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", env=os.environ | alone)
    assert done.returncode == 0, done.stderr
    return done.stdout


# --- containers ------------------------------------------------------------------------------


def test_a_container_comes_back_with_every_type_and_shape(tmp_path):
    made = scenario.Container(format="organ", version=3, content='{"name":"dalağı"}', arrays=ARRAYS)

    scenario.write_container(tmp_path / "a.organ", made)
    found = scenario.read_container(tmp_path / "a.organ", "organ", 3)

    assert (found.format, found.version) == ("organ", 3)
    assert json.loads(found.content) == {"name": "dalağı"}
    assert found.written_by == f"palpate {palpate.__version__}"
    assert found.arrays.keys() == ARRAYS.keys()
    for name, expected in ARRAYS.items():
        assert found.arrays[name].dtype == expected.dtype
        assert found.arrays[name].shape == expected.shape
        assert found.arrays[name].tobytes() == expected.tobytes()
    assert list(tmp_path.iterdir()) == [tmp_path / "a.organ"]


def test_arrays_of_a_container_are_views_that_cannot_be_written_and_keep_it_alive():
    array = scenario.Container(format="organ", version=1, arrays=ARRAYS).arrays["mesh/vertices"]
    gc.collect()

    assert array.tolist() == [[0.5, -1.25, 3.0]]
    with pytest.raises(ValueError, match="read-only"):
        array[0, 0] = 1.0


def test_arrays_of_any_layout_and_byte_order_are_taken():
    grid = np.arange(12.0).reshape(3, 4)
    given = {"turned": grid.T, "sparse": grid[::2, ::3], "big": grid.astype(">f8"), "list": [1, 2]}

    found = scenario.Container(format="organ", version=1, arrays=given).arrays

    assert found["turned"].tolist() == grid.T.tolist()
    assert found["sparse"].tolist() == grid[::2, ::3].tolist()
    assert found["big"].tolist() == grid.tolist()
    assert found["big"].dtype == np.dtype("<f8")
    assert found["list"].dtype == np.int64


@pytest.mark.parametrize("dtype", ["?", "<f2", "<c16", "<u8", "O", "U3", "<M8[s]"])
def test_other_types_are_refused_by_name(dtype):
    with pytest.raises(ValueError, match=r"mask: got dtype .*, expected \|u1, <i4, <i8, <f4"):
        scenario.Container(format="organ", version=1, arrays={"mask": np.zeros(2, dtype)})


def test_bytes_are_the_same_for_the_same_contents():
    made = scenario.Container(format="organ", version=1, arrays=ARRAYS)
    again = scenario.Container(
        format="organ", version=1, content=" {} ", arrays=dict(reversed(ARRAYS.items()))
    )

    packed = scenario.pack_container(made)

    assert packed == scenario.pack_container(again)
    assert packed == scenario.pack_container(scenario.unpack_container(packed, "file", "organ", 1))


def test_what_could_not_be_read_is_not_written(tmp_path):
    bad = scenario.Container(format="organ", version=1, arrays={"a": [np.nan]})

    with pytest.raises(ValueError, match="a: got number 0 that is infinite or not a number"):
        scenario.write_container(tmp_path / "a.organ", bad)

    assert list(tmp_path.iterdir()) == []


# --- scenarios -------------------------------------------------------------------------------


@pytest.mark.parametrize("scene", [organ_scene(1), molecular_scene()], ids=["mss", "mms"])
def test_a_scene_that_was_read_ticks_with_the_same_bits(scene, tmp_path):
    authored = json.dumps({"stage": 3, "note": "kırmızı"}, ensure_ascii=False)
    made = scenario.Scenario(
        scene=scene, title="Dalak", task="Bas ve bırak.", authored=authored, authored_arrays=ARRAYS
    )

    scenario.write(tmp_path / "a.palpate", made)
    found = scenario.read(tmp_path / "a.palpate")

    before, after = (run_frames(s, press_frames()) for s in (scene, found.scene))
    assert np.abs(before.felt["force"]).max() > 0.01
    for name in before.felt.dtype.names:
        assert after.felt[name].tobytes() == before.felt[name].tobytes()
    assert after.hashes.tobytes() == before.hashes.tobytes()
    assert (found.title, found.task, found.version) == ("Dalak", "Bas ve bırak.", 7)
    assert json.loads(found.authored) == json.loads(authored)
    assert found.authored_arrays.keys() == ARRAYS.keys()
    assert palpate.replay(found.scene, before).equal


def test_a_scene_that_was_never_built_is_refused(tmp_path):
    scene = palpate.make_scene(organ_scene(1).bodies[0].tissue)

    with pytest.raises(ValueError, match="the result of build_scene"):
        scenario.write(tmp_path / "a.palpate", scenario.Scenario(scene=scene))


def test_a_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(palpate.FileError, match=r"none\.palpate: got No such file"):
        scenario.read(tmp_path / "none.palpate")


def test_what_waits_for_a_writer_is_refused_and_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "pipe.palpate")

    with pytest.raises(palpate.FileError, match="something other than a file"):
        scenario.read(tmp_path / "pipe.palpate")


def test_a_hole_of_a_terabyte_is_refused(tmp_path):
    with open(tmp_path / "hole.palpate", "wb") as file:
        file.truncate(1 << 40)

    with pytest.raises(palpate.FileError, match="got 1099511627776 bytes, expected at most"):
        scenario.read(tmp_path / "hole.palpate")


# --- hostile files ---------------------------------------------------------------------------


def write_good_file(path: Path, scene: palpate.Scene) -> bytes:
    scenario.write(path, scenario.Scenario(scene=scene, title="good"))
    return path.read_bytes()


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """What came of every hostile file, and of a good one, within 1 GB and 5 s."""
    folder = tmp_path_factory.mktemp("hostile")
    good = write_good_file(folder / "good.palpate", molecular_scene())
    large = write_good_file(folder / "large.palpate", molecular_scene(5))
    paths = {"good": folder / "good.palpate", "large": folder / "large.palpate"}
    files = {name: make(good) for name, (make, _) in HOSTILE.items()}
    files["large but for its last number"] = with_manifest(
        large,
        lambda manifest: manifest["content"]["scene"]["bodies"][0].update(spectrum_damping=1e9),
    )
    for number, (name, data) in enumerate(files.items()):
        paths[name] = folder / f"{number}.palpate"
        paths[name].write_bytes(data)
    found = json.loads(run_python("read_in_limits.py", *paths.values()))
    return {name: found[str(path)].replace(str(path), "FILE") for name, path in paths.items()}


@pytest.mark.parametrize("name", ["good", "large"])
def test_a_good_file_is_read_within_the_limits(outcomes, name):
    assert outcomes[name] == "read"


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_refused_in_a_sentence_within_the_limits(outcomes, name):
    assert outcomes[name].startswith("refused: FILE: ")
    assert HOSTILE[name][1] in outcomes[name]
    assert ": got " in outcomes[name] and ", expected " in outcomes[name]
    assert len(outcomes[name]) < 400
    assert "\n" not in outcomes[name]


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_refused_in_turkish_too(outcomes, turkish, name):
    assert "; beklenen: " in say_in_turkish(outcomes[name].removeprefix("refused: "))


def test_a_large_file_that_is_wrong_at_its_very_end_is_refused_within_the_limits(outcomes):
    assert "spectrum_damping: got 1e+09" in outcomes["large but for its last number"]


# --- kills -----------------------------------------------------------------------------------


@pytest.mark.parametrize("kills", [20, pytest.param(100, marks=pytest.mark.verify)])
def test_a_kill_while_saving_leaves_the_old_or_the_new_file_whole(kills, tmp_path):
    noise = np.random.default_rng(7).integers(0, 256, 4 << 20, np.uint8)  # most of the time to save
    for name, scene in (("old", organ_scene(1)), ("new", molecular_scene())):
        made = scenario.Scenario(scene=scene, title=name, authored_arrays={"noise": noise})
        scenario.write(tmp_path / name, made)
    random.seed(7)
    moments = [random.uniform(0.0, 0.1) for _ in range(kills)]
    (tmp_path / "folder").mkdir()

    found = json.loads(
        run_python("save_again_and_again.py", tmp_path / "folder" / "scene.palpate",
                   tmp_path / "old", tmp_path / "new", *moments)
    )  # fmt: skip

    assert len(found) == kills
    assert {words for words, _ in found} == {"old", "new"}
    # some kills came in the middle of a file, or none of this was shown
    assert any(in_the_middle for _, in_the_middle in found)


# --- the mirror ------------------------------------------------------------------------------


def test_every_public_name_of_the_room_has_its_twin_with_the_same_parameters():
    c_only = {"Array", "Dtype", "width_of", "find_language_problem"}
    for header in PUBLIC:
        declared = read_header(ROOM / header)
        for name in declared.constants:
            spelled = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name[1:]).upper()
            assert isinstance(getattr(scenario, spelled), int)
        for kind in declared.types:
            if kind.name not in c_only:
                python = getattr(scenario, kind.name)
                assert [f for f in kind.fields if not hasattr(python, f)] == []
        for function in declared.functions:
            if function.name not in c_only:
                assert function.parameters in overloads(getattr(scenario, function.name))

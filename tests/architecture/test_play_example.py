# SPDX-License-Identifier: BSD-3-Clause
"""A published file plays without Python: an installed palpate::scenario and a program of a page."""

from __future__ import annotations

import fcntl
import subprocess
from pathlib import Path

import numpy as np
import palpate
import palpate.scenario
import pytest
from tree import CHECKOUT, install

TICKS = 1000


def run(*command: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, encoding="utf-8")


def require(*command: str | Path) -> None:
    done = run(*command)
    assert done.returncode == 0, done.stdout + done.stderr


def build_player(flags: str = "") -> Path:
    """The example, compiled with these flags against what the release build installs. Its folder
    stays, so a second run is quick; another test's process may want it at the same time."""
    build = CHECKOUT / "build" / ("play" + flags.replace(" ", ""))
    with (CHECKOUT / "build/play.lock").open("w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        prefix = install(CHECKOUT / "build/release", "play-prefix")
        require("cmake", "-S", CHECKOUT / "tests/examples/play_a_scenario", "-B", build,
                "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_FLAGS={flags}",
                f"-DCMAKE_PREFIX_PATH={prefix}")  # fmt: skip
        require("cmake", "--build", build)
    return build / "play_a_scenario"


@pytest.fixture(scope="module")
def player() -> Path:
    return build_player()


def make_scene() -> palpate.Scene:
    """A dome of 10 cm, 3 cm high, as a molecular model with a wall of 4 mm."""
    count = 15
    at = np.linspace(-0.05, 0.05, count)
    x, y = (grid.ravel() for grid in np.meshgrid(at, at))
    vertices = np.stack([x, y, 0.03 - 6.0 * (x * x + y * y)], axis=1)
    corners = [j * count + i for j in range(count - 1) for i in range(count - 1)]
    triangles = [(a, a + 1, a + count + 1) for a in corners]
    triangles += [(a, a + count + 1, a + count) for a in corners]
    border = [i for i in range(count * count) if {i % count, i // count} & {0, count - 1}]
    tissue = palpate.build_molecular(
        palpate.SurfaceMesh(vertices, triangles),
        palpate.Material(wall_thickness=0.004),
        palpate.MolecularConstants(bond_stiffness=300.0, bend_stiffness=1e-3),
        palpate.SurfaceOptions(fixed=border),
    )
    return palpate.build_scene(
        palpate.Scene(bodies=[palpate.SoftBody(tissue=tissue)], gravity=(0.0, 0.0, -9.81))
    )


def script(scene: palpate.Scene, tick: int) -> palpate.HapticSample:
    """The hand of the example."""
    rest = scene.bodies[0].tissue.rest_position
    top = rest[np.argmax(rest[:, 2])]
    step = 256 - tick if tick < 512 else -256
    height = (top[2] + scene.instruments[0].tool.radius) + step * 2.0**-17
    return palpate.HapticSample(time=tick / scene.rate, position=(top[0], top[1], height))


def felt(scene: palpate.Scene) -> np.ndarray:
    world = palpate.World(scene)
    samples = [script(scene, tick) for tick in range(TICKS)]
    return np.array([palpate.tick(scene, s, 1.0 / scene.rate, world).force for s in samples])


@pytest.fixture(scope="module")
def published(tmp_path_factory: pytest.TempPathFactory) -> tuple[palpate.Scene, Path]:
    path = tmp_path_factory.mktemp("published") / "dome.palpate"
    scene = make_scene()
    made = palpate.scenario.Scenario(scene=scene, title="Kubbe", task="Press the dome.")
    palpate.scenario.write(path, made)
    return scene, path


def test_a_program_without_python_feels_the_very_forces_python_feels(player, published):
    scene, path = published

    done = run(player, path)

    assert done.returncode == 0, done.stderr
    assert done.stderr == "Kubbe: Press the dome.\n"
    forces = np.array([[float.fromhex(word) for word in line.split()]
                       for line in done.stdout.splitlines()])  # fmt: skip
    assert forces.shape == (TICKS, 3)
    assert (forces[:200] == 0.0).all()
    assert forces[-1, 2] > 0.01
    assert forces.tobytes() == felt(scene).tobytes()
    assert forces.tobytes() == felt(palpate.scenario.read(path).scene).tobytes()


@pytest.mark.landing
@pytest.mark.parametrize("organ", ["spleen", "gallbladder"])
def test_the_program_feels_in_the_file_of_a_shipped_organ_what_python_feels(player, organ):
    path = CHECKOUT / "meshes/published" / f"{organ}.palpate"

    done = run(player, path)

    assert done.returncode == 0, done.stderr
    forces = np.array([[float.fromhex(word) for word in line.split()]
                       for line in done.stdout.splitlines()])  # fmt: skip
    assert forces.shape == (TICKS, 3)
    assert forces[-1, 2] > 0.01
    assert forces.tobytes() == felt(palpate.scenario.read(path).scene).tobytes()


def test_the_program_refuses_a_damaged_file_in_a_sentence(player, published, tmp_path):
    damaged = tmp_path / "half.palpate"
    damaged.write_bytes(published[1].read_bytes()[:5000])

    done = run(player, damaged)

    assert done.returncode == 1
    assert done.stdout == ""
    assert f"{damaged}: got a damaged zip archive" in done.stderr

# SPDX-License-Identifier: BSD-3-Clause
"""What every Python test may ask for."""

from __future__ import annotations

import gc
import itertools
import os
import shutil
from collections.abc import Callable, Generator
from pathlib import Path

import pytest
from data_folder import find_data
from pytestqt.qtbot import QtBot
from tiers import name_test, read_list

CHECKOUT = Path(__file__).resolve().parents[1]

# before anybody imports Qt: no test may need a display. The screen of none has 800 x 800 pixels:
# what people work on has room for a window with all its docks
SCREEN = CHECKOUT / "tests" / "wide_screen.json"
os.environ.setdefault("QT_QPA_PLATFORM", f"offscreen:configfile={SCREEN}")
# the software renderer draws in the thread that asks: its work counts as that thread's
os.environ.setdefault("LP_NUM_THREADS", "0")
# before anybody imports numpy: what waits for threads of linear algebra, waits at work
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
# what tests compile is kept as ./run's own builds are
if shutil.which("ccache"):
    os.environ.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache")
    os.environ.setdefault("CCACHE_SLOPPINESS", "pch_defines,time_macros")


# [ms] what a test of a window waits for where it says nothing else: pytest-qt's own 5 s are too few
# for a processor that others share
for wait in (QtBot.waitUntil, QtBot.waitSignal, QtBot.waitSignals, QtBot.waitExposed):
    wait.__kwdefaults__["timeout"] = 60_000

# of later tiers, the latest first: the marks for which -m must ask, one of them, so that they run
TIERS = {"verify": ("verify",), "landing": ("landing", "window")}


def find_tier(item: pytest.Item) -> str | None:
    """The latest tier of its marks; None for an everyday test."""
    return next(filter(item.get_closest_marker, TIERS), None)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Tests of a later tier are left out: those of a landing run by `.ci/run`, their windows with
    all others on its X server; sweeps at full length by `./run verify`."""
    listed = {"landing": read_list("long.txt"), "verify": read_list("longest.txt")}
    for item in items:
        name = name_test(item.nodeid)
        for tier, names in listed.items():
            if name in names:
                item.add_marker(tier)
    asked = config.getoption("markexpr")
    left_out = {tier for tier, by in TIERS.items() if not any(mark in asked for mark in by)}
    later = [item for item in items if find_tier(item) in left_out]
    if later:
        config.hook.pytest_deselected(items=later)
        kept = set(items).difference(later)
        items[:] = [item for item in items if item in kept]


def pytest_collection_finish() -> None:
    """No collection of cycles goes through what was imported: with all tests that is 0.2 s each."""
    gc.collect()
    gc.freeze()


PROCESSOR_TIME = pytest.StashKey[float]()


def read_processor_time() -> float:
    """[s] of this process, and of its children that have ended."""
    return sum(os.times()[:4])


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> Generator[None, object, object]:
    item.stash[PROCESSOR_TIME] = read_processor_time()
    return (yield)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_teardown(item: pytest.Item) -> Generator[None, object, object]:
    """What a test took, its fixtures included, stands in the results; summarise.py adds it up."""
    try:
        return (yield)
    finally:
        used = read_processor_time() - item.stash[PROCESSOR_TIME]
        item.user_properties.append(("processor_s", f"{used:.2f}"))


NUMBERS = itertools.count()


@pytest.fixture(autouse=True)
def user_data(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The user's own data of one test, so that no test leaves a record in the real one."""
    # numbered here: mktemp lists the folders of all tests before this one to find a number
    folder = tmp_path_factory.getbasetemp() / "user_data" / str(next(NUMBERS))
    folder.mkdir(parents=True)
    monkeypatch.setenv("XDG_DATA_HOME", str(folder))
    return folder


FEW_DIRECTIONS = 4
"""Of the sky, in place of a hundred."""
FEW_CELLS = 24
"""Of the floor, each way."""


@pytest.fixture
def rough_frames(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Frames are as small as while things move, none is refined, and folds and floor are shaded
    roughly, unless a test is marked `fine`.

    A processor that stands in for a graphics card spends most of its time on that.
    """
    from palpate.render import ground
    from palpate.viewport import canvas, sky_light

    if not request.node.get_closest_marker("fine"):
        monkeypatch.setattr(sky_light, "DIRECTIONS", FEW_DIRECTIONS)
        monkeypatch.setattr(ground, "CELLS", FEW_CELLS)
        monkeypatch.setattr(canvas, "QUICK_SIZES", canvas.QUICK_SIZES[:1] * 5)
        monkeypatch.setattr(canvas.Canvas, "refine", lambda *frame: False)


@pytest.fixture
def little_sky(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures are lit from few directions, unless a test is marked `fine`.

    Half of what a picture costs is how much of the sky each vertex sees.
    """
    from palpate.render import openness

    if not request.node.get_closest_marker("fine"):
        monkeypatch.setattr(openness, "DIRECTIONS", 2 * FEW_DIRECTIONS)


@pytest.fixture
def turkish(qapp):
    """Sentences of windows are Turkish during the test."""
    from palpate import translation
    from PySide6.QtCore import QLocale

    translation.install(qapp, "tr")
    QLocale.setDefault(QLocale("tr"))
    yield
    translation.install(qapp, "en")
    QLocale.setDefault(QLocale("en"))


@pytest.fixture(scope="session")
def shared_data() -> Callable[[str], Path]:
    """shared_data("organs/VH_F_Spleen.glb") is that file; the test is skipped where it is not."""

    def find(path: str) -> Path:
        found = find_data() / path
        if not found.exists():
            pytest.skip(f"shared data: no {path} in PALPATE_DATA (default ../shared/data)")
        return found

    return find


@pytest.fixture(scope="session")
def checkout() -> Path:
    """The top folder of the source tree."""
    return CHECKOUT

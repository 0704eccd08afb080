# SPDX-License-Identifier: BSD-3-Clause
"""The type stub says what the compiled module offers, no more and no less."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import palpate
import palpate._sim

WRITER = Path(__file__).resolve().parents[2] / "bindings" / "write_stub.py"


def load_writer() -> ModuleType:
    spec = importlib.util.spec_from_file_location("write_stub", WRITER)
    writer = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(writer)
    return writer


def test_the_stub_is_what_write_stub_would_write():
    writer = load_writer()

    written = writer.STUB.read_text(encoding="utf-8")

    assert written == writer.render_stub(palpate._sim), "run python bindings/write_stub.py"


def test_the_stub_of_scenario_is_what_write_stub_would_write():
    writer = load_writer()

    written = writer.SCENARIO_STUB.read_text(encoding="utf-8")

    expected = writer.render_stub(palpate._sim._scenario, writer.SCENARIO_HEADER)
    assert written == expected, "run python bindings/write_stub.py"


def test_the_package_offers_everything_the_module_has():
    names = [name for name in vars(palpate._sim) if not name.startswith("_")]

    assert len(names) > 100
    for name in names:
        assert getattr(palpate, name) is getattr(palpate._sim, name)


def test_the_package_is_typed():
    assert (Path(palpate.__file__).with_name("py.typed")).is_file()

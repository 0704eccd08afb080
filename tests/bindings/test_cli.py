# SPDX-License-Identifier: BSD-3-Clause
"""The command line as a person or a script meets it: words in, exit code and report out."""

from __future__ import annotations

import json
import shlex
import subprocess
import sys

import pytest
from palpate.cli.main import (
    EDITOR_VERBS,
    build_parser,
    join_negative_values,
    load_verbs,
    main,
)
from palpate.command.verb import quantity

OUR_VERBS = ("doctor", "press", "replay", "render", "bench")


def test_every_promised_verb_is_there():
    assert set(OUR_VERBS) <= set(load_verbs())


@pytest.mark.parametrize("name", sorted(load_verbs()))
def test_help_shows_one_example_that_parses(name, capsys):
    verb = load_verbs()[name]

    assert main([name, "--help"]) == 0

    assert f"example: {verb.example}" in " ".join(capsys.readouterr().out.split())
    words = shlex.split(verb.example)
    assert words[:2] == ["palpate", name]
    build_parser(load_verbs()).parse_args(words[1:])  # exits 2, and fails, where it does not parse


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["fly"],
        ["press"],
        ["press", "a.json", "--depth", "6"],
        ["press", "a.json", "--depth", "six mm"],
        ["press", "a.json", "--depth", "nanmm"],
        ["render", "a.obj"],
        ["render", "a.obj", "-o", "a.png", "--time", "1s"],
        ["render", "a.obj", "-o", "a.png", "--size", "3x3"],
    ],
    ids=" ".join,
)
def test_a_wrong_call_exits_2_and_says_why(words, capsys):
    assert main(words) == 2

    assert "palpate" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["press", "replay", "render"])
def test_a_missing_file_exits_1_with_a_sentence_and_under_json_with_its_parts(
    name, tmp_path, capsys
):
    suffix = {"press": "json", "replay": "prec", "render": "obj"}[name]
    words = [name, str(tmp_path / f"none.{suffix}")]
    if name == "render":
        words += ["-o", str(tmp_path / "none.png")]

    assert main(words) == 1
    said = capsys.readouterr()
    assert said.out == "" and f"none.{suffix}" in said.err

    assert main([*words, "--json"]) == 1
    error = json.loads(capsys.readouterr().out)["error"]
    assert set(error) == {"file", "where", "got", "expected"}
    assert error["file"].endswith(f"none.{suffix}")


def test_doctor_reports_every_check_as_json(capsys):
    assert main(["doctor", "--json"]) == 0

    report = json.loads(capsys.readouterr().out)
    names = {check["name"] for check in report["checks"]}
    assert names == {
        "python",
        "editor",
        "graphics",
        "realtime",
        "mesh files",
        "serial ports",
        "shared data",
    }
    realtime = next(check for check in report["checks"] if check["name"] == "realtime")
    assert "ticks missed" in realtime["detail"]


def test_quantities_are_read_to_si_and_need_their_unit():
    assert quantity("m")("6mm") == pytest.approx(0.006)
    assert quantity("N/m3")("1.5e5N/m3") == 1.5e5
    assert quantity("J")("4e-4J") == 4e-4
    assert quantity("Pa")("5kPa") == 5000.0


def test_the_installed_command_runs_in_a_process_of_its_own():
    done = subprocess.run(
        [sys.executable, "-m", "palpate", "--version"], capture_output=True, encoding="utf-8"
    )

    assert done.returncode == 0
    assert done.stdout.startswith("palpate ")


def test_a_verb_of_a_missing_distribution_says_what_to_install(monkeypatch, capsys):
    monkeypatch.setattr("palpate.cli.main.entry_points", lambda group: [])

    assert main(["import", "a.stl", "-o", "a.obj"]) == 2

    assert "palpate-editor" in capsys.readouterr().err
    assert "import" in EDITOR_VERBS


def test_a_negative_number_with_its_unit_is_a_value_and_no_option():
    """argparse takes -2kPa for an option, and -2 for a number."""
    words = ["material", "a.organ", "--pressure", "-2kPa", "--gravity", "-1,0,-9.8"]

    joined = join_negative_values([*words, "--share", "-.5", "--json", "-o", "a.organ"])

    assert joined == [
        *("material", "a.organ", "--pressure=-2kPa", "--gravity=-1,0,-9.8"),
        *("--share=-.5", "--json", "-o", "a.organ"),
    ]
    assert join_negative_values(["a", "--b=1", "-2"]) == ["a", "--b=1", "-2"]
    assert join_negative_values(["a", "--", "--b", "-2"]) == ["a", "--", "--b", "-2"]
    call = build_parser(load_verbs()).parse_args(joined[:4] + ["--stretch-bend=-2N"])
    assert getattr(call, "model.pressure") == -2e3
    assert call.gravity == (-1.0, 0.0, -9.8)


def test_a_negative_stretch_bend_is_read_as_a_person_writes_it(tmp_path, capsys):
    assert main(["material", str(tmp_path / "none.organ"), "--stretch-bend", "-2N"]) == 1

    assert "none.organ" in capsys.readouterr().err  # the call is right, the file is not there

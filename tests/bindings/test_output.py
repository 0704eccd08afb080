# SPDX-License-Identifier: BSD-3-Clause
"""No output of any verb takes the place of a file of another kind, unless it is forced to."""

from __future__ import annotations

import argparse
import json
import os
import shlex
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.cli.main import build_parser, load_verbs, main
from palpate.command.output import DECLARED, require_replaceable
from palpate.files import file_kind
from palpate.files.file_kind import find_kind
from palpate.files.refusal import Refusal
from palpate.render.picture import write_png
from palpate.runs.script_file import write_script_file
from surfaces import organ_scene, press_frames, run_frames

READ = {
    "--library",
    "--scene",
    "--mesh",
    "--curve",
    "--constants",
    "--tool",
    "--script",
    "--truth",
    "--rerun",
    "--resume",
    "--original",
    "--organ",
} | {"--chart"}
"""Options that name a file to be read."""
PRECIOUS = b"the notes of a year\n"


def list_parsers(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    """A parser and those of all words below it."""
    yield parser
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for word in action.choices.values():
                yield from list_parsers(word)


PARSERS = list(list_parsers(build_parser(load_verbs())))
OUTPUTS = [
    (parser.prog.split()[1:], option)
    for parser in PARSERS
    for option, _, _ in parser.get_default(DECLARED) or ()
]
ARGUMENTS = {
    "device selftest": ["plant"],
    "study": ["accuracy"],
    "bench": [],
    "organs": ["spleen"],
    "records export": ["--csv"],
    "scene new": [],
    "scene publish": ["two.layout.json"],
    "scene task": ["two.layout.json"],
    "scenario new": ["spleen.palpate", "--title", "Mine"],
    "scenario selfplay": ["spleen.palpate"],
    "scenario review": ["a.palpate", "--of", "task", "--by", "A", "--role", "surgeon"],
    "scenario publish": ["spleen.palpate", "assessment.json"],
}
"""What a verb needs beside the option; else the words of its example."""


def find_words(words: list[str]) -> list[str]:
    known = ARGUMENTS.get(" ".join(words))
    return (
        [*words, *known] if known is not None else shlex.split(load_verbs()[words[0]].example)[1:]
    )


def test_every_option_that_names_a_file_is_an_output_or_known_to_be_read():
    left_over = {
        (parser.prog, action.option_strings[0])
        for parser in PARSERS
        for action in parser._actions
        if action.option_strings and action.type is Path
        if action.option_strings[0] not in READ
        if action.option_strings[0] not in [o for o, _, _ in parser.get_default(DECLARED) or ()]
    }

    assert left_over == set()
    assert len(OUTPUTS) > 15


@pytest.mark.parametrize(("words", "option"), OUTPUTS, ids=lambda value: " ".join(value))
def test_an_output_leaves_a_file_of_another_kind_alone(words, option, tmp_path, capsys):
    """Before anything is done: the example of the verb need not even exist."""
    call = build_parser(load_verbs()).parse_args([*find_words(words), option, str(tmp_path / "x")])
    list_files = next(lister for o, _, lister in getattr(call, DECLARED) if o == option)
    file = list_files(call)[-1][0]
    file.parent.mkdir(exist_ok=True)
    file.write_bytes(PRECIOUS)

    code = main([*find_words(words), option, str(tmp_path / "x")])

    said = capsys.readouterr().err
    assert code == 1
    assert f"{file}: {option}: got another file, expected" in said
    assert "--force" in said
    assert file.read_bytes() == PRECIOUS


@pytest.fixture
def files(tmp_path) -> dict[str, Path]:
    """A file of each kind, as its writer makes it."""
    scene = organ_scene(0)
    made = {name: tmp_path / f"{name}.file" for name in vars(file_kind)}
    palpate.write_record(made["RECORD"], run_frames(scene, press_frames()))
    scenario.write(made["PUBLISHED"], scenario.Scenario(scene=scene, title="A"))
    scenario.write_container(made["ORGAN"], scenario.Container(format="organ", version=3))
    write_script_file(made["SCRIPT"], press_frames())
    write_png(made["PICTURE"], np.zeros((4, 4, 3), np.uint8))
    made["SCENE"].write_text(
        json.dumps({"format": "palpate scene", "version": 1}), encoding="utf-8"
    )
    made["OBJ"].write_text("# palpate: unit m, up z\nv 0 0 0\n", encoding="utf-8")
    made["STL"].write_bytes(bytes(80) + (1).to_bytes(4, "little") + bytes(50))
    made["OTHER"].write_bytes(PRECIOUS)
    return {getattr(file_kind, name): path for name, path in made.items() if path.exists()}


def test_a_file_is_known_by_what_is_in_it(files):
    assert len(files) == 9
    for kind, path in files.items():
        assert find_kind(path) == kind


def test_only_an_older_file_of_the_same_kind_is_replaced_without_force(files):
    for written in set(files) - {file_kind.OTHER}:
        for kind, path in files.items():
            call = argparse.Namespace(out=path, force=False)
            setattr(call, DECLARED, [("--out", "out", lambda c, k=written: [(c.out, k)])])
            if kind == written:
                require_replaceable(call)
            else:
                with pytest.raises(Refusal, match="--force"):
                    require_replaceable(call)
            call.force = True
            require_replaceable(call)


@pytest.mark.parametrize(
    ("name", "kind", "sentence"),
    [
        ("a.palpate", file_kind.ORGAN, "a name of a published scenario, expected one of an organ, "
         "which ends in .organ"),
        ("a.ORGAN", file_kind.PUBLISHED, "a name of an organ"),
        ("a.prec", file_kind.PICTURE, "a name of a record"),
        ("a.png", file_kind.OBJ, "a name of a PNG picture, expected one of an OBJ mesh$"),
        ("a.svg", file_kind.CHART, "a name of an SVG picture"),
    ],
)  # fmt: skip
def test_a_name_of_another_kind_of_file_is_refused(tmp_path, name, kind, sentence):
    call = argparse.Namespace(out=tmp_path / name, force=True)
    setattr(call, DECLARED, [("--out", "out", lambda c: [(c.out, kind)])])

    with pytest.raises(Refusal, match=sentence):
        require_replaceable(call)


def test_a_new_name_an_empty_file_and_no_name_at_all_are_free(tmp_path):
    (tmp_path / "empty").touch()
    for path in (tmp_path / "new", tmp_path / "empty", None):
        call = argparse.Namespace(out=path, force=False)
        setattr(call, DECLARED, [("--out", "out", lambda c: [(c.out, file_kind.RECORD)])])

        require_replaceable(call)


def test_what_is_no_file_is_not_replaced_even_by_force(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path / "pipe", tmp_path, Path("/dev/null")):
        call = argparse.Namespace(out=path, force=True)
        setattr(call, DECLARED, [("--out", "out", lambda c: [(c.out, file_kind.RECORD)])])

        with pytest.raises(Refusal, match="something other than a file"):
            require_replaceable(call)


def test_a_damaged_archive_is_another_file(tmp_path, files):
    good = files[file_kind.ORGAN].read_bytes()
    for cut in range(1, len(good), 37):
        (tmp_path / "cut").write_bytes(good[:cut])

        assert find_kind(tmp_path / "cut") == file_kind.OTHER

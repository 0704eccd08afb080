# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes of a layout, by the words of `palpate scene` that make them: what the window does and
what it says that the command line does are one and the same."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import NoReturn

from palpate.cli.main import join_negative_values
from palpate.cli.scene import SCENE_VERB
from palpate.cli.scene_changes import CHANGES
from palpate.command.verb import WrongCall
from palpate.layout.document import Layout

Words = tuple[str, ...]
"""Behind `palpate scene`: the action, then what follows the file."""


class _Parser(argparse.ArgumentParser):
    """Raises what another would print."""

    def error(self, message: str) -> NoReturn:
        raise WrongCall(message)


@cache
def build_parser() -> argparse.ArgumentParser:
    parser = _Parser("scene")
    SCENE_VERB.add_arguments(parser)
    return parser


def change(path: Path, layout: Layout, words: Sequence[str]) -> Layout:
    """The layout of the file at `path` after `palpate scene ACTION FILE ...`. Raises LayoutError,
    WrongCall, Refusal or OSError."""
    action, *rest = words
    call = build_parser().parse_args([action, str(path), *join_negative_values(rest)])
    return CHANGES[action](layout, call)


def write_line(path: Path | str, words: Sequence[str]) -> list[str]:
    """The whole command."""
    action, *rest = words
    return ["palpate", "scene", action, str(path), *rest]


def write_three(numbers: Sequence[float], scale: float = 1.0) -> str:
    """X,Y,Z as these options take them, exact to a picometre."""
    return ",".join(f"{scale * float(x):.10g}" for x in numbers)

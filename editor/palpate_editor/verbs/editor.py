# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `editor`: opens the window; Qt is only loaded when it is called."""

from __future__ import annotations

import argparse
import logging
from pathlib import Path

from palpate.command.verb import Report, Verb
from palpate.files.refusal import Refusal
from palpate.system.display import require_display

LANGUAGES = ("en", "tr")
INSTEAD = (
    "these verbs do the editor's work without one: import, inspect, repair, decimate, material, "
    "check, press, publish"
)


def add_editor(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file", type=Path, nargs="?", help=".organ, .palpate, mesh or layout to begin with"
    )
    parser.add_argument("--theme", choices=("dark", "light"), help="default: as chosen last")
    parser.add_argument("--language", choices=LANGUAGES, help="default: as chosen last")


def run_editor(call: argparse.Namespace) -> Report:
    if call.file is not None and not call.file.is_file():
        raise Refusal(call.file, "", "no such file", "an .organ, a .palpate, a mesh or a layout")
    require_display(INSTEAD)
    logging.basicConfig(level=logging.WARNING, format="palpate editor: %(message)s")
    from palpate_editor.views.start import open_window

    return open_window(call.file, call.theme, call.language)


def describe_editor(report: Report) -> str:
    return "closed"


EDITOR = Verb(
    "editor",
    "open the organ editor",
    "palpate editor spleen.organ --theme light",
    add_editor,
    run_editor,
    describe_editor,
)

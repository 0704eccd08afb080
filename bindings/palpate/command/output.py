# SPDX-License-Identifier: BSD-3-Clause
"""Options that name a file to be written: none replaces a file of another kind by mistake.

Every such option of every verb is added by `add_output` or `add_output_folder`; the command checks
them all before a verb begins (cli.py). An older file of the same kind is replaced, as ever.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from palpate.files.file_kind import ENDINGS, NO_FILE, NOTHING, find_kind
from palpate.files.refusal import Refusal

Files = list[tuple[Path, str]]
"""Paths, and the kind of file that will stand there."""
Lister = Callable[[argparse.Namespace], Files]
DECLARED = "declared_outputs"
"""Of a parsed call: (option, what lists the files it writes) of every output."""


def add_output(
    parser: argparse.ArgumentParser,
    *flags: str,
    writes: str | Mapping[str, str],
    beside: Lister | None = None,
    **options: Any,
) -> None:
    """An option for one file, and --force with it.

    Args:
        parser: The verb's parser.
        flags: The option's names.
        writes: The kind that is written, or one for each ending of the name; "" for every other.
        beside: Lists what is written beside it, if anything.
        options: Of add_argument.
    """
    action = parser.add_argument(*flags, type=Path, **options)

    def list_files(call: argparse.Namespace) -> Files:
        path = getattr(call, action.dest)
        more = beside(call) if beside else []
        return [(path, choose_kind(path, writes)), *more]

    declare(parser, action, list_files)


def add_output_folder(
    parser: argparse.ArgumentParser, *flags: str, writes: Lister, **options: Any
) -> None:
    """An option for a folder, and --force with it; `writes` lists the files in it."""
    declare(parser, parser.add_argument(*flags, type=Path, **options), writes)


def declare(parser: argparse.ArgumentParser, action: argparse.Action, list_files: Lister) -> None:
    if not any("--force" in known.option_strings for known in parser._actions):
        parser.add_argument(
            "--force",
            action="store_true",
            help="let an output replace a file of another kind, such as an organ",
        )
    before = parser.get_default(DECLARED) or ()
    row = (action.option_strings[0], action.dest, list_files)
    parser.set_defaults(**{DECLARED: (*before, row)})


def choose_kind(path: Path, writes: str | Mapping[str, str]) -> str:
    if isinstance(writes, str):
        return writes
    return writes.get(path.suffix.lower(), writes.get("", NOTHING))


def require_replaceable(call: argparse.Namespace) -> None:
    """Raises Refusal where an output would take the place of what is no older output of its kind,
    or has the ending of another kind's names.

    --force replaces another kind of file, but never what is no file at all, and names none wrongly.
    """
    for option, name, list_files in getattr(call, DECLARED, ()):
        if getattr(call, name) is None:
            continue
        for path, kind in list_files(call):
            require_ending(option, path, kind)
            found = find_kind(path)
            if found == NO_FILE or (found not in (NOTHING, kind) and not call.force):
                expected = f"{kind}, or a new name"
                if found != NO_FILE:
                    expected += "; --force replaces it"
                raise Refusal(path, option, found, expected)


def require_ending(option: str, path: Path, kind: str) -> None:
    """Raises Refusal for a name that ends as those of another kind of file do."""
    named = ENDINGS.get(path.suffix.lower(), kind)
    if kind == NOTHING or named == kind:
        return
    own = [ending for ending, other in ENDINGS.items() if other == kind]
    expected = f"one of {kind}" + (f", which ends in {own[0]}" if own else "")
    raise Refusal(path, option, f"a name of {named}", expected)

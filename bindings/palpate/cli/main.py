# SPDX-License-Identifier: BSD-3-Clause
"""The `palpate` command: finds a verb, runs it, and says what came of it.

Exit codes: 0 done; 1 data was refused; 2 the call itself was wrong.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
from collections.abc import Sequence
from importlib.metadata import entry_points, version

from palpate import DeviceError, FileError
from palpate.command.output import require_replaceable
from palpate.command.terminal import make_harmless
from palpate.command.verb import Verb, WrongCall
from palpate.files.refusal import Refusal

EDITOR_VERBS = (
    *("inspect", "import", "decimate", "material", "appearance", "calibrate", "check", "repair"),
    *("publish", "organs", "demo", "editor", "segment", "tissues", "felt", "truth", "chart"),
    *("advise", "stability"),
)
"""Verbs of the palpate-editor distribution, to say what to install where it is missing."""
NEGATIVE = re.compile(r"-\.?\d")
"""How a negative number begins; no option does."""


def load_verbs() -> dict[str, Verb]:
    """Our own verbs and those that installed distributions plug in, by name."""
    from palpate.cli.verbs import VERBS

    verbs = {verb.name: verb for verb in VERBS}
    for point in entry_points(group="palpate.verbs"):
        try:
            plugged = point.load()
        except ImportError as problem:  # a broken editor must not take replay and play with it
            print(f"palpate: no verbs of '{point.value}': {problem}", file=sys.stderr)
            continue
        verbs |= {verb.name: verb for verb in plugged}
    return dict(sorted(verbs.items()))


def build_parser(verbs: dict[str, Verb]) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="palpate", description="Soft-tissue organ models that can be felt."
    )
    parser.add_argument("--version", action="version", version=f"palpate {version('palpate')}")
    subparsers = parser.add_subparsers(dest="verb", metavar="VERB", required=True)
    for verb in verbs.values():
        subparser = subparsers.add_parser(
            verb.name,
            help=verb.summary,
            description=verb.summary,
            epilog=f"example: {verb.example}",
        )
        subparser.add_argument(
            "--json", action="store_true", help="report as JSON on standard output"
        )
        verb.add_arguments(subparser)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    verbs = load_verbs()
    if arguments and arguments[0] in EDITOR_VERBS and arguments[0] not in verbs:
        print(
            f"palpate: '{arguments[0]}' belongs to the palpate-editor distribution, which is not "
            "installed or cannot be loaded: pip install palpate-editor",
            file=sys.stderr,
        )
        return 2
    parser = build_parser(verbs)
    try:
        call = parser.parse_args(join_negative_values(arguments))
    except SystemExit as stop:  # argparse has already said what is wrong
        return int(stop.code or 0)
    return run(verbs[call.verb], call)


def join_negative_values(arguments: Sequence[str]) -> list[str]:
    """The arguments with `--pressure -2kPa` as `--pressure=-2kPa`: argparse knows bare negative
    numbers only, and takes one with a unit for an option. What stands behind -- stays as it is."""
    joined: list[str] = []
    for word in arguments:
        before = joined[-1] if joined else ""
        is_value = NEGATIVE.match(word) and "--" not in joined
        if is_value and before.startswith("--") and "=" not in before:
            joined[-1] = f"{before}={word}"
        else:
            joined.append(word)
    return joined


def run(verb: Verb, call: argparse.Namespace) -> int:
    """Runs a verb; every refusal becomes a sentence or, under --json, an error object."""
    try:
        require_replaceable(call)
        report = verb.run(call)
    except WrongCall as wrong:
        print(make_harmless(f"palpate {verb.name}: {wrong}"), file=sys.stderr)
        return 2
    except (Refusal, FileError) as refusal:
        fields = {key: getattr(refusal, key) for key in ("file", "where", "got", "expected")}
        return refuse(call, str(refusal), fields)
    except (RuntimeError, DeviceError) as failure:  # a run that could not be brought to its end
        fields = {"file": None, "where": "", "got": str(failure), "expected": "a run to its end"}
        return refuse(call, str(failure), fields)
    except OSError as problem:  # a file that is missing, unreadable or cannot be written
        fields = {
            "file": str(problem.filename) if problem.filename else None,
            "where": "",
            "got": problem.strerror or str(problem),
            "expected": "a file that can be read or a place that can be written",
        }
        return refuse(call, f"{fields['file'] or 'file'}: {fields['got']}", fields)
    if call.json:
        print(json.dumps(report, indent=2, allow_nan=False))
    else:
        print(make_harmless(verb.describe(report)))
    sys.stdout.flush()
    return 1 if verb.failed(report) else 0


def refuse(call: argparse.Namespace, sentence: str, fields: dict[str, str | None]) -> int:
    if call.json:
        print(json.dumps({"error": fields}, indent=2, allow_nan=False))
    else:
        print(make_harmless(f"palpate {call.verb}: {sentence}"), file=sys.stderr)
    return 1


def run_main() -> None:
    """The console script: a closed pipe downstream is not an error worth a traceback."""
    try:
        code = main()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        code = 1
    except KeyboardInterrupt:
        code = 130
    sys.exit(code)

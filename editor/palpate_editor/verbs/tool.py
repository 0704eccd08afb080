# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that gives an organ its instrument, and says what it costs: tool."""

from __future__ import annotations

import argparse
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, plain_number, quantity
from palpate.files.file_kind import ORGAN
from palpate.files.refusal import Refusal
from palpate.runs.costs import hold_costs
from palpate.scene.instrument_kinds import KINDS

from palpate_editor.check import split_refusal
from palpate_editor.compile import compile_organ
from palpate_editor.document import Organ
from palpate_editor.document.constants import find_constant
from palpate_editor.document.files import write_organ
from palpate_editor.document.idle import find_idle
from palpate_editor.edits import Edit, SetConstant
from palpate_editor.verbs.files import ReadFile, apply, open_any

EXPECTED = {
    "trocar_height": "a length above 0, or none of it",
    "jaw_opening": "a length above 0, or none of it",
    "grip_force": "jaws that open, or none of it",
}
"""What a number that has no effect asks for."""
OPTIONS = {
    "radius": "--radius",
    "length": "--length",
    "friction": "--friction",
    "trocar_height": "--trocar-height",
    "jaw_opening": "--jaw-opening",
    "grip_force": "--grip-force",
}
"""Every number, and what it is called in a call."""


def add_tool(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate, or OBJ of `palpate import`")
    parser.add_argument(
        "shape", nargs="?", choices=tuple(KINDS), help="what it is; what it was without one"
    )
    parser.add_argument("--radius", type=quantity("m"), help="of the tip and the shaft")
    parser.add_argument(
        "--length", type=quantity("m"), help="of the shaft that touches; 0mm: a ball"
    )
    parser.add_argument(
        "--friction", type=plain_number(), help="Coulomb's coefficient; 0: it slides"
    )
    parser.add_argument(
        "--trocar-height",
        type=quantity("m"),
        help="over the organ, where the shaft passes the abdominal wall; 0mm: the device turns it",
    )
    parser.add_argument(
        "--jaw-opening", type=plain_number("rad"), help="[rad] of each jaw; 0: it has none"
    )
    parser.add_argument("--grip-force", type=quantity("N"), help="with which jaws close at most")
    add_output(parser, "--out", "-o", writes=ORGAN, help=".organ to write; without one, nothing is")


def list_edits(call: argparse.Namespace) -> list[tuple[str, Edit]]:
    """What the call asks for, by its options: numbers count before those of the shape."""
    shape = KINDS.get(call.shape)
    edits: list[tuple[str, Edit]] = []
    for name, option in OPTIONS.items():
        value = getattr(call, name)
        if value is None and shape is not None:
            option, value = "SHAPE", getattr(shape, name, None)
        if value is not None:
            edits.append((option, SetConstant("tool", name, value)))
    return edits


def run_tool(call: argparse.Namespace) -> Report:
    read, organ = ReadFile.of(call.file), open_any(call.file)
    if organ.surface is None:
        raise Refusal(call.file, "", "no surface", "an organ that has one")
    for option, edit in list_edits(call):
        organ = apply(edit, organ, call.file, option)
    refuse_idle(call, organ)
    try:
        costs = hold_costs(compile_organ(organ))
    except ValueError as refused:
        where, found, expected = split_refusal(str(refused))
        raise Refusal(call.file, where, found, expected) from None
    if call.out is not None:
        read.check(call.out)
        write_organ(call.out, organ)
    return {
        "file": str(call.file),
        **{name: getattr(organ.tool, name) for name in OPTIONS},
        "instrument_us": 1e6 * costs.instruments[0].median,
        "contact_us": 1e6 * costs.pairs[0].median,
        "tick_us": 1e6 * costs.tick.median,
        "ended_by_alarm": bool(costs.alarm),
        "out": None if call.out is None else str(call.out),
    }


def refuse_idle(call: argparse.Namespace, organ: Organ) -> None:
    """Refuses a number that has no effect on what touches."""
    for name, option in OPTIONS.items():
        constant = find_constant("tool", name)
        if getattr(call, name) is None or constant is None:
            continue
        if (idle := find_idle(constant, organ)) is not None:
            found = f"{getattr(call, name):g}, which has no effect here: {idle.why}"
            raise Refusal(call.file, option, found, EXPECTED[name])


def describe_tool(report: Report) -> str:
    radius, length = 1e3 * report["radius"], 1e3 * report["length"]
    what = f"a ball of {radius:g} mm"
    if length > 0.0:
        height = 1e3 * report["trocar_height"]
        turned = f"by a trocar {height:g} mm over the organ" if height else "by the device"
        what = f"a shaft of {radius:g} mm that touches on {length:g} mm, turned {turned}"
        if opening := report["jaw_opening"]:
            what = (
                f"two jaws of {radius:g} mm, {length:g} mm long, that open by {opening:g} rad each "
                f"and close with {report['grip_force']:g} N, turned {turned}"
            )
    while_it = "holds" if length > 0.0 and report["jaw_opening"] else "touches"
    lines = [
        f"{report['file']}: {what}, friction {report['friction']:g}",
        f"of a tick of {report['tick_us']:.0f} us while it {while_it}: "
        f"{report['contact_us']:.0f} us of contact, {report['instrument_us']:.0f} us of hand and "
        "air (medians on this machine)",
    ]
    if report["ended_by_alarm"]:
        lines.append("ended early by an alarm, maybe before it touched")
    if report["out"]:
        lines.append(f"wrote {report['out']}")
    return "\n".join(lines)


VERBS = [
    Verb(
        "tool",
        "give an organ its instrument, and say what it costs in a tick",
        "palpate tool spleen.organ probe --friction 0.1 -o probe.organ",
        add_tool,
        run_tool,
        describe_tool,
    )
]

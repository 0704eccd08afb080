# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that gives a surface its tissue, a tool and a hand: material."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path

import palpate
from palpate.command.output import Files, add_output
from palpate.command.verb import Report, Verb, quantity
from palpate.files.file_kind import OBJ, ORGAN, SCENE
from palpate.files.refusal import Refusal
from palpate.scene.scene_parts import FILLED
from palpate.study.scene_chart import FAR_FIELDS

from palpate_editor.argument_text import LAWS, NONE
from palpate_editor.check import (
    Assessment,
    assess,
    describe_model,
    describe_problem,
    split_refusal,
)
from palpate_editor.compile import compile_organ
from palpate_editor.document import EMPTY, Organ
from palpate_editor.document.constants import CHOICES, CONSTANTS, SHORT_KINDS, Constant
from palpate_editor.document.far_compliance import is_stale, wants_far_field
from palpate_editor.document.files import write_organ
from palpate_editor.document.idle import Idle, find_idle, find_idle_choice, say_unused
from palpate_editor.document.problems import Problem
from palpate_editor.edits import (
    FixLowest,
    SetChoice,
    SetConstant,
    SetFarField,
    SetFineRegion,
    SetGravity,
    SetReach,
)
from palpate_editor.far_field import SolveFarField
from palpate_editor.foresee import foresee_too_slow
from palpate_editor.kinds import compare_kinds, describe_kinds
from palpate_editor.scene_files import name_mesh, write_scene
from palpate_editor.verbs.check import describe_problems
from palpate_editor.verbs.files import ReadFile, apply, open_any
from palpate_editor.verbs.tissue_library import add_tissue_options, set_tissues


def read_constant(constant: Constant, unit: str) -> Callable[[str], float | str]:
    number: Callable[[str], float] = quantity(unit) if unit else float

    def read(text: str) -> float | str:
        return NONE if constant.optional and text == NONE else number(text)

    read.__name__ = getattr(number, "__name__", "number")
    return read


def list_beside(call: argparse.Namespace) -> Files:
    """The mesh of a scene file that is made of anything but an OBJ."""
    if call.out.suffix == ".organ" or call.file.suffix == ".obj":
        return []
    return [(name_mesh(call.out), OBJ)]


def add_material(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .scene.json, or OBJ of `palpate import`")
    add_output(
        parser,
        "--out",
        "-o",
        writes={".organ": ORGAN, "": SCENE},
        beside=list_beside,
        help=".organ, or scene file to write; without one, every kind is built and compared",
    )
    parser.add_argument(
        "--kind",
        choices=tuple(SHORT_KINDS),
        help="mass-spring, molecular, shell of prisms, solid, linear solid (shallow "
        "presses), corotated or neo-Hookean solid",
    )
    add_tissue_options(parser)
    for constant in CONSTANTS:
        unit = constant.option_unit
        default = getattr(getattr(EMPTY, constant.part), constant.field)
        usual = constant.absent if default is None else f"{default:g} {unit}".strip()
        also = f"; '{NONE}': {constant.absent}" if constant.optional else ""
        parser.add_argument(
            constant.option,
            dest=constant.key,
            type=read_constant(constant, unit),
            metavar=unit.upper() or "NUMBER",
            help=f"{constant.label} ({usual}){also}",
        )
    for key, option in LAWS.items():
        parser.add_argument(option, dest=key, choices=CHOICES[key])
    parser.add_argument(
        "--far-field",
        choices=FAR_FIELDS,
        help="of a solid with contact as on tissue, how the organ gives way beyond the ball: "
        "solved now on a finer mesh, some seconds; or that of the tetrahedra it ticks on",
    )
    parser.add_argument(
        "--reach",
        metavar="REGION",
        help="of a linear solid: the region on which it can be pushed, so that its response is "
        f"smaller; elsewhere it does not give ('{NONE}': all of the surface)",
    )
    parser.add_argument(
        "--fine",
        metavar="REGION",
        help=f"of a solid: where it is filled finer, by --fine-ratio ('{NONE}': nowhere)",
    )
    parser.add_argument(
        "--gravity", type=read_vector, metavar="X,Y,Z", help="[m/s²] of the organ (0,0,0)"
    )
    parser.add_argument(
        "--fix-lowest",
        type=float,
        default=0.0,
        metavar="SHARE",
        help="hold this share of the height, from below (0.1)",
    )


def read_vector(text: str) -> tuple[float, ...]:
    try:
        numbers = tuple(float(parser) for parser in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != 3:
        raise argparse.ArgumentTypeError(f"got {text!r}, expected X,Y,Z")
    return numbers


def set_constants(call: argparse.Namespace, organ: Organ) -> Organ:
    """The organ with what the call names; the rest as it is in the file."""
    organ = set_tissues(call, organ)
    if call.kind is not None:
        organ = apply(SetChoice("kind", SHORT_KINDS[call.kind]), organ, call.file, "--kind")
    for key, option in LAWS.items():
        law = getattr(call, key)
        if law is not None:
            edit = SetChoice(key.removeprefix("model."), law)
            organ = apply(edit, organ, call.file, option)
    for constant in CONSTANTS:
        value = getattr(call, constant.key)
        if value is not None:
            edit = SetConstant(constant.part, constant.field, None if value == NONE else value)
            organ = apply(edit, organ, call.file, constant.option)
    if call.reach is not None:
        everywhere = call.reach == NONE and NONE not in organ.regions
        organ = apply(SetReach("" if everywhere else call.reach), organ, call.file, "--reach")
    if call.fine is not None:
        nowhere = call.fine == NONE and NONE not in organ.regions
        organ = apply(SetFineRegion("" if nowhere else call.fine), organ, call.file, "--fine")
    if call.gravity is not None:
        organ = apply(SetGravity(call.gravity), organ, call.file, "--gravity")
    if call.fix_lowest != 0.0:
        organ = apply(FixLowest(call.fix_lowest), organ, call.file, "--fix-lowest")
    # what is held counts, so this comes last
    if call.far_field is not None and call.far_field != find_far_field(organ):
        edit = SolveFarField() if call.far_field == "fine" else SetFarField(None)
        organ = apply(edit, organ, call.file, "--far-field")
    return organ


def find_far_field(organ: Organ) -> str:
    """One of FAR_FIELDS, or empty where there is none that could be one."""
    if not wants_far_field(organ):
        return ""
    return "mesh" if organ.far_field is None else "" if is_stale(organ) else "fine"


def require_effects(call: argparse.Namespace, organ: Organ) -> None:
    """Raises Refusal for the first option that changes nothing that `organ`, as the call leaves
    it, is felt by."""
    for constant in CONSTANTS:
        value = getattr(call, constant.key)
        idle = None if value is None else find_idle(constant, organ)
        if idle is not None:
            shown = constant.describe(None if value == NONE else value)
            refuse_idle(call, constant.option, shown, idle)
    for key, option in LAWS.items():
        value = getattr(call, key)
        idle = value and find_idle_choice(key.removeprefix("model."), value, organ)
        if idle:
            refuse_idle(call, option, value, idle)
    if call.fine not in (None, NONE) and organ.model.kind not in FILLED:
        idle = Idle(say_unused(organ.model.kind), "--kind solid with it")
        refuse_idle(call, "--fine", call.fine, idle)
    if call.reach not in (None, NONE) and organ.model.kind != "linear_solid":
        refuse_idle(
            call,
            "--reach",
            call.reach,
            Idle(say_unused(organ.model.kind), "--kind linear with it"),
        )


def refuse_idle(call: argparse.Namespace, option: str, value: str, idle: Idle) -> None:
    raise Refusal(call.file, option, f"{value}, which has no effect here: {idle.why}", idle.instead)


def require_compared(call: argparse.Namespace) -> None:
    """Raises Refusal for an option that no kind has a use for where all are compared."""
    options = [(c.option, getattr(call, c.key)) for c in CONSTANTS if c.chosen]
    options += [(option, getattr(call, key)) for key, option in LAWS.items()]
    for option, value in [*options, ("--kind", call.kind), ("--far-field", call.far_field)]:
        if value is not None and option != LAWS["model.damping_law"]:
            idle = Idle(
                "without --out every kind is built of the tissue and compared",
                "--out with it",
            )
            refuse_idle(call, option, f"{value}", idle)


def run_material(call: argparse.Namespace) -> Report:
    read = ReadFile.of(call.file)
    if call.out is None:
        require_compared(call)
    organ = set_constants(call, open_any(call.file))
    if call.out is not None:
        require_effects(call, organ)
    if call.out is None:
        return {"out": None, **compare_kinds(organ, call.file)}
    if organ.model.kind in FILLED and call.out.suffix != ".organ":
        raise Refusal(
            call.file,
            "--out",
            call.out.name,
            "a name ending in .organ: a scene file has no tetrahedra",
        )
    assessment = build_assessed(call, organ)
    compiled = assessment.scene
    assert compiled is not None
    read.check(call.out)
    if call.out.suffix == ".organ":
        write_organ(call.out, organ)
    else:
        write_scene(call.out, organ, call.file if call.file.suffix == ".obj" else None)
    tissue = compiled.bodies[0].tissue
    named = ("material", "model", "fill", "tool", "hand")
    parts = {name: asdict(getattr(organ, name)) for name in named}
    parts["model"] |= {"fixed": len(tissue.fixed), "stiffness_scale": None}
    return {
        "out": str(call.out),
        "scene": parts,
        "particles": len(tissue.mass),
        "springs": len(tissue.springs.ends),
        "bonds": len(tissue.bonds.ends),
        "angles": 3 * len(tissue.angles.corners),
        "tetrahedra": len(palpate.list_tetrahedra(tissue)),
        "response_bytes": compiled.bodies[0].response.size.bytes
        if compiled.bodies[0].response
        else None,
        "fixed": len(tissue.fixed),
        "total_mass_g": 1e3 * palpate.compute_total_mass(tissue),
        "stable_step_ms": 1e3 * palpate.stable_step(tissue),
        "substeps": compiled.bodies[0].substeps,
        "description": describe_model(compiled),
        "problems": [describe_problem(p) for p in assessment.problems if is_of_tissue(p)],
    }


def build_assessed(call: argparse.Namespace, organ: Organ) -> Assessment:
    """The organ built and judged as `check` and `publish` judge its tissue. Raises Refusal for what
    cannot be built, and for the first error of the tissue."""
    refuse_too_slow(call, organ)
    assessment = assess(organ, measured=say_size)
    if assessment.scene is None:
        try:
            compile_organ(organ)
        except ValueError as problem:
            raise Refusal(call.file, *split_refusal(str(problem))) from None
    for problem in assessment.errors:
        if is_of_tissue(problem) or assessment.scene is None:
            raise Refusal(call.file, problem.where, problem.got, problem.expected)
    return assessment


def refuse_too_slow(call: argparse.Namespace, organ: Organ) -> None:
    """Raises Refusal for a solid of which it is known in a second that it is too slow; made and
    tried it would take minutes."""
    try:
        slow = foresee_too_slow(organ)
    except ValueError:
        return  # which the assessment says better
    if slow is not None:
        got = f"{organ.fill.tetrahedra}, which asks for {slow.got}"
        raise Refusal(call.file, "fill.tetrahedra", got, f"fewer than about {round(slow.most, -3)}")


def is_of_tissue(problem: Problem) -> bool:
    """Whether the material has a part in it, and not the shape of the surface alone."""
    return problem.stage == "material" or problem.key in ("too_slow", "size")


def say_size(size: palpate.ResponseSize) -> None:
    """On standard error; the report alone goes to standard output."""
    text = f"{1e-6 * size.bytes:.1f} MB for {size.pushed} of {size.moved} particles"
    print(f"its response takes {text}", file=sys.stderr, flush=True)


def describe_material(report: Report) -> str:
    if report["out"] is None:
        return describe_kinds(report)
    written = f"wrote {report['out']}: {report['description']}, {report['fixed']} fixed"
    if report["response_bytes"] is None:  # else nothing of it swings
        written += f", stable step {report['stable_step_ms']:.3f} ms"
    lines = describe_problems(report["problems"]) if report["problems"] else []
    return "\n".join([written, *lines])


VERBS = [
    Verb(
        "material",
        "give an organ its tissue, a tool and a hand; what is not named stays as it is",
        "palpate material spleen.organ --kind mms --stiffness 60N/m --home 1.5e5N/m3 "
        "-o spleen.organ",
        add_material,
        run_material,
        describe_material,
    ),
]

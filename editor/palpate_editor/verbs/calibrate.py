# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that fits an organ's constants to a measured curve: calibrate."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING

import palpate
from palpate.cli.press import read_point
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, quantity
from palpate.files.file_kind import ORGAN, PICTURE
from palpate.files.refusal import Refusal
from palpate.runs.press import find_place, find_top
from palpate.scene.scene_parts import FILLED
from palpate.study.curve import Curve, read_curve

from palpate_editor.check import split_refusal
from palpate_editor.compile import compile_organ, mesh_of
from palpate_editor.document import Organ
from palpate_editor.document.constants import CONSTANTS
from palpate_editor.document.files import write_organ
from palpate_editor.edits import SetConstant
from palpate_editor.verbs.files import ReadFile, apply, open_any

if TYPE_CHECKING:
    from palpate.study.calibrate import Fit

CHOSEN = (("model", "stiffness"), ("model", "bend_stiffness"), ("model", "stretch_coupling"))
TISSUE = (("material", "young_modulus"),)
HOME = (("model", "home_stiffness"),)
FITS = ("all", "springs", "home", "both")
"""What --fit names: one factor of everything elastic, of one part of it, or one of each part."""
FROM_TISSUE = ("shell", *FILLED)
"""Kinds whose constants always come from the material."""

Field = tuple[str, str]
"""A part of an organ, and a constant of it."""


def name_factors(organ: Organ, fit: str) -> dict[str, tuple[Field, ...]]:
    """Every factor of a fit and the constants that it multiplies."""
    from_tissue = organ.model.constants == "tissue" or organ.model.kind in FROM_TISSUE
    springs = TISSUE if from_tissue else CHOSEN
    parser = "Young's modulus" if from_tissue else "springs"
    return {
        "all": {"elastic constants": (*springs, *HOME)},
        "springs": {parser: springs},
        "home": {"home springs": HOME},
        "both": {parser: springs, "home springs": HOME},
    }[fit]


def read_field(organ: Organ, field: Field) -> float:
    return getattr(getattr(organ, field[0]), field[1]) or 0.0


def add_calibrate(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .scene.json or .palpate")
    parser.add_argument(
        "--curve",
        type=Path,
        required=True,
        help="CSV of depth and force, units in the header: 'depth [mm], force [N]'",
    )
    parser.add_argument("--fit", choices=FITS, default="all", help="what is fitted (all)")
    parser.add_argument(
        "--at",
        type=read_point,
        metavar="X,Y,Z",
        help="where it was measured: the surface point nearest to this [mm]; default: from above",
    )
    parser.add_argument(
        "--tip-radius", type=quantity("m"), metavar="M", help="of the indenter (the organ's tool)"
    )
    add_output(
        parser, "--out", "-o", writes=ORGAN, help="the organ with the fitted constants, .organ"
    )
    add_output(parser, "--plot", writes=PICTURE, help="measured and fitted curve as PNG")


def scaled(organ: Organ, fit: str, factors: Sequence[float]) -> Organ:
    """The organ with the constants that a fit names multiplied."""
    for fields, factor in zip(name_factors(organ, fit).values(), factors, strict=True):
        for part, field in fields:
            value = getattr(getattr(organ, part), field)
            if value is not None:
                changed = replace(getattr(organ, part), **{field: factor * value})
                organ = replace(organ, **{part: changed})
    return organ


def prepare(call: argparse.Namespace) -> Organ:
    """The organ of the call with the indenter as its tool and its home springs in numbers."""
    organ = open_any(call.file)
    if organ.surface is None:
        raise Refusal(call.file, "organ", "no surface", "an imported mesh")
    if organ.model.home_stiffness is None and organ.model.kind not in FILLED:
        material = palpate.Material(**asdict(organ.material))
        usual = palpate.default_home_stiffness(mesh_of(organ.surface), material)
        organ = replace(organ, model=replace(organ.model, home_stiffness=usual))
    if call.tip_radius is not None:
        organ = replace(organ, tool=replace(organ.tool, radius=call.tip_radius))
    for name, fields in name_factors(organ, call.fit).items():
        if not any(read_field(organ, field) for field in fields):
            raise Refusal(call.file, "model", f"no {name}", "a constant above 0 to fit")
    return organ


def fit_organ(call: argparse.Namespace, organ: Organ, curve: Curve) -> Fit:
    # loads SciPy, which every other command does without
    from palpate.study.calibrate import NotFitted, fit_factors
    from palpate.study.indent import OutOfReach, measure_indentation

    def forces(factors: Sequence[float]):
        scene = compile_organ(scaled(organ, call.fit, factors))
        place = find_top(scene) if call.at is None else find_place(scene, call.at)
        return measure_indentation(scene, place, curve.depth)

    try:
        return fit_factors(curve, tuple(name_factors(organ, call.fit)), forces)
    except OutOfReach as problem:
        raise Refusal(call.curve, "depth", str(problem), "depths that the tool can reach") from None
    except NotFitted as problem:
        raise Refusal(call.curve, "", str(problem), "a curve that tells the constants") from None
    except ValueError as problem:
        raise Refusal(call.file, *split_refusal(str(problem))) from None


def write_fitted(call: argparse.Namespace, read: ReadFile, fitted: Organ) -> None:
    """The organ of the call with the constants that were fitted; its own tool stays."""
    organ = open_any(call.file)
    for constant in CONSTANTS:
        value = getattr(getattr(fitted, constant.part), constant.field)
        if constant.part == "tool" or value == getattr(
            getattr(organ, constant.part), constant.field
        ):
            continue
        edit = SetConstant(constant.part, constant.field, value)
        organ = apply(edit, organ, call.file, constant.option)
    read.check(call.out)
    write_organ(call.out, organ)


def run_calibrate(call: argparse.Namespace) -> Report:
    curve = read_curve(call.curve)
    if call.out is not None and call.out.suffix != ".organ":
        raise Refusal(call.out, "", f"a name ending in {call.out.suffix!r}", ".organ")
    read = ReadFile.of(call.file)
    organ = prepare(call)
    fit = fit_organ(call, organ, curve)
    fitted = scaled(organ, call.fit, fit.factors)
    if call.out is not None:
        write_fitted(call, read, fitted)
    if call.plot is not None:
        from palpate.study.fit_plot import save_fit_plot

        save_fit_plot(call.plot, curve, fit, f"{organ.name or call.file.stem}: {call.curve.name}")
    fields = [field for group in name_factors(organ, call.fit).values() for field in group]
    return {
        "organ": str(call.file),
        "curve": str(call.curve),
        "points": len(curve.depth),
        "factors": [
            {"name": name, "factor": factor, "low": low, "high": high}
            for name, factor, low, high in zip(
                fit.names, fit.factors, fit.low, fit.high, strict=True
            )
        ],
        "before": {field[1]: read_field(organ, field) for field in fields},
        "after": {field[1]: read_field(fitted, field) for field in fields},
        "residual_N": fit.residual,
        "residual_of_peak": fit.residual / float(curve.force.max()),
        "explained": fit.explained,
        "misses_shape": fit.misses_shape(),
        "evaluations": fit.evaluations,
        "out": str(call.out) if call.out else None,
        "plot": str(call.plot) if call.plot else None,
    }


def describe_calibrate(report: Report) -> str:
    lines = [
        f"{found['name']:18} x {found['factor']:.4g}  (95 %: {found['low']:.4g} to "
        f"{found['high']:.4g})"
        for found in report["factors"]
    ]
    lines += [
        f"  {name:16} {before:.4g} -> {report['after'][name]:.4g}"
        for name, before in report["before"].items()
        if before
    ]
    lines.append(
        f"residual           {1e3 * report['residual_N']:.3g} mN root mean square, "
        f"{report['residual_of_peak']:.2%} of the peak; R² {report['explained']:.4f} "
        f"of {report['points']} points"
    )
    if report["misses_shape"]:
        lines.append(
            "what is left over is no noise: the model's curve has another shape, and the true "
            "factors may lie outside of these intervals"
        )
    lines += [f"wrote {report[key]}" for key in ("out", "plot") if report[key]]
    return "\n".join(lines)


VERBS = [
    Verb(
        "calibrate",
        "fit an organ's constants to a measured force-indentation curve",
        "palpate calibrate liver.organ --curve liver.csv -o fitted.organ --plot fit.png",
        add_calibrate,
        run_calibrate,
        describe_calibrate,
    ),
]

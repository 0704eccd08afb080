# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that fits an organ's constants to a measured curve: calibrate."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import asdict, replace
from pathlib import Path

import palpate
from palpate.press import find_place, find_top
from palpate.study.calibrate import Fit, NotFitted, fit_factors
from palpate.study.curve import Curve, read_curve
from palpate.study.fit_plot import save_fit_plot
from palpate.study.indent import OutOfReach, measure_indentation
from palpate.verb import Refusal, Report, Verb, quantity
from palpate.verbs import read_point

from palpate_editor.check import split_refusal
from palpate_editor.compile import compile_organ, mesh_of
from palpate_editor.document import Organ
from palpate_editor.document.files import write_organ
from palpate_editor.verbs.files import open_any

ELASTIC = ("stiffness", "bend_stiffness", "stretch_coupling")
FITS = {
    "all": (("elastic constants", (*ELASTIC, "home_stiffness")),),
    "springs": (("springs", ELASTIC),),
    "home": (("home springs", ("home_stiffness",)),),
    "both": (("springs", ELASTIC), ("home springs", ("home_stiffness",))),
}
"""What --fit names: factors, each with the constants of the model that it multiplies."""


def add_calibrate(word: argparse.ArgumentParser) -> None:
    word.add_argument("file", type=Path, help=".organ, .scene.json or .palpate")
    word.add_argument(
        "--curve",
        type=Path,
        required=True,
        help="CSV of depth and force, units in the header: 'depth [mm], force [N]'",
    )
    word.add_argument("--fit", choices=tuple(FITS), default="all", help="what is fitted (all)")
    word.add_argument(
        "--at",
        type=read_point,
        metavar="X,Y,Z",
        help="where it was measured: the surface point nearest to this [mm]; default: from above",
    )
    word.add_argument(
        "--tip-radius", type=quantity("m"), metavar="M", help="of the indenter (the organ's tool)"
    )
    word.add_argument("--out", "-o", type=Path, help="the organ with the fitted constants, .organ")
    word.add_argument("--plot", type=Path, help="measured and fitted curve as PNG")


def scaled(organ: Organ, fit: str, factors: Sequence[float]) -> Organ:
    """The organ with the constants that a fit names multiplied."""
    for (_, constants), factor in zip(FITS[fit], factors, strict=True):
        values = {name: factor * getattr(organ.model, name) for name in constants}
        organ = replace(organ, model=replace(organ.model, **values))
    return organ


def prepare(call: argparse.Namespace) -> Organ:
    """The organ of the call with the indenter as its tool and its home springs in numbers."""
    organ = open_any(call.file)
    if organ.surface is None:
        raise Refusal(call.file, "organ", "no surface", "an imported mesh")
    if organ.model.home_stiffness is None:
        material = palpate.Material(**asdict(organ.material))
        usual = palpate.default_home_stiffness(mesh_of(organ.surface), material)
        organ = replace(organ, model=replace(organ.model, home_stiffness=usual))
    if call.tip_radius is not None:
        organ = replace(organ, tool=replace(organ.tool, radius=call.tip_radius))
    for name, constants in FITS[call.fit]:
        if not any(getattr(organ.model, constant) for constant in constants):
            raise Refusal(call.file, "model", f"no {name}", "a constant above 0 to fit")
    return organ


def fit_organ(call: argparse.Namespace, organ: Organ, curve: Curve) -> Fit:
    def forces(factors: Sequence[float]):
        scene = compile_organ(scaled(organ, call.fit, factors))
        place = find_top(scene) if call.at is None else find_place(scene, call.at)
        return measure_indentation(scene, place, curve.depth)

    names = [name for name, _ in FITS[call.fit]]
    try:
        return fit_factors(curve, names, forces)
    except OutOfReach as problem:
        raise Refusal(call.curve, "depth", str(problem), "depths that the tool can reach") from None
    except NotFitted as problem:
        raise Refusal(call.curve, "", str(problem), "a curve that tells the constants") from None
    except ValueError as problem:
        raise Refusal(call.file, *split_refusal(str(problem))) from None


def run_calibrate(call: argparse.Namespace) -> Report:
    curve = read_curve(call.curve)
    if call.out is not None and call.out.suffix != ".organ":
        raise Refusal(call.out, "", f"a name ending in {call.out.suffix!r}", ".organ")
    organ = prepare(call)
    fit = fit_organ(call, organ, curve)
    fitted = scaled(organ, call.fit, fit.factors)
    if call.out is not None:
        write_organ(call.out, replace(fitted, tool=open_any(call.file).tool))
    if call.plot is not None:
        save_fit_plot(call.plot, curve, fit, f"{organ.name or call.file.stem}: {call.curve.name}")
    constants = [name for _, names in FITS[call.fit] for name in names]
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
        "before": {name: getattr(organ.model, name) for name in constants},
        "after": {name: getattr(fitted.model, name) for name in constants},
        "residual_N": fit.residual,
        "residual_of_peak": fit.residual / float(curve.force.max()),
        "explained": fit.explained,
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

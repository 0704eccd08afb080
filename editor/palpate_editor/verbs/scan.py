# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb that makes an organ of a scan: segment."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall, quantity

from palpate_editor.document import EMPTY
from palpate_editor.edits.inspected import inspect_surface
from palpate_editor.from_scan import import_scan
from palpate_editor.scan import (
    MOST_SMOOTHING,
    USUAL_SMOOTHING,
    Choice,
    Limits,
    Scan,
    describe_choice,
    read_range,
    read_scan,
)
from palpate_editor.verbs.decimate import decimate_to, describe_decimate
from palpate_editor.verbs.files import OUTPUTS, write_any
from palpate_editor.verbs.source import UNITS


def read_threshold(text: str) -> tuple[float | None, float | None]:
    try:
        return read_range(text)
    except ValueError as problem:
        raise argparse.ArgumentTypeError(str(problem)) from None


def add_segment(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file",
        type=Path,
        help="volume of NIfTI, NRRD, MetaImage or legacy VTK, or a folder of DICOM slices",
    )
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument(
        "--label",
        type=int,
        action="append",
        default=[],
        metavar="NUMBER",
        help="of the voxels of the organ; may be repeated; without it and --threshold the volume "
        "is described",
    )
    chosen.add_argument(
        "--threshold",
        type=read_threshold,
        metavar="LOW:HIGH",
        help="grey levels of the organ, both ends included; either may be left out",
    )
    parser.add_argument(
        "--smooth",
        type=float,
        metavar="VOXELS",
        help="width of a Gaussian that takes stairs away without shrinking, 0 to "
        f"{MOST_SMOOTHING:g} ({USUAL_SMOOTHING:g} for labels, 0 for a range)",
    )
    parser.add_argument(
        "--largest", action="store_true", help="the largest piece alone, without cavities"
    )
    parser.add_argument(
        "--least-volume",
        type=quantity("m3"),
        default=0.0,
        metavar="VOLUME",
        help="of a piece or cavity that is kept, such as 0.5ml",
    )
    parser.add_argument("--series", metavar="UID", help="of several in a folder of DICOM slices")
    parser.add_argument("--unit", choices=UNITS, help="of the volume's spacing; default: mm")
    parser.add_argument("--vertices", type=int, help="decimate to exactly this many")
    parser.add_argument(
        "--time-limit",
        type=quantity("s"),
        default=Limits.time,
        metavar="TIME",
        help=f"that reading may take ({Limits.time:g} s)",
    )
    add_output(
        parser,
        "--output",
        "--out",
        "-o",
        writes=OUTPUTS,
        help=".organ, or a mesh file in metres, z up; without it nothing is written",
    )


def run_segment(call: argparse.Namespace) -> Report:
    limits = Limits(time=call.time_limit)
    if not call.label and call.threshold is None:
        require_choice(call)
        return report_scan(read_scan(call.file, series=call.series, limits=limits))
    low, high = call.threshold or (None, None)
    try:
        choice = Choice(tuple(call.label), low, high, call.smooth, call.largest, call.least_volume)
    except ValueError as problem:
        raise WrongCall(str(problem)) from None
    edit, found = import_scan(call.file, choice, series=call.series, unit=call.unit, limits=limits)
    organ = edit(EMPTY)
    assert organ.surface is not None and organ.segmentation is not None
    report = {
        "out": None if call.output is None else str(call.output),
        "scan": report_scan(found.scan),
        "chosen": describe_choice(choice),
        "segmentation": asdict(organ.segmentation),
        "cut_sides": list(found.cut_sides),
        "notes": list(edit.source.notes),
    }
    if call.vertices is not None:
        organ, report["decimated"] = decimate_to(organ, call.vertices, call.file)
    assert organ.surface is not None
    report["mesh"] = inspect_surface(organ.surface).as_dict()
    if call.output is not None:
        write_any(call.output, organ)
    return report


def require_choice(call: argparse.Namespace) -> None:
    """Raises WrongCall for an option that has no effect where a volume is only described."""
    given = {
        "--smooth": call.smooth is not None,
        "--largest": call.largest,
        "--least-volume": call.least_volume != 0.0,
        "--unit": call.unit is not None,
        "--vertices": call.vertices is not None,
        "--output": call.output is not None,
    }
    for option, is_given in given.items():
        if is_given:
            raise WrongCall(f"{option} needs --label or --threshold: which voxels are the organ")


def report_scan(scan: Scan) -> Report:
    voxel_ml = 1e6 * scan.voxel_volume
    return {
        "format": scan.format,
        "size": list(scan.size),
        "spacing_mm": (1e3 * scan.spacing).tolist(),
        "tilt_deg": scan.tilt,
        "type": scan.type,
        "range": [scan.low, scan.high],
        "labels": None
        if scan.labels is None
        else [
            {"label": row.label, "name": row.name, "volume_ml": voxel_ml * row.voxels}
            for row in scan.labels
        ],
        "notes": list(scan.notes),
    }


def describe_scan(report: Report) -> str:
    size = " x ".join(map(str, report["size"]))
    spacing = " x ".join(f"{length:.4g}" for length in report["spacing_mm"])
    low, high = report["range"]
    lines = [
        f"{report['format']}: {size} voxels of {spacing} mm, {report['type']}, {low:g} to {high:g}"
    ]
    if report["labels"] is None:
        lines.append("grey levels: choose a range with --threshold LOW:HIGH")
    else:
        lines += [
            f"label {row['label']}: {row['volume_ml']:.4g} ml {row['name']}".rstrip()
            for row in report["labels"]
        ] or ["no label but 0"]
    return "\n".join(lines + [f"note: {note}" for note in report["notes"]])


def describe_segment(report: Report) -> str:
    if "segmentation" not in report:
        return describe_scan(report)
    done, mesh = report["segmentation"], report["mesh"]
    size = " x ".join(map(str, done["size"]))
    spacing = " x ".join(f"{1e3 * length:.4g}" for length in done["spacing"])
    smoothed = (
        f"smoothed by {done['smooth']:g} voxels, which changes the volume by "
        f"{100.0 * done['volume_change']:+.2f} %"
        if done["smooth"]
        else "not smoothed"
    )
    lines = [
        f"{report['chosen']} of {size} voxels of {spacing} mm",
        f"{1e6 * done['voxel_volume']:.4g} ml of voxels, {1e6 * done['volume']:.4g} ml inside the "
        f"surface; {smoothed}",
        f"dropped: {done['pieces_dropped']} piece(s) of voxels, {done['shells_dropped']} shell(s)",
    ]
    lines += [f"note: {note}" for note in report["notes"]]
    if "decimated" in report:
        lines.append(describe_decimate(report["decimated"]))
    wrote = "wrote nothing" if report["out"] is None else f"wrote {report['out']}"
    lines.append(
        f"{wrote}: {mesh['vertices']} vertices, {mesh['triangles']} triangles, "
        f"{mesh['shells']} shell(s), {'closed' if mesh['closed'] else 'open'}"
    )
    return "\n".join(lines)


VERBS = [
    Verb(
        "segment",
        "cut an organ out of a scan, by label or by grey levels",
        "palpate segment ct_labels.nii.gz --label 1 --largest --vertices 600 -o spleen.organ",
        add_segment,
        run_segment,
        describe_segment,
    ),
]

# SPDX-License-Identifier: GPL-3.0-or-later
"""The designer's verbs: inspect, import, decimate, material, check, demo."""

from __future__ import annotations

import argparse
import sys
from dataclasses import asdict
from pathlib import Path

import numpy as np
import palpate
from palpate.mesh_file import read_mesh_file
from palpate.scene_file import compile_scene, hash_file, write_scene_file
from palpate.scene_parts import HandPart, MaterialPart, ModelPart, OrganPart, SceneFile, ToolPart
from palpate.verb import Refusal, Report, Verb, quantity

from palpate_editor import authoring
from palpate_editor.check import check_file, describe_model
from palpate_editor.demo import CONSTANTS, run_demo
from palpate_editor.edits.fix import find_lowest

UNITS = ("m", "cm", "mm", "in")
UPS = ("x", "y", "z", "-x", "-y", "-z")


def add_source(word: argparse.ArgumentParser) -> None:
    word.add_argument(
        "--part",
        action="append",
        default=[],
        metavar="NAME",
        help="part of the file to use, may be repeated; default: all, welded",
    )
    word.add_argument("--unit", choices=UNITS, help="of the file; default: stated or guessed")
    word.add_argument("--up", choices=UPS, help="axis of the file; default: stated or z")


# ---------------------------------------------------------------- inspect


def add_inspect(word: argparse.ArgumentParser) -> None:
    word.add_argument("file", type=Path, help="mesh file")
    add_source(word)


def run_inspect(call: argparse.Namespace) -> Report:
    scene = authoring.read_mesh(call.file)
    joined = authoring.join_parts(scene, parts=call.part, unit=call.unit, up=call.up)
    return {
        **authoring.inspect_mesh(joined.mesh).as_dict(),
        "unit": joined.unit,
        "unit_guessed": joined.unit_guessed,
        "unit_reason": joined.unit_reason,
        "up": joined.up,
        "up_guessed": joined.up_guessed,
        "up_reason": joined.up_reason,
        "format": scene.format,
        "parts": [
            {"name": part.name, "triangles": len(part.mesh.triangles)} for part in scene.parts
        ],
        "parts_used": list(joined.parts),
        "welded_vertices": joined.welded_vertices,
        "notes": list(scene.notes),
    }


def describe_inspect(report: Report) -> str:
    def known(value: object, unit: str = "") -> str:
        return "unknown" if value is None else f"{value:.4g}{unit}"

    loops = report["border_loops"]
    guess = "guessed" if report["unit_guessed"] else "stated"
    lines = [
        f"{report['vertices']} vertices, {report['triangles']} triangles, "
        f"{report['shells']} shell(s), genus {known(report['genus'])}",
        "closed"
        if report["closed"]
        else f"open: {len(loops)} border loop(s) of {', '.join(map(str, loops))} vertices",
        f"outward: {'unknown' if report['outward'] is None else report['outward']}",
        f"{report['non_manifold_edges']} non-manifold edges, "
        f"{known(report['self_intersecting_faces'])} self-intersecting faces, smallest angle "
        f"{known(report['smallest_angle_deg'], ' degrees')}",
        f"size {' x '.join(f'{length:.1f}' for length in report['size_mm'])} mm, volume "
        f"{known(report['volume_ml'], ' ml')}",
        f"unit {report['unit']} ({guess}: {report['unit_reason']})",
        f"up {report['up']} ({report['up_reason']})",
        "parts: " + ", ".join(f"{p['name']} ({p['triangles']})" for p in report["parts"]),
    ]
    return "\n".join(lines + [f"note: {note}" for note in report["notes"]])


# ---------------------------------------------------------------- import


def add_import(word: argparse.ArgumentParser) -> None:
    word.add_argument("file", type=Path, help="OBJ, STL, PLY, GLB, 3DS, FBX or DAE")
    add_source(word)
    word.add_argument("--vertices", type=int, help="decimate to exactly this many")
    word.add_argument("--out", "-o", type=Path, required=True, help="OBJ in metres, z up")


def run_import(call: argparse.Namespace) -> Report:
    imported = authoring.import_mesh(call.file, parts=call.part, unit=call.unit, up=call.up)
    mesh, repaired, joined = imported.mesh, imported.repaired, imported.joined
    report = {
        "out": str(call.out),
        "unit": joined.unit,
        "unit_guessed": joined.unit_guessed,
        "unit_reason": joined.unit_reason,
        "up": joined.up,
        "up_reason": joined.up_reason,
        "parts_used": list(joined.parts),
        "welded_vertices": joined.welded_vertices,
        "repaired": {
            name: getattr(repaired, name)
            for name in (
                "duplicate_triangles",
                "degenerate_triangles",
                "unused_vertices",
                "split_vertices",
                "turned_triangles",
            )
        },
    }
    if call.vertices is not None:
        mesh, report["decimated"] = decimate_to(mesh, call.vertices)
    report["mesh"] = authoring.inspect_mesh(mesh).as_dict()
    authoring.write_mesh(call.out, mesh)
    return report


def decimate_to(mesh: palpate.SurfaceMesh, vertices: int) -> tuple[palpate.SurfaceMesh, Report]:
    try:
        small = authoring.decimate(mesh, vertices)
    except ValueError as problem:
        raise Refusal(None, "--vertices", str(vertices), str(problem)) from None
    return small.mesh, {
        "vertices_before": len(mesh.vertices),
        "vertices": len(small.mesh.vertices),
        "triangles_before": len(mesh.triangles),
        "triangles": len(small.mesh.triangles),
        "smallest_angle_deg": small.smallest_angle_deg,
        "mean_distance_mm": 1e3 * small.mean_distance,
        "max_distance_mm": 1e3 * small.max_distance,
        "self_intersecting_faces": small.self_intersecting_faces,
    }


def describe_import(report: Report) -> str:
    mesh = report["mesh"]
    loops = mesh["border_loops"]
    done = ", ".join(
        f"{count} {name.replace('_', ' ')}" for name, count in report["repaired"].items() if count
    )
    lines = [
        f"parts {', '.join(report['parts_used'])}; {report['welded_vertices']} vertices welded",
        f"unit {report['unit']}: {report['unit_reason']}; up {report['up']}: {report['up_reason']}",
        f"repaired: {done or 'nothing to do'}",
        "closed"
        if not loops
        else f"{len(loops)} hole(s) of {', '.join(map(str, loops))} vertices, kept open",
    ]
    if "decimated" in report:
        lines.append(describe_decimate(report["decimated"]))
    lines.append(
        f"wrote {report['out']}: {mesh['vertices']} vertices, {mesh['triangles']} triangles"
    )
    return "\n".join(lines)


# ---------------------------------------------------------------- decimate


def add_decimate(word: argparse.ArgumentParser) -> None:
    word.add_argument("mesh", type=Path, help="OBJ written by `palpate import`")
    word.add_argument("--vertices", type=int, required=True, help="exactly this many")
    word.add_argument("--out", "-o", type=Path, required=True, help="OBJ to write")


def run_decimate(call: argparse.Namespace) -> Report:
    mesh, report = decimate_to(read_mesh_file(call.mesh), call.vertices)
    authoring.write_mesh(call.out, mesh)
    return {"out": str(call.out), **report}


def describe_decimate(report: Report) -> str:
    return (
        f"decimated {report['vertices_before']} / {report['triangles_before']} to "
        f"{report['vertices']} / {report['triangles']}; smallest angle "
        f"{report['smallest_angle_deg']:.1f} degrees; {report['mean_distance_mm']:.3f} mm from the "
        f"source on average, {report['max_distance_mm']:.3f} mm at most"
    )


# ---------------------------------------------------------------- material


def add_material(word: argparse.ArgumentParser) -> None:
    material, model, tool, hand = MaterialPart(), ModelPart(), ToolPart(), HandPart()
    word.add_argument("mesh", type=Path, help="OBJ written by `palpate import`")
    word.add_argument("--out", "-o", type=Path, required=True, help="scene file to write")
    word.add_argument(
        "--kind", choices=("mss", "mms"), default="mss", help="mass-spring or molecular"
    )
    word.add_argument(
        "--stiffness",
        type=quantity("N/m"),
        default=model.stiffness,
        help="of every spring or bond (50N/m)",
    )
    word.add_argument("--bend", type=quantity("J"), default=0.0, help="K_theta per corner (mms)")
    word.add_argument(
        "--stretch-bend", type=quantity("N"), default=0.0, help="K_btheta per corner (mms)"
    )
    word.add_argument("--home", type=quantity("N/m3"), help="home springs; default: by kind")
    word.add_argument(
        "--wall",
        type=quantity("m"),
        help="wall thickness of a hollow organ or sheet; none for a solid",
    )
    word.add_argument("--density", type=quantity("kg/m3"), default=material.density)
    word.add_argument(
        "--damping",
        type=float,
        default=material.damping_ratio,
        help="ratio of one link between its end masses (0.2)",
    )
    word.add_argument("--drag", type=quantity("1/s"), default=model.drag)
    word.add_argument("--pressure", type=quantity("Pa"), default=0.0)
    word.add_argument(
        "--fix-lowest",
        type=float,
        default=0.0,
        metavar="SHARE",
        help="hold this share of the height, from below (0.1)",
    )
    word.add_argument("--tool-radius", type=quantity("m"), default=tool.radius)
    word.add_argument(
        "--coupling",
        type=quantity("N/m"),
        default=hand.coupling,
        help="of the hand's spring, K of Eq 12 (1000N/m)",
    )


def run_material(call: argparse.Namespace) -> Report:
    mesh = read_mesh_file(call.mesh)
    if call.mesh.resolve().parent != call.out.resolve().parent:
        raise Refusal(
            call.out,
            "",
            "a scene file in another folder than its mesh",
            "the same folder, so that both move together",
        )
    scene = SceneFile(
        organ=OrganPart(call.mesh.stem, call.mesh.name, hash_file(call.mesh)),
        material=MaterialPart(
            density=call.density, damping_ratio=call.damping, wall_thickness=call.wall
        ),
        model=ModelPart(
            kind={"mss": "mass_spring", "mms": "molecular"}[call.kind],
            stiffness=call.stiffness,
            bend_stiffness=call.bend,
            stretch_coupling=call.stretch_bend,
            home_stiffness=call.home,
            pressure=call.pressure,
            drag=call.drag,
            fixed=tuple(find_lowest(np.asarray(mesh.vertices), call.fix_lowest).tolist())
            if call.fix_lowest > 0.0
            else (),
        ),
        tool=ToolPart(radius=call.tool_radius),
        hand=HandPart(coupling=call.coupling),
    )
    try:
        compiled = compile_scene(scene, mesh)
    except ValueError as problem:
        raise Refusal(call.mesh, "", str(problem), "constants a tissue can have") from None
    write_scene_file(call.out, scene)
    tissue = compiled.tissue
    return {
        "out": str(call.out),
        "scene": asdict(scene)
        | {"model": {**asdict(scene.model), "fixed": len(tissue.fixed), "stiffness_scale": None}},
        "particles": len(tissue.mass),
        "springs": len(tissue.springs.ends),
        "bonds": len(tissue.bonds.ends),
        "angles": 3 * len(tissue.angles.corners),
        "fixed": len(tissue.fixed),
        "total_mass_g": 1e3 * palpate.compute_total_mass(tissue),
        "stable_step_ms": 1e3 * palpate.stable_step(tissue),
        "substeps": compiled.substeps,
        "description": describe_model(compiled),
    }


def describe_material(report: Report) -> str:
    return (
        f"wrote {report['out']}: {report['description']}, {report['fixed']} fixed, stable step "
        f"{report['stable_step_ms']:.3f} ms"
    )


# ---------------------------------------------------------------- check


def add_check(word: argparse.ArgumentParser) -> None:
    word.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")


def run_check(call: argparse.Namespace) -> Report:
    return check_file(call.file)


def describe_check(report: Report) -> str:
    lines = [f"{report['file']}: {report['description']}"]
    for problem in report["problems"]:
        lines.append(
            f"  {problem['severity']:7} {problem['where']}: found {problem['found']}, "
            f"expected {problem['expected']}"
        )
    if not report["problems"]:
        lines.append("  no problems")
    return "\n".join(lines)


# ---------------------------------------------------------------- demo


def add_demo(word: argparse.ArgumentParser) -> None:
    word.add_argument("--mesh", type=Path, help="organ to use; default: a generated spleen")
    word.add_argument("--vertices", type=int, default=600, help="of the model (600)")
    word.add_argument("--out", type=Path, default=Path("demo"), help="folder (demo)")
    word.add_argument("--constants", type=Path, default=CONSTANTS, help="TOML; default: demo.toml")
    add_source(word)


def run_demo_verb(call: argparse.Namespace) -> Report:
    def say(line: str) -> None:
        print(line, file=sys.stderr, flush=True)

    try:
        return run_demo(
            call.out,
            call.mesh,
            call.vertices,
            call.constants,
            tuple(call.part),
            call.unit,
            call.up,
            say,
        )
    except ValueError as problem:
        raise Refusal(call.mesh, "", str(problem), "an organ a tissue can be built on") from None


def describe_demo(report: Report) -> str:
    def row(kind: str) -> str:
        r = report[kind]
        return (
            f"{kind}: peak {r['peak_force_N']:.2f} N, pull {r['pull_force_N']:.2f} N, patch "
            f"{r['patch_stiffness_N_per_m']:.0f} N/m, tick {r['tick_median_us']:.0f} us, "
            f"replay {'equal' if r['replay_equal'] else 'DIFFERS'}"
        )

    return "\n".join(
        [
            f"{report['organ']}: {report['vertices']} vertices, {report['triangles']} triangles",
            row("mss"),
            row("mms"),
        ]
    )


VERBS = [
    Verb(
        "inspect",
        "say what is good and bad about a mesh file",
        "palpate inspect VH_F_Spleen.glb --json",
        add_inspect,
        run_inspect,
        describe_inspect,
    ),
    Verb(
        "import",
        "read a mesh file, weld, repair, orient, and write it in metres, z up",
        "palpate import VH_F_Spleen.glb -o spleen.obj",
        add_import,
        run_import,
        describe_import,
    ),
    Verb(
        "decimate",
        "reduce a surface to an exact vertex count with well-shaped triangles",
        "palpate decimate spleen.obj --vertices 600 -o spleen600.obj",
        add_decimate,
        run_decimate,
        describe_decimate,
    ),
    Verb(
        "material",
        "give a surface its tissue, a tool and a hand: a scene file",
        "palpate material spleen600.obj --kind mms --stiffness 60N/m --home 1.5e5N/m3 "
        "-o spleen.scene.json",
        add_material,
        run_material,
        describe_material,
    ),
    Verb(
        "check",
        "list every problem of a scene file",
        "palpate check spleen.scene.json",
        add_check,
        run_check,
        describe_check,
        failed=lambda report: any(p["severity"] == "error" for p in report["problems"]),
    ),
    Verb(
        "demo",
        "run the main job from mesh file to felt force",
        "palpate demo --mesh VH_F_Spleen.glb --out demo",
        add_demo,
        run_demo_verb,
        describe_demo,
        failed=lambda report: not all(report[kind]["replay_equal"] for kind in ("mss", "mms")),
    ),
]

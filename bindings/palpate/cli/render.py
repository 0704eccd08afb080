# SPDX-License-Identifier: BSD-3-Clause
"""The verb `render`: a picture of an organ, with no display."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import palpate
from palpate.command.output import add_output
from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.files.file_kind import PICTURE
from palpate.files.refusal import Refusal
from palpate.runs.pictures import picture_of_record, picture_of_rest
from palpate.runs.run import is_published, read_scene
from palpate.scene.mesh_file import read_mesh_file


def add_render(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file", type=Path, help="scene, published file, record, or OBJ of `palpate import`"
    )
    add_output(parser, "--out", "-o", writes=PICTURE, required=True, help="PNG to write")
    parser.add_argument(
        "--scene", type=Path, help="of a record, where its scene was moved; default: as it says"
    )
    parser.add_argument(
        "--time", type=quantity("s"), help="of a record; default: at its peak force"
    )
    parser.add_argument("--size", type=read_size, default=(1280, 720), metavar="WxH")
    parser.add_argument("--theme", choices=("dark", "light"), default="dark")
    parser.add_argument("--azimuth", type=float, default=-60.0, help="[degree] of the camera (-60)")
    parser.add_argument("--elevation", type=float, default=25.0, help="[degree] (25)")
    parser.add_argument("--no-wireframe", action="store_true")


def read_size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    if not (
        width.isdigit()
        and height.isdigit()
        and 64 <= int(width) <= 8192
        and 64 <= int(height) <= 8192
    ):
        raise argparse.ArgumentTypeError(f"got {text!r}, expected WIDTHxHEIGHT, each 64 to 8192")
    return int(width), int(height)


def run_render(call: argparse.Namespace) -> Report:
    options: dict[str, Any] = {
        "size": call.size,
        "theme": call.theme,
        "azimuth": call.azimuth,
        "elevation": call.elevation,
        "wireframe": not call.no_wireframe,
    }
    if call.file.suffix == ".prec":
        time = picture_of_record(call.out, call.file, call.time, options, scene_path=call.scene)
        return {"picture": str(call.out), "time_s": time}
    if call.time is not None:
        raise WrongCall(
            f"--time: got {call.file}, expected a record (.prec): others have only their rest"
        )
    if call.file.suffix == ".obj":
        mesh = read_mesh_file(call.file)
    elif is_published(call.file):
        # loads the renderer, which other verbs do without
        from palpate.render.authored_appearance import find_appearance, find_colours

        made = palpate.scenario.read(call.file)
        mesh, options["appearance"] = made.scene, find_appearance(made)
        options["vertex_colours"] = find_colours(made)
    elif call.file.suffix == ".json":
        mesh = read_scene(call.file)
    else:
        raise Refusal(
            call.file,
            "",
            f"a name ending in {call.file.suffix!r}",
            ".palpate (published), .json (scene), .prec (record) or .obj",
        )
    picture_of_rest(call.out, mesh, call.file.stem, options)
    return {"picture": str(call.out), "time_s": None}


def describe_render(report: Report) -> str:
    time = report["time_s"]
    return report["picture"] + ("" if time is None else f" (at {time:.3f} s)")


RENDER = Verb(
    "render",
    "draw an organ, at rest or as a record left it, with no display",
    "palpate render press.prec -o press.png",
    add_render,
    run_render,
    describe_render,
)

# SPDX-License-Identifier: BSD-3-Clause
"""Places as they are said on the command line."""

from __future__ import annotations

import argparse

from palpate.assessment.author import AuthorError, Json


def add_at(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--at",
        metavar="PLACE",
        help="a place of the assessment, region:NAME of the organ (of several region:ORGAN/NAME), "
        "ball:X,Y,Z,RADIUS or path:X,Y,Z:X,Y,Z..., in metres; of a scene with stones "
        "object:NAME as well, and space:X,Y,Z,RADIUS of the scene itself",
    )


def find_place(made: Json, told: str) -> Json:
    """The place of region:, ball: or path:."""
    kind, _, rest = told.partition(":")
    organ = next(iter(made["organs"]))
    if kind == "region":
        named = rest.partition("/")[0] in made["organs"]
        return {"region": rest if named else f"{organ}/{rest}"}
    if kind == "ball":
        return {"organ": organ, "ball": read_numbers(rest, 4)}
    if kind == "path":
        points = [read_numbers(point, 3) for point in rest.split(":")]
        return {"organ": organ, "path": points}
    if kind == "object":
        known = made.get("objects", {})
        if rest not in known:
            raise AuthorError(
                f"--at: got {told!r}, expected object: and one of {', '.join(known) or 'none'}"
            )
        return {"object": rest}
    if kind == "space":
        return {"space": read_numbers(rest, 4)}
    raise AuthorError(f"--at: got {told!r}, expected region:, ball:, path:, object: or space:")


def read_numbers(text: str, count: int) -> list[float]:
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != count:
        raise AuthorError(f"--at: got {text!r}, expected {count} numbers with commas between [m]")
    return numbers

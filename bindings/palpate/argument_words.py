# SPDX-License-Identifier: BSD-3-Clause
"""What the arguments of the compiled functions are: shape, unit and meaning.

One name is one thing throughout the library, so it stands here once; the compiled module adds the
lines to the documentation of every function that takes such an argument.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from palpate.refused_call import read_signature

WORDS = {
    "a": "[m] shape (3,), a corner",
    "b": "[m] shape (3,), a corner",
    "bend_stiffness": "[J] K_theta of every corner",
    "bulk": "[Pa] shape (t,), of each tetrahedron",
    "c": "[m] shape (3,), a corner",
    "centre": "[m] shape (3,)",
    "corners": "particle indices, shape (t, 4)",
    "counts": "[counts] six, 0 to 1023",
    "coupling": "[N/m] that a tool may add at any one particle",
    "d": "[m] shape (3,), a corner",
    "damping_time": "[s] in which strain follows stress",
    "direction": "[-] shape (3,), of any length but zero",
    "drag": "[1/s]",
    "dt": "[s]",
    "f": "[N] shape (n, 3), float64, C order, written to",
    "far": "[m/N] shape (n, 6): xx, yy, zz, xy, yz, zx per vertex; empty: that of the mesh",
    "force": "[N] shape (3,)",
    "frames": "the key frames of the script, in order",
    "from_": "[m] shape (3,)",
    "gimbal": "[rad] shape (3,)",
    "gravity": "[m/s²] shape (3,)",
    "hand_position": "[m] shape (3,)",
    "hand_rate": "[Hz] at which hands are read",
    "home": "[N/m] shape (n,) or empty, per particle",
    "internal": "[-] or [m] shape (k,) or empty",
    "joints": "[rad] shape (3,): yaw, elevation, forearm",
    "lame": "[Pa] shape (t,), lambda of each tetrahedron",
    "latest": "[ns] of the monotonic clock",
    "mass": "[kg] shape (n,), per particle",
    "max_distance": "[m]",
    "modulus": "[Pa] E / (1 - nu²) of the tissue",
    "nodal_share": "[-] 0 to 1",
    "origin": "[m] shape (3,)",
    "out": "triangle indices, shape (k,), int32, C order, written to",
    "p": "[m] shape (3,)",
    "pressure": "[Pa]",
    "proportion": "[-] three, one per corner",
    "pushes": "a structured array with the fields of Push, shape (k,), or a list of Push",
    "radius": "[m]",
    "rates": "[rad/s] shape (3,)",
    "rest": "[m] shape (n, 3), particles at rest",
    "rest_area": "[m²]",
    "rest_areas": "[m²] shape (t,), per triangle",
    "rest_volume": "[m³] shape (t,), of each tetrahedron",
    "samples": "a structured array with the fields of HapticSample, shape (k,), or a list of these",
    "scratch": "[-] shape (n,), float64, C order: work space, written to",
    "seconds": "[s]",
    "shear": "[Pa] shape (t,), mu of each tetrahedron",
    "step": "between two neighbouring readings, [-] in their unit",
    "stiffness": "[N/m]",
    "stiffness_scale": "[-] shape (n,) or empty, per particle",
    "surface": "[m] shape (n, 3), float64, C order, written to",
    "surface_vertices": "indices, shape (k,), or a mask, shape (n,)",
    "t": "three vertex indices",
    "time": "[s] since the run began",
    "timeout": "[s]",
    "tip": "[m] shape (3,)",
    "to": "[m] shape (3,)",
    "tool_position": "[m] shape (3,)",
    "jaw_angle": "[rad] by which each jaw is open",
    "orientation": "[-] shape (4,), of the tool's frame: unit quaternion (x, y, z, w)",
    "torque": "[N·m] shape (3,)",
    "torque_max": "[N·m] shape (3,)",
    "triangles": "vertex indices, shape (t, 3), counter-clockwise from outside",
    "v": "[m/s] shape (n, 3), velocities",
    "value": "the reading, [-] in its own unit",
    "vertices": "[m] shape (n, 3)",
    "viscosity": "[Pa·s] shape (t,), eta of each tetrahedron",
    "weights": "[-] shape (3,), barycentric",
    "work": "[J]",
    "x": "[m] shape (n, 3), positions",
}
"""By the name of the argument."""

SPECIAL = {
    "build_membrane_molecular.bend_stiffness": "[J] of every corner; no bearing on the stretch",
    "find_in_sphere.centre": "[m] shape (3,), of the ball",
    "is_positive_definite.stiffness": "[N/m] shape (3, 3), symmetric",
    "describe_fault.value": "[m] or [m/s] that the fault found",
    "compute_torque.torque_max": "[N·m] shape (3,), of each motor",
}
"""By function and argument, where the name alone does not say it all."""

FIELDS = "Arguments are the fields of these names, with their shapes and units."


def read_parameters(doc: str) -> list[str]:
    """The names of the arguments of all overloads, in order."""
    names: dict[str, None] = {}
    for line in doc.splitlines():
        if re.match(r"(?:\d+\. )?\w+\(.*\) -> ", line) and "*args" not in line:
            names |= dict.fromkeys(parameter.name for parameter in read_signature(line))
    return list(names)


def document(name: str, doc: str, fields: Collection[str]) -> str:
    """The documentation of `name` with its arguments; `fields` are those of its class, if any."""
    known = read_parameters(doc)
    if name.endswith(".__init__") and not known and len(doc.strip().splitlines()) == 1:
        return f"{doc.rstrip()}\n\nEvery field at its first value.\n"
    if not known or "    Args:" in doc:
        return doc
    is_made = name.endswith(".__init__")
    lines = [
        f"    {each}: {words}"
        for each in known
        if (words := SPECIAL.get(f"{name}.{each}") or WORDS.get(each))
        and not (is_made and each in fields)
    ]
    if is_made and any(each in fields for each in known):
        doc = f"{doc.rstrip()}\n\n{FIELDS}\n"
    return f"{doc.rstrip()}\n\nArgs:\n" + "\n".join(lines) + "\n" if lines else doc

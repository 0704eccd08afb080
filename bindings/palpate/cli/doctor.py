# SPDX-License-Identifier: BSD-3-Clause
"""The verb `doctor`: what this machine can do, each check with what it found."""

from __future__ import annotations

import argparse
import ctypes
import os
import platform
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np

import palpate
from palpate.command.verb import Report, Verb
from palpate.device.link import describe_low_latency
from palpate.scene.scene_file import compile_scene
from palpate.scene.scene_parts import SceneFile


def add_doctor(parser: argparse.ArgumentParser) -> None:
    del parser


def run_doctor(call: argparse.Namespace) -> Report:
    checks = [check_python(), check_editor(), check_graphics(), check_realtime()]
    checks += [check_landlock(), check_serial(), check_data()]
    return {
        "palpate": version("palpate"),
        "platform": platform.platform(),
        "cores": os.cpu_count(),
        "checks": checks,
    }


def check_python() -> Report:
    ok = sys.version_info[:2] >= (3, 11)
    return {
        "name": "python",
        "ok": ok,
        "needed": True,
        "detail": f"{platform.python_version()}, 3.11 is the reference",
    }


def check_editor() -> Report:
    try:
        detail, ok = f"palpate-editor {version('palpate-editor')}", True
    except PackageNotFoundError:
        detail, ok = "palpate-editor is not installed: import, decimate and demo need it", False
    return {"name": "editor", "ok": ok, "needed": False, "detail": detail}


def check_graphics() -> Report:
    from palpate.render import describe_gl

    try:
        return {"name": "graphics", "ok": True, "needed": False, "detail": describe_gl()}
    except RuntimeError as problem:
        return {"name": "graphics", "ok": False, "needed": False, "detail": str(problem)}


def check_realtime() -> Report:
    """Runs the real loop for 0.2 s on four particles and reports what it was granted."""
    corners = np.array([[0.0, 0.0, 0.0], [0.01, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.01]])
    mesh = palpate.SurfaceMesh(
        corners, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], dtype=np.int32)
    )
    scene = compile_scene(SceneFile(organ=None), mesh)
    frame = palpate.KeyFrame()
    frame.position = [0.0, 0.0, 0.1]
    options = palpate.LoopOptions()
    options.duration = 0.2
    loop = palpate.Loop(scene, palpate.ScriptedDevice([frame]), options)
    loop.start()
    loop.wait(5.0)
    report = loop.report()
    priority = "real-time priority granted" if report.realtime else report.realtime_note
    return {
        "name": "realtime",
        "ok": report.realtime,
        "needed": False,
        "detail": f"{priority}; lateness p99 {1e6 * report.lateness.p99:.0f} us, "
        f"{report.missed_ticks} of {report.ticks} ticks missed",
    }


CREATE_RULESET, ASK_VERSION = 444, 1
"""landlock_create_ruleset(2), the same on every processor."""


def find_landlock() -> int | None:
    """The version of Landlock that the kernel has, which shuts the reader of mesh files into their
    folder; None where it has none."""
    try:
        syscall = ctypes.CDLL(None).syscall
    except (OSError, AttributeError):
        return None
    found = syscall(
        ctypes.c_long(CREATE_RULESET), None, ctypes.c_size_t(0), ctypes.c_uint(ASK_VERSION)
    )
    return found if found > 0 else None


def check_landlock() -> Report:
    found = find_landlock()
    detail = (
        "Palpate alone keeps the reader of mesh files in their folder: the kernel has no Landlock"
        if found is None
        else f"Landlock {found} of the kernel keeps the reader of mesh files in their folder"
    )
    return {"name": "mesh files", "ok": found is not None, "needed": False, "detail": detail}


def check_serial() -> Report:
    good, detail = describe_low_latency()
    return {"name": "serial ports", "ok": good, "needed": False, "detail": detail}


def check_data() -> Report:
    folder = Path(os.environ.get("PALPATE_DATA", "../shared/data"))
    ok = folder.is_dir()
    return {
        "name": "shared data",
        "ok": ok,
        "needed": False,
        "detail": f"{folder} {'found' if ok else 'is not there; set PALPATE_DATA'}",
    }


def describe_doctor(report: Report) -> str:
    lines = [f"palpate {report['palpate']} on {report['platform']}, {report['cores']} cores"]
    for check in report["checks"]:
        mark = "ok" if check["ok"] else "MISSING" if check["needed"] else "no"
        lines.append(f"  {check['name']:12} {mark:8} {check['detail']}")
    return "\n".join(lines)


DOCTOR = Verb(
    "doctor",
    "say what this machine can do for palpate",
    "palpate doctor",
    add_doctor,
    run_doctor,
    describe_doctor,
    failed=lambda report: any(c["needed"] and not c["ok"] for c in report["checks"]),
)

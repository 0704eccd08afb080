# SPDX-License-Identifier: BSD-3-Clause
"""What a device's damping, period and delay and an instrument's coupling leave of a tissue's
stiffness [stability: passivity]."""

from __future__ import annotations

import palpate
from palpate.command.verb import Report

SHARE = 9.0
"""Times as stiff as a tissue a coupling must be, so that at most a tenth of its stiffness is not
felt: of k and K in a row the hand feels K / (1 + K/k)."""


def describe_couplings(costs: palpate.LoopReport, scene: palpate.Scene) -> Report:
    """Of each instrument of a run; nothing of a device that declares no damping."""
    rows = []
    for instrument, device in zip(scene.instruments, costs.devices, strict=False):
        if not device.passive_stiffness > 0.0:
            continue
        coupling = instrument.coupling.stiffness
        rows.append(
            {
                "coupling_N_per_m": coupling,
                "passive_N_per_m": device.passive_stiffness,
                "felt_within_a_tenth_N_per_m": coupling / SHARE,
            }
        )
    return {"couplings": rows} if rows else {}


def say_couplings(report: Report) -> list[str]:
    """Lines of a report, where a device declares what it damps."""
    lines = []
    for row in report.get("couplings", ()):
        coupling, passive = row["coupling_N_per_m"], row["passive_N_per_m"]
        lines.append(
            f"coupling     {coupling:.0f} N/m; the device is passive up to {passive:.0f} N/m by "
            "its damping, period and delay"
        )
        if passive < coupling:
            lines.append(
                f"             contact harder than {passive:.0f} N/m may give the hand energy, "
                "which the passivity controller damps"
            )
        lines.append(
            f"             behind it tissue of {coupling / SHARE:.0f} N/m feels a tenth too soft, "
            "harder tissue more"
        )
    return lines

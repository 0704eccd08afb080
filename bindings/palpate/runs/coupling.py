# SPDX-License-Identifier: BSD-3-Clause
"""What a device's damping, period and delay and an instrument's coupling leave of a tissue's
stiffness [stability: weak coupling]."""

from __future__ import annotations

import palpate
from palpate.command.verb import Report

FELT_WITHIN = 0.12
"""Part of a stiffness that may be missing without being shown as it is felt: the tenth that a
spring which follows a tissue leaves, and how exactly that is known."""


def describe_couplings(costs: palpate.LoopReport, scene: palpate.Scene) -> Report:
    """Of each instrument of a run; nothing of a device that declares no damping."""
    rows = []
    for instrument, device in zip(scene.instruments, costs.devices, strict=False):
        if not device.passive_stiffness > 0.0:
            continue
        coupling = instrument.coupling.stiffness
        row = {
            "coupling_N_per_m": coupling,
            "passive_N_per_m": device.passive_stiffness,
            "felt_within_a_tenth_N_per_m": find_borne(coupling, device.passive_stiffness),
        }
        if device.passive_stiffness < coupling and device.touch_ticks > 0:
            row["follows_tissue_ticks"] = device.follows_tissue_ticks
            row["tissue_N_per_m"] = device.tissue_stiffness
            row["stiffness_error"] = device.stiffness_error
        rows.append(row)
    return {"couplings": rows} if rows else {}


def find_borne(coupling: float, passive: float) -> float:
    """[N/m] Of the hardest tissue of whose stiffness nine tenths are felt: with the hand's spring k
    that palpate.fit_coupling chooses, k / (k + K) of K are."""
    share = palpate.COUPLING_SHARE
    return min(coupling / share, (1.0 + 1.0 / share) * passive)


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
                f"             so the hand's spring is {passive:.0f} N/m, and stiffer as the "
                f"tissue asks, as far as no more than {passive:.0f} N/m is felt"
            )
        lines.append(
            f"             tissue of {row['felt_within_a_tenth_N_per_m']:.0f} N/m feels a tenth "
            "too soft, harder tissue more"
        )
        if "stiffness_error" in row:
            lines.append(
                f"             the hardest that was touched had {row['tissue_N_per_m']:.0f} N/m; "
                f"up to {100 * row['stiffness_error']:.0f} % of the stiffness was not felt"
            )
    return lines

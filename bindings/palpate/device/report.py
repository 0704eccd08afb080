# SPDX-License-Identifier: BSD-3-Clause
"""What a device says of itself, as JSON can hold it and as people read it."""

from __future__ import annotations

import numpy as np

import palpate
from palpate.command.verb import Report
from palpate.device.link import Link, to_list

FAULTS = 12
NO_FAULT = 15


def report_status(link: Link, status: palpate.DeviceStatus) -> Report:
    """Angles in degrees for people, times in ms, all else in SI units."""
    return {
        "device": link.name,
        "latency": str(link.note),
        "state": palpate.describe_status(status),
        "serial_number": status.serial_number,
        "firmware": ".".join(str(part) for part in status.release),
        "counts": list(status.counts),
        "joints_degree": to_list(np.degrees(status.joints)),
        "gimbal_degree": to_list(np.degrees(status.gimbal)),
        "tip_m": to_list(status.tip),
        "force_commanded_N": to_list(status.force_commanded),
        "force_applied_N": to_list(status.force_applied),
        "duty": list(status.duty),
        "first_fault": name_first_fault(status),
        "faults": list_faults(status),
        "report_rate_Hz": status.report_rate,
        "reports": status.reports,
        "lost_reports": status.lost_reports,
        "damaged_frames": status.damaged_frames,
        "commands": status.commands,
        "round_trip_median_ms": 1e3 * status.round_trip_median,
        "round_trip_p99_ms": 1e3 * status.round_trip_p99,
        "round_trips": list(status.round_trips),
        "jitter_p99_ms": 1e3 * status.jitter_p99,
        "clock_drift_ppm": 1e6 * status.clock_drift,
        "missed_ticks": link.missed_ticks(),
    }


def name_first_fault(status: palpate.DeviceStatus) -> str | None:
    """What cut the motors, or None."""
    return None if status.first_fault == NO_FAULT else palpate.name_fault(status.first_fault)


def list_faults(status: palpate.DeviceStatus) -> list[str]:
    """Whatever was noticed."""
    return [palpate.name_fault(bit) for bit in range(FAULTS) if status.faults >> bit & 1]


def describe_listed(row: Report) -> str:
    notes = [row["product"]]
    if not row["permitted"]:
        notes.append("not permitted")
    if row["latency_timer_ms"] is not None:
        notes.append(f"latency timer {row['latency_timer_ms']} ms")
    return f"{row['device']:24} {', '.join(notes)}"


def describe_monitor(report: Report) -> str:
    joints = ", ".join(f"{angle:.1f}" for angle in report["joints_degree"])
    tip = ", ".join(f"{1e3 * x:.1f}" for x in report["tip_m"])
    return "\n".join(
        [
            f"{report['device']}: {report['state']}; {report['latency']}",
            f"joints       {joints} degrees",
            f"tip          {tip} mm",
            f"reports      {report['report_rate_Hz']:.0f} Hz; {report['lost_reports']} lost, "
            f"{report['damaged_frames']} damaged of {report['reports']}",
            f"round trip   {report['round_trip_median_ms']:.1f} ms median, "
            f"{report['round_trip_p99_ms']:.1f} ms p99",
            f"clock        {report['clock_drift_ppm']:+.0f} ppm, "
            f"jitter {report['jitter_p99_ms']:.2f} ms p99",
            f"faults       {', '.join(report['faults']) or 'none'}",
        ]
    )


def describe_feel(report: Report) -> str:
    lines = [describe_monitor(report)]
    forces = np.array(report["forces"]).reshape(-1, 7)
    if len(forces):
        asked = np.linalg.norm(forces[:, 1:4], axis=1).max()
        given = np.linalg.norm(forces[:, 4:7], axis=1).max()
        lines.append(f"forces       {asked:.2f} N asked at most, {given:.2f} N given")
    else:
        lines.append("forces       none: the motors stay off")
    return "\n".join(lines)

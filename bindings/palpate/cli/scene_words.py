# SPDX-License-Identifier: BSD-3-Clause
"""The report of the verb `scene` in words."""

from __future__ import annotations

from typing import Any

from scipy.spatial.transform import Rotation

from palpate.command.verb import Report


def describe_scene(report: Report) -> str:
    lines = [f"{report['layout']}: {report['title'] or 'without a title'}"]
    if report["gravity_m_per_s2"]:
        x, y, z = report["gravity_m_per_s2"]
        lines.append(f"  gravity {x:g}, {y:g}, {z:g} m/s²")
    if report["fluid"]:
        density, viscosity = report["fluid"]
        lines.append(f"  its stones in a fluid of {density:g} kg/m³ and {viscosity:g} Pa s")
    for body in report["bodies"]:
        said = "; may fold" if body["may_fold"] else ""
        said += "; weightless" if body["weightless"] else ""
        lines.append(describe_place(body) + said)
    for stone in report["stones"]:
        lines.append(describe_place(stone) + describe_hull(stone))
    for scenery in report["scenery"]:
        stops = ", ".join(scenery["stops"]) or "no body"
        lines.append(f"{describe_place(scenery)}; scenery, stops {stops}")
    lines += map(describe_tool, report["tools"])
    task = report["assessment"]
    if task is not None:
        steps, limits = len(task.get("steps", [])), len(task.get("limits", []))
        lines.append(f"  judged: {steps} steps, {limits} limits, as `scene task --write` shows")
    if "problems" not in report:
        pairs = zip(report["pairs"], report["pair_friction"], strict=True)
        lines += [f"  {one} and {other} may touch{describe_rub(mu)}" for (one, other), mu in pairs]
        lines.append(f"  {report['can_undo']} changes can be undone, {report['can_redo']} redone")
        return "\n".join(lines)
    lines += map(describe_costs, report["costs"])
    for problem in report["problems"]:
        lines.append(f"{problem['severity']}: {problem['where']}: {problem['message']}")
    return "\n".join([*lines, describe_end(report)])


def describe_place(told: dict[str, Any]) -> str:
    at = ", ".join(f"{1e3 * x:.2f}" for x in told["position_m"])
    turn = Rotation.from_rotvec(told["rotation_rad"]).as_euler("xyz", degrees=True)
    own = f"; instruments rub with {told['tool_friction'][0]:g}" if told["tool_friction"] else ""
    return (
        f"  {told['name']}: at {at} mm, turned {', '.join(f'{x:.1f}' for x in turn)} degrees{own}"
    )


def describe_rub(friction: float) -> str:
    return f", and rub with {friction:g}" if friction else ""


def describe_hull(told: dict[str, Any]) -> str:
    said = f"; a stone of {told['density_kg_per_m3']:g} kg/m³, {told['spheres']} spheres"
    if "mass_kg" not in told:
        return said
    return f"{said}, {1e3 * told['mass_kg']:.3g} g, hull up to {1e3 * told['hull_gap_m']:.2f} mm in"


def describe_tool(told: dict[str, Any]) -> str:
    at = ", ".join(f"{1e3 * x:.2f}" for x in told["trocar"])
    through = f", through {at} mm" if at else ""
    return f"  touched by a {told['kind']} of radius {1e3 * told['radius']:g} mm{through}"


def describe_costs(told: dict[str, Any]) -> str:
    head = f"  {told['pair']}: thickness {1e3 * told['thickness_m']:.2f} mm"
    head += describe_rub(told["friction"])
    if "pair_median_us" not in told:
        return head
    return (
        f"{head}; pressed together {told['most_touching']} vertices touch, "
        f"{told['pair_median_us']:.0f} us median and {told['pair_p99_us']:.0f} us p99 of ticks of "
        f"{told['tick_median_us']:.0f} and {told['tick_p99_us']:.0f} us on this machine"
    )


def describe_end(report: Report) -> str:
    if has_failed(report):
        return "not published" if report["action"] == "publish" else "cannot be published"
    if report["out"]:
        return f"wrote {report['out']}; not validated, not a medical device"
    return "can be published" + ("" if report["measured"] else "; no pair was pressed (--quick)")


def has_failed(report: Report) -> bool:
    return any(problem["severity"] == "error" for problem in report.get("problems", ()))

# SPDX-License-Identifier: BSD-3-Clause
"""What crossed its limit where a run ended in an alarm: found from the scene, after the run.

First from the spectrum of the tissue at rest, which says how many substeps each of its parts needs.
Where that explains nothing the scene is tried: with nothing touching it, then under a light touch,
each time with one constant after another nearer to what is usual. What alone lets the trial pass is
the cause.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

import palpate
from palpate.runs.press import Place, PressScript, find_top, has_jaws, write_script
from palpate.scene.pair_friction import keep_pairs

AlarmKind = palpate.AlarmKind

UNTOUCHED = 1.0
"""[s] of a run in which nothing is touched."""
TOUCH = PressScript(depth=2e-3, pull=2e-3, speed=0.3, hold=0.05)
"""A light touch: no tissue that is sound raises an alarm."""
FINER = 4
"""Times the substeps that are tried."""
STEP = 10.0
"""Between two trials of a constant."""
HALVINGS = 3
"""Then of the step in which the value lies that is farthest from usual and passes."""
LEAST_PART = 7
"""Steps down to a millionth: what moves the tissue even then is not this."""
BLOWN = (AlarmKind.not_finite, AlarmKind.moved_far, AlarmKind.energy)
"""For want of substeps or of a softer contact; what is merely strained is so without."""
NEVER_ASKED = (
    AlarmKind.none,
    AlarmKind.invalid_input,
    AlarmKind.pressed_deep,
    AlarmKind.not_solved,
)
"""These say themselves what they are of."""


Put = Callable[[palpate.Scene, float], palpate.Scene]
"""(scene, value) -> the same scene with that value of a constant."""


@dataclass(frozen=True)
class Cause:
    """A constant that is beyond its limit."""

    name: str
    """One of palpate.runs.alarms.CAUSES."""
    value: float = 0.0
    """Substeps that it needs, or the constant as it is."""
    limit: float = 0.0
    """Substeps that there are, or a value of the constant that passed."""
    body: int = 0
    """Of the scene, whose it is or that the tool with this constant touched."""


def find_cause(scene: palpate.Scene, alarm: palpate.Alarm, body: int = -1) -> Cause | None:
    """The first that alone explains the alarm, from the tissue at rest to the tool; None where the
    scene does not tell. `body` is World.alarm_body, -1 where it is not known: then each is examined
    until one has a cause. Takes some seconds of ticks a body and instrument at most. Raises
    ValueError for a body that the scene has not.
    """
    count = len(scene.bodies)
    if not -1 <= body < count:
        raise ValueError(f"body: got {body}, expected {f'0 to {count - 1}' if count > 1 else 0}")
    if alarm.kind in NEVER_ASKED:
        return None
    examined = range(count) if body < 0 else [body]
    causes = (examine_body(scene, alarm.kind, each) for each in examined)
    return next((cause for cause in causes if cause is not None), None)


def examine_body(scene: palpate.Scene, kind: AlarmKind, body: int) -> Cause | None:
    """What explains an alarm of a body, with the scene's instruments one after the other."""
    if scene.bodies[body].response is not None:
        return None
    alone = take_out(scene, body, 0)
    cause = find_unstable_part(alone) or find_restless_part(alone)
    if cause is None and kind in BLOWN:
        tools = range(len(scene.instruments))
        causes = (find_hard_part(take_out(scene, body, tool)) for tool in tools)
        cause = next((found for found in causes if found is not None), None)
    return None if cause is None else replace(cause, body=body)


def take_out(scene: palpate.Scene, body: int, instrument: int) -> palpate.Scene:
    """A body with an instrument, and nothing else: bodies do not act on each other."""
    if len(scene.bodies) == len(scene.instruments) == 1:
        return scene
    own = scene.bodies[body]
    free = copy.copy(own)
    free.substeps = free.substeps_max = 0
    alone = palpate.build_scene(
        palpate.Scene(bodies=[free], gravity=scene.gravity, rate=scene.rate)
    )
    alone = change_body(alone, substeps=own.substeps, substeps_max=own.substeps_max)
    tool = scene.instruments[instrument]
    # after the build, which refuses constants that a program may have set since
    fields = {name: getattr(tool, name) for name in ("tool", "coupling", "hold_stiffness")}
    return change_instrument(alone, **fields)


# ---------------------------------------------------------------- substeps of the tissue at rest


def count_substeps(scene: palpate.Scene, stiffness: float, damping: float) -> int:
    """Substeps of a tick that are stable at eigenvalues [1/s²] and [1/s] of K and C over M:

    dt <= (sqrt(c² + 4 w²) - c) / w² (core/sim/tick/private/choose_substeps.cpp).
    """
    if not stiffness > 0.0:
        return 1
    longest = (math.sqrt(damping**2 + 4.0 * stiffness) - damping) / stiffness
    return math.ceil(1.0 / (scene.rate * longest))


def find_unstable_part(scene: palpate.Scene) -> Cause | None:
    """What of the tissue needs more substeps than there can be."""
    stiffness, damping = scene.bodies[0].spectrum_stiffness, scene.bodies[0].spectrum_damping
    needed = count_substeps(scene, stiffness, 0.0)
    if needed > scene.bodies[0].substeps_max:
        return Cause(
            find_stiffest_part(scene.bodies[0].tissue), needed, scene.bodies[0].substeps_max
        )
    needed = count_substeps(scene, stiffness, damping)
    if needed > scene.bodies[0].substeps_max:
        name = "drag" if scene.bodies[0].tissue.drag > 0.5 * damping else "damping"
        return Cause(name, needed, scene.bodies[0].substeps_max)
    return None


def find_stiffest_part(tissue: palpate.TissueModel) -> str:
    """stiffness, bend, home or modulus: whose own largest eigenvalue is the largest."""
    mass, home = np.asarray(tissue.mass), np.asarray(tissue.home)
    moves = np.ones(len(mass), dtype=bool)
    moves[np.asarray(tissue.fixed, dtype=int)] = False
    links = estimate_alone(tissue, springs=tissue.springs, bonds=tissue.bonds)
    # shares of the bonds belong to the angles, which do not stand without them
    bent = estimate_alone(
        tissue, bonds=tissue.bonds, angles=tissue.angles, angle_law=tissue.angle_law
    )
    volumes = estimate_alone(tissue, volumes=tissue.volumes, prisms=tissue.prisms)
    pulled_home = float((home / mass)[moves].max(initial=0.0)) if len(home) else 0.0
    largest = {"stiffness": links, "bend": bent - links, "home": pulled_home, "modulus": volumes}
    name = max(largest, key=lambda part: largest[part])
    # one modulus gives volumes, prisms and all links beside them their constants
    return "modulus" if volumes > 0.0 and name in ("stiffness", "bend") else name


def estimate_alone(tissue: palpate.TissueModel, **parts: object) -> float:
    """[1/s²] The largest eigenvalue of M⁻¹K of some parts of a tissue."""
    alone = palpate.TissueModel(
        rest_position=tissue.rest_position,
        mass=tissue.mass,
        fixed=tissue.fixed,
        triangles=tissue.triangles,
        skin=tissue.skin,
        **parts,
    )
    return float(palpate.estimate_spectrum(alone).stiffness)


# ---------------------------------------------------------------- trials


def run_trial(scene: palpate.Scene, device: palpate.HapticDevice, lasts: float) -> AlarmKind:
    """How so many seconds of a hand end."""
    world, dt = palpate.World(scene, recovers=False), 1.0 / scene.rate
    for tick in range(max(1, round(lasts * scene.rate))):
        palpate.tick(scene, device.read(tick * dt), dt, world)
        if world.alarm:
            return world.alarm.kind
    return AlarmKind.none


def rests_untouched(scene: palpate.Scene) -> bool:
    """Whether the tissue raises no alarm with nobody near it."""
    x = np.asarray(scene.bodies[0].tissue.rest_position)
    away = palpate.KeyFrame()
    away.position = np.minimum(x.max(axis=0) + 10.0 * np.ptp(x, axis=0) + 1.0, 9.0)
    hand = palpate.ScriptedDevice([away])
    return run_trial(scene, hand, UNTOUCHED) is AlarmKind.none


def bears_touch(scene: palpate.Scene, place: Place) -> bool:
    """Whether a light press and pull leave the tissue sound."""
    frames, times = write_script(place, scene.instruments[0].tool.radius, TOUCH, has_jaws(scene))
    return run_trial(scene, palpate.ScriptedDevice(frames), times.end) not in BLOWN


def change_body(scene: palpate.Scene, **fields: object) -> palpate.Scene:
    """A scene whose body differs in what its spectrum does not depend on."""
    other = copy.copy(scene)
    for name, value in fields.items():
        setattr(other.bodies[0], name, value)
    return other


def change_instrument(scene: palpate.Scene, **fields: object) -> palpate.Scene:
    other = copy.copy(scene)
    for name, value in fields.items():
        setattr(other.instruments[0], name, value)
    return other


def with_tissue(scene: palpate.Scene, tissue: palpate.TissueModel) -> palpate.Scene:
    """The scene of another tissue, with the steps of before."""
    body = scene.bodies[0]
    kept = ("force_error", "kernel", "integrator", "iterations")
    fields = {name: getattr(body, name) for name in kept}
    other = palpate.build_scene(
        palpate.Scene(
            bodies=[palpate.SoftBody(tissue=tissue, **fields)],
            instruments=keep_pairs(scene.instruments, [0]),
            gravity=scene.gravity,
            rate=scene.rate,
        )
    )
    # after the build, which refuses too few
    return change_body(other, substeps=body.substeps, substeps_max=body.substeps_max)


def scale_pressure(scene: palpate.Scene, pressure: float) -> palpate.Scene:
    """The same scene with another pressure [Pa]."""
    tissue = copy.copy(scene.bodies[0].tissue)
    tissue.pressure = pressure
    return with_tissue(scene, tissue)


def scale_angles(scene: palpate.Scene, bend: float) -> palpate.Scene:
    """The same scene with angles of which the hardest has another constant [N], as under Eq 10."""
    tissue = copy.copy(scene.bodies[0].tissue)
    rows = np.asarray(tissue.angles.bend_stiffness)
    rows *= bend / rows.max()
    return with_tissue(scene, tissue)


def find_restless_part(scene: palpate.Scene) -> Cause | None:
    """What moves the tissue though nothing touches it: pressure or Eq 10."""
    tissue = scene.bodies[0].tissue
    has_eq10 = tissue.angle_law == palpate.AngleLaw.eq10 and len(tissue.angles.corners) > 0
    if not (tissue.pressure or has_eq10) or rests_untouched(scene):
        return None
    if tissue.pressure and rests_untouched(scale_pressure(scene, 0.0)):
        return find_borne("pressure", tissue.pressure, scene, scale_pressure)
    if not has_eq10:
        return None
    hardest = float(np.asarray(tissue.angles.bend_stiffness).max())
    return find_borne("eq10", hardest, scene, scale_angles) if hardest > 0.0 else None


def find_borne(name: str, value: float, scene: palpate.Scene, put: Put) -> Cause:
    """Of a constant that moves the tissue by itself, the value nearest to it that does not; 0
    where a millionth of it still does.
    """

    def passes(other: float) -> bool:
        try:
            return rests_untouched(put(scene, other))
        except ValueError:
            return False

    for power in range(1, LEAST_PART):
        if passes(borne := value / STEP**power):
            return Cause(name, value, sharpen(passes, borne, borne * STEP))
    return Cause(name, value, 0.0)


def sharpen(passes: Callable[[float], bool], good: float, bad: float) -> float:
    """A value between one that passes and one that does not, which passes: in two digits."""
    for _ in range(HALVINGS):
        middle = float(f"{math.copysign(math.sqrt(good * bad), good):.2g}")
        if passes(middle):
            good = middle
        else:
            bad = middle
    return good


def find_hard_part(scene: palpate.Scene) -> Cause | None:
    """What makes a light touch end the run: of the constants of hand and tool that are beyond what
    is usual, the farthest is tried first; then shorter steps."""
    place = find_top(scene)
    if bears_touch(scene, place):
        return None
    for hard in sorted(HARD, key=lambda hard: hard.excess(scene), reverse=True):
        for value in hard.list_trials(scene):
            if bears_touch(hard.put(scene, value), place):
                return Cause(hard.name, hard.get(scene), value)
    most = FINER * scene.bodies[0].substeps
    finer = change_body(scene, substeps=most, substeps_max=max(most, scene.bodies[0].substeps_max))
    if bears_touch(finer, place):
        return Cause("finer", scene.bodies[0].substeps, most)
    return None


@dataclass(frozen=True)
class Hard:
    """A constant of the hand or the tool that may be too much for a touch."""

    name: str
    usual: float
    """[SI]"""
    get: Callable[[palpate.Scene], float]
    put: Put

    def excess(self, scene: palpate.Scene) -> float:
        """[-] Times beyond what is usual."""
        return self.get(scene) / self.usual

    def list_trials(self, scene: palpate.Scene) -> Iterator[float]:
        """Ever nearer to what is usual, which comes last."""
        for power in reversed(range(math.ceil(math.log10(max(1.0, self.excess(scene)))))):
            yield self.usual * STEP**power


def put_contact(scene: palpate.Scene, value: float) -> palpate.Scene:
    its = scene.instruments[0].tool
    tool = palpate.Tool(radius=its.radius, stiffness=value, friction=its.friction)
    return change_instrument(scene, tool=tool)


HARD = (
    Hard(
        "contact",
        palpate.Tool().stiffness,
        lambda scene: scene.instruments[0].tool.stiffness,
        put_contact,
    ),
    Hard(
        "grip",
        palpate.Instrument().hold_stiffness,
        lambda scene: scene.instruments[0].hold_stiffness,
        lambda scene, value: change_instrument(scene, hold_stiffness=value),
    ),
)
"""The coupling is not among them: a tool without mass passes on no more than the contact does, and
1e15 N/m raise no alarm."""

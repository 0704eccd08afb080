# SPDX-License-Identifier: BSD-3-Clause
"""A tissue that ticks more slowly than the hand is read, beside the same at full rate: what is felt
of a press, a slip and a release [stability: slow tissue]."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import palpate
from palpate.runs.press import Place
from palpate.study.row_file import Json, write_rows

FORMAT, VERSION = "palpate multirate", 1
RATES = (30.0, 60.0, 100.0, 250.0, 500.0, 1000.0)
"""[Hz] asked for; each is the next that is a whole number of ticks."""
MODES = ("hold", "extrapolation", "local_stiffness")
"""Of LocalForceMode; beside them the full rate."""
FULL = "full_rate"
WEAK = "weak_device"
"""The tissue at full rate, felt through a device that bears less of a spring than the instrument
has."""
WEAK_DAMPING, WEAK_DELAY = 0.19, 2.2e-3
"""[N s/m], [s] What the low-cost arm declares at its tip where it starts [stability: weak
coupling]."""
PHASES = {"press": (0.0, 0.6), "slip": (0.6, 1.1), "release": (1.1, 1.6)}
"""[s] of the way of the hand."""
PRESS_TIME, TREMOR, TREMOR_RATE = 0.5, 2.5e-4, 8.0
"""[s] down; [m] and [Hz] of the tremor of a hand."""
ABOVE = 1e-3
"""[m] of the tip over the surface at rest, where the hand begins and where it ends."""


@dataclass(frozen=True)
class HandWay:
    """A press with a tremor, a slip, and a release, from a place and back above it."""

    place: Place
    radius: float
    """[m] of the tip."""
    depth: float = 5e-3
    """[m] below the surface at rest."""
    slip: float = 4e-3
    """[m] along it."""

    def find_position(self, time: float) -> NDArray[np.float64]:
        """[m] (3,) of the hand."""
        end_of_slip, end = PHASES["slip"][1], PHASES["release"][1]
        down = smooth(time / PRESS_TIME)
        up = smooth((time - end_of_slip) / (0.8 * (end - end_of_slip)))
        height = ABOVE - (self.depth + ABOVE) * down * (1.0 - up)
        tremor = TREMOR * np.sin(2.0 * np.pi * TREMOR_RATE * time) * down * (1.0 - up)
        begin = PHASES["slip"][0]
        aside = self.slip * smooth((time - begin) / (end_of_slip - begin)) * (1.0 - up)
        outward = np.asarray(self.place.outward)
        return (
            np.asarray(self.place.point)
            + (self.radius + height + tremor) * outward
            + aside * find_tangent(outward)
        )


@dataclass(frozen=True)
class MultirateRow:
    """What one way of bridging gave at one rate of the tissue, beside the full rate."""

    mode: str
    """One of MODES, FULL or WEAK."""
    rate: float
    """[Hz] of the exchanges."""
    rms: float
    """[-] of the force's error, over the largest force of the full rate."""
    largest: float
    """[-] likewise, the largest error of any tick."""
    press: float
    """[-] rms of that part; likewise slip and release."""
    slip: float
    release: float
    jump: float
    """[N] largest change of the force from one tick to the next."""
    margin: float
    """[-] of the energy that the hand put in, what the tissue kept: below 0 the hand was given
    energy, and the tissue was not passive."""


@dataclass(frozen=True)
class MultirateChart:
    """Of one scene."""

    scene: str
    """Name and SHA-256 of its file."""
    sha256: str
    depth: float
    """[m] of the press."""
    slip: float
    """[m]"""
    peak: float
    """[N] largest force at full rate."""
    rows: tuple[MultirateRow, ...]


def smooth(part: float) -> float:
    """0 to 1 without a jerk [-]."""
    p = min(1.0, max(0.0, part))
    return p * p * p * (10.0 + p * (6.0 * p - 15.0))


def find_tangent(outward: NDArray[np.float64]) -> NDArray[np.float64]:
    """A direction [-] (3,) along the surface, always the same."""
    axis = np.eye(3)[int(np.argmin(np.abs(outward)))]
    along = np.cross(outward, axis)
    return along / np.linalg.norm(along)


def list_samples(way: HandWay, rate: float) -> list[palpate.HapticSample]:
    """A tick each."""
    count = round(PHASES["release"][1] * rate)
    times = np.arange(count) / rate
    positions = np.array([way.find_position(time) for time in times])
    speeds = np.gradient(positions, 1.0 / rate, axis=0)
    return [
        palpate.HapticSample(time=time, position=position, velocity=speed)
        for time, position, speed in zip(times, positions, speeds, strict=True)
    ]


def feel_in_full(
    scene: palpate.Scene, samples: Sequence[palpate.HapticSample]
) -> NDArray[np.float64]:
    """[N] (ticks, 3) of the tissue that ticks with the hand. Raises RuntimeError for an alarm."""
    world, dt = palpate.World(scene), 1.0 / scene.rate
    forces = np.array([palpate.tick(scene, sample, dt, world).force for sample in samples])
    if world.alarm:
        raise RuntimeError(f"the tissue at full rate raised an alarm: {world.alarm}")
    return forces


def find_weak_spring(rate: float) -> tuple[float, float]:
    """[N/m] Up to which a spring is passive with the weak device, and [s] by which a force is
    late, at that rate of ticks [Hz]."""
    delay = 0.5 / rate + WEAK_DELAY
    return WEAK_DAMPING / delay, delay


def feel_weakly(
    scene: palpate.Scene, samples: Sequence[palpate.HapticSample]
) -> NDArray[np.float64]:
    """[N] (ticks, 3) as feel_in_full(), through the weak device. Raises RuntimeError for an
    alarm."""
    world, dt = palpate.World(scene), 1.0 / scene.rate
    world.bound_coupling(0, *find_weak_spring(scene.rate))
    forces = np.array([palpate.tick(scene, sample, dt, world).force for sample in samples])
    if world.alarm:
        raise RuntimeError(f"the tissue of a weak device raised an alarm: {world.alarm}")
    return forces


def feel_slowly(
    scene: palpate.Scene, samples: Sequence[palpate.HapticSample], ticks: int, mode: str
) -> NDArray[np.float64]:
    """[N] (ticks, 3) with an exchange every so many ticks. Raises RuntimeError for an alarm."""
    bridged = palpate.LocalForceMode.__members__[mode]
    slow = palpate.SlowTissue(scene, scene.rate, ticks, bridged)
    forces = np.array([slow.tick(sample).force for sample in samples])
    if slow.alarm():
        raise RuntimeError(f"the tissue at {scene.rate / ticks:g} Hz raised an alarm")
    return forces


def compare(
    mode: str,
    ticks: int,
    scene: palpate.Scene,
    samples: Sequence[palpate.HapticSample],
    felt: NDArray[np.float64],
    full: NDArray[np.float64],
) -> MultirateRow:
    """The row of what was felt, and of what is felt at full rate."""
    peak = float(np.linalg.norm(full, axis=1).max())
    error = np.linalg.norm(felt - full, axis=1) / peak
    times = np.array([sample.time for sample in samples])

    def part(name: str) -> float:
        begin, end = PHASES[name]
        return rms(error[(times >= begin) & (times < end)])

    return MultirateRow(
        mode=mode,
        rate=scene.rate / ticks,
        rms=rms(error),
        largest=float(error.max()),
        press=part("press"),
        slip=part("slip"),
        release=part("release"),
        jump=find_jump(felt),
        margin=find_margin(samples, felt),
    )


def rms(error: NDArray[np.float64]) -> float:
    return float(np.sqrt(np.mean(error**2)))


def find_jump(felt: NDArray[np.float64]) -> float:
    """[N] The largest change from one tick to the next."""
    return float(np.linalg.norm(np.diff(felt, axis=0), axis=1).max())


def find_margin(samples: Sequence[palpate.HapticSample], felt: NDArray[np.float64]) -> float:
    """[-] The force of a tick is held until the next, and the hand moves on under it: what it was
    given is f_(k-1) . (x_k - x_(k-1)), as the passivity observer counts [HannafordRyu02]."""
    steps = np.diff([sample.position for sample in samples], axis=0)
    given = np.einsum("ij,ij->i", felt[:-1], steps)
    taken = -float(given[given < 0.0].sum())
    return -float(given.sum()) / taken if taken > 0.0 else 0.0


def list_ticks(rate: float, rates: Sequence[float]) -> Iterator[int]:
    """Ticks of an interval for each rate [Hz] of exchanges."""
    for asked in rates:
        yield max(1, round(rate / asked))


def draw_rows(
    scene: palpate.Scene,
    way: HandWay,
    rates: Sequence[float] = RATES,
    told: Callable[[MultirateRow], None] = lambda row: None,
) -> Iterator[MultirateRow]:
    """The full rate first, through a weak device next, then every mode at every rate [Hz]. Raises
    RuntimeError for an alarm."""
    samples = list_samples(way, scene.rate)
    full = feel_in_full(scene, samples)
    yield compare(FULL, 1, scene, samples, full, full)
    yield compare(WEAK, 1, scene, samples, feel_weakly(scene, samples), full)
    for mode in MODES:
        for ticks in list_ticks(scene.rate, rates):
            felt = feel_slowly(scene, samples, ticks, mode)
            row = compare(mode, ticks, scene, samples, felt, full)
            told(row)
            yield row


def draw_chart(
    path: Path,
    scene: palpate.Scene,
    way: HandWay,
    rates: Sequence[float] = RATES,
    told: Callable[[MultirateRow], None] = lambda row: None,
) -> MultirateChart:
    """Of the scene in that file. Raises OSError, ValueError for a scene without a ball on a tissue
    alone, or RuntimeError for an alarm, and where the tissue is not felt at all."""
    palpate.SlowTissue(scene, scene.rate, 1)  # refuses at once what it cannot do
    peak = float(np.linalg.norm(feel_in_full(scene, list_samples(way, scene.rate)), axis=1).max())
    if peak == 0.0:
        raise RuntimeError("the tissue was not felt at full rate: press deeper (--depth)")
    return MultirateChart(
        scene=path.name,
        sha256=hashlib.sha256(path.read_bytes()).hexdigest(),
        depth=way.depth,
        slip=way.slip,
        peak=peak,
        rows=tuple(draw_rows(scene, way, rates, told)),
    )


def write_chart(path: Path, chart: MultirateChart) -> None:
    """Raises OSError."""
    content: Json = asdict(chart)
    content["rows"] = [asdict(row) for row in chart.rows]
    content["scene_sha256"] = content.pop("sha256")
    rows = content.pop("rows")
    write_rows(path, content | {"rows": rows}, FORMAT, VERSION)

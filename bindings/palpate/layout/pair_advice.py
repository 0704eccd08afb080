# SPDX-License-Identifier: BSD-3-Clause
"""Which chosen constant of two bodies that may touch is wrong, where they do not bear a press
towards each other, and the nearest value of it that does."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import palpate
from palpate.layout.assemble import Assembly, build, choose_barriers
from palpate.layout.costs import Pressed, follow_press, write_press_of
from palpate.layout.nearest_value import find_nearest_value, round_to_two

UNITS = {"thickness": "m", "stiffness": "N/m3"}
"""Of options with the constants that may be wrong."""
FAR = 5.0
"""[-] Times what would be chosen: a constant nearer to that is not taken for the cause of many
substeps."""
SPARE = 1.3
"""[-] Times the substeps with what would be chosen: these are not too many."""


@dataclass(frozen=True)
class PairAdvice:
    """A constant of a pair, and a value with which its bodies bear the press."""

    name: str
    """One of UNITS."""
    value: float
    limit: float
    pressed: Pressed
    """With the limit."""

    @property
    def now(self) -> str:
        """As `palpate scene pair` takes it."""
        return write_option(self.name, self.value)

    @property
    def option(self) -> str:
        return write_option(self.name, self.limit)


def write_option(name: str, value: float) -> str:
    return f"--{name} {value:.2g}{UNITS[name]}"


Bears = Callable[[Pressed], bool]


def is_sound(pressed: Pressed) -> bool:
    return not pressed.end and pressed.least_gap >= 0.0


def advise_pair(scene: palpate.Scene, index: int, assembly: Assembly) -> PairAdvice | None:
    """What alone lets a press be borne that ends a run, or drives bodies through each other; None
    where nothing that was set does. Some presses of half a second."""
    return find_advice(PairTrial(scene, index, assembly), is_sound)


def advise_slow_pair(
    scene: palpate.Scene, index: int, assembly: Assembly
) -> tuple[PairAdvice, float] | None:
    """What alone saves substeps of a press, and how many it takes now on the mean; None where
    nothing that was set is much harder than what would be chosen, or saves any."""
    trial = PairTrial(scene, index, assembly)
    if not any(trial.is_hard(name) for name in trial.list_set()):
        return None
    now = trial.follow(scene).substeps

    def is_quick(pressed: Pressed) -> bool:
        return is_sound(pressed) and pressed.substeps * SPARE <= now

    found = find_advice(trial, is_quick)
    return None if found is None else (found, now)


def find_advice(trial: PairTrial, bears: Bears) -> PairAdvice | None:
    for name in trial.list_set():
        value = getattr(trial.row, name)

        def press(tried: float, name: str = name) -> Pressed | None:
            pressed = trial.press(name, tried)
            return pressed if pressed is not None and bears(pressed) else None

        found = find_nearest_value(press, value, trial.choose_usual(name))
        if found is not None:
            return PairAdvice(name, value, *found)
    return None


class PairTrial:
    """A pair of a scene whose bodies are pressed together, with one constant or another."""

    def __init__(self, scene: palpate.Scene, index: int, assembly: Assembly):
        self.scene, self.index, self.assembly = scene, index, assembly
        rows = assembly.layout.pairs
        # beyond these are bodies with themselves, whose constants are chosen
        self.row = rows[index] if index < len(rows) else None
        self.samples = write_press_of(scene, index, assembly.surfaces)

    def list_set(self) -> list[str]:
        """Constants that are not chosen: what may be wrong."""
        return [name for name in UNITS if self.row is not None and getattr(self.row, name)]

    def is_hard(self, name: str) -> bool:
        """Whether a barrier is much stiffer, or thinner, than what would be chosen."""
        value, usual = getattr(self.row, name), self.choose_usual(name)
        return (value / usual if name == "stiffness" else usual / value) > FAR

    def choose_usual(self, name: str) -> float:
        """What a constant is where it is not set, in two digits."""
        return round_to_two(getattr(self.choose(name, 0.0), name))

    def choose(self, name: str, value: float) -> palpate.BodyPair:
        """The pair with another value of a constant, the rest as it was set or would be chosen."""
        row = replace(self.row, **{name: value})
        layout = replace(self.assembly.layout, pairs=(row,))
        return choose_barriers(layout, self.assembly.bodies)[0]

    def press(self, name: str, value: float) -> Pressed | None:
        """How the press goes with another value; None where it is refused."""
        pairs = list(self.assembly.pairs)
        try:
            pairs[self.index] = self.choose(name, value)
            other = build(replace(self.assembly, pairs=pairs))
        except ValueError:
            return None
        return self.follow(other)

    def follow(self, scene: palpate.Scene) -> Pressed:
        return follow_press(scene, self.index, self.samples)

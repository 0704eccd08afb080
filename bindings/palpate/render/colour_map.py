# SPDX-License-Identifier: BSD-3-Clause
"""From numbers to colours, and the ticks of the legend that leads back."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from palpate.render.viridis import VIRIDIS

LUT_SIZE = 256


def build_viridis() -> NDArray[np.uint8]:
    """Dark violet to yellow, (256, 3): even steps to the eye, colour-blind eyes included."""
    return np.frombuffer(bytes.fromhex(VIRIDIS), np.uint8).reshape(LUT_SIZE, 3)


def build_cool_warm() -> NDArray[np.uint8]:
    """Blue over light grey to red, (256, 3), for signed values: the middle is zero.

    Interpolates magnitude, saturation and hue of CIELAB between the two ends and a white of
    magnitude 88, the hue of which is spun away so that no third colour appears [Moreland09].
    """
    cool, warm = ([80.0056, 1.0798, -1.1005], [80.0312, 1.0797, 0.5009])
    whites = [[88.0, 0.0, -1.661], [88.0, 0.0, 1.061]]
    t = np.linspace(0.0, 1.0, LUT_SIZE)[:, None]
    low = (1 - 2 * t) * np.array(cool) + 2 * t * np.array(whites[0])
    high = (2 - 2 * t) * np.array(whites[1]) + (2 * t - 1) * np.array(warm)
    magnitude, saturation, hue = np.where(t <= 0.5, low, high).T
    chroma = magnitude * np.sin(saturation)
    lab = np.stack(
        [magnitude * np.cos(saturation), chroma * np.cos(hue), chroma * np.sin(hue)], axis=1
    )
    return np.round(255 * encode_srgb(convert_lab(lab))).astype(np.uint8)


def convert_lab(lab: NDArray[np.float64]) -> NDArray[np.float64]:
    """CIELAB under the white D65 to linear sRGB, both (n, 3) [IEC 61966-2-1]."""
    fy = (lab[:, 0] + 16) / 116
    f = np.stack([fy + lab[:, 1] / 500, fy, fy - lab[:, 2] / 200], axis=1)
    ratio = np.where(f > 6 / 29, f**3, 3 * (6 / 29) ** 2 * (f - 4 / 29))
    xyz = ratio * np.array([0.95047, 1.0, 1.08883])
    to_rgb = np.array(
        [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]]
    )
    return np.asarray(xyz @ to_rgb.T)


def encode_srgb(linear: ArrayLike) -> NDArray[np.float64]:
    """Linear light to what a screen is sent, both in 0 to 1 [IEC 61966-2-1]."""
    c = np.clip(np.asarray(linear, dtype=float), 0.0, 1.0)
    return np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


COLOUR_MAPS = {"viridis": build_viridis, "cool_warm": build_cool_warm}
"""From name to the function that gives its 256 colours."""


@dataclass(frozen=True)
class Legend:
    """A range of values, its colours, and the ticks that explain it."""

    low: float
    high: float
    colour_map: str
    ticks: tuple[float, ...]
    labels: tuple[str, ...]
    exponent: int = 0
    """The labels are in units of ten to this."""
    below: bool = False
    above: bool = False
    """Whether there are values beyond the ends, drawn in the colour of the end."""


def build_legend(
    values: ArrayLike,
    value_range: tuple[float, float] | None = None,
    colour_map: str | None = None,
    tick_count: int = 6,
) -> Legend:
    """The range as given, or one with round ends that holds all the values.

    A range of both signs is symmetric and gets the diverging map, unless a map is named. Raises
    ValueError for an unknown map, an empty range or values that are not finite.
    """
    v = np.asarray(values, dtype=float)
    if v.size == 0 or not np.isfinite(v).all():
        wrong = f"{np.count_nonzero(~np.isfinite(v))} that are not finite" if v.size else "none"
        raise ValueError(f"values: got {wrong}, expected finite numbers, at least one")
    if value_range is None:
        low, high = choose_range(float(v.min()), float(v.max()), tick_count)
    else:
        low, high = (float(end) for end in value_range)
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            raise ValueError(f"value_range must be finite and ascending, got {value_range}")
    name = colour_map or ("cool_warm" if low < 0.0 < high else "viridis")
    if name not in COLOUR_MAPS:
        raise ValueError(f"colour_map must be one of {', '.join(COLOUR_MAPS)}, got {name!r}")
    ticks = choose_ticks(low, high, tick_count)
    exponent, labels = format_ticks(ticks)
    slack = 1e-6 * (high - low)  # of round ends, which are rounded
    below, above = bool(v.min() < low - slack), bool(v.max() > high + slack)
    return Legend(low, high, name, ticks, labels, exponent, below, above)


def choose_step(span: float, count: int) -> float:
    """The smallest of 1, 2, 2.5 or 5 times a power of ten that cuts `span` in at most `count`."""
    raw = span / count
    power = 10.0 ** math.floor(math.log10(raw))
    return next(m * power for m in (1.0, 2.0, 2.5, 5.0, 10.0) if m * power >= raw * (1 - 1e-9))


def choose_range(low: float, high: float, count: int = 6) -> tuple[float, float]:
    """Round ends around values from `low` to `high`.

    Zero is one of them where it is near: a displacement starts at none, and the colours of a
    signed value stand evenly around nothing.
    """
    if low < 0.0 < high:
        high = max(-low, high)
        step = choose_step(high, max(1, count // 2))
        high = step * math.ceil(high / step - 1e-9)
        return -high, high
    if low >= 0.0 and low <= 0.5 * high:
        low = 0.0
    if high <= 0.0 and high >= 0.5 * low:
        high = 0.0
    if high - low <= 1e-9 * max(abs(low), abs(high)):  # one value everywhere
        margin = 0.5 * abs(high) or 1.0
        low, high = (0.0, 1.0) if high == 0.0 else (low - margin, high + margin)
    step = choose_step(high - low, count)
    return step * math.floor(low / step + 1e-9), step * math.ceil(high / step - 1e-9)


def choose_ticks(low: float, high: float, count: int = 6) -> tuple[float, ...]:
    """Round values inside a range, at most count + 1 of them."""
    step = choose_step(high - low, count)
    first, last = math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6)
    return tuple(step * k for k in range(first, last + 1))


def format_ticks(ticks: tuple[float, ...]) -> tuple[int, tuple[str, ...]]:
    """A common power of ten, 0 where plain numbers are short enough, and the labels."""
    largest = max((abs(tick) for tick in ticks), default=0.0)
    power = math.floor(math.log10(largest)) if largest > 0.0 else 0
    exponent = 0 if -3 <= power <= 4 else power
    scaled = [tick / 10.0**exponent for tick in ticks]
    gap = min((b - a for a, b in zip(scaled, scaled[1:], strict=False)), default=1.0)
    decimals = next((d for d in range(8) if abs(round(gap, d) - gap) <= 1e-6 * gap), 8)
    labels = (f"{0.0 if abs(tick) < 1e-9 * gap else tick:.{decimals}f}" for tick in scaled)
    return exponent, tuple(label.replace("-", "\N{MINUS SIGN}") for label in labels)

# SPDX-License-Identifier: BSD-3-Clause
"""The value of a constant nearest to what it is with which a trial goes well."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TypeVar

STEP, HALVINGS = 10.0, 2
"""[-] Between two values that are tried; then of the last step."""

Found = TypeVar("Found")


def find_nearest_value(
    run: Callable[[float], Found | None], value: float, usual: float
) -> tuple[float, Found] | None:
    """Between a value and the usual one, the nearest with which `run` gives something, in two
    digits, and what it gives; None where it gives nothing with the usual one."""
    found = run(usual)
    if found is None:
        return None
    good, bad = usual, value
    way = math.copysign(1.0, math.log(usual / value)) if usual != value else 0.0
    steps = math.ceil(abs(math.log(usual / value)) / math.log(STEP))
    for power in range(1, steps):
        tried = round_to_two(value * STEP ** (way * power))
        ended = run(tried)
        if ended is not None:
            good, found = tried, ended
            break
        bad = tried
    for _ in range(HALVINGS if usual != value else 0):
        tried = round_to_two(math.sqrt(good * bad))
        ended = run(tried)
        if ended is not None:
            good, found = tried, ended
        else:
            bad = tried
    return good, found


def round_to_two(value: float) -> float:
    return float(f"{value:.2g}")

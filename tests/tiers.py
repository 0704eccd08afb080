# SPDX-License-Identifier: BSD-3-Clause
"""Which cases of a sweep `./run test` takes; the others are a landing's."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Any

import pytest


def keep_everyday(cases: Iterable[Any], everyday: Collection[Any]) -> list[Any]:
    """For `parametrize`: the cases as they are, those outside of `everyday` at a landing alone."""
    return [
        case if case in everyday else pytest.param(case, marks=pytest.mark.landing)
        for case in cases
    ]

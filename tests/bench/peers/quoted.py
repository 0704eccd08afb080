# SPDX-License-Identifier: BSD-3-Clause
"""Engines that no package index has, measured once: their steps as ratios to the plain loop.

2026-11-21, one core of a 2-core AMD EPYC (Zen 3), each between two runs of the plain loop, on the
same shell without homes, in the press, with no gate: what their contact force was is not known, so
a row of these is no claim. Versions stand in SOURCE.
"""

from __future__ import annotations

SOURCE = (
    "quoted from the study of 2026-11-21: Jolt 3b47ec39, SOFA v25.12.00, PositionBasedDynamics "
    "d0894bd; no homes, no gate"
)
QUOTED = {
    "Jolt, XPBD, 1 substep": {
        600: (1.0, 2.1),
        2000: (1.0, 1.9),
        5400: (1.0, 1.9),
        20_000: (1.0, 1.9),
    },
    "Jolt, XPBD, 5 substeps": {
        600: (1.0, 7.6),
        2000: (1.0, 7.7),
        5400: (1.0, 7.9),
        20_000: (1.0, 8.2),
    },
    "SOFA, triangle FEM, explicit": {
        600: (2.2, 6.1),
        2000: (1.2, 5.3),
        5400: (0.7, 5.1),
        20_000: (0.35, 5.2),
    },
    "SOFA, springs, explicit": {
        600: (2.2, 14.2),
        2000: (1.2, 13.7),
        5400: (0.7, 13.3),
        20_000: (0.35, 13.4),
    },
    "PositionBasedDynamics, 1 iteration": {
        600: (1.0, 8.2),
        2000: (1.0, 8.8),
        5400: (1.0, 9.3),
        20_000: (1.0, 12.9),
    },
}
"""Name -> vertices -> step [ms] and cost of a step over that of the plain loop."""
QUOTED_LARGEST = {
    "Jolt, XPBD, 1 substep": 23_000,
    "Jolt, XPBD, 5 substeps": 6_000,
    "SOFA, triangle FEM, explicit": 6_000,
    "SOFA, springs, explicit": 3_300,
    "PositionBasedDynamics, 1 iteration": 5_000,
}
"""Vertices at 1 kHz."""

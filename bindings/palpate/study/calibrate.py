# SPDX-License-Identifier: BSD-3-Clause
"""Constants fitted to a measured curve: least squares, with what the fit leaves open."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.special import stdtrit

from palpate.study.curve import Curve

Forces = Callable[[Sequence[float]], NDArray[np.float64]]
"""Factors of the constants -> [N] at every depth of the curve."""

FARTHEST = 1e4
"""Largest factor, and one over the smallest, that is tried."""
CONFIDENCE = 0.95
PATTERNED = 0.8
"""Of Durbin and Watson: below it, what is left over is no noise (10 points, 95 %: 0.88)."""
NOTICED = 0.01
"""Of the peak: what is left over where its pattern matters."""
STEP = 0.03
"""Of a factor: the difference that slopes are taken over, well above what settling leaves."""


@dataclass(frozen=True)
class Fit:
    """What was fitted, how well, and how sure."""

    names: tuple[str, ...]
    factors: tuple[float, ...]
    """Of the constants that the model had."""
    low: tuple[float, ...]
    high: tuple[float, ...]
    """The 95 % confidence interval of each factor, from the residual and the slopes."""
    force: NDArray[np.float64]
    """[N] of the fitted model at the depths of the curve."""
    residual: float
    """[N], root mean square."""
    explained: float
    """[-] R²: 1 where the curve is met."""
    durbin_watson: float
    """[-] 2 where what is left over is noise, near 0 where it swings slowly [DurbinWatson50]."""
    evaluations: int

    def misses_shape(self) -> bool:
        """Whether the model's curve has another shape, so that the intervals are too narrow."""
        noticed = self.residual > NOTICED * self.force.max()
        return bool(self.durbin_watson < PATTERNED and noticed)


class NotFitted(ValueError):
    """The curve leaves a constant open."""


def fit_factors(curve: Curve, names: Sequence[str], forces: Forces) -> Fit:
    """Factors whose forces come nearest to the curve's, in the sum of squares.

    Logarithms are fitted, so no factor turns negative. Raises NotFitted where the curve does not
    say what a factor is, or where it runs away.
    """
    count = len(names)
    if len(curve.depth) <= count:
        raise NotFitted(f"{len(curve.depth)} points cannot tell {count} factors")
    scale = float(np.sqrt((curve.force**2).mean()))

    def miss(logarithms: NDArray[np.float64]) -> NDArray[np.float64]:
        return (forces(np.exp(logarithms).tolist()) - curve.force) / scale

    farthest = np.log(FARTHEST)
    start = np.full(count, guess_factor(curve, forces, count))
    found = least_squares(
        miss,
        np.log(np.clip(start, 2.0 / FARTHEST, FARTHEST / 2.0)),
        bounds=(-farthest, farthest),
        diff_step=STEP,
        xtol=1e-5,
        ftol=1e-8,
    )
    for name, at in zip(names, found.x, strict=True):
        if abs(at) > 0.99 * farthest:
            raise NotFitted(f"{name}: the best factor is beyond {np.exp(at):.3g}")
    spread = find_spread(names, found.jac, found.fun)
    residuals = scale * found.fun
    around = curve.force - curve.force.mean()
    return Fit(
        names=tuple(names),
        factors=tuple(np.exp(found.x).tolist()),
        low=tuple(np.exp(found.x - spread).tolist()),
        high=tuple(np.exp(found.x + spread).tolist()),
        force=curve.force + residuals,
        residual=float(np.sqrt((residuals**2).mean())),
        explained=1.0 - float((residuals**2).sum() / (around**2).sum()),
        durbin_watson=float((np.diff(residuals) ** 2).sum() / max((residuals**2).sum(), 1e-300)),
        evaluations=int(found.nfev),
    )


def guess_factor(curve: Curve, forces: Forces, count: int) -> float:
    """All constants together scale the force, nearly: what brings it to the curve's."""
    before = forces([1.0] * count)
    size = float(before @ before)
    if size <= 0.0:
        raise NotFitted("the model pushes back nowhere along the curve")
    return float(before @ curve.force) / size


def find_spread(
    names: Sequence[str], slopes: NDArray[np.float64], residuals: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Half the confidence interval of each logarithm: t s sqrt(diag (J^T J)^-1)."""
    normal = slopes.T @ slopes
    if np.linalg.cond(normal) > 1e8:
        raise NotFitted(f"the curve cannot tell {' and '.join(names)} apart: fit one of them")
    freedom = len(residuals) - len(names)
    variance = float(residuals @ residuals) / freedom * np.diag(np.linalg.inv(normal))
    return stdtrit(freedom, 0.5 + 0.5 * CONFIDENCE) * np.sqrt(variance)

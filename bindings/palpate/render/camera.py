# SPDX-License-Identifier: BSD-3-Clause
"""An orbit camera: right-handed world, z up, angles in radians."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

STEEPEST = math.pi / 2
"""[rad] Straight from above and straight from below."""


def at_origin() -> Array:
    return np.zeros(3)


@dataclass
class Camera:
    """Looks at a target from a distance; the angles say from where.

    Pixels are counted from the upper left corner of the picture, so the middle of the first pixel
    is (0.5, 0.5).
    """

    azimuth: float = math.radians(-60.0)
    """[rad] of the eye around z, from +x towards +y."""
    elevation: float = math.radians(25.0)
    """[rad] of the eye above the horizontal, at most a right angle."""
    distance: float = 1.0
    """[m] from eye to target."""
    target: Array = field(default_factory=at_origin)
    """[m] (3,)"""
    field_of_view: float = math.radians(28.0)
    """[rad] of the picture's height."""
    headlight: float = 0.0
    """[m] At which a lamp beside the eye lights as brightly as those of the studio; 0 for those."""

    def basis(self) -> tuple[Array, Array, Array]:
        """Unit vectors to the right, up, and forward, away from the eye."""
        ca, sa = math.cos(self.azimuth), math.sin(self.azimuth)
        ce, se = math.cos(self.elevation), math.sin(self.elevation)
        # right comes from the azimuth alone, so that it exists when looking along z too
        right = np.array([-sa, ca, 0.0])
        forward = np.array([-ce * ca, -ce * sa, -se])
        return right, np.cross(right, forward), forward

    def eye(self) -> Array:
        """[m] (3,)"""
        return np.asarray(self.target, dtype=float) - self.distance * self.basis()[2]

    def describe(self) -> tuple[float, ...]:
        """All that says what is seen."""
        x, y, z = (float(part) for part in self.target)
        angles = (self.azimuth, self.elevation, self.field_of_view)
        return (*angles, self.distance, self.headlight, x, y, z)

    def view(self) -> Array:
        """World to eye, (4, 4): x right, y up, -z forward."""
        right, up, forward = self.basis()
        matrix = np.eye(4)
        matrix[:3, :3] = [right, up, -forward]
        matrix[:3, 3] = -matrix[:3, :3] @ self.eye()
        return matrix

    def projection(self, aspect: float, near: float, far: float) -> Array:
        """Eye to clip space, (4, 4), for a picture `aspect` times as wide as high."""
        s = 1.0 / math.tan(self.field_of_view / 2)
        matrix = np.zeros((4, 4))
        matrix[0, 0], matrix[1, 1] = s / aspect, s
        matrix[2, 2], matrix[2, 3] = (far + near) / (near - far), 2 * far * near / (near - far)
        matrix[3, 2] = -1.0
        return matrix

    def project(self, points: ArrayLike, size: tuple[int, int]) -> tuple[Array, Array]:
        """Pixels (n, 2) of points [m] (n, 3), and their depths [m] (n,) in front of the eye."""
        right, up, forward = self.basis()
        d = np.atleast_2d(np.asarray(points, dtype=float)) - self.eye()
        depth = d @ forward
        focal = size[1] / 2 / math.tan(self.field_of_view / 2)
        x = size[0] / 2 + focal * (d @ right) / depth
        y = size[1] / 2 - focal * (d @ up) / depth
        return np.stack([x, y], axis=1), depth

    def ray(self, x: float, y: float, size: tuple[int, int]) -> tuple[Array, Array]:
        """The eye [m] and the unit direction through a pixel."""
        right, up, forward = self.basis()
        focal = size[1] / 2 / math.tan(self.field_of_view / 2)
        direction = focal * forward + (x - size[0] / 2) * right - (y - size[1] / 2) * up
        return self.eye(), direction / np.linalg.norm(direction)

    def fit(
        self,
        points: ArrayLike,
        size: tuple[int, int],
        frame: tuple[float, float, float, float] | None = None,
    ) -> None:
        """Moves, without turning, as near as it can with all points inside a frame of the picture.

        `frame` is left, top, right, bottom in pixels; without it, the whole picture. Every side of
        the frame bounds the eye by one plane through each point, so the nearest eye has a closed
        form: along right, with a = max(x - t_r z) and b = min(x - t_l z) over the points,
        a + t_r e_z <= e_x <= b + t_l e_z. Raises ValueError for an empty frame.
        """
        left, top, right, bottom = frame or (0.0, 0.0, float(size[0]), float(size[1]))
        if not (left < right and top < bottom):
            raise ValueError(f"frame must be left, top, right, bottom, got {frame}")
        axes = self.basis()
        p = np.atleast_2d(np.asarray(points, dtype=float))
        x, y, z = (p @ axis for axis in axes)
        focal = size[1] / 2 / math.tan(self.field_of_view / 2)
        tl, tr = (left - size[0] / 2) / focal, (right - size[0] / 2) / focal
        tb, tt = (size[1] / 2 - bottom) / focal, (size[1] / 2 - top) / focal
        ar, al = (x - tr * z).max(), (x - tl * z).min()
        at, ab = (y - tt * z).max(), (y - tb * z).min()
        # a single point would be fitted from no distance at all
        smallest = 1e-3 * max(1.0, np.abs(p).max())
        ez = min((al - ar) / (tr - tl), (ab - at) / (tt - tb), z.min() - smallest)
        ex = ((ar + tr * ez) + (al + tl * ez)) / 2
        ey = ((at + tt * ez) + (ab + tb * ez)) / 2
        eye = ex * axes[0] + ey * axes[1] + ez * axes[2]
        self.distance = float((z.min() + z.max()) / 2 - ez)
        self.target = eye + self.distance * axes[2]

    def depths(self, centre: ArrayLike, radius: float) -> tuple[float, float]:
        """Near and far planes [m] that just hold a ball."""
        middle = float((np.asarray(centre, dtype=float) - self.eye()) @ self.basis()[2])
        far = max(middle + 1.01 * radius, 1e-6)
        return max(middle - 1.01 * radius, 1e-3 * far), far

    def orbit(self, azimuth: float, elevation: float) -> None:
        """Turns around the target by angles [rad], stopping straight above and below."""
        self.azimuth = math.remainder(self.azimuth + azimuth, 2 * math.pi)
        self.elevation = min(max(self.elevation + elevation, -STEEPEST), STEEPEST)

    def pan(self, x: float, y: float, size: tuple[int, int]) -> None:
        """Moves so that what lies at the target's depth follows a drag of (x, y) pixels."""
        right, up, _ = self.basis()
        metres = 2 * self.distance * math.tan(self.field_of_view / 2) / size[1]
        self.target = np.asarray(self.target, dtype=float) + metres * (y * up - x * right)

    def zoom(self, factor: float) -> None:
        """Divides the distance by `factor`. Raises ValueError unless it is positive."""
        if not factor > 0.0:
            raise ValueError(f"factor must be positive, got {factor}")
        self.distance /= factor

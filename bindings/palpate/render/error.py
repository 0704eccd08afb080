# SPDX-License-Identifier: BSD-3-Clause
"""What the renderer refuses with."""

from __future__ import annotations


class RenderError(RuntimeError):
    """This machine cannot draw: no OpenGL library, no context, or one that is too old."""

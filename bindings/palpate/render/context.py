# SPDX-License-Identifier: BSD-3-Clause
"""OpenGL with no display: a standalone context through EGL."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import moderngl

from palpate.render.error import RenderError

GL_VERSION = 330
"""OpenGL 3.3 core: the oldest with all we need, and what macOS's frozen 4.1 still has."""
LIBGL = "libGL.so.1"
LIBEGL = "libEGL.so.1"
"""The names of run-time packages; glcontext's own defaults need the -dev packages."""


def create_context(libgl: str = LIBGL, libegl: str = LIBEGL) -> moderngl.Context:
    """An OpenGL 3.3 context of our own, to be entered in a with statement wherever it is used.

    Raises RenderError where this machine has none. The caller releases it.
    """
    try:
        return moderngl.create_context(
            require=GL_VERSION, standalone=True, backend="egl", libgl=libgl, libegl=libegl
        )
    except Exception as problem:  # glcontext and moderngl raise bare Exception, ValueError, ...
        raise RenderError(
            f"no OpenGL 3.3 context without a display: {problem}. Debian's packages libgl1 and "
            f"libegl1 hold {libgl}, {libegl} and a software driver: "
            "apt-get install --no-install-recommends libgl1 libegl1"
        ) from problem


@contextmanager
def open_context(libgl: str = LIBGL, libegl: str = LIBEGL) -> Iterator[moderngl.Context]:
    """An OpenGL 3.3 context of our own, current until the end of the with statement.

    Raises RenderError where this machine has none.
    """
    context = create_context(libgl, libegl)
    try:
        with context:
            yield context
    finally:
        # takes with it whatever was made in the context and not released
        context.release()


def describe_gl() -> str:
    """Vendor, renderer and version of the OpenGL that draws pictures. Raises RenderError."""
    with open_context() as context:
        info = context.info
        return f"{info['GL_VENDOR']}, {info['GL_RENDERER']}, OpenGL {info['GL_VERSION']}"

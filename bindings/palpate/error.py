# SPDX-License-Identifier: BSD-3-Clause
"""What the library refuses with: the Python twins of core/sim/base/error.h.

Both come out of C++ as these very classes, and Python code raises them with the same arguments.
"""

from __future__ import annotations


class FileError(OSError):
    """A file that is refused: which file, where in it, what was got and what was expected."""

    def __init__(self, file: str, where: str, got: str, expected: str):
        place = f"{file}: {where}" if where else file
        super().__init__(f"{place}: got {got}, expected {expected}")
        self.file, self.where, self.got, self.expected = file, where, got, expected

    def __reduce__(self) -> tuple[type[FileError], tuple[str, str, str, str]]:
        return type(self), (self.file, self.where, self.got, self.expected)


class NotDurable(FileError):
    """The file is in place, whole, but the disk has not confirmed its name: a loss of power now
    may bring back what stood there before."""


class DeviceError(OSError):
    """A device that cannot be opened or has stopped responding."""

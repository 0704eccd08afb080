# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits that a reader of foreign files puts on itself, as palpate-read-mesh does (confine.cpp)."""

from __future__ import annotations

import ctypes
import os
import resource
import signal
import struct

CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446
"""Calls of Landlock [landlock(7)]; the same numbers on every processor."""
ASK_VERSION, PATH_BENEATH, READ_FILE, READ_FOLDER = 1, 1, 1 << 2, 1 << 3
SET_DEATH_SIGNAL, SET_NO_NEW_PRIVILEGES = 1, 38
"""Of prctl."""


def confine(path: str, libraries: list[str], memory: int, seconds: int) -> None:
    """From here on this process can read one file, compute, and write to what is open.

    Args:
        path: The file.
        libraries: Folders that may be read: of modules, of which numpy loads some when first used.
        memory: [bytes] of address space.
        seconds: [s] of processor time.
    """
    libc = ctypes.CDLL(None, use_errno=True)
    libc.prctl(SET_DEATH_SIGNAL, signal.SIGKILL, 0, 0, 0)
    for kind, most in (
        (resource.RLIMIT_AS, memory),
        (resource.RLIMIT_CPU, seconds),
        (resource.RLIMIT_FSIZE, 0),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_NPROC, 0),
    ):
        hard = resource.getrlimit(kind)[1]
        least = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(kind, (least, least))
    restrict_to(libc, path, libraries)


def restrict_to(libc: ctypes.CDLL, path: str, libraries: list[str]) -> None:
    """Nothing where the kernel has no Landlock; ends the process where it does not obey."""
    version = libc.syscall(CREATE_RULESET, None, ctypes.c_size_t(0), ASK_VERSION)
    if version < 1:
        return
    rights = 16 if version >= 5 else 15 if version >= 3 else 14 if version >= 2 else 13
    words = [(1 << rights) - 1]
    if version >= 4:
        words.append(3)  # to bind, to connect
    if version >= 6:
        words.append(3)  # abstract sockets, signals
    wanted = struct.pack(f"={len(words)}Q", *words)
    ruleset = libc.syscall(CREATE_RULESET, wanted, ctypes.c_size_t(len(wanted)), 0)
    obeyed = ruleset >= 0 and allow(libc, ruleset, path, READ_FILE)
    for folder in libraries:
        obeyed = obeyed and allow(libc, ruleset, folder, READ_FILE | READ_FOLDER)
    obeyed = (
        obeyed
        and libc.prctl(SET_NO_NEW_PRIVILEGES, 1, 0, 0, 0) == 0
        and libc.syscall(RESTRICT_SELF, ruleset, 0) == 0
    )
    if not obeyed:
        os._exit(6)
    os.close(ruleset)


def allow(libc: ctypes.CDLL, ruleset: int, path: str, access: int) -> bool:
    handle = os.open(path, os.O_PATH | os.O_CLOEXEC)
    rule = struct.pack("=Qi", access, handle)
    added = libc.syscall(ADD_RULE, ruleset, PATH_BENEATH, rule, 0) == 0
    os.close(handle)
    return added

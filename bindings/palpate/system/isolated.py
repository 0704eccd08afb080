# SPDX-License-Identifier: BSD-3-Clause
"""How Palpate starts another Python: nothing is imported from the folder the user stands in.

`python -c` and `python -m` look for modules in the current folder first, so a json.py beside an
organ would run in place of the library's. Every process that bindings/ and editor/ start begins
with the arguments that `build_command` gives.
"""

from __future__ import annotations

import sys


def build_command(*arguments: object) -> list[str]:
    """This interpreter with `arguments`; its modules are those installed with it."""
    # -P and not -I, under which what a user installed for himself alone would be missing
    return [sys.executable, "-P", *map(str, arguments)]


def build_isolated(*arguments: object) -> list[str]:
    """This interpreter with `arguments`, deaf to its environment and to what a user installed for
    himself alone: for a script of ours that opens what strangers wrote, and is told its folders."""
    return [sys.executable, "-I", *map(str, arguments)]


def build_verb(*arguments: object) -> list[str]:
    """The command `palpate` with `arguments`, of this very installation."""
    return build_command("-m", "palpate", *arguments)

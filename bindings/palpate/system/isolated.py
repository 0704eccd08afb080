# SPDX-License-Identifier: BSD-3-Clause
"""How Palpate starts another Python: nothing is imported from the folder the user stands in.

`python -c` and `python -m` look for modules in the current folder first, so a json.py beside an
organ would run in place of the library's. Every process that bindings/ and editor/ start begins
with the words that `build_command` gives.
"""

from __future__ import annotations

import sys


def build_command(*words: object) -> list[str]:
    """This interpreter with `words`, its modules from where it and its packages are installed."""
    # -P and not -I, under which what a user installed for himself alone would be missing
    return [sys.executable, "-P", *map(str, words)]


def build_verb(*words: object) -> list[str]:
    """The command `palpate` with `words`, of this very installation."""
    return build_command("-m", "palpate", *words)

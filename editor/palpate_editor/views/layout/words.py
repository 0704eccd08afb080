# SPDX-License-Identifier: GPL-3.0-or-later
"""What a change is called on the command line, and what is said of one."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from palpate.layout.document import Layout
from palpate.layout.separate import Separation

from palpate_editor.layout_changes import Words
from palpate_editor.views.translations import number, tr


def list_adding(layout: Layout, kind: str, path: Path) -> Words:
    """The words that add a file, under a name that is not taken."""
    names = {part.name for part in layout.parts}
    name, count = path.stem, 2
    while name in names:
        name, count = f"{path.stem} {count}", count + 1
    words = ["add", str(path)]
    if kind != "organ":
        words += ["--as", kind]
    return (*words, "--name", name) if name != path.stem else tuple(words)


def say_move(layout: Layout, separation: Separation) -> str:
    far = 1e3 * float(np.linalg.norm(np.asarray(separation.shift)))
    return tr("{name} was moved {far} mm away from {other}.").format(
        name=layout.bodies[separation.body].name,
        other=layout.bodies[separation.other].name,
        far=number(far, 3),
    )

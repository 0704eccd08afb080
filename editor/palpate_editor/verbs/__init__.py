# SPDX-License-Identifier: GPL-3.0-or-later
"""The designer's verbs: all that the window does, without a window."""

from __future__ import annotations

from palpate_editor.verbs import (
    advise,
    appearance,
    calibrate,
    chart,
    check,
    decimate,
    demo,
    felt,
    fill,
    inspect,
    mesh,
    organs,
    paint,
    publish,
    rebuild,
    repair,
    scan,
    stability,
    tissue,
    tissue_library,
    tool,
    truth,
)
from palpate_editor.verbs.editor import EDITOR

VERBS = [
    *inspect.VERBS,
    *mesh.VERBS,
    *decimate.VERBS,
    *scan.VERBS,
    *tissue.VERBS,
    *tool.VERBS,
    *fill.VERBS,
    *tissue_library.VERBS,
    *appearance.VERBS,
    *paint.VERBS,
    *calibrate.VERBS,
    *check.VERBS,
    *repair.VERBS,
    *publish.VERBS,
    *rebuild.VERBS,
    *organs.VERBS,
    *felt.VERBS,
    *advise.VERBS,
    *chart.VERBS,
    *stability.VERBS,
    *truth.VERBS,
    *demo.VERBS,
    EDITOR,
]

# SPDX-License-Identifier: GPL-3.0-or-later
"""How the view shows what is painted: fixed vertices as highlight, local stiffness as colours."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from palpate.viewport import View

from palpate_editor.document import Organ
from palpate_editor.views.translations import tr

FAINT_FIXED = 0.45
"""[-] highlight of fixed vertices beside selected ones."""
LEAST_TOP = 2.0
"""[-] stiffness factor at the end of the legend, so that an even organ is not all at one end."""


def show_fixed(view: View, fixed: NDArray[np.bool_], selected: NDArray[np.bool_] | None) -> None:
    """Highlights fixed vertices, fainter where there is a selection beside them."""
    if selected is None:
        weights = fixed.astype(float)
    else:
        weights = np.where(selected, 1.0, np.where(fixed, FAINT_FIXED, 0.0))
    view.show_selection(weights if weights.any() else None)


def show_stiffness(view: View, scale: NDArray[np.float64], always: bool = False) -> None:
    """Colours by stiffness factor; plain tissue where it is 1 everywhere, unless `always`."""
    if len(scale) == 0 or (not always and bool((scale == 1.0).all())):
        view.show_values(None)
        return
    top = max(LEAST_TOP, float(math.ceil(scale.max())))
    view.show_values(scale, tr("stiffness factor"), (0.0, top))


def show_painted(view: View, organ: Organ) -> None:
    """An organ at rest with all that was painted on it."""
    if organ.surface is None:
        return
    show_fixed(view, organ.fixed, None)
    show_stiffness(view, organ.stiffness_scale)

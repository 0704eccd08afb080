# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Material stage says of a tissue, in sentences and rows."""

from __future__ import annotations

import palpate
from palpate.scene.scene_parts import FINITE, VALIDATED_TIPS

from palpate_editor.document import Organ
from palpate_editor.document.cost_rules import TICK_SHARE
from palpate_editor.document.fill_rules import LEAST_DIHEDRAL
from palpate_editor.document.phrase import Phrase
from palpate_editor.document.press_rules import MOST_HOME_SHARE
from palpate_editor.document.problems import TissueFacts
from palpate_editor.views.stages.facts import Fact
from palpate_editor.views.translations import number, quantity, say, tr

ROUNDING = 1e-6
"""[-] an error of stretching below this is that of the computer's numbers."""


def say_error(error: float) -> str:
    """Rounding is no error."""
    return tr("none at rest") if error < ROUNDING else f"{number(100.0 * error, 2)} %"


def say_origin(organ: Organ) -> str:
    """What Young's modulus and its like do in this organ."""
    if organ.model.kind == "shell":
        return tr(
            "These five give the wall its stretching and its bending; nothing else need be chosen."
        )
    if organ.model.kind == "solid":
        return tr(
            "Young's modulus and Poisson's ratio give springs and volumes their constants; nothing "
            "else need be chosen."
        )
    if organ.model.kind == "linear_solid":
        return tr(
            "Young's modulus and Poisson's ratio are its law. It is good for presses of up to "
            "{share} % of the thickness; a deeper one ends the run."
        ).format(share=f"{100 * palpate.SHALLOW:.0f}")
    if organ.model.kind in FINITE:
        return tr(
            "Young's modulus and Poisson's ratio are its law for small strains; it may be strained "
            "and turned far. It runs in plain code, which takes longer than springs do."
        )
    if organ.model.constants == "tissue":
        return tr(
            "Young's modulus, Poisson's ratio and the wall's thickness give every spring and bond "
            "its constants. Choose them by hand to go on from there."
        )
    if organ.material.wall_thickness is None:
        return tr(
            "Springs and bonds take the stiffness below, so Young's modulus and Poisson's ratio "
            "have no effect. They count in a solid, and in a wall that has a thickness."
        )
    if organ.model.home_stiffness is not None:
        return tr(
            "Springs and bonds take the stiffness below, and home springs their own value, so "
            "Young's modulus and Poisson's ratio have no effect on the force: the wall is only "
            "compared with them."
        )
    return tr(
        "Springs and bonds take the stiffness below. Young's modulus sets the home springs of a "
        "hollow organ where they have no own value, and what its wall is compared with."
    )


def say_compared(error: Phrase) -> str:
    """Of a kind that no shipped organ is of."""
    return tr("For comparison: {error}.").format(error=say(error))


def home_rows(tissue: TissueFacts) -> list[Fact]:
    """What of the felt force home springs carry."""
    shares = () if tissue.trial is None else tissue.trial.home_shares
    if not shares:
        return []
    least, most = (f"{round(100.0 * share) + 0:d}" for share in (min(shares), max(shares)))
    span = most if least == most else f"{least} \N{EN DASH} {most}"
    tone = "good" if max(shares) <= MOST_HOME_SHARE else "warning"
    return [(tr("Home springs carry"), tr("{span} % of the force").format(span=span), tone)]


def filling_rows(tissue: TissueFacts) -> list[Fact]:
    """How flat and how fine the tetrahedra of a solid are."""
    found = tissue.filling
    if found is None:
        return []
    tone = "good" if found.smallest_angle_deg >= LEAST_DIHEDRAL else "warning"
    angle = f"{number(found.smallest_angle_deg, 3)}°"
    least, median, most = (number(1e3 * edge, 2) for edge in found.edges)
    span = tr("{least} to {most} mm, {median} in the middle")
    rows: list[Fact] = [
        (tr("Smallest angle between faces"), angle, tone),
        (tr("Edges"), span.format(least=least, most=most, median=median)),
    ]
    if found.fine_edge is not None:
        rows.append((tr("Edges at the finer region"), quantity(1e3 * found.fine_edge, "mm", 2)))
    return rows


def validity_rows(tissue: TissueFacts) -> list[Fact]:
    """How deep the tool may go, by place."""
    if tissue.trial is None:
        return []
    depths = tissue.trial.validated
    if not depths:
        tips = [number(1e3 * radius, 2) for radius in VALIDATED_TIPS]
        text = tr("no depth: only balls of {least} to {most} mm are")
        return [(tr("Validated to"), text.format(least=tips[0], most=tips[1]))]
    least, most = (number(1e3 * depth, 2) for depth in (min(depths), max(depths)))
    span = most if least == most else f"{least} \N{EN DASH} {most}"
    return [(tr("Validated to"), tr("{span} mm deep, by place").format(span=span))]


def share_rows(share: float | None) -> list[Fact]:
    """What of its time a tick takes."""
    if share is None:
        return []
    tone = "good" if share <= TICK_SHARE else "warning"
    text = tr("about {share} % of its time").format(share=f"{100 * share:.0f}")
    return [(tr("A tick in touch takes"), text, tone)]

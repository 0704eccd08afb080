# SPDX-License-Identifier: GPL-3.0-or-later
"""How deep the scripted press goes, beside what is validated at its place."""

from __future__ import annotations

from palpate.runs.validated import find_validity

from palpate_editor.document.depth_rules import find_depth_problems
from palpate_editor.document.problems import PressFacts, Problem
from palpate_editor.trial import describe_place
from palpate_editor.views.assessment import Assessment
from palpate_editor.views.touch.press_form import PressForm
from palpate_editor.views.touch.runner import find_target
from palpate_editor.views.translations import number, tr


def judge_press(found: Assessment | None, form: PressForm) -> tuple[list[Problem], list[str]]:
    """What is wrong with the depth of the form's press, and what is right; nothing of an organ
    that cannot be built."""
    if found is None or found.scene is None:
        return [], []
    place = find_target(found.scene, form.place)
    validity = find_validity(found.scene, place, found.organ.material.wall_thickness)
    press = PressFacts(form.script().depth, describe_place(place, validity))
    problems = list(find_depth_problems(found.organ, [press]))
    text = tr("The press stays within the {depth} mm that are validated there.")
    news = [] if problems else [text.format(depth=number(1e3 * validity.depth, 2))]
    return problems, news

# SPDX-License-Identifier: GPL-3.0-or-later
"""The actions of View: stages, camera, colours, theme, language, full screen."""

from __future__ import annotations

from palpate_editor.document.problems import STAGES
from palpate_editor.views.action_targets import ActionTargets
from palpate_editor.views.order import Order
from palpate_editor.views.stage_bar import stage_title
from palpate_editor.views.words import tr


def view_orders(w: ActionTargets) -> list[Order]:
    looks = [
        (tr("&Front"), w.deeds.look_front, "1"),
        (tr("&Right"), w.deeds.look_right, "3"),
        (tr("&Above"), w.deeds.look_above, "7"),
        (tr("&Behind"), w.deeds.look_behind, "Ctrl+Alt+1"),
        (tr("&Left"), w.deeds.look_left, "Ctrl+Alt+3"),
        (tr("Be&low"), w.deeds.look_below, "Ctrl+Alt+7"),
    ]
    colours = [
        ("auto", tr("As the &stage needs"), w.deeds.colour_auto),
        ("plain", tr("&Tissue"), w.deeds.colour_plain),
        ("stiffness", tr("Stiff&ness"), w.deeds.colour_stiffness),
        ("distance", tr("&Distance to the source"), w.deeds.colour_distance),
    ]
    orders = [
        Order(
            f"stage_{stage}",
            "stages",
            stage_title(stage),
            w.on_stage_action,
            (f"Ctrl+{i}",),
            group="stages",
        )
        for i, stage in enumerate(STAGES, start=1)
    ]
    orders += [
        Order("frame", "view", tr("Show &all"), w.deeds.frame_all, ("Home", "F"), "frame"),
        Order(
            "wireframe",
            "view",
            tr("&Wireframe"),
            w.deeds.switch_wireframe,
            ("W",),
            "wire",
            checkable=True,
        ),
    ]
    orders += [
        Order(f"look_{i}", "directions", text, slot, (key,))
        for i, (text, slot, key) in enumerate(looks)
    ]
    orders += [
        Order(f"colour_{name}", "colours", text, slot, (f"Alt+{i}",), group="colours")
        for i, (name, text, slot) in enumerate(colours, start=1)
    ]
    orders += [
        Order(
            "theme_system",
            "theme",
            tr("As the &desktop"),
            w.looks.theme_system,
            ("Ctrl+Alt+T",),
            group="theme",
        ),
        Order(
            "theme_dark", "theme", tr("&Dark"), w.looks.theme_dark, ("Ctrl+Alt+D",), group="theme"
        ),
        Order(
            "theme_light",
            "theme",
            tr("&Light"),
            w.looks.theme_light,
            ("Ctrl+Alt+L",),
            group="theme",
        ),
        Order(
            "language_en",
            "language",
            "English",
            w.looks.language_en,
            ("Ctrl+Alt+E",),
            group="language",
        ),
        Order(
            "language_tr",
            "language",
            "Türkçe",
            w.looks.language_tr,
            ("Ctrl+Alt+U",),
            group="language",
        ),
        Order(
            "full",
            "view",
            tr("&Full screen"),
            w.switch_full,
            ("F11",),
            checkable=True,
            line_before=True,
        ),
        Order("reset", "view", tr("&Reset layout"), w.reset_layout, ("Ctrl+Alt+R",), "reset"),
    ]
    return orders

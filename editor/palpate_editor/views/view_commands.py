# SPDX-License-Identifier: GPL-3.0-or-later
"""The actions of View: stages, camera, colours, theme, language, full screen."""

from __future__ import annotations

from palpate_editor.views.command import Command
from palpate_editor.views.command_targets import CommandTargets
from palpate_editor.views.translations import tr


def view_commands(w: CommandTargets) -> list[Command]:
    stages = w.context.stages
    directions = [
        (tr("&Front"), w.menu_actions.look_front, "1"),
        (tr("&Right"), w.menu_actions.look_right, "3"),
        (tr("&Above"), w.menu_actions.look_above, "7"),
        (tr("&Behind"), w.menu_actions.look_behind, "Ctrl+Alt+1"),
        (tr("&Left"), w.menu_actions.look_left, "Ctrl+Alt+3"),
        (tr("Be&low"), w.menu_actions.look_below, "Ctrl+Alt+7"),
    ]
    colours = [
        ("auto", tr("As the &stage needs"), w.menu_actions.colour_auto),
        ("plain", tr("&Tissue"), w.menu_actions.colour_plain),
        ("stiffness", tr("Stiff&ness"), w.menu_actions.colour_stiffness),
        ("distance", tr("&Distance to the source"), w.menu_actions.colour_distance),
    ]
    commands = [
        Command(
            f"stage_{stage}",
            "stages",
            stages.title(stage),
            w.on_stage_action,
            (f"Ctrl+{i}",),
            group="stages",
        )
        for i, stage in enumerate(stages.names, start=1)
    ]
    commands += [
        Command("frame", "view", tr("Show &all"), w.menu_actions.frame_all, ("Home", "F"), "frame"),
        Command(
            "wireframe",
            "view",
            tr("&Wireframe"),
            w.menu_actions.switch_wireframe,
            ("W",),
            "wire",
            checkable=True,
        ),
        Command(
            "force_arrow",
            "view",
            tr("&Force as an arrow"),
            w.menu_actions.switch_force_arrow,
            ("Shift+F",),
            checkable=True,
        ),
    ]
    commands += [
        Command(f"look_{i}", "directions", text, slot, (key,))
        for i, (text, slot, key) in enumerate(directions)
    ]
    commands += [
        Command(f"colour_{name}", "colours", text, slot, (f"Alt+{i}",), group="colours")
        for i, (name, text, slot) in enumerate(colours, start=1)
    ]
    commands += [
        Command(
            "theme_system",
            "theme",
            tr("As the &desktop"),
            w.appearance.theme_system,
            ("Ctrl+Alt+T",),
            group="theme",
        ),
        Command(
            "theme_dark",
            "theme",
            tr("&Dark"),
            w.appearance.theme_dark,
            ("Ctrl+Alt+D",),
            group="theme",
        ),
        Command(
            "theme_light",
            "theme",
            tr("&Light"),
            w.appearance.theme_light,
            ("Ctrl+Alt+L",),
            group="theme",
        ),
        Command(
            "language_en",
            "language",
            "English",
            w.appearance.language_en,
            ("Ctrl+Alt+E",),
            group="language",
        ),
        Command(
            "language_tr",
            "language",
            "Türkçe",
            w.appearance.language_tr,
            ("Ctrl+Alt+U",),
            group="language",
        ),
        Command(
            "full",
            "view",
            tr("&Full screen"),
            w.switch_full,
            ("F11",),
            checkable=True,
            line_before=True,
        ),
        Command("reset", "view", tr("&Reset layout"), w.reset_layout, ("Ctrl+Alt+R",), "reset"),
    ]
    return commands

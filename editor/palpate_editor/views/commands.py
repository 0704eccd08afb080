# SPDX-License-Identifier: GPL-3.0-or-later
"""Every action of the window in one table: its menu, its name, its keys, and what it does."""

from __future__ import annotations

from palpate_editor.views.command import Command
from palpate_editor.views.command_targets import CommandTargets
from palpate_editor.views.translations import tr
from palpate_editor.views.view_commands import view_commands


def build_commands(w: CommandTargets) -> list[Command]:
    """All of them, in the order of the menus."""
    return [
        *file_commands(w),
        *edit_commands(w),
        *view_commands(w),
        *mesh_commands(w),
        *material_commands(w),
        *simulate_commands(w),
        *publish_commands(w),
        *help_commands(w),
    ]


def file_commands(w: CommandTargets) -> list[Command]:
    f = w.files
    return [
        Command("new", "file", tr("&New"), f.start_new, ("Ctrl+N",), "new"),
        Command("new_scene", "file", tr("New s&cene…"), f.ask_new_scene, ("Ctrl+Shift+E",), "new"),
        Command("open", "file", tr("&Open…"), f.ask_open, ("Ctrl+O",), "open"),
        Command("import", "file", tr("&Import a mesh…"), f.ask_import, ("Ctrl+Shift+I",), "import"),
        Command(
            "import_scan",
            "file",
            tr("Import from a s&can…"),
            w.ask_scan,
            ("Ctrl+Shift+N",),
            "import",
        ),
        Command("save", "file", tr("&Save"), f.save, ("Ctrl+S",), "save", line_before=True),
        Command("save_as", "file", tr("Save &as…"), f.ask_save, ("Ctrl+Shift+S",)),
        Command(
            "screenshot",
            "file",
            tr("Save a &picture…"),
            w.menu_actions.ask_picture,
            ("F12",),
            "camera",
            line_before=True,
        ),
        Command("quit", "file", tr("&Quit"), w.quit, ("Ctrl+Q",), line_before=True),
    ]


def edit_commands(w: CommandTargets) -> list[Command]:
    history = w.context.session.history
    return [
        Command("undo", "edit", tr("&Undo"), history.undo, ("Ctrl+Z",), "undo"),
        Command("redo", "edit", tr("&Redo"), history.redo, ("Ctrl+Shift+Z", "Ctrl+Y"), "redo"),
        Command(
            "palette",
            "edit",
            tr("&Find an action…"),
            w.show_palette,
            ("Ctrl+Shift+P",),
            "search",
            line_before=True,
        ),
    ]


def mesh_commands(w: CommandTargets) -> list[Command]:
    return [
        Command(
            "reimport",
            "mesh",
            tr("&Import again"),
            w.menu_actions.reimport,
            ("Ctrl+R",),
            needs_organ=True,
        ),
        Command(
            "turn",
            "mesh",
            tr("&Turn outwards"),
            w.menu_actions.turn_outward,
            ("Ctrl+Alt+O",),
            needs_organ=True,
        ),
        Command(
            "largest",
            "mesh",
            tr("Keep the &largest piece"),
            w.menu_actions.keep_largest,
            ("Ctrl+Alt+K",),
            needs_organ=True,
        ),
        Command(
            "decimate",
            "mesh",
            tr("&Decimate"),
            w.menu_actions.decimate,
            ("Ctrl+D",),
            "mesh",
            needs_organ=True,
        ),
        Command(
            "use_imported",
            "mesh",
            tr("&Use the imported surface"),
            w.menu_actions.use_imported,
            ("Ctrl+Shift+D",),
            needs_organ=True,
        ),
    ]


def material_commands(w: CommandTargets) -> list[Command]:
    return [
        *(
            Command(name, "material", text, slot, (keys,), group="kinds")
            for name, text, slot, keys in (
                ("mss", tr("&Mass–spring model"), w.menu_actions.use_mss, "Ctrl+Alt+S"),
                ("mms", tr("M&olecular model"), w.menu_actions.use_mms, "Ctrl+Alt+M"),
                ("shell", tr("S&hell of prisms"), w.menu_actions.use_shell, "Ctrl+Alt+H"),
                ("solid", tr("&Solid"), w.menu_actions.use_solid, "Ctrl+Alt+V"),
                ("linear", tr("L&inear solid"), w.menu_actions.use_linear, "Ctrl+Alt+I"),
                ("corotated", tr("&Corotated solid"), w.menu_actions.use_corotated, "Ctrl+Alt+W"),
                (
                    "neo-hookean",
                    tr("&Neo-Hookean solid"),
                    w.menu_actions.use_neo_hookean,
                    "Ctrl+Alt+Y",
                ),
            )
        ),
        Command(
            "fix_lowest",
            "material",
            tr("Fix the &lowest part"),
            w.menu_actions.fix_lowest,
            ("Ctrl+L",),
            "fix",
            needs_organ=True,
            line_before=True,
        ),
        Command(
            "free_all",
            "material",
            tr("&Free all"),
            w.menu_actions.free_all,
            ("Ctrl+Shift+L",),
            needs_organ=True,
        ),
        Command(
            "copy",
            "material",
            tr("&Copy the material"),
            w.menu_actions.copy_material,
            ("Ctrl+Shift+C",),
            line_before=True,
        ),
        Command(
            "paste",
            "material",
            tr("&Paste the material"),
            w.menu_actions.paste_material,
            ("Ctrl+Shift+V",),
        ),
        Command(
            "chart",
            "material",
            tr("Speed and &accuracy…"),
            w.show_chart,
            ("Ctrl+Alt+A",),
            line_before=True,
        ),
        Command("open_chart", "material", tr("&Open a chart…"), w.chart.ask_open, ("Ctrl+Alt+G",)),
        Command("stability", "material", tr("&Stability…"), w.show_atlas, ("Ctrl+Alt+J",)),
    ]


def simulate_commands(w: CommandTargets) -> list[Command]:
    test = w.test_panel
    return [
        Command(
            "run",
            "simulate",
            tr("&Feel it / pause"),
            w.toggle_run,
            ("Space",),
            "play",
            needs_organ=True,
        ),
        Command(
            "press",
            "simulate",
            tr("Scripted &press"),
            test.press,
            ("Shift+Space",),
            needs_organ=True,
        ),
        Command(
            "restart",
            "simulate",
            tr("&Back to rest"),
            test.reset,
            ("R",),
            "reset",
            needs_organ=True,
        ),
        Command(
            "record",
            "simulate",
            tr("Save the r&ecord…"),
            test.choose_record,
            ("Ctrl+Alt+P",),
            line_before=True,
        ),
        Command(
            "forces", "simulate", tr("E&xport the forces…"), test.plot.choose_csv, ("Ctrl+Alt+X",)
        ),
        Command(
            "clear_plot", "simulate", tr("Clear the force plo&t"), test.plot.clear, ("Ctrl+Alt+C",)
        ),
        Command(
            "check",
            "simulate",
            tr("&Check the organ"),
            w.menu_actions.check,
            ("F5",),
            "tick",
            needs_organ=True,
            line_before=True,
        ),
        Command(
            "device",
            "simulate",
            tr("Haptic de&vice…"),
            w.publishing.child_processes.open_device,
            ("F7",),
            line_before=True,
        ),
    ]


def publish_commands(w: CommandTargets) -> list[Command]:
    return [
        Command(
            "publish",
            "publish",
            tr("&Publish…"),
            w.publishing.ask,
            ("Ctrl+P",),
            "publish",
            needs_organ=True,
        ),
        Command(
            "play", "publish", tr("P&lay the published file"), w.publishing.play, ("F6",), "play"
        ),
    ]


def help_commands(w: CommandTargets) -> list[Command]:
    return [
        Command("help", "help", tr("&Help on this stage"), w.show_help, ("F1",), "info"),
        Command("keys", "help", tr("&Keyboard and mouse"), w.show_keys, ("Shift+F1",)),
        Command("about", "help", tr("&About Palpate"), w.show_about, ("Ctrl+F1",)),
    ]

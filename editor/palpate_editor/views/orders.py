# SPDX-License-Identifier: GPL-3.0-or-later
"""Every action of the window in one table: its menu, its name, its keys, and what it does."""

from __future__ import annotations

from palpate_editor.views.action_targets import ActionTargets
from palpate_editor.views.order import Order
from palpate_editor.views.view_orders import view_orders
from palpate_editor.views.words import tr


def build_orders(w: ActionTargets) -> list[Order]:
    """All of them, in the order of the menus."""
    return [
        *file_orders(w),
        *edit_orders(w),
        *view_orders(w),
        *mesh_orders(w),
        *material_orders(w),
        *simulate_orders(w),
        *publish_orders(w),
        *help_orders(w),
    ]


def file_orders(w: ActionTargets) -> list[Order]:
    f = w.files
    return [
        Order("new", "file", tr("&New"), f.start_anew, ("Ctrl+N",), "new"),
        Order("open", "file", tr("&Open…"), f.ask_open, ("Ctrl+O",), "open"),
        Order("import", "file", tr("&Import a mesh…"), f.ask_import, ("Ctrl+Shift+I",), "import"),
        Order("save", "file", tr("&Save"), f.save, ("Ctrl+S",), "save", line_before=True),
        Order("save_as", "file", tr("Save &as…"), f.ask_save, ("Ctrl+Shift+S",)),
        Order(
            "screenshot",
            "file",
            tr("Save a &picture…"),
            w.deeds.ask_picture,
            ("F12",),
            "camera",
            line_before=True,
        ),
        Order("quit", "file", tr("&Quit"), w.quit, ("Ctrl+Q",), line_before=True),
    ]


def edit_orders(w: ActionTargets) -> list[Order]:
    history = w.desk.session.history
    return [
        Order("undo", "edit", tr("&Undo"), history.undo, ("Ctrl+Z",), "undo"),
        Order("redo", "edit", tr("&Redo"), history.redo, ("Ctrl+Shift+Z", "Ctrl+Y"), "redo"),
        Order(
            "palette",
            "edit",
            tr("&Find an action…"),
            w.show_palette,
            ("Ctrl+Shift+P",),
            "search",
            line_before=True,
        ),
    ]


def mesh_orders(w: ActionTargets) -> list[Order]:
    return [
        Order(
            "reimport", "mesh", tr("&Import again"), w.deeds.reimport, ("Ctrl+R",), needs_organ=True
        ),
        Order(
            "turn",
            "mesh",
            tr("&Turn outwards"),
            w.deeds.turn_outward,
            ("Ctrl+Alt+O",),
            needs_organ=True,
        ),
        Order(
            "largest",
            "mesh",
            tr("Keep the &largest piece"),
            w.deeds.keep_largest,
            ("Ctrl+Alt+K",),
            needs_organ=True,
        ),
        Order(
            "decimate",
            "mesh",
            tr("&Decimate"),
            w.deeds.decimate,
            ("Ctrl+D",),
            "mesh",
            needs_organ=True,
        ),
        Order(
            "use_imported",
            "mesh",
            tr("&Use the imported surface"),
            w.deeds.use_imported,
            ("Ctrl+Shift+D",),
            needs_organ=True,
        ),
    ]


def material_orders(w: ActionTargets) -> list[Order]:
    return [
        *(
            Order(name, "material", text, slot, (keys,), group="kinds")
            for name, text, slot, keys in (
                ("mss", tr("&Mass–spring model"), w.deeds.use_mss, "Ctrl+Alt+S"),
                ("mms", tr("M&olecular model"), w.deeds.use_mms, "Ctrl+Alt+M"),
                ("shell", tr("S&hell of prisms"), w.deeds.use_shell, "Ctrl+Alt+H"),
                ("solid", tr("&Solid"), w.deeds.use_solid, "Ctrl+Alt+V"),
                ("linear", tr("L&inear solid"), w.deeds.use_linear, "Ctrl+Alt+I"),
            )
        ),
        Order(
            "fix_lowest",
            "material",
            tr("Fix the &lowest part"),
            w.deeds.fix_lowest,
            ("Ctrl+L",),
            "fix",
            needs_organ=True,
            line_before=True,
        ),
        Order(
            "free_all",
            "material",
            tr("&Free all"),
            w.deeds.free_all,
            ("Ctrl+Shift+L",),
            needs_organ=True,
        ),
        Order(
            "copy",
            "material",
            tr("&Copy the material"),
            w.deeds.copy_material,
            ("Ctrl+Shift+C",),
            line_before=True,
        ),
        Order(
            "paste",
            "material",
            tr("&Paste the material"),
            w.deeds.paste_material,
            ("Ctrl+Shift+V",),
        ),
    ]


def simulate_orders(w: ActionTargets) -> list[Order]:
    test = w.test_panel
    return [
        Order(
            "run",
            "simulate",
            tr("&Feel it / pause"),
            w.toggle_run,
            ("Space",),
            "play",
            needs_organ=True,
        ),
        Order(
            "press",
            "simulate",
            tr("Scripted &press"),
            test.press,
            ("Shift+Space",),
            needs_organ=True,
        ),
        Order(
            "restart",
            "simulate",
            tr("&Back to rest"),
            test.reset,
            ("R",),
            "reset",
            needs_organ=True,
        ),
        Order(
            "record",
            "simulate",
            tr("Save the r&ecord…"),
            test.choose_record,
            ("Ctrl+Alt+P",),
            line_before=True,
        ),
        Order(
            "forces", "simulate", tr("E&xport the forces…"), test.plot.choose_csv, ("Ctrl+Alt+X",)
        ),
        Order(
            "clear_plot", "simulate", tr("Clear the force plo&t"), test.plot.clear, ("Ctrl+Alt+C",)
        ),
        Order(
            "check",
            "simulate",
            tr("&Check the organ"),
            w.deeds.check,
            ("F5",),
            "tick",
            needs_organ=True,
            line_before=True,
        ),
        Order(
            "device",
            "simulate",
            tr("Haptic de&vice…"),
            w.publishing.companions.open_device,
            ("F7",),
            line_before=True,
        ),
    ]


def publish_orders(w: ActionTargets) -> list[Order]:
    return [
        Order(
            "publish",
            "publish",
            tr("&Publish…"),
            w.publishing.ask,
            ("Ctrl+P",),
            "publish",
            needs_organ=True,
        ),
        Order(
            "play", "publish", tr("P&lay the published file"), w.publishing.play, ("F6",), "play"
        ),
    ]


def help_orders(w: ActionTargets) -> list[Order]:
    return [
        Order("help", "help", tr("&Help on this stage"), w.show_help, ("F1",), "info"),
        Order("keys", "help", tr("&Keyboard and mouse"), w.show_keys, ("Shift+F1",)),
        Order("about", "help", tr("&About Palpate"), w.show_about, ("Ctrl+F1",)),
    ]

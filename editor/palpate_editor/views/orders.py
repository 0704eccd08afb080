# SPDX-License-Identifier: GPL-3.0-or-later
"""Every action of the window in one table: its menu, its name, its keys, and what it does."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from palpate_editor.views.stage_bar import STAGES, stage_title
from palpate_editor.views.words import tr

if TYPE_CHECKING:
    from palpate_editor.views.window import MainWindow

MENUS = ("file", "edit", "view", "mesh", "material", "simulate", "publish", "help")


def menu_title(menu: str) -> str:
    return {
        "file": tr("&File"),
        "edit": tr("&Edit"),
        "view": tr("&View"),
        "mesh": tr("&Mesh"),
        "material": tr("M&aterial"),
        "simulate": tr("&Simulate"),
        "publish": tr("&Publish"),
        "help": tr("&Help"),
        "recent": tr("Open &recent"),
        "stages": tr("&Stage"),
        "colours": tr("&Colours"),
        "directions": tr("&Look from"),
        "theme": tr("&Theme"),
        "language": tr("&Language"),
        "docks": tr("&Panels"),
    }[menu]


@dataclass(frozen=True)
class Order:
    """One action as it is asked for."""

    name: str
    menu: str
    text: str
    slot: Callable[[], None]
    """A bound method."""
    keys: tuple[str, ...] = ()
    sign: str = ""
    group: str = ""
    """Actions of one group exclude each other."""
    checkable: bool = False
    needs_organ: bool = False
    line_before: bool = False


def build_orders(w: MainWindow) -> list[Order]:
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


def file_orders(w: MainWindow) -> list[Order]:
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


def edit_orders(w: MainWindow) -> list[Order]:
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


def view_orders(w: MainWindow) -> list[Order]:
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


def mesh_orders(w: MainWindow) -> list[Order]:
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


def material_orders(w: MainWindow) -> list[Order]:
    return [
        Order("mss", "material", tr("&Mass–spring model"), w.deeds.use_mss, ("Ctrl+Alt+S",)),
        Order("mms", "material", tr("M&olecular model"), w.deeds.use_mms, ("Ctrl+Alt+M",)),
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


def simulate_orders(w: MainWindow) -> list[Order]:
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
    ]


def publish_orders(w: MainWindow) -> list[Order]:
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


def help_orders(w: MainWindow) -> list[Order]:
    return [
        Order("help", "help", tr("&Help on this stage"), w.show_help, ("F1",), "info"),
        Order("keys", "help", tr("&Keyboard and mouse"), w.show_keys, ("Shift+F1",)),
        Order("about", "help", tr("&About Palpate"), w.show_about, ("Ctrl+F1",)),
    ]

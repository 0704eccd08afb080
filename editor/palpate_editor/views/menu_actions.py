# SPDX-License-Identifier: GPL-3.0-or-later
"""What the menus do that no panel does: looking, colouring, repeating, copying."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from pathlib import Path

import numpy as np
from palpate.scene.scene_parts import MaterialPart, ModelPart
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication

from palpate_editor.edits import (
    FixLowest,
    FixVertices,
    KeepLargestShell,
    SetChoice,
    SetMaterial,
    TurnOutward,
    UseImported,
)
from palpate_editor.views.command_lines import render_arguments
from palpate_editor.views.context import Context
from palpate_editor.views.display import Display
from palpate_editor.views.files import Files
from palpate_editor.views.publishing import Publishing
from palpate_editor.views.tasks import Tasks
from palpate_editor.views.translations import say_problems, tr

LOWEST = 0.1
"""[-] of the height that the menu fixes; the form takes any share."""
CLIPBOARD = "palpate material"
"""Names our JSON on the clipboard."""
STEEPEST = math.radians(89.0)


class MenuActions(QObject):
    """Slots of the menus."""

    decimate_wanted = Signal()
    reimport_wanted = Signal()

    def __init__(
        self,
        context: Context,
        display: Display,
        files: Files,
        tasks: Tasks,
        publishing: Publishing,
        parent: QObject | None = None,
    ):
        super().__init__(parent)
        self.context, self.display, self.files = context, display, files
        self.tasks, self.publishing = tasks, publishing

    # ------------------------------------------------------------ looking

    def look(self, azimuth: float, elevation: float) -> None:
        """From a direction [rad]."""
        self.context.view.look_from(azimuth, elevation)

    def look_front(self) -> None:
        self.look(math.radians(-90.0), 0.0)

    def look_behind(self) -> None:
        self.look(math.radians(90.0), 0.0)

    def look_right(self) -> None:
        self.look(0.0, 0.0)

    def look_left(self) -> None:
        self.look(math.pi, 0.0)

    def look_above(self) -> None:
        self.look(math.radians(-90.0), STEEPEST)

    def look_below(self) -> None:
        self.look(math.radians(-90.0), -STEEPEST)

    def frame_all(self) -> None:
        self.context.view.frame_all()

    def switch_wireframe(self) -> None:
        self.context.view.wireframe = not self.context.view.wireframe

    def switch_force_arrow(self) -> None:
        self.context.view.shows_force = not self.context.view.shows_force

    def colour_auto(self) -> None:
        self.display.use_colouring("auto")

    def colour_plain(self) -> None:
        self.display.use_colouring("plain")

    def colour_stiffness(self) -> None:
        self.display.use_colouring("stiffness")

    def colour_distance(self) -> None:
        self.display.use_colouring("distance")

    # ------------------------------------------------------------ pictures

    def ask_picture(self) -> None:
        name = f"{self.context.stem()}.png"
        self.files.ask(tr("Save a picture"), [tr("Pictures (*.png)")], self.save_picture, save=name)

    def save_picture(self, name: str) -> None:
        """Writes what the viewport shows, with its legend."""
        path = Path(name)
        picture = self.context.view.grab_picture()
        if not picture.save(str(path)):
            self.context.tell(tr("{file} could not be written.").format(file=path))
            return
        arguments = render_arguments(self.published(), path, self.context.view, self.context.theme)
        self.context.log_command(arguments)
        self.context.tell(tr("Saved as {file}.").format(file=path.name), "info")

    def published(self) -> Path | str:
        """A file that `palpate render` can draw."""
        return self.publishing.path or f"{self.context.stem()}.palpate"

    # ------------------------------------------------------------ mesh

    def reimport(self) -> None:
        self.reimport_wanted.emit()

    def turn_outward(self) -> None:
        self.context.apply(TurnOutward())

    def keep_largest(self) -> None:
        self.tasks.apply_slowly(KeepLargestShell())

    def decimate(self) -> None:
        self.context.show_stage("decimate")
        self.decimate_wanted.emit()

    def use_imported(self) -> None:
        self.tasks.apply_slowly(UseImported())

    # ------------------------------------------------------------ material

    def use_mss(self) -> None:
        self.use_kind("mass_spring")

    def use_mms(self) -> None:
        self.use_kind("molecular")

    def use_shell(self) -> None:
        self.use_kind("shell")

    def use_solid(self) -> None:
        self.use_kind("solid")

    def use_linear(self) -> None:
        self.use_kind("linear_solid")

    def use_corotated(self) -> None:
        self.use_kind("corotated_solid")

    def use_neo_hookean(self) -> None:
        self.use_kind("neo_hookean_solid")

    def use_kind(self, kind: str) -> None:
        if self.context.session.organ.model.kind == kind:
            return
        self.context.apply(SetChoice("kind", kind))

    def fix_lowest(self) -> None:
        self.context.apply(FixLowest(LOWEST))

    def free_all(self) -> None:
        self.context.apply(FixVertices(np.flatnonzero(self.context.session.organ.fixed), False))

    def copy_material(self) -> None:
        """The constants as JSON, for this window, another one or an e-mail."""
        organ = self.context.session.organ
        model = asdict(organ.model) | {"fixed": [], "stiffness_scale": []}
        data = {"format": CLIPBOARD, "material": asdict(organ.material), "model": model}
        QGuiApplication.clipboard().setText(json.dumps(data, indent=2))
        self.context.tell(tr("The material is on the clipboard."), "info")

    def paste_material(self) -> None:
        edit = read_material(QGuiApplication.clipboard().text())
        if edit is None:
            self.context.tell(
                tr("There is no material on the clipboard: copy one first."), "warning"
            )
        else:
            self.context.apply(edit)

    # ------------------------------------------------------------ checks

    def check(self) -> None:
        """Says in how far the organ has problems."""
        assessment = self.context.assessment
        if assessment is None or not self.context.assessor.is_current:
            self.context.tell(tr("The organ is being checked: one moment."), "info")
            return
        errors = len(assessment.checked.errors)
        warnings = sum(p.severity == "warning" for p in assessment.problems)
        self.context.log_command(["palpate", "check", self.context.document()])
        if not errors and not warnings:
            self.context.tell(tr("This organ has no problems."), "info")
            return
        problems = say_problems(errors, warnings)
        self.context.tell(tr("{problems}: see Problems.").format(problems=problems), "warning")


def read_material(text: str) -> SetMaterial | None:
    """The material of a clipboard's text; None where there is none."""
    try:
        data = json.loads(text)
        if data.get("format") != CLIPBOARD:
            return None
        model = data["model"] | {"fixed": (), "stiffness_scale": ()}
        return SetMaterial(MaterialPart(**data["material"]), ModelPart(**model))
    except (ValueError, AttributeError, KeyError, TypeError):
        return None

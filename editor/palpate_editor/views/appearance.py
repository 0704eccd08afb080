# SPDX-License-Identifier: GPL-3.0-or-later
"""Theme and language of the window: chosen once, kept, changed without losing anything."""

from __future__ import annotations

from palpate.translation import LANGUAGES
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QApplication

from palpate_editor.views.action_set import ActionSet
from palpate_editor.views.context import Context
from palpate_editor.views.theme import prefers_dark, use_theme


class Appearance(QObject):
    """Slots of View > Theme and View > Language."""

    language_wanted = Signal(str)
    """The window must be made again in another language."""

    def __init__(self, context: Context, asked: str | None):
        super().__init__(context)
        self.context, self.asked = context, asked
        """`asked` is the theme of the command line, for this window alone."""
        context.theme = self.find_theme()

    def find_theme(self) -> str:
        chosen = self.asked or self.context.settings.theme
        if chosen != "system":
            return chosen
        app = QApplication.instance()
        return "dark" if not isinstance(app, QApplication) or prefers_dark(app) else "light"

    def begin(self, actions: ActionSet) -> None:
        """Dresses the window for the first time and marks what is in force."""
        actions.check(f"theme_{self.asked or self.context.settings.theme}")
        code = self.context.settings.language
        if code in LANGUAGES:
            actions.check(f"language_{code}")
        actions.check("colour_auto")
        actions.actions["wireframe"].setChecked(self.context.view.wireframe)
        actions.actions["force_arrow"].setChecked(self.context.view.shows_force)
        self.dress()

    def dress(self) -> None:
        app = QApplication.instance()
        assert isinstance(app, QApplication)
        theme = self.find_theme()
        use_theme(app, theme)
        self.context.use_theme(theme)

    def use_theme(self, theme: str) -> None:
        self.asked = None
        self.context.settings.theme = theme
        self.dress()

    def theme_system(self) -> None:
        self.use_theme("system")

    def theme_dark(self) -> None:
        self.use_theme("dark")

    def theme_light(self) -> None:
        self.use_theme("light")

    def language_en(self) -> None:
        self.use_language("en")

    def language_tr(self) -> None:
        self.use_language("tr")

    def use_language(self, language: str) -> None:
        self.context.settings.language = language
        self.language_wanted.emit(language)

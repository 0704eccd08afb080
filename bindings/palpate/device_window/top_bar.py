# SPDX-License-Identifier: BSD-3-Clause
"""Which device, and whether one is connected to it."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QWidget

from palpate.device.link import list_devices
from palpate.device.names import PLANT, find_port, read_device
from palpate.device_window.cards import build_button
from palpate.device_window.sentences import say_device, translate
from palpate.player.cards import build_label
from palpate.translation import LANGUAGES
from palpate.viewport.tone import set_tone


class TopBar(QWidget):
    """The list of devices, the button, the state in a pill, theme and language."""

    asked = Signal(str)
    """To connect to a device by name; empty to let it go."""
    theme_asked = Signal()
    language_asked = Signal(str)

    def __init__(self, parent: QWidget | None = None, with_language: bool = True):
        super().__init__(parent)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        self.brand = build_label("brand", self)
        self.devices = QComboBox(self)
        self.devices.setEditable(True)
        self.devices.setInsertPolicy(QComboBox.InsertPolicy.NoInsert)
        self.devices.setMinimumWidth(300)
        self.refresh, self.go = build_button(self), build_button(self, main=True)
        self.pill = build_label("pill", self)
        self.theme = build_button(self)
        self.languages = QComboBox(self)
        for code, name in LANGUAGES.items():
            self.languages.addItem(name, code)
        self.languages.setVisible(with_language)
        for widget in (self.brand, self.devices, self.refresh, self.go, self.pill):
            row.addWidget(widget)
        row.insertSpacing(1, 14)
        row.addStretch(1)
        row.addWidget(self.theme)
        row.addWidget(self.languages)
        self.refresh.clicked.connect(self.update_devices)
        self.go.clicked.connect(self._ask)
        self.theme.clicked.connect(self.theme_asked)
        self.languages.activated.connect(self._choose_language)
        self.connected = False
        self.update_devices()

    def chosen(self) -> str:
        """The device by name: of the list, or as it was typed."""
        text = self.devices.currentText().strip()
        index = self.devices.findText(text)
        if index >= 0:
            return str(self.devices.itemData(index))
        return read_device(text)

    def choose(self, name: str) -> None:
        index = self.devices.findData(name)
        if index >= 0:
            self.devices.setCurrentIndex(index)
        else:
            self.devices.setEditText(find_port(name) or name)

    def update_devices(self) -> None:
        """Looks for devices; what is chosen stays where it is still there."""
        before = self.chosen() if self.devices.count() else PLANT
        self.devices.clear()
        for row in list_devices():
            text = say_device(row["device"], row["product"])
            if not row["permitted"]:
                text += translate("Device", ", not permitted")
            self.devices.addItem(text, row["device"])
        self.choose(before)

    def show_state(self, text: str, tone: str) -> None:
        if self.pill.text() != text:
            self.pill.setText(text)
        set_tone(self.pill, tone)

    def show_connection(self, connected: bool, waiting: bool) -> None:
        self.connected = connected
        self.devices.setEnabled(not connected and not waiting)
        self.refresh.setEnabled(not connected and not waiting)
        self.go.setEnabled(not waiting)
        self.go.setText(
            translate("Device", "Connecting…") if waiting
            else translate("Device", "Disconnect") if connected
            else translate("Device", "Connect")
        )  # fmt: skip

    def say(self, theme: str, language: str) -> None:
        """Sets all texts."""
        self.brand.setText(translate("Device", "Device"))
        self.refresh.setText("\N{CLOCKWISE OPEN CIRCLE ARROW}")
        self.refresh.setToolTip(translate("Device", "Look for devices again"))
        self.theme.setText(
            translate("Device", "Light") if theme == "dark" else translate("Device", "Dark")
        )
        self.languages.setCurrentIndex(self.languages.findData(language))
        name = self.chosen()
        self.update_devices()
        self.choose(name)

    def _ask(self) -> None:
        self.asked.emit("" if self.connected else self.chosen())

    def _choose_language(self, index: int) -> None:
        self.language_asked.emit(self.languages.itemData(index))

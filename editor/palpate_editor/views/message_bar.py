# SPDX-License-Identifier: GPL-3.0-or-later
"""One strip over the viewport where the window speaks: a sentence, and no box to click away."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QToolButton, QWidget

from palpate_editor.views.icons import draw_icon, icon
from palpate_editor.views.theme import Colours
from palpate_editor.views.translations import tr

SHORT = 7000
"""[ms] a mere information stays; what went wrong stays until it is read or fixed."""
SIGNS = {"error": ("cross", "bad"), "warning": ("warning", "warning"), "info": ("info", "good")}


class MessageBar(QWidget):
    """Shows the newest sentence."""

    closed = Signal()

    def __init__(self, colours: Colours, parent: QWidget | None = None):
        super().__init__(parent)
        self.setObjectName("message_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.colours, self.severity = colours, "info"
        layout = QHBoxLayout(self)
        layout.setContentsMargins(12, 7, 7, 7)
        layout.setSpacing(10)
        self.sign = QLabel(self)
        self.label = QLabel(self)
        self.label.setWordWrap(True)
        self.label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.label.setTextFormat(Qt.TextFormat.PlainText)
        self.label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.button = QToolButton(self)
        self.button.setToolTip(tr("Dismiss"))
        self.button.clicked.connect(self.dismiss)
        layout.addWidget(self.sign)
        layout.addWidget(self.label, 1)
        layout.addWidget(self.button)
        if parent is not None:
            parent.installEventFilter(self)
        self.timer = QTimer(self, singleShot=True, interval=SHORT)
        self.timer.timeout.connect(self.dismiss)
        self.use_colours(colours)
        self.hide()

    def use_colours(self, colours: Colours) -> None:
        self.colours = colours
        self.button.setIcon(icon("cross", colours.faint))
        self.dress()

    def dress(self) -> None:
        sign, colour = SIGNS[self.severity]
        self.sign.setPixmap(draw_icon(sign, getattr(self.colours, colour), 18, 2.0))

    @property
    def text(self) -> str:
        """The sentence shown; empty where there is none."""
        return "" if self.isHidden() else self.label.text()

    def tell(self, sentence: str, severity: str = "error") -> None:
        self.severity = severity
        self.label.setText(sentence)
        self.label.setToolTip(sentence)  # long names of files do not fit into a narrow viewport
        self.dress()
        self.show()
        self.place()
        if severity == "info":
            self.timer.start()
        else:
            self.timer.stop()

    def place(self) -> None:
        """Over the top of the viewport, so that nothing moves when it comes and goes."""
        parent = self.parentWidget()
        if parent is not None:
            width = parent.width()
            self.layout().activate()
            self.setGeometry(0, 0, width, self.layout().totalHeightForWidth(width))
            self.raise_()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize and not self.isHidden():
            self.place()
        return super().eventFilter(watched, event)

    def dismiss(self) -> None:
        self.timer.stop()
        self.hide()
        self.closed.emit()

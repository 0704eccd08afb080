# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of cards, each drawn once and kept by the content of its file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QObject, QProcess, Qt
from PySide6.QtGui import QPixmap

from palpate.player.scenario_card import PICTURE, ScenarioCard
from palpate.scene.scene_file import hash_file
from palpate.system.data_folder import find_cache_folder
from palpate.system.isolated import build_verb


class CardPictures(QObject):
    """Draws in a process of its own, one after the other."""

    def __init__(self, cards: Sequence[ScenarioCard], theme: str, parent: QObject):
        super().__init__(parent)
        self._theme = theme
        self._waiting = [card for card in cards if not card.problem]
        self._drawing = QProcess(self)
        self._drawing.finished.connect(self._show)
        self._draw_next()

    def close(self) -> None:
        """What is not drawn yet is not drawn any more."""
        self._waiting = []
        self._drawing.kill()
        self._drawing.waitForFinished(2000)

    def _draw_next(self) -> None:
        while self._waiting:
            card = self._waiting[0]
            path = find_picture(card.path)
            if path.exists():
                use_picture(card, path)
                self._waiting.pop(0)
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            size = f"{2 * PICTURE[0]}x{2 * PICTURE[1]}"
            program, *words = build_verb("render", str(card.path), "-o", str(path))
            words += ["--no-wireframe", "--size", size, "--theme", self._theme]
            self._drawing.start(program, words)
            return

    def _show(self) -> None:
        if not self._waiting:  # the window was closed meanwhile
            return
        card = self._waiting.pop(0)
        use_picture(card, find_picture(card.path))
        self._draw_next()


def use_picture(card: ScenarioCard, path: Path) -> None:
    pixels = QPixmap(str(path))
    if not pixels.isNull():
        kept = Qt.AspectRatioMode.KeepAspectRatio
        smooth = Qt.TransformationMode.SmoothTransformation
        card.picture.setPixmap(pixels.scaled(*PICTURE, kept, smooth))


def find_picture(path: Path) -> Path:
    """Where the picture of a file is kept, by its content."""
    return find_cache_folder() / "pictures" / f"{hash_file(path)}.png"

# SPDX-License-Identifier: GPL-3.0-or-later
"""An editor without windows that edits an organ, and is then killed by the test that started it.

    python edit_and_hang.py FOLDER EDITS [DOCUMENT]

Opens DOCUMENT, or imports a surface, makes EDITS edits one after the other, waits until autosave
has the last of them, writes a line to standard output, and hangs.
"""

from __future__ import annotations

import sys
from pathlib import Path

from organs import make_organ
from palpate_editor.app.autosave import Autosave
from palpate_editor.app.session import Session
from palpate_editor.edits import PaintStiffness, SetTask
from PySide6.QtCore import QCoreApplication, QTimer


class Editor:
    """Makes the edits, one every few milliseconds, and tells when they are kept."""

    def __init__(self, folder: Path, edits: int, document: Path | None):
        self.session = Session(make_organ())
        if document is not None:
            self.session.open(document)
        self.autosave = Autosave(self.session, folder, delay=20)
        self.autosave.saved.connect(self.on_saved)
        self.left = edits
        self.timer = QTimer(interval=5)
        self.timer.timeout.connect(self.on_time)
        self.timer.start()

    def on_time(self) -> None:
        if self.left == 0:
            self.timer.stop()
            return
        self.left -= 1
        self.session.apply(PaintStiffness([self.left], 3.0 + self.left))
        self.session.apply(SetTask(task=f"{self.left} left"))

    def on_saved(self, time: object) -> None:
        if self.left == 0 and self.autosave.kept is self.session.organ:
            print("kept", flush=True)


if __name__ == "__main__":
    app = QCoreApplication(sys.argv)
    path = Path(sys.argv[3]) if len(sys.argv) > 3 else None
    editor = Editor(Path(sys.argv[1]), int(sys.argv[2]), path)
    app.exec()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows of `palpate` that the editor opens beside itself, each in a process of its own."""

from __future__ import annotations

from collections.abc import Sequence

from palpate.system.isolated import build_verb
from PySide6.QtCore import QObject, QProcess

from palpate_editor.views.context import Context
from palpate_editor.views.translations import tr

GRACE = 2000
"""[ms] for one to end by itself."""


class ChildProcesses(QObject):
    """Starts them, tells why one ended badly, and ends them with the editor."""

    def __init__(self, context: Context, parent: QObject | None = None):
        super().__init__(parent)
        self.context = context
        self.running: list[QProcess] = []

    def start(self, call: Sequence[object]) -> QProcess:
        """`call` follows `palpate`."""
        process = QProcess(self)
        process.setProcessChannelMode(QProcess.ProcessChannelMode.MergedChannels)
        process.errorOccurred.connect(self.on_error)
        process.finished.connect(self.on_finished)
        self.running.append(process)
        program, *arguments = build_verb(*call)
        process.start(program, arguments)
        self.context.log_command(["palpate", *call])
        return process

    def open_device(self) -> None:
        """The device window, in the colours and the language of the editor."""
        call: list[object] = ["device", "--theme", self.context.theme]
        if self.context.settings.language:
            call += ["--language", self.context.settings.language]
        self.start(call)

    def on_error(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self.context.tell(tr("The window could not be started."))

    def on_finished(self, code: int, status: QProcess.ExitStatus) -> None:
        ended = [p for p in self.running if p.state() == QProcess.ProcessState.NotRunning]
        for process in ended:
            self.running.remove(process)
            output = bytes(process.readAll().data()).decode(errors="replace").strip()
            process.deleteLater()
            if code != 0 or status != QProcess.ExitStatus.NormalExit:
                last = output.splitlines()[-1] if output else tr("it said nothing")
                self.context.tell(tr("The window ended: {reason}").format(reason=last))

    def finish(self) -> None:
        """They end with the window that started them."""
        for process in self.running:
            process.errorOccurred.disconnect()
            process.finished.disconnect()
            process.terminate()
        for process in self.running:
            if not process.waitForFinished(GRACE):
                process.kill()
                process.waitForFinished(GRACE)
        self.running.clear()

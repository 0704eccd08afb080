# SPDX-License-Identifier: GPL-3.0-or-later
"""From whatever went wrong to a sentence a person can act on, never a traceback."""

from __future__ import annotations

import logging
import sys
import threading
from types import TracebackType

from palpate import FileError
from palpate.files.refusal import Refusal
from palpate.translation.refusals import say_refusal
from PySide6.QtCore import QObject, Signal

from palpate_editor.edits import EditError
from palpate_editor.own_values import BadValue
from palpate_editor.publish import PublishError
from palpate_editor.views.translations import say, tr

LOG = logging.getLogger(__name__)


def sentence_of(problem: BaseException) -> str:
    """What to tell a person about an exception."""
    if isinstance(problem, EditError):
        return say(problem.sentence)
    if isinstance(problem, PublishError):
        found = "; ".join(f"{say(p.got)} ({say(p.expected)})" for p in problem.problems)
        return tr("Not published: {problems}.").format(problems=found)
    if isinstance(problem, BadValue):
        return say_refusal(str(problem)).replace(str(problem.fault), say(problem.fault))
    if isinstance(problem, Refusal | FileError | ValueError):
        return say_refusal(str(problem))
    if isinstance(problem, OSError):
        text = f"{problem.filename}: {problem.strerror}" if problem.filename else str(problem)
        return say_refusal(text)
    if isinstance(problem, MemoryError):
        return tr("This needs more memory than the machine has.")
    if isinstance(problem, RuntimeError) and str(problem):
        return say_refusal(str(problem))
    kind, text = type(problem).__name__, str(problem)
    return tr(
        "Something went wrong in the editor itself ({what}). Your work is still here: save it, "
        "and please report this."
    ).format(what=f"{kind}: {text}" if text else kind)


class ExceptHook(QObject):
    """Catches what nobody caught, on any thread, and says it in the window."""

    caught = Signal(str)

    def __init__(self, parent: QObject | None = None):
        super().__init__(parent)
        self.before = sys.excepthook, threading.excepthook

    def install(self) -> None:
        sys.excepthook = self.on_exception
        threading.excepthook = self.on_thread_exception

    def remove(self) -> None:
        sys.excepthook, threading.excepthook = self.before

    def on_exception(
        self, kind: type[BaseException], problem: BaseException, trace: TracebackType | None
    ) -> None:
        if issubclass(kind, KeyboardInterrupt):
            self.before[0](kind, problem, trace)
            return
        LOG.error("nobody caught this", exc_info=(kind, problem, trace))
        self.caught.emit(sentence_of(problem))

    def on_thread_exception(self, caught: threading.ExceptHookArgs) -> None:
        if caught.exc_value is not None:
            self.on_exception(caught.exc_type, caught.exc_value, caught.exc_traceback)

# SPDX-License-Identifier: BSD-3-Clause
"""What the check of a device has found."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget

from palpate.command.verb import Report
from palpate.player.boards import Board
from palpate.player.check_sentences import say_check
from palpate.player.sentences import say_no_force, translate


class CheckBoard(Board):
    """What was found. A check that failed leaves practice open."""

    def __init__(self, parent: QWidget):
        super().__init__(parent)
        self.summary, self.found = self.add("body"), self.add("body")
        self.go = self.add_button(main=True)
        self.again, self.practice = self.add_button(), self.add_button()
        self._report: Report = {"force": False, "checks": [], "ok": True}
        self.say()

    def tell(self, report: Report) -> None:
        self._report = report
        self.main = self.go if report["ok"] or not report["force"] else self.again
        self.say()

    def say(self) -> None:
        report = self._report
        self.headline.setText(translate("Player", "Device check"))
        if not report["force"]:
            text = say_no_force()
        elif report["ok"]:
            text = translate("Player", "The device is as it should be.")
        elif not report["checks"]:
            text = translate("Player", "The device was not checked, so there is practice alone.")
        elif report.get("ended_early"):
            text = translate(
                "Player",
                "The device failed before its check was over: look at its cable, then check again. "
                "Until then there is practice alone.",
            )
        else:
            text = translate("Player", "The device is not as it should be: attempts with it would "
                             "not count, so there is practice alone.")  # fmt: skip
        self.summary.setText(text)
        self.found.setText("\n".join(map(say_check, report["checks"])))
        self.go.setText(translate("Player", "Go on"))
        self.again.setText(translate("Player", "Check again"))
        self.practice.setText(translate("Player", "Practice: nothing is kept"))
        blocked = report["force"] and not report["ok"]
        self.go.setVisible(not blocked)
        self.practice.setVisible(blocked)

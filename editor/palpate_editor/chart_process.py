# SPDX-License-Identifier: GPL-3.0-or-later
"""A process that draws the chart of an organ, and advises: the window never waits for either.

    python -P -m palpate_editor.chart_process

Its parent alone starts it and speaks with it, by pickles on its standard streams. To end it is to
cancel: what is finished is on the disk, and the next one goes on from there.
"""

from __future__ import annotations

import os
import pickle
import sys
from collections.abc import Callable

from palpate.files.refusal import Refusal
from palpate.study.scene_chart import Chart

from palpate_editor.advise import AdviseError, advise_organ
from palpate_editor.chart_jobs import open_document
from palpate_editor.chart_messages import Done, Refused, Request, Shown, Told
from palpate_editor.chart_session import draw_kept_chart
from palpate_editor.truth import TruthError


def main() -> None:
    out = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what a library prints is no answer

    def send(what: object) -> None:
        pickle.dump(what, out)
        out.flush()

    answer(pickle.load(sys.stdin.buffer), send)


def answer(request: Request, send: Callable[[object], None]) -> None:
    """Told and Shown, again and again; at last Done or Refused."""

    def tell(stage: str, share: float) -> None:
        send(Told(stage, share))

    def show(chart: Chart) -> None:
        send(Shown(chart))

    organ, cache, advised = open_document(request.organ), request.cache, None
    truths = None if cache is None else cache / "truths"
    try:
        chart = request.chart
        if chart is None:
            chart = draw_kept_chart(
                organ,
                request.workers,
                request.file,
                tell,
                shown=show,
                cache=cache,
                configurations=request.configurations,
            )
            show(chart)
        if request.targets is not None:
            advised = advise_organ(organ, chart, request.targets, told=tell, cache=truths)
        send(Done(chart, advised))
    except (AdviseError, TruthError, Refusal, OSError) as problem:
        send(Refused(str(problem)))
    except MemoryError:
        send(Refused("the truth of this organ needs more memory than the machine has"))


if __name__ == "__main__":
    main()

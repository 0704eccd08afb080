# SPDX-License-Identifier: GPL-3.0-or-later
"""A process that runs rows of a chart: jobs come in, what they came to goes out.

    python -P -m palpate_editor.chart_worker

Its parent alone starts it and speaks with it, by pickles on its standard streams (chart_pool).
"""

from __future__ import annotations

import os
import pickle
import signal
import sys
from typing import BinaryIO

from palpate_editor.chart_jobs import Job, Plan, run_job


def main() -> None:
    # what is interrupted is the command; it ends its processes by itself
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    out = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what a library prints is no answer
    answer(sys.stdin.buffer, out)


def answer(jobs: BinaryIO, results: BinaryIO) -> None:
    """Until nobody asks any more."""
    plan: Plan = pickle.load(jobs)
    while True:
        try:
            job: Job = pickle.load(jobs)
        except EOFError:
            return
        pickle.dump(run_job(plan, job), results)
        results.flush()


if __name__ == "__main__":
    main()

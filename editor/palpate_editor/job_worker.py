# SPDX-License-Identifier: GPL-3.0-or-later
"""A process that runs jobs: they come in, what they came to goes out.

    python -P -m palpate_editor.job_worker

Its parent alone starts it and speaks with it, by pickles on its standard streams (job_pool): first
the function that runs a job, then the plan that all jobs share, then jobs.
"""

from __future__ import annotations

import os
import pickle
import signal
import sys
from typing import BinaryIO


def main() -> None:
    # what is interrupted is the command; it ends its processes by itself
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    out = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what a library prints is no answer
    answer(sys.stdin.buffer, out)


def answer(jobs: BinaryIO, results: BinaryIO) -> None:
    """Until nobody asks any more."""
    run, plan = pickle.load(jobs)
    while True:
        try:
            job = pickle.load(jobs)
        except EOFError:
            return
        pickle.dump(run(plan, job), results)
        results.flush()


if __name__ == "__main__":
    main()

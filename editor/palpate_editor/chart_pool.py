# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the rows of a chart run: in this process, in others, or on a cluster. Errors are the same.

Each of these takes a plan and jobs and gives what every job came to, in the order in which they
end. A process that dies loses the job that it had, and no other.
"""

from __future__ import annotations

import pickle
import queue
import subprocess
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress

from palpate.study.scene_chart import LOST, Row
from palpate.system.isolated import build_command

from palpate_editor.chart_jobs import Converged, Job, Plan, open_document, run_job, start_row

Result = tuple[Job, Row | Converged]
Runner = Callable[[Plan, Sequence[Job]], Iterator[Result]]


class WorkerLost(Exception):
    """A process ended while it had a job."""


def run_here(plan: Plan, jobs: Sequence[Job]) -> Iterator[Result]:
    """In this very process, one after the other."""
    for job in jobs:
        yield job, run_job(plan, job)


def lose(plan: Plan, job: Job, reason: str) -> Row | Converged:
    """What a job came to whose process ended."""
    if job.converges:
        return Converged((), None)
    return start_row(open_document(plan.organ), job, LOST, reason)


class Worker:
    """A process that runs jobs, and another one in its place once it has died."""

    def __init__(self, plan: Plan):
        self.plan = plan
        self.process: subprocess.Popen[bytes] | None = None

    def run(self, job: Job) -> Row | Converged:
        """Raises WorkerLost."""
        if self.process is None:
            self.process = subprocess.Popen(
                build_command("-m", "palpate_editor.chart_worker"),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
            )
            self.send(self.plan)
        self.send(job)
        assert self.process.stdout is not None
        try:
            return pickle.load(self.process.stdout)
        except (EOFError, pickle.UnpicklingError):
            raise WorkerLost(self.say_end()) from None

    def send(self, what: Plan | Job) -> None:
        assert self.process is not None and self.process.stdin is not None
        try:
            pickle.dump(what, self.process.stdin)
            self.process.stdin.flush()
        except OSError:
            raise WorkerLost(self.say_end()) from None

    def say_end(self) -> str:
        """How the process ended, in words."""
        assert self.process is not None
        self.close()
        code = self.process.returncode if self.process is not None else None
        return "" if code is None else describe_end(code)

    def close(self) -> None:
        if self.process is not None:
            self.process.kill()
            self.process.wait()


def describe_end(code: int) -> str:
    how = f"by signal {-code}" if code < 0 else f"with code {code}"
    return f"the process that ran it ended {how}; the rest of the chart is not concerned"


def run_in_processes(workers: int) -> Runner:
    """In so many processes at once."""

    def run(plan: Plan, jobs: Sequence[Job]) -> Iterator[Result]:
        pool = [Worker(plan) for _ in range(min(workers, len(jobs)))]
        waiting: queue.SimpleQueue[Job] = queue.SimpleQueue()
        for job in jobs:
            waiting.put(job)
        done: queue.SimpleQueue[Result] = queue.SimpleQueue()
        threads = [
            threading.Thread(target=work, args=(worker, waiting, done), daemon=True)
            for worker in pool
        ]
        for thread in threads:
            thread.start()
        try:
            for _ in jobs:
                yield done.get()
        finally:
            with suppress(queue.Empty):  # nobody begins anything more
                while True:
                    waiting.get_nowait()
            for worker in pool:
                worker.close()
            for thread in threads:
                thread.join()

    return run


def work(worker: Worker, waiting: queue.SimpleQueue[Job], done: queue.SimpleQueue[Result]) -> None:
    """What a thread does that speaks with a process."""
    with suppress(queue.Empty):
        while True:
            job = waiting.get_nowait()
            try:
                done.put((job, worker.run(job)))
            except WorkerLost as problem:
                worker.process = None
                done.put((job, lose(worker.plan, job, str(problem))))

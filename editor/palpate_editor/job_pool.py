# SPDX-License-Identifier: GPL-3.0-or-later
"""Where jobs run: in this process, or in others. What they come to is the same.

A runner takes a plan and jobs and gives what every job came to, in the order in which they end. A
process that dies loses the job that it had, and no other.
"""

from __future__ import annotations

import pickle
import queue
import subprocess
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from typing import Any

from palpate.system.isolated import build_command

Run = Callable[[Any, Any], Any]
"""Of a plan and a job of it: what the job came to."""
Lose = Callable[[Any, Any, str], Any]
"""The same for a job whose process ended, with the reason."""
Runner = Callable[[Any, Sequence[Any]], Iterator[tuple[Any, Any]]]


PATIENCE = 5.0
"""[s] that a process that answers no more has to end by itself."""


class WorkerLost(Exception):
    """A process ended while it had a job."""


def run_here(run_job: Run) -> Runner:
    """In this very process, one after the other."""

    def run(plan: Any, jobs: Sequence[Any]) -> Iterator[tuple[Any, Any]]:
        for job in jobs:
            yield job, run_job(plan, job)

    return run


class Worker:
    """A process that runs jobs, and another one in its place once it has died."""

    def __init__(self, run: Run, plan: Any):
        self.run_job, self.plan = run, plan
        self.process: subprocess.Popen[bytes] | None = None

    def run(self, job: Any) -> Any:
        """Raises WorkerLost."""
        if self.process is None:
            self.process = subprocess.Popen(
                build_command("-m", "palpate_editor.job_worker"),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
            )
            self.send((self.run_job, self.plan))
        self.send(job)
        assert self.process.stdout is not None
        try:
            return pickle.load(self.process.stdout)
        except (EOFError, pickle.UnpicklingError):
            raise WorkerLost(self.say_end()) from None

    def send(self, what: Any) -> None:
        assert self.process is not None and self.process.stdin is not None
        try:
            pickle.dump(what, self.process.stdin)
            self.process.stdin.flush()
        except OSError:
            raise WorkerLost(self.say_end()) from None

    def say_end(self) -> str:
        """How the process ended, in words."""
        assert self.process is not None
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(PATIENCE)  # one that failed by itself ends with a code of its own
        self.close()
        code = self.process.returncode if self.process is not None else None
        return "" if code is None else describe_end(code)

    def close(self) -> None:
        if self.process is not None:
            self.process.kill()
            self.process.wait()


def describe_end(code: int) -> str:
    how = f"by signal {-code}" if code < 0 else f"with code {code}"
    return f"the process that ran it ended {how}; nothing else is concerned"


def run_in_processes(run_job: Run, lose: Lose, workers: int) -> Runner:
    """In so many processes at once.

    Args:
        run_job: Runs one, with its plan; a function of a module, which any process can import.
        lose: Says what a job came to whose process ended: with the plan, the job and the reason.
        workers: How many processes.
    """

    def run(plan: Any, jobs: Sequence[Any]) -> Iterator[tuple[Any, Any]]:
        pool = [Worker(run_job, plan) for _ in range(min(workers, len(jobs)))]
        waiting: queue.SimpleQueue[Any] = queue.SimpleQueue()
        for job in jobs:
            waiting.put(job)
        done: queue.SimpleQueue[tuple[Any, Any]] = queue.SimpleQueue()
        threads = [
            threading.Thread(target=work, args=(worker, lose, waiting, done), daemon=True)
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


def work(
    worker: Worker,
    lose: Lose,
    waiting: queue.SimpleQueue[Any],
    done: queue.SimpleQueue[tuple[Any, Any]],
) -> None:
    """What a thread does that speaks with a process."""
    with suppress(queue.Empty):
        while True:
            job = waiting.get_nowait()
            try:
                done.put((job, worker.run(job)))
            except WorkerLost as problem:
                worker.process = None
                done.put((job, lose(worker.plan, job, str(problem))))

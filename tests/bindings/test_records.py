# SPDX-License-Identifier: BSD-3-Clause
"""Attempts in the database: there before the first tick, whole at the end, forgotten on request."""

from __future__ import annotations

import csv
import io
import json
import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import Barrier

import numpy as np
import palpate
import pytest
from palpate import scenario
from palpate.assessment.publish import read_assessment, with_assessment
from palpate.cli.main import main
from palpate.files.refusal import Refusal
from palpate.records import attempts
from palpate.records.attempts import begin_attempt, begin_session, close_interrupted, end_attempt
from palpate.records.people import CONSENT, add_person, find_person, forget, give_consent
from palpate.records.queries import export_csv, list_attempts, show_attempt
from palpate.records.store import ENVIRONMENT, Store, find_database, make_id
from palpate.records.tables import META, VERSION, device
from sqlalchemy import select

MESHES = Path(__file__).resolve().parents[2] / "meshes"
DESIGNED = {
    "person": "id code cohort experience created",
    "consent": "id person text_sha256 language practice research given withdrawn",
    "session": "id person station device software started check",
    "attempt": "id session scenario level seed drawn guide started ended outcome ticks missed "
    "clamped late_p99_us trace_sha256 trace_bytes trace_state counts_for_judging why_not",
    "step_result": "attempt step from_tick to_tick outcome",
    "event": "attempt seq tick kind data",
    "metric": "attempt step name version value unit",
}
LONGEST_S, AT_ONCE = 6.0, 4
"""[s] that a program plays before it is killed, and how many play at a time"""
NAMES_OF_PEOPLE = ("name", "mail", "birth")


@pytest.fixture(scope="module")
def task(tmp_path_factory) -> Path:
    path = MESHES / "scenarios" / "simple_tissue.json"
    organ = scenario.read(MESHES / "published" / "simple_tissue.palpate")
    out = tmp_path_factory.mktemp("task") / "tissue.palpate"
    scenario.write(out, with_assessment(path, read_assessment(path), organ))
    return out


@pytest.fixture
def store(tmp_path, monkeypatch) -> Store:
    monkeypatch.setenv(ENVIRONMENT, str(tmp_path / "db" / "records.sqlite"))
    return Store()


def join(store: Store) -> str:
    who = give_consent(store, add_person(store), "en")
    assert who.code is not None
    return who.code


def begin(store: Store, task: Path, code: str):
    who = find_person(store, code)
    played = scenario.read(task)
    of = begin_session(store, who, "mouse", {})
    return begin_attempt(store, of, played, scenario.draw_task(played), "0" * 64)


def report_of(events: list | None = None) -> dict:
    verdict = {
        "outcome": "done", "time_s": 3.5, "errors": 1, "warnings": 0, "peak_force_N": 0.7,
        "steps": [{"id": "touch", "from_tick": 0, "until_tick": 40, "status": "done"}],
        "limits": [{"id": "hard", "count": 1, "duration_s": 0.2}],
        "events": events or [{"tick": 40, "kind": "step_done", "step": "touch", "value": 0.04}],
    }  # fmt: skip
    return {"verdict": verdict, "ticks": 3500, "missed_ticks": 0, "lateness_p99_us": 20.0,
            "record_gaps": 0, "has_force": True}  # fmt: skip


def test_the_tables_are_those_of_the_design_and_know_nobody_by_name(store):
    for table, columns in DESIGNED.items():
        assert set(columns.split()) <= set(META.tables[table].columns.keys()), table
    columns = [c.name for table in META.tables.values() for c in table.columns]
    people = [c.name for c in META.tables["person"].columns]
    assert not [name for name in people if any(word in name for word in NAMES_OF_PEOPLE)]
    assert columns


def test_a_database_is_of_a_wal_that_is_synced_in_full(store):
    with store.begin() as connection:

        def ask(pragma: str) -> object:
            return connection.exec_driver_sql(f"PRAGMA {pragma}").scalar_one()

        assert ask("journal_mode") == "wal"
        assert ask("synchronous") == 2
        assert ask("foreign_keys") == 1
        assert ask("user_version") == VERSION


def test_ids_ascend_with_time():
    ids = []
    for _ in range(3):
        ids.append(make_id())
        time.sleep(0.002)
    assert ids == sorted(ids)
    assert all(text[14] == "7" and text[19] in "89ab" for text in ids)


def test_an_attempt_is_there_before_it_has_ended_and_has_its_verdict_after(store, task):
    begun = begin(store, task, join(store))
    other = Store()
    (row,) = list_attempts(other)
    assert (row["outcome"], row["ended"]) == ("interrupted", None)
    assert close_interrupted(other) == []  # its program lives

    end_attempt(store, begun, report_of())

    found = show_attempt(other, begun.id[:8])
    assert (found["outcome"], found["ticks"]) == ("done", 3500)
    assert found["steps"] == [{"step": "touch", "from_tick": 0, "to_tick": 40, "outcome": "done"}]
    values = {each["name"]: each["value"] for each in found["metrics"]}
    assert values["errors"] == 1
    assert values["limit.hard.duration"] == 0.2
    assert found["events"][0]["kind"] == "step_done"
    assert found["counts_for_judging"]


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"has_force": False}, "no force; not comparable"),
        ({"missed_ticks": 4}, "more than 0.1 % of the ticks were missed"),
        ({"record_gaps": 1}, "the trace has gaps"),
    ],
)
def test_what_cannot_be_compared_does_not_count(store, task, change, why):
    begun = begin(store, task, join(store))

    end_attempt(store, begun, {**report_of(), **change})

    (row,) = list_attempts(store)
    assert (row["counts_for_judging"], row["why_not"]) == (False, why)


def test_a_transaction_that_fails_leaves_the_attempt_as_it_was(store, task):
    begun = begin(store, task, join(store))
    twice = [{"id": "touch", "from_tick": 0, "until_tick": 1, "status": "done"}] * 2
    broken = report_of()
    broken["verdict"]["steps"] = twice

    with pytest.raises(Exception, match="UNIQUE"):
        end_attempt(store, begun, broken)

    found = show_attempt(store, begun.id)
    assert (found["outcome"], found["ended"]) == ("interrupted", None)
    assert found["steps"] == found["metrics"] == found["events"] == []


def test_who_is_forgotten_leaves_a_count_and_nothing_else(store, task):
    code = join(store)
    begun = begin(store, task, code)
    begun.trace.write_bytes(b"trace")
    end_attempt(store, begun, report_of())

    gone = forget(store, code)

    assert gone["traces"] == gone["events"] == gone["attempts_kept_as_counts"] == 1
    assert not begun.trace.exists()
    assert find_person(store, code) is None
    assert forget(store, code) is None
    (row,) = list_attempts(store)
    assert (row["person"], row["counts_for_judging"]) == (None, False)
    store.close()
    files = [path for path in store.folder.iterdir() if path.is_file()]
    assert not any(code.encode() in path.read_bytes() for path in files if "wal" not in path.name)


def test_another_text_is_asked_for_again(store, monkeypatch):
    code = join(store)
    assert find_person(store, code).practice

    monkeypatch.setitem(CONSENT, "en", "Something else.")

    assert not find_person(store, code).practice


def test_another_file_and_a_newer_database_are_refused(tmp_path, monkeypatch):
    other = tmp_path / "notes.txt"
    other.write_text("not a database at all", encoding="utf-8")
    with pytest.raises(Refusal):
        Store(other)
    assert other.read_text(encoding="utf-8") == "not a database at all"
    newer = tmp_path / "newer.sqlite"
    Store(newer).close()
    with sqlite3.connect(newer) as connection:
        connection.execute(f"PRAGMA user_version={VERSION + 1}")
    with pytest.raises(Refusal, match="newer"):
        Store(newer)
    monkeypatch.setenv(ENVIRONMENT, "postgresql+psycopg://centre")
    with pytest.raises(Refusal):
        find_database()


def test_csv_says_what_its_columns_mean_and_has_a_row_for_each(store, task):
    begun = begin(store, task, join(store))
    end_attempt(store, begun, report_of())

    wide, long = export_csv(store), export_csv(store, long=True)

    assert wide.startswith("# Not validated. Not a medical device.")
    rows = [line for line in wide.splitlines() if not line.startswith("#")]
    (row,) = csv.DictReader(io.StringIO("\n".join(rows)))
    assert (row["outcome"], row["errors"], row["peak_force"]) == ("done", "1.0", "0.7")
    rows = list(csv.DictReader(line for line in long.splitlines() if not line.startswith("#")))
    assert {row["metric"]: row["unit"] for row in rows}["peak_force"] == "N"


def test_a_headless_attempt_is_kept_under_a_code_and_shown(store, task, capsys):
    code = join(store)
    words = ["play", str(task), "--headless", "--device", "script:careful", "--json"]

    assert main([*words, "--person", code]) == 0
    report = json.loads(capsys.readouterr().out)
    assert main(["records", "show", report["attempt"], "--json"]) == 0
    kept = json.loads(capsys.readouterr().out)["attempt"]

    assert (kept["person"], kept["outcome"], kept["ticks"]) == (code, "done", report["ticks"])
    assert not kept["counts_for_judging"]  # a simulated hand
    assert [each["tick"] for each in kept["events"]] == [
        each["tick"] for each in report["verdict"]["events"]
    ]
    record = palpate.read_record(report["record"])
    assert record.complete
    assert Path(report["record"]).parent == store.traces
    assert main([*words, "--person", "NOBODYXX"]) == 2
    assert main([*words, "--guest", "--record", "x.prec"]) == 2


def test_two_programs_that_begin_at_once_close_a_killed_attempt_once(store, task, monkeypatch):
    """Both have seen it open; the second one could not begin."""
    begun = begin(store, task, join(store))
    row = {"tick": 3, "kind": int(palpate.TaskEvent.step_done), "index": 0, "value": 0.1}
    monkeypatch.setattr(palpate, "read_record", lambda path: palpate.Record())
    monkeypatch.setattr(attempts, "pick_events", lambda events: [row])

    for _ in range(2):
        attempts.close_one(store, begun.id, begun.trace)

    kept = show_attempt(store, begun.id)
    assert (kept["outcome"], len(kept["events"])) == ("interrupted", 1)


def test_programs_that_begin_at_once_with_a_new_file_all_begin(store, task):
    code, played = join(store), scenario.read(task)
    drawn, together = scenario.draw_task(played), Barrier(AT_ONCE)

    def begin_one(_: int) -> str:
        mine = Store(store.path)
        of = begin_session(mine, find_person(mine, code), "mouse", {})
        together.wait()
        return begin_attempt(mine, of, played, drawn, "1" * 64).id

    with ThreadPoolExecutor(AT_ONCE) as pool:
        begun = set(pool.map(begin_one, range(AT_ONCE)))

    assert {row["attempt"] for row in list_attempts(store)} == begun
    assert len(begun) == AT_ONCE


def test_a_program_that_waits_for_another_sees_what_that_one_wrote(store):
    """Else each would make a row for the same device."""
    who, second = find_person(store, join(store)), Store(store.path)
    with ThreadPoolExecutor(1) as pool:
        with store.begin() as mine:
            mine.execute(
                device.insert().values(id=make_id(), kind="mouse", firmware="", serial_hash="",
                                       calibrated=None, calibration={})
            )  # fmt: skip
            other = pool.submit(begin_session, second, who, "mouse", {})
            time.sleep(0.2)
            assert not other.done()
        other.result(timeout=20)

    with store.begin() as connection:
        assert len(connection.execute(select(device.c.id)).all()) == 1


def write_strokes(folder: Path) -> Path:
    """A hand that presses the tissue once a second, as long as a kill may wait."""
    x = scenario.read(MESHES / "published" / "simple_tissue.palpate").scene.bodies[0].tissue
    top = np.asarray(x.rest_position)[:, 2].max()
    heights = [0.02 if k % 2 else 0.004 for k in range(2 * round(LONGEST_S) + 1)]
    frames = [{"time": 0.5 * k, "position": [0.0, 0.0, float(top) + height]}
              for k, height in enumerate(heights)]  # fmt: skip
    path = folder / "strokes.json"
    path.write_text(
        json.dumps({"format": "palpate script", "version": 1, "frames": frames}), encoding="utf-8"
    )
    return path


def kill_one(task: Path, hand: Path, code: str, folder: Path, after: float) -> tuple[str, float]:
    """An attempt that is killed so long [s] after its row was acknowledged."""
    words = ["-m", "palpate", "play", str(task), "--headless", "--device", f"script:{hand}",
             "--person", code]  # fmt: skip
    child = subprocess.Popen(
        [sys.executable, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
        encoding="utf-8", env={**os.environ, ENVIRONMENT: str(folder)},
    )  # fmt: skip
    assert child.stderr is not None
    line = child.stderr.readline()
    assert line.startswith("attempt "), line + child.stderr.read()
    time.sleep(after)
    os.kill(child.pid, signal.SIGKILL)
    child.wait()
    child.stderr.close()
    return line.split()[1], after


@pytest.mark.parametrize(
    ("count", "seed"),
    [
        pytest.param(2, 0, marks=pytest.mark.landing),
        *(pytest.param(25, seed, marks=pytest.mark.verify) for seed in range(1, 5)),
    ],
)
def test_a_killed_program_loses_no_attempt_that_it_had_begun(store, task, tmp_path, count, seed):
    """A hundred kills in all, four programs at a time with one database."""
    code = join(store)
    done = begin(store, task, code)
    end_attempt(store, done, report_of())
    hand, draw = write_strokes(tmp_path), random.Random(seed)
    delays = [draw.uniform(0.0, LONGEST_S) for _ in range(count)]

    with ThreadPoolExecutor(AT_ONCE) as pool:
        killed = list(pool.map(lambda d: kill_one(task, hand, code, store.path, d), delays))

    close_interrupted(store)  # what no later program has closed
    rows = {row["attempt"]: row for row in list_attempts(store)}
    assert set(rows) == {done.id, *(identity for identity, _ in killed)}
    assert rows[done.id]["outcome"] == "done"
    for identity, after in killed:
        row = rows[identity]
        assert row["ended"] is not None, after
        if row["outcome"] == "left":  # it had ended before it was killed
            continue
        assert row["outcome"] == "interrupted"
        trace = store.traces / row["trace"]
        if row["ticks"]:
            assert len(palpate.read_record(str(trace)).hand) == row["ticks"]
    assert close_interrupted(store) == []

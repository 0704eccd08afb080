# SPDX-License-Identifier: BSD-3-Clause
"""The database file of a station: opened, made, and what is refused of it."""

from __future__ import annotations

import os
import secrets
import sqlite3
import time
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, Engine, create_engine, event, select
from sqlalchemy.exc import DatabaseError

from palpate.files.refusal import Refusal
from palpate.files.whole_file import open_locked
from palpate.records.tables import META, VERSION, station
from palpate.system.data_folder import find_data_folder

ENVIRONMENT = "PALPATE_DATABASE"
NAME = "records.sqlite"
TRACES = "traces"
LOCKS = "locks"
PATIENCE_MS = 10_000
"""[ms] that one waits for another program's transaction."""


def find_database() -> Path:
    """$PALPATE_DATABASE, a path, or records.sqlite in the user's data folder."""
    told = os.environ.get(ENVIRONMENT, "")
    if "://" in told and not told.startswith("sqlite:///"):
        raise Refusal(ENVIRONMENT, "", repr(told), "the path of a file on this machine")
    return Path(told.removeprefix("sqlite:///")) if told else find_data_folder() / NAME


def now() -> str:
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def make_id() -> str:
    """A UUID of version 7 [RFC9562]: milliseconds since 1970, then chance; so ids are in order."""
    bits = (time.time_ns() // 1_000_000) << 80 | secrets.randbits(80)
    bits = bits & ~(0xF << 76) | 0x7 << 76
    bits = bits & ~(0x3 << 62) | 0x2 << 62
    text = f"{bits:032x}"
    return "-".join((text[:8], text[8:12], text[12:16], text[16:20], text[20:]))


class Store:
    """A database and the traces beside it. One for each thread."""

    def __init__(self, path: Path | None = None):
        """Opens it; one that is not there is made. Raises Refusal for another file, or a database
        of a newer program, OSError where it cannot be written.
        """
        self.path = path or find_database()
        self.path.parent.mkdir(parents=True, exist_ok=True)
        require_database(self.path)
        self.folder = self.path.parent
        self.traces = self.folder / TRACES
        self.traces.mkdir(exist_ok=True)
        (self.folder / LOCKS).mkdir(exist_ok=True)
        self.engine = make_engine(self.path)
        try:
            with self.engine.begin() as connection:
                prepare(connection, self.path)
        except DatabaseError as problem:
            raise OSError(f"{self.path}: {problem.orig}") from None

    def begin(self) -> Any:
        """A transaction: all of it is on the disk once it has ended, or none of it is there."""
        return self.engine.begin()

    def close(self) -> None:
        self.engine.dispose()

    def lock(self, attempt: str) -> int | None:
        """A lock that this program has while it lives; None where another one has it."""
        return open_locked(self.folder / LOCKS / attempt)

    def unlock(self, attempt: str, handle: int) -> None:
        (self.folder / LOCKS / attempt).unlink(missing_ok=True)
        os.close(handle)


def require_database(path: Path) -> None:
    """Raises Refusal for a file that is no database: it would be written over."""
    if not path.exists() or path.stat().st_size == 0:
        return
    with path.open("rb") as file:
        if file.read(16) != b"SQLite format 3\0":
            raise Refusal(path, "", "another kind of file", "a database of records, or a new name")


def make_engine(path: Path) -> Engine:
    engine = create_engine(f"sqlite:///{path}")

    @event.listens_for(engine, "connect")
    def set_up(connection: sqlite3.Connection, _: object) -> None:
        # FULL: a loss of power may take commits away from a WAL that is not synced; secure_delete:
        # what was forgotten is not left in free pages
        for pragma in (
            *("journal_mode=WAL", "synchronous=FULL", "foreign_keys=ON", "secure_delete=ON"),
            f"busy_timeout={PATIENCE_MS}",
        ):
            connection.execute(f"PRAGMA {pragma}")
        connection.isolation_level = None  # else sqlite3 begins late, when a row is written

    @event.listens_for(engine, "begin")
    def begin(connection: Connection) -> None:
        # from its first question on: what it has not found no other one makes meanwhile
        connection.exec_driver_sql("BEGIN IMMEDIATE")

    return engine


def prepare(connection: Connection, path: Path) -> None:
    """Makes the tables where there are none. Raises Refusal for those of a newer program."""
    found = connection.exec_driver_sql("PRAGMA user_version").scalar_one()
    if found > VERSION:
        raise Refusal(path, "version", str(found), f"at most {VERSION}; a newer program made it")
    if found == VERSION:
        return
    META.create_all(connection)
    connection.exec_driver_sql(f"PRAGMA user_version={VERSION}")
    if connection.execute(select(station.c.id)).first() is None:
        connection.execute(station.insert().values(id=make_id(), label=""))

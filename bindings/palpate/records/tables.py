# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the database. Ids are UUIDs as text, times are UTC as ISO 8601 text, units SI."""

from __future__ import annotations

from sqlalchemy import (
    JSON,
    Boolean,
    Column,
    Float,
    ForeignKey,
    ForeignKeyConstraint,
    Index,
    Integer,
    MetaData,
    Table,
    Text,
)

VERSION = 1
"""Of the schema; a database of a newer one is refused."""

META = MetaData()


def link(to: str, **options: bool) -> Column:
    """A column that names a row of another table."""
    name = to.partition(".")[0]
    return Column(name, Text, ForeignKey(to), **{"nullable": False, **options})


person = Table(
    "person", META,
    Column("id", Text, primary_key=True),
    Column("code", Text, unique=True),  # null for a guest, who can be linked to nobody
    Column("cohort", Text, nullable=False, default=""),
    Column("experience", JSON, nullable=False, default=dict),
    Column("created", Text, nullable=False),
)  # fmt: skip

consent = Table(
    "consent", META,
    Column("id", Text, primary_key=True),
    link("person.id"),
    Column("text_sha256", Text, nullable=False),
    Column("language", Text, nullable=False),
    Column("practice", Boolean, nullable=False),
    Column("research", Boolean, nullable=False),
    Column("given", Text, nullable=False),
    Column("withdrawn", Text),
)  # fmt: skip

station = Table(
    "station", META, Column("id", Text, primary_key=True), Column("label", Text, nullable=False)
)

device = Table(
    "device", META,
    Column("id", Text, primary_key=True),
    Column("kind", Text, nullable=False),
    Column("firmware", Text, nullable=False, default=""),
    Column("serial_hash", Text, nullable=False, default=""),
    Column("calibrated", Text),
    Column("calibration", JSON, nullable=False, default=dict),
)  # fmt: skip

scenario = Table(
    "scenario", META,
    Column("sha256", Text, primary_key=True),  # of the file
    Column("id", Text, nullable=False),
    Column("version", Text, nullable=False),
    Column("title", JSON, nullable=False),
    Column("reviews", JSON, nullable=False, default=list),
)  # fmt: skip

session = Table(
    "session", META,
    Column("id", Text, primary_key=True),
    link("person.id"),
    link("station.id"),
    link("device.id"),
    Column("software", Text, nullable=False),
    Column("started", Text, nullable=False),
    Column("check", JSON, nullable=False, default=dict),
)  # fmt: skip

attempt = Table(
    "attempt", META,
    Column("id", Text, primary_key=True),  # UUID 7: in order of time
    link("session.id"),
    link("scenario.sha256"),
    Column("level", Text, nullable=False),
    Column("seed", Integer, nullable=False),
    Column("drawn", JSON, nullable=False),
    Column("guide", JSON, nullable=False, default=dict),
    Column("started", Text, nullable=False),
    Column("ended", Text),  # null while it goes on
    Column("outcome", Text, nullable=False),  # `interrupted` until it has ended
    Column("ticks", Integer, nullable=False, default=0),
    Column("missed", Integer, nullable=False, default=0),
    Column("clamped", Integer, nullable=False, default=0),
    Column("late_p99_us", Float),
    Column("trace", Text, nullable=False),  # name of the file beside the database
    Column("trace_sha256", Text),
    Column("trace_bytes", Integer, nullable=False, default=0),
    Column("trace_state", Text, nullable=False, default="here"),
    Column("counts_for_judging", Boolean, nullable=False, default=False),
    Column("why_not", Text, nullable=False, default=""),
    Index("attempt_of_scenario", "scenario", "level"),
    Index("attempt_of_session", "session"),
)  # fmt: skip

step_result = Table(
    "step_result", META,
    Column("attempt", Text, ForeignKey("attempt.id"), primary_key=True),
    Column("step", Text, primary_key=True),
    Column("from_tick", Integer),
    Column("to_tick", Integer),
    Column("outcome", Text, nullable=False),
)  # fmt: skip

event = Table(
    "event", META,
    Column("attempt", Text, ForeignKey("attempt.id"), primary_key=True),
    Column("seq", Integer, primary_key=True),
    Column("tick", Integer, nullable=False),
    Column("kind", Text, nullable=False),
    Column("data", JSON, nullable=False),
)  # fmt: skip

metric = Table(
    "metric", META,
    Column("attempt", Text, ForeignKey("attempt.id"), primary_key=True),
    Column("step", Text, primary_key=True),  # empty for the whole attempt
    Column("name", Text, primary_key=True),
    Column("version", Integer, primary_key=True),
    Column("value", Float, nullable=False),
    Column("unit", Text, nullable=False),
)  # fmt: skip

rating = Table(
    "rating", META,
    Column("attempt", Text, ForeignKey("attempt.id"), primary_key=True),
    Column("rater", Text, ForeignKey("person.id"), primary_key=True),
    Column("form", Text, primary_key=True),
    Column("version", Integer, primary_key=True),
    Column("item", Text, primary_key=True),
    Column("value", Float, nullable=False),
    Column("blinded", Boolean, nullable=False),
)  # fmt: skip

survey = Table(
    "survey", META,
    Column("id", Text, primary_key=True),
    link("person.id"),
    link("session.id", nullable=True),
    Column("form", Text, nullable=False),
    Column("version", Integer, nullable=False),
    Column("language", Text, nullable=False),
    Column("given", Text, nullable=False),
)  # fmt: skip

answer = Table(
    "answer", META,
    Column("survey", Text, primary_key=True),
    Column("item", Text, primary_key=True),
    Column("value", JSON, nullable=False),
    ForeignKeyConstraint(["survey"], ["survey.id"]),
)  # fmt: skip

standard = Table(
    "standard", META,
    Column("id", Text, primary_key=True),
    link("scenario.sha256"),
    Column("metric", Text, nullable=False),
    Column("cut", Float, nullable=False),
    Column("method", Text, nullable=False),
    Column("report_sha256", Text, nullable=False),
    Column("decided", Text, nullable=False),
)  # fmt: skip

outbox = Table(
    "outbox", META,
    Column("seq", Integer, primary_key=True, autoincrement=True),
    Column("table", Text, nullable=False),
    Column("row_id", Text, nullable=False),
)  # fmt: skip

audit = Table(
    "audit", META,
    Column("seq", Integer, primary_key=True, autoincrement=True),
    Column("at", Text, nullable=False),
    Column("who", Text, nullable=False),
    Column("what", Text, nullable=False),
    Column("why", Text, nullable=False),
)  # fmt: skip

# SPDX-License-Identifier: BSD-3-Clause
"""Charts of organs as files: they come back as they were written, or are refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import jsonschema
import palpate
import pytest
from made_up_charts import make_chart, make_row
from palpate.files.file_kind import CHART, find_kind
from palpate.files.refusal import Refusal
from palpate.study import scene_chart
from palpate.study.chart_file import read_chart, write_chart
from palpate.study.scene_chart import find_front, find_possible_front
from row_files import check_schema_fields, spoil

SCHEMA = json.loads(
    (Path(palpate.__file__).parent / "schemas" / "chart.schema.json").read_text(encoding="utf-8")
)


def test_a_chart_comes_back_as_it_was_written_and_fits_its_schema(tmp_path):
    chart, path = make_chart(), tmp_path / "chart.json"
    write_chart(path, chart)

    assert read_chart(path) == chart
    assert find_kind(path) == CHART
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    jsonschema.Draft202012Validator(SCHEMA).validate(json.loads(path.read_text(encoding="utf-8")))


def test_the_schema_has_every_field_of_a_chart():
    check_schema_fields(SCHEMA, scene_chart, scene_chart.Chart)


FAULTS = [
    (lambda d: d.update(format="palpate script"), "got a script, expected a chart"),
    (lambda d: d.update(version=2), "version"),
    (lambda d: d.update(version=True), "version"),
    (lambda d: d.pop("organ"), "no organ"),
    (lambda d: d.update(colour="red"), "an unknown field"),
    (lambda d: d.update(rows={}), "rows"),
    (lambda d: d["rows"][0].update(number=7), r"rows\[0\].number"),
    (lambda d: d["rows"][1].update(own=True), "2 rows of the organ's own"),
    (lambda d: d["rows"][0].update(outcome="fine"), "outcome"),
    (lambda d: d["rows"][0].update(reason="none"), "reason"),
    (lambda d: d["rows"][0].update(total=None), "total"),
    (lambda d: d["rows"][0].update(total=[1]), r"rows\[0\].total"),
    (lambda d: d["rows"][0]["total"].update(force_rms=-1.0), "0 or more"),
    (lambda d: d["rows"][0]["cost"].update(median=float("nan")), "a finite number"),
    (lambda d: d["rows"][0]["configuration"].update(kind="jelly"), "configuration.kind"),
    (lambda d: d["rows"][0]["configuration"].update(tetrahedra=0), "configuration.tetrahedra"),
    (lambda d: d["truth"].update(force=0.0), "truth.force"),
    (lambda d: d["way"].update(kind="wander"), "way.kind"),
]


@pytest.mark.parametrize(("change", "said"), FAULTS, ids=[said for _, said in FAULTS])
def test_a_chart_that_does_not_fit_together_is_refused(change, said, tmp_path):
    path = tmp_path / "chart.json"
    write_chart(path, make_chart())
    spoil(path, change)

    with pytest.raises(Refusal, match=said):
        read_chart(path)


def test_a_number_that_was_changed_is_noticed_by_the_hash(tmp_path):
    path = tmp_path / "chart.json"
    write_chart(path, make_chart())
    spoil(path, lambda d: d["rows"][0]["total"].update(force_rms=0.01), hashed=False)

    with pytest.raises(Refusal, match="sha256"):
        read_chart(path)


@pytest.mark.parametrize("data", [b"", b"[1", b"[" * 100_000, b"[]", b"\xff\xfe", b"null"])
def test_what_is_no_chart_is_refused(data, tmp_path):
    path = tmp_path / "chart.json"
    path.write_bytes(data)

    with pytest.raises(Refusal):
        read_chart(path)


def test_the_front_is_what_nothing_cheaper_is_better_than():
    rows = [make_row(0, cost=1e-3, error=0.02), make_row(1, cost=1e-4, error=0.10),
            make_row(2, cost=2e-4, error=0.20), make_row(3, cost=1e-5, error=0.50),
            make_row(4, cost=2e-3, error=0.02), make_row(5, reason="it flew apart")]  # fmt: skip

    assert [row.number for row in find_front(rows)] == [3, 1, 0]


def test_what_the_intervals_cannot_tell_from_the_front_stays_on_it():
    best = make_row(0, cost=1e-4, error=0.10)
    as_good = make_row(1, cost=1.05e-4, error=0.105)  # intervals of 10 % overlap
    as_right = make_row(2, cost=2e-4, error=0.11)  # costs more, but the truth itself is 2 % off
    beaten = make_row(3, cost=2e-4, error=0.13)

    found = find_possible_front([best, as_good, as_right, beaten], 0.02)

    assert [row.number for row in found] == [0, 1, 2]
    assert [row.number for row in find_front([best, as_good, as_right, beaten])] == [0]


def test_points_and_rail_share_the_rows():
    chart = make_chart()
    waiting = replace(chart.rows[0], number=3, own=False, cost=None)
    chart = replace(chart, rows=(*chart.rows, waiting))

    assert [row.number for row in chart.list_ran()] == [0, 1]
    assert [row.number for row in chart.list_failed()] == [2]

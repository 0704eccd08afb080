# SPDX-License-Identifier: BSD-3-Clause
"""Measured curves: what is read, and what is refused in which words."""

from __future__ import annotations

import pytest
from palpate.files.refusal import Refusal
from palpate.study.curve import read_curve

GOOD = "depth [mm], force [N]\n0, 0\n1, 0.01\n2, 0.04\n3, 0.09\n"


def write(tmp_path, text: str | bytes):
    path = tmp_path / "curve.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def test_a_curve_is_read_in_si(tmp_path):
    curve = read_curve(write(tmp_path, GOOD))

    assert curve.depth == pytest.approx([0.0, 1e-3, 2e-3, 3e-3])
    assert curve.force == pytest.approx([0.0, 0.01, 0.04, 0.09])


def test_columns_may_stand_in_any_order_between_others_and_under_remarks(tmp_path):
    text = "# liver, 1 mm/s\ntime [s],force [mN],depth [um]\n\n0,10,1000\n1,20,2000\n" + (
        "# a pause\n2,30,3000\n3,40,4000\n"
    )

    curve = read_curve(write(tmp_path, text))

    assert curve.depth == pytest.approx([1e-3, 2e-3, 3e-3, 4e-3])
    assert curve.force == pytest.approx([0.01, 0.02, 0.03, 0.04])


def test_a_byte_order_mark_is_no_letter(tmp_path):
    assert len(read_curve(write(tmp_path, GOOD.encode("utf-8-sig"))).depth) == 4


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "got no lines, expected a header such as 'depth"),
        ("# nothing\n\n", "got no lines"),
        (b"\xff\xfe\x00d", "got bytes that are not text"),
        (GOOD.replace(" [mm]", ""), "line 1: got depth without a unit, expected depth with its"),
        (GOOD.replace("mm", "inch"), "line 1: got depth in 'inch', expected .* one of m, cm"),
        (GOOD.replace("[N]", "[mm]"), "line 1: got force in 'mm', expected .* one of N, mN"),
        (GOOD.replace("force", "load"), "line 1: got no column 'force' in 'depth"),
        (GOOD.replace("force [N]", "depth [m]"), "line 1: got two columns named 'depth'"),
        (GOOD.replace(",", ";"), "line 1: got no column 'depth'"),
        (GOOD.replace("0.04", "four"), "line 4: got 'four', expected a finite number"),
        (GOOD.replace("0.04", "nan"), "line 4: got 'nan', expected a finite number"),
        (GOOD.replace("0.04", "inf"), "line 4: got 'inf', expected a finite number"),
        (GOOD.replace("2, 0.04", "2"), "line 4: got '', expected a finite number"),
        (GOOD.replace("3, 0.09\n", ""), "got 3 points, expected at least 4"),
        (GOOD.replace("0, 0", "-1, 0"), "line 2: got a depth of -0.001 m, expected 0 or more"),
        (GOOD.replace("2, 0.04", "1, 0.04"), "line 4: got a depth of 1 mm after one of 1 mm"),
        (GOOD + "2.5, 0.05\n", "line 6: got a depth of 2.5 mm after one of 3 mm"),
        (GOOD.replace("0.0", "-0.0"), "force: got -0.09 N at the deepest point, expected a pos"),
    ],
)
def test_a_bad_curve_is_refused_with_its_line(tmp_path, text, sentence):
    with pytest.raises(Refusal, match=sentence):
        read_curve(write(tmp_path, text))

# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of a chart in sentences, which a window can say in another language."""

from __future__ import annotations

from collections.abc import Iterator

from palpate.study.scene_chart import ALARM, LOST, RAN, Chart, Cost, Errors, Row

from palpate_editor.document import Phrase, phrase


def describe_row(row: Row, chart: Chart) -> list[Phrase]:
    """What it costs, how far it is off and by what, and what it is made of."""
    lines = [] if row.outcome == RAN else [say_end(row)]
    if row.total is not None:
        lines += describe_errors(row, chart)
    if row.cost is not None:
        lines.append(say_cost(row.cost, chart.rate))
    elif row.outcome == RAN:
        lines.append(phrase("Not timed yet."))
    lines += describe_counts(row)
    return lines


def say_end(row: Row) -> Phrase:
    """Why it did not run to its end."""
    if row.outcome == ALARM:
        return phrase("An alarm ended it: {why}.", why=row.reason)
    if row.outcome == LOST:
        return phrase("Lost: {why}.", why=row.reason)
    return phrase("It cannot be built: {why}.", why=row.reason)


def describe_errors(row: Row, chart: Chart) -> Iterator[Phrase]:
    assert row.total is not None
    yield say_total(row.total)
    if row.model is not None and row.time is not None:
        yield phrase(
            "Of that the model itself {model:.1%}, its steps in time {time:.1%}; the truth is "
            "known to {truth:.1%}.",
            model=row.model.force_rms,
            time=row.time.force_rms,
            truth=chart.truth.force_error,
        )
    else:
        yield phrase("The truth is known to {truth:.1%}.", truth=chart.truth.force_error)
    if row.reference_limited:
        yield phrase("That is no more than the truth's own error: which of such rows is better it "
                     "cannot tell.")  # fmt: skip


def say_total(total: Errors) -> Phrase:
    if total.displacement is None:
        return phrase(
            "Force {rms:.1%} off, at most {most:.1%}.", rms=total.force_rms, most=total.force_most
        )
    return phrase(
        "Force {rms:.1%} off, at most {most:.1%}; displacement {displacement:.1%}.",
        rms=total.force_rms,
        most=total.force_most,
        displacement=total.displacement,
    )


def say_cost(cost: Cost, rate: float) -> Phrase:
    return phrase(
        "A tick in touch takes {median:.3g} µs, p99 {p99:.3g} µs, of {period:.4g} µs that it may; "
        "{misses:.1%} take longer.",
        median=1e6 * cost.median,
        p99=1e6 * cost.p99,
        period=1e6 / rate,
        misses=cost.misses,
    )


def describe_counts(row: Row) -> Iterator[Phrase]:
    if row.counts is not None:
        yield phrase(
            "{particles} particles, {elements} elements; at most {substeps} substeps in touch.",
            particles=row.counts.particles,
            elements=row.counts.elements,
            substeps=row.counts.substeps,
        )


def describe_chart(chart: Chart) -> Phrase:
    """What all rows share."""
    done = len(chart.list_ran())
    return phrase(
        "{organ}: a {way} of {depth:.2g} mm with a ball of {radius:.2g} mm; {ran} of {all} "
        "configurations ran to the end.",
        organ=chart.organ,
        way=phrase_way(chart.way.kind),
        depth=1e3 * abs(chart.way.depth),
        radius=1e3 * chart.tool_radius,
        ran=done,
        all=len(chart.rows),
    )


def phrase_way(kind: str) -> Phrase:
    """One of scene_chart.PATHS."""
    if kind == "pull":
        return phrase("pull")
    if kind == "drag":
        return phrase("drag")
    return phrase("press") if kind == "press" else phrase("script")

# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb `advise`: the cheapest way to simulate an organ that is right and quick enough."""

from __future__ import annotations

import argparse
import math
import sys
import time
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.files.refusal import Refusal
from palpate.study.advice import Candidate, Targets
from palpate.study.chart_file import read_chart
from palpate.study.scene_chart import DISPLACEMENT_TARGET, FORCE_TARGET, Chart

from palpate_editor.document import Organ
from palpate_editor.document.files import write_organ
from palpate_editor.edits import Configure, SetConstant
from palpate_editor.verbs.files import ReadFile, apply, open_any

if TYPE_CHECKING:  # it loads SciPy
    from palpate_editor.advise import Advised

MOST_RATE = 100_000.0
"""[Hz]"""
MOST_WORKERS = 256


def add_advise(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=".organ, .palpate or .scene.json")
    parser.add_argument(
        "--force-error",
        type=read_share,
        default=FORCE_TARGET,
        metavar="SHARE",
        help="root mean square along the path, of the largest force, the truth's own error "
        f"included ({FORCE_TARGET:g})",
    )
    parser.add_argument(
        "--displacement-error",
        type=read_share,
        default=DISPLACEMENT_TARGET,
        metavar="SHARE",
        help=f"root mean square of the surface, of the depth, likewise ({DISPLACEMENT_TARGET:g})",
    )
    parser.add_argument("--rate", type=read_rate, metavar="HZ", help="of ticks (the organ's own)")
    parser.add_argument(
        "--depth",
        type=quantity("m"),
        default=0.0,
        metavar="LENGTH",
        help="how far it will be pressed or pulled: farther than it was charted, linear solids are "
        "left out (as far as it was charted)",
    )
    parser.add_argument(
        "--chart",
        type=Path,
        metavar="CHART.json",
        help="choose from this, as `palpate chart -o` writes it (without one it is drawn: minutes, "
        "kept for the next time)",
    )
    parser.add_argument(
        "--workers",
        type=read_workers,
        metavar="N",
        help="run rows of a chart in so many processes at once (1)",
    )
    parser.add_argument(
        "--no-score",
        action="store_true",
        help="do not run the choice on presses held out from it, which takes minutes more",
    )
    parser.add_argument(
        "--apply", action="store_true", help="write the choice into the .organ; only one that fits"
    )


def read_workers(text: str) -> int:
    count = int(text) if text.isdecimal() and len(text) < 4 else 0
    if not 1 <= count <= MOST_WORKERS:
        raise argparse.ArgumentTypeError(
            f"got {text!r}, expected a whole number of 1 to {MOST_WORKERS}"
        )
    return count


def read_share(text: str) -> float:
    try:
        share = float(text)
    except ValueError:
        share = math.nan
    if not 0.0 < share <= 1.0:
        raise argparse.ArgumentTypeError(f"got {text!r}, expected above 0 and at most 1")
    return share


def read_rate(text: str) -> float:
    try:
        rate = float(text)
    except ValueError:
        rate = math.nan
    if not 0.0 < rate <= MOST_RATE:
        raise argparse.ArgumentTypeError(f"got {text!r}, expected above 0 and at most 100000 Hz")
    return rate


def run_advise(call: argparse.Namespace) -> Report:
    # they load SciPy, which every other command does without
    from palpate_editor.advice_words import describe_advised
    from palpate_editor.advise import AdviseError, advise_organ

    if call.apply and call.file.suffix != ".organ":
        raise Refusal(call.file, "--apply", f"a name ending in {call.file.suffix!r}", ".organ")
    if call.chart is not None and call.workers is not None:
        raise WrongCall("--workers has no effect on a --chart, which is drawn already")
    read, organ = ReadFile.of(call.file), open_any(call.file)
    if organ.surface is None:
        raise Refusal(call.file, "organ", "no surface", "an imported mesh")
    if call.depth < 0.0:
        raise Refusal(None, "--depth", f"{1e3 * call.depth:g} mm", "0 mm or more")
    rate = organ.hand.rate if call.rate is None else call.rate
    targets = Targets(call.force_error, call.displacement_error, rate, call.depth)
    organ = replace(organ, hand=replace(organ.hand, rate=rate))
    chart = find_chart(call, organ)
    try:
        advised = advise_organ(organ, chart, targets, scored=not call.no_score, told=Teller())
    except AdviseError as refused:
        raise AdviceRefusal(call.file, str(refused)) from None
    written = None
    if call.apply:
        written = write_choice(call, read, organ, advised)
    return {
        "file": str(call.file),
        "chart": None if call.chart is None else str(call.chart),
        **report_advised(advised),
        "written": written,
        "said": [str(line) for line in describe_advised(advised, chart, organ)],
    }


class AdviceRefusal(Refusal):
    """An organ that cannot be advised, in the advisor's own words."""

    def __init__(self, file: Path, sentence: str):
        super().__init__(file, "advise", sentence, "an organ and its chart")
        self.args = (f"{file}: {sentence}",)


def find_chart(call: argparse.Namespace, organ: Organ) -> Chart:
    """Read, or drawn and kept. Raises Refusal or OSError."""
    if call.chart is not None:
        return read_chart(call.chart)
    from palpate_editor.chart_session import draw_kept_chart
    from palpate_editor.truth import TruthError

    try:
        return draw_kept_chart(organ, call.workers or 1, str(call.file), Teller())
    except TruthError as refused:
        raise AdviceRefusal(call.file, str(refused)) from None


RARELY = 20.0
"""[s] From one line of progress to the next where nobody looks at a terminal."""


class Teller:
    """How far the work is, on standard error: minutes where truths are to be solved."""

    def __init__(self) -> None:
        self.said = time.monotonic()

    def __call__(self, stage: str, share: float) -> None:
        now = time.monotonic()
        if not sys.stderr.isatty() and now < self.said + RARELY:
            return
        self.said = now
        print(f"{stage}: {share:.0%}", file=sys.stderr, flush=True)


def write_choice(
    call: argparse.Namespace, read: ReadFile, organ: Organ, advised: Advised
) -> str | None:
    """Writes the choice into the organ's file, and says what was done. Raises Refusal."""
    advice = advised.advice
    if not advice.fits:
        raise Refusal(
            call.file,
            "--apply",
            "no configuration that meets every target",
            "wider targets, or a chart that has one",
        )
    assert advice.choice is not None
    changed = open_any(call.file)
    if advice.keeps_own and changed.hand.rate == organ.hand.rate:
        return None
    if changed.hand.rate != organ.hand.rate:
        rate = SetConstant("hand", "rate", organ.hand.rate)
        changed = apply(rate, changed, call.file, "--rate")
    if not advice.keeps_own:
        edit = Configure(advice.choice.configuration)
        changed = apply(edit, changed, call.file, "--apply")
    read.check(call.file)
    write_organ(call.file, changed)
    return str(call.file)


def report_advised(advised: Advised) -> Report:
    advice = advised.advice
    return {
        "targets": asdict(advice.targets),
        "fits": advice.fits,
        "keeps_own": advice.keeps_own,
        "binding": advice.binding,
        "tried": advice.tried,
        "ran": advice.ran,
        **{
            name: report_candidate(getattr(advice, name))
            for name in ("choice", "cheaper", "better", "own")
        },
        "ground": None if advised.ground is None else asdict(advised.ground),
        "score": report_score(advised.score),
        "own_score": report_score(advised.own_score),
    }


def report_candidate(candidate: Candidate | None) -> Report | None:
    if candidate is None:
        return None
    return {
        "row": candidate.row.number,
        "name": candidate.row.name,
        "configuration": asdict(candidate.configuration),
        "total": asdict(candidate.row.total) if candidate.row.total is not None else None,
        "cost": asdict(candidate.cost),
        "needs": [asdict(need) | {"met": need.is_met} for need in candidate.needs],
    }


def report_score(score: Any) -> Report | None:
    if score is None:
        return None
    return {
        "errors": None if score.errors is None else asdict(score.errors),
        "force_error": score.force_error,
        "displacement_error": score.displacement_error,
        "p99": score.p99,
        "presses": [asdict(press) for press in score.presses],
    }


def describe_advise(report: Report) -> str:
    lines = list(report["said"])
    if report["written"] is not None:
        lines.append(f"wrote {report['written']}")
    return "\n".join(lines)


VERBS = [
    Verb(
        "advise",
        "choose the cheapest way to simulate an organ that is right and quick enough",
        "palpate advise spleen.organ --force-error 0.10 --displacement-error 0.05 --rate 1000",
        add_advise,
        run_advise,
        describe_advise,
    )
]

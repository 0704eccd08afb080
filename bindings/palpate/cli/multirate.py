# SPDX-License-Identifier: BSD-3-Clause
"""The verb `multirate`: a tissue that ticks more slowly than the hand is read."""

from __future__ import annotations

import argparse
import sys
from dataclasses import asdict
from pathlib import Path

from palpate.command.output import add_output_folder
from palpate.command.verb import Report, Verb, WrongCall, quantity
from palpate.files.file_kind import MULTIRATE, PICTURE, SVG
from palpate.files.refusal import Refusal, split_sentence
from palpate.runs.press import find_top
from palpate.runs.run import PUBLISHED, read_scene, require_one_instrument

OF_SCENE = "slow tissue: "
"""So begins what is said of a scene that cannot tick more slowly than the hand."""


def add_multirate(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, help=f"published scenario, {PUBLISHED}")
    parser.add_argument(
        "--exchange-rate",
        type=float,
        action="append",
        metavar="HZ",
        help="of the tissue; may be repeated; without it 30 to 1000",
    )
    parser.add_argument("--depth", type=quantity("m"), default=5e-3, help="of the press (5mm)")
    parser.add_argument("--slip", type=quantity("m"), default=4e-3, help="along the surface (4mm)")
    add_output_folder(
        parser,
        "--out",
        writes=list_outputs,
        metavar="DIR",
        help="keep the rows there as <name>.json, and draw them as <name>.png and <name>.svg",
    )


def list_outputs(call: argparse.Namespace) -> list[tuple[Path, str]]:
    folder: Path = call.out
    kinds = {".json": MULTIRATE, ".png": PICTURE, ".svg": SVG}
    return [(folder / (call.file.stem + ending), kind) for ending, kind in kinds.items()]


def run_multirate(call: argparse.Namespace) -> Report:
    from palpate.study.multirate import RATES, HandWay, MultirateRow, draw_chart, write_chart

    scene = read_scene(call.file)
    require_one_instrument(call.file, scene)
    for rate in call.exchange_rate or ():
        if not 10.0 <= rate <= scene.rate:
            raise WrongCall(
                f"--exchange-rate: got {rate:g} Hz, expected 10 to the rate of {scene.rate:g} Hz"
            )
    for name in ("depth", "slip"):
        value = getattr(call, name)
        if not 0.0 < value <= 0.05:
            raise WrongCall(f"--{name}: got {1e3 * value:g} mm, expected more than 0, at most 50")
    way = HandWay(find_top(scene), scene.instruments[0].tool.radius, call.depth, call.slip)

    def tell(row: MultirateRow) -> None:
        print(f"{row.mode} {row.rate:.4g} Hz: {row.rms:.1%}", file=sys.stderr, flush=True)

    try:
        chart = draw_chart(call.file, scene, way, call.exchange_rate or RATES, tell)
    except ValueError as problem:
        sentence = str(problem)
        parts = split_sentence(sentence.removeprefix(OF_SCENE))
        if sentence.startswith(OF_SCENE) and parts is not None:
            raise Refusal(call.file, *parts) from None
        raise WrongCall(f"{call.file}: {sentence}") from None
    if call.out is not None:
        # loads matplotlib, which the table does without
        from palpate.study.multirate_plot import save_multirate_plot

        call.out.mkdir(parents=True, exist_ok=True)
        rows, *pictures = (path for path, _ in list_outputs(call))
        write_chart(rows, chart)
        for picture in pictures:
            save_multirate_plot(picture, chart)
    return {
        "file": str(call.file),
        "depth_m": chart.depth,
        "slip_m": chart.slip,
        "peak_N": chart.peak,
        "rows": [asdict(row) for row in chart.rows],
        "out": str(call.out) if call.out else None,
    }


def describe_multirate(report: Report) -> str:
    lines = [
        f"{report['file']}: {1e3 * report['depth_m']:g} mm pressed, "
        f"{1e3 * report['slip_m']:g} mm slipped, {report['peak_N']:.3f} N at full rate",
        "mode              Hz     rms  largest   press    slip  release   jump    margin",
    ]
    for row in report["rows"]:
        shares = "".join(
            f"{row[name]:8.1%}" for name in ("rms", "largest", "press", "slip", "release")
        )
        lines.append(
            f"{row['mode']:16}{row['rate']:5.0f}{shares}{1e3 * row['jump']:7.0f} mN"
            f"{row['margin']:8.1%}"
        )
    return "\n".join(lines)


MULTIRATE_VERB = Verb(
    "multirate",
    "feel a tissue that is slower than the hand: held, extrapolated, by its local stiffness",
    "palpate multirate spleen.palpate --out charts",
    add_multirate,
    run_multirate,
    describe_multirate,
)

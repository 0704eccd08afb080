# SPDX-License-Identifier: GPL-3.0-or-later
"""What a window and its chart_process say to each other, by pickles."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from palpate.study.advice import Targets
from palpate.study.scene_chart import Chart, Configuration

if TYPE_CHECKING:  # it loads SciPy
    from palpate_editor.advise import Advised


@dataclass(frozen=True)
class Request:
    """What is asked of the process."""

    organ: bytes
    """The document, as chart_jobs.pack_document packs it."""
    file: str
    """What the chart says it was drawn of."""
    workers: int = 1
    """Processes that run rows at once."""
    chart: Chart | None = None
    """To choose from; None to draw it."""
    targets: Targets | None = None
    """What is asked for; None for the chart alone."""
    configurations: tuple[Configuration, ...] | None = None
    """To try, the organ's own first; all that there are if None."""
    cache: Path | None = None
    """The folder of what is kept; the user's own if None."""


@dataclass(frozen=True)
class Told:
    """How far the work is."""

    stage: str
    """mesh, stiffness, factor or response of a truth; converged, rows or costs of a chart; choosing
    and pressing of an advice."""
    share: float
    """[-] of the chart, or of the advice."""


@dataclass(frozen=True)
class Shown:
    """The chart of what is finished so far."""

    chart: Chart


@dataclass(frozen=True)
class Done:
    """All that was asked for; nothing more comes."""

    chart: Chart
    advised: Advised | None


@dataclass(frozen=True)
class Refused:
    """Why there is none; nothing more comes."""

    sentence: str

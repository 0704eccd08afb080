# SPDX-License-Identifier: BSD-3-Clause
"""The verbs of the distribution `palpate`; palpate-editor plugs in its own."""

from __future__ import annotations

from palpate.cli.bench import BENCH
from palpate.cli.device import DEVICE
from palpate.cli.doctor import DOCTOR
from palpate.cli.multirate import MULTIRATE_VERB
from palpate.cli.play import PLAY
from palpate.cli.press import PRESS
from palpate.cli.records import RECORDS_VERB
from palpate.cli.render import RENDER
from palpate.cli.replay import REPLAY
from palpate.cli.scenario import SCENARIO_VERB
from palpate.cli.scene import SCENE_VERB
from palpate.cli.study import STUDY

VERBS = [
    *(DOCTOR, PRESS, PLAY, SCENARIO_VERB, RECORDS_VERB, DEVICE, REPLAY, RENDER, BENCH, STUDY),
    *(MULTIRATE_VERB, SCENE_VERB),
]

# SPDX-License-Identifier: GPL-3.0-or-later
"""The Scenario stage: what is asked of a trainee, drawn on the organ and tried out by hands."""

from palpate_editor.views.scenario.scenario_panel import ScenarioPanel

__all__ = ["ScenarioPanel"]

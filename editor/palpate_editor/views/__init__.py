# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor's main window: stages, docks, actions, and what a person sees of the session."""

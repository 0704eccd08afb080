# SPDX-License-Identifier: BSD-3-Clause
"""Runs of a scene: live, by a script, played, replayed; what was felt, and why one ended."""

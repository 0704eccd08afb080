# SPDX-License-Identifier: BSD-3-Clause
"""Scenarios with a task: their file, their check, hands that try them out, and their verdict."""

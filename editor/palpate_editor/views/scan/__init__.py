# SPDX-License-Identifier: GPL-3.0-or-later
"""Cutting an organ out of a scan, in a window of its own beside the stages."""

# SPDX-License-Identifier: GPL-3.0-or-later
"""The window of scenes: organs, stones and scenery placed in a layout."""

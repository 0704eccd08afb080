# SPDX-License-Identifier: GPL-3.0-or-later
"""The atlas of the organ's stability, and the mark of the scene on it."""

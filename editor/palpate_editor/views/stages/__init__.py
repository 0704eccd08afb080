# SPDX-License-Identifier: GPL-3.0-or-later
"""One panel for each step on the way from a mesh file to a published scenario."""

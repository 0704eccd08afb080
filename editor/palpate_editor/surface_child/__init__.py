# SPDX-License-Identifier: GPL-3.0-or-later
"""The process that does what may take long on a surface, so that it can be ended at any moment."""

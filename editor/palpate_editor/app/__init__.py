# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor without its windows: the open document, its history, files and settings."""

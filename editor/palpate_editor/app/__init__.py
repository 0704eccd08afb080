# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor without its windows: the document on the desk, its history, files and settings."""

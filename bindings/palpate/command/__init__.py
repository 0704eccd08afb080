# SPDX-License-Identifier: BSD-3-Clause
"""What a command is made of: its verb, its output files, its output on a terminal."""

# SPDX-License-Identifier: BSD-3-Clause
"""What the operating system gives: another Python, a display, the folder of a user."""

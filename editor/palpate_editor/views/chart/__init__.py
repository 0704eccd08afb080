# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of the organ on the desk: what each way to simulate it costs, and how far it is off."""

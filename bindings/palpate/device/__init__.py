# SPDX-License-Identifier: BSD-3-Clause
"""Haptic devices by name: link, calibration, self-test, and what they say of themselves."""

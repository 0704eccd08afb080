# SPDX-License-Identifier: GPL-3.0-or-later
"""Make organ models for Palpate: import, repair and decimate meshes, set materials."""

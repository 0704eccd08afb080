# SPDX-License-Identifier: BSD-3-Clause
"""Organs to work with: generators, and the meshes they made."""

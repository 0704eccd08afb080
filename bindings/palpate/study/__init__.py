# SPDX-License-Identifier: BSD-3-Clause
"""How right the models are: finite-element references, what the models answer, and fits."""

# SPDX-License-Identifier: BSD-3-Clause
"""How right the models are: finite-element references, how the models respond, and fits."""

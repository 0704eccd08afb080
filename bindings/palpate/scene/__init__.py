# SPDX-License-Identifier: BSD-3-Clause
"""Scene files: the mesh, material, model, tool and hand of an organ, compiled to a Scene."""

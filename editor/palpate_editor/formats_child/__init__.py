# SPDX-License-Identifier: GPL-3.0-or-later
"""The process that reads the files of VTK and Gmsh; palpate_editor.formats starts it."""

# SPDX-License-Identifier: GPL-3.0-or-later
"""The program that reads scans, in a process of its own: only here SimpleITK and scikit-image are
imported.

`python -m palpate_editor.scan_child FOLDER` does what the JSON on its standard input asks, says the
answer as JSON on standard output and leaves arrays in FOLDER. What is wrong with the data is an
answer too: where, got, expected. See palpate_editor.scan, which starts it.
"""

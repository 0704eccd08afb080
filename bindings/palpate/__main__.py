# SPDX-License-Identifier: BSD-3-Clause
"""`python -m palpate`: the command `palpate` of this very installation."""

from palpate.cli.main import run_main

run_main()

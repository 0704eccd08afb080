# SPDX-License-Identifier: BSD-3-Clause
"""The program `palpate`: a module for each verb, their table, and what runs one."""

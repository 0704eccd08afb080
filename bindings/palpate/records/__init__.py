# SPDX-License-Identifier: BSD-3-Clause
"""Attempts of trainees in a local database: here first, whole, and never in the way of play.

Knows no Qt. A person is a drawn code: no name, mail or birthday has a column.
"""

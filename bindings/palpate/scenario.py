# SPDX-License-Identifier: BSD-3-Clause
"""The published file, `.palpate`, and the container it and `.organ` are.

What C++ offers in palpate::scenario, under the same names. The JSON Schema of both files stands in
palpate/schemas.
"""

from palpate._sim._scenario import *  # noqa: F403

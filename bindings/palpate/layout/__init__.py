# SPDX-License-Identifier: BSD-3-Clause
"""Several published organs placed in one scene: the document, its checks, and what is published."""

# SPDX-License-Identifier: BSD-3-Clause
"""Files: read within limits, every field checked, written whole or not at all."""

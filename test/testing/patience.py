# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Deadlines of tests are multiplied by this, for a machine that is slow, such as one in emulation."""
import os

PATIENCE = float(os.environ.get('LINK_BOUNDS_TEST_PATIENCE', 1))

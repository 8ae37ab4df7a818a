# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The robots that are measured: those of LINK_BOUNDS_DATA, or that of the demo."""
import os
import pathlib

DATA = os.environ.get("LINK_BOUNDS_DATA")
DEMO = str(pathlib.Path(__file__).resolve().parents[3] / "launch/demo/demo.urdf")
FILES = {"panda": "franka_description/urdf/panda.urdf", "ur5e": "ur_description/urdf/ur5e.urdf",
         "pr2": "pr2_description/urdf/pr2.urdf"}


def public(*names):
    """{name: URDF}; none where LINK_BOUNDS_DATA is not set, which a line says."""
    if not DATA:
        print("LINK_BOUNDS_DATA is not set: public robots are not measured")
        return {}
    return {name: os.path.join(DATA, "robots", FILES[name]) for name in names}

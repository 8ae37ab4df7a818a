# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses of the demo robot."""
import math


def joints(pan, lift, bend, roll, wrist, flange, finger):
    """Degrees, and metres for the finger; finger_right mimics finger_left."""
    angles = {"shoulder_pan": pan, "shoulder_lift": lift, "elbow_bend": bend,
              "forearm_roll": roll, "wrist_bend": wrist, "wrist_roll": flange}
    result = {name: math.radians(angle) for name, angle in angles.items()}
    result["finger_left_slide"] = finger
    return result


POSES = [joints(0, 0, 45, 0, 0, 0, 0.0), joints(30, 0, 45, 0, 0, 0, 0.01),
         joints(45, 30, 30, 45, 30, 45, 0.02), joints(-120, -30, 100, 200, -45, -30, 0.055)]

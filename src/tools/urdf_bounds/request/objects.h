// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects around a robot: the file of --objects, which doc/tools.md describes.
#pragma once

#include <string>

#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// Returns a robot with one link per object and no joints, in the frame of the other robot's root
/// link. Errors name `file`. Throws UsageError with the name of the object and the remedy.
Robot parseObjects(const std::string& text, const std::string& file);

/// Makes the problems of loaded objects name an object instead of a link and its only visual.
void nameObjects(BoundedRobot& objects);

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Objects around a robot: the file of --objects, which doc/tools.md describes.
#pragma once

#include <string>

#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// One link per object, in the frame of the root link of a robot, all of them fixed. `file` is
/// named in errors. Throws UsageError with the name of the object and the remedy.
Robot parseObjects(const std::string& text, const std::string& file);

/// The problems of loaded objects then name an object, not a link and its only visual.
void nameObjects(BoundedRobot& objects);

}  // namespace link_bounds

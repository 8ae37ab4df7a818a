// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks that reports can tell the links and joints of a robot apart.
#pragma once

#include "link_bounds/robot/urdf/robot.h"

namespace link_bounds {

/// Throws UsageError if two links or two joints have the same name once bytes that are no UTF-8 are
/// replaced, as reports do.
void checkNames(const Robot& robot);

}  // namespace link_bounds

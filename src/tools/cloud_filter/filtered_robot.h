// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robot as the filter needs it: made once, then immutable.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "geometry/cloud/body_grid.h"
#include "tools/cloud_filter/filter_parameters.h"

namespace link_bounds {

struct FilteredRobot {
  FilterParameters parameters;
  std::vector<std::string> links;                      ///< those with geometry
  std::vector<std::shared_ptr<const BodyGrid>> grids;  ///< by link
  std::vector<std::string> problems;  ///< geometry that is not filtered, or as its convex hull only
  std::vector<std::string> warnings;  ///< names in parameters that fit no link
};

/// Loads the meshes. Throws RobotError. `is_cancelled` may be called on several threads; if it
/// returns true, what it returns is not complete.
FilteredRobot filteredRobot(const std::string& description, const FilterParameters& parameters,
                            const std::function<bool()>& is_cancelled);

}  // namespace link_bounds

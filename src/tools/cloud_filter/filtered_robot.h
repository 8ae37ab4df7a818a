// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The robot as the filter needs it: made once, then immutable.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "geometry/cloud/body_grid.h"
#include "tools/cloud_filter/filter_parameters.h"

namespace link_bounds {

struct FilteredRobot {
  FilterParameters parameters;
  std::vector<std::string> links;                      ///< those with geometry
  std::vector<std::string> frames;                     ///< in tf, by link
  std::vector<std::shared_ptr<const BodyGrid>> grids;  ///< by link; equal bodies share one
  std::set<std::string> all_frames;                    ///< of all links of the description
  std::vector<std::string> incomplete;                 ///< links of which something is missing
  std::vector<std::string> problems;  ///< geometry that is not filtered, or as its convex hull only
  std::vector<std::string> warnings;  ///< names in parameters that fit no link
  std::string left_out;               ///< see leftOutNote()
  std::string summary;                ///< one line for the log
};

/// Message after the name of a body whose grid is incomplete.
constexpr char kNotWhole[] =
    " is not filtered, or not all of it: coordinates are too large or not finite";

/// Loads the meshes and makes the grids, on up to four threads. Throws RobotError. `is_cancelled`
/// may be called on several threads; once it returns true, the result is null.
std::shared_ptr<const FilteredRobot> filteredRobot(const std::string& description,
                                                   const FilterParameters& parameters,
                                                   const std::function<bool()>& is_cancelled);

}  // namespace link_bounds

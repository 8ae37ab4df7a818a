// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/tf/transform_problem.h"

namespace link_bounds {

std::string describe(TransformProblem problem, const std::string& frame,
                     const std::string& fixed_frame) {
  const std::string from = "from \"" + frame + "\"";
  const std::string to = "to \"" + fixed_frame + "\"";
  switch (problem) {
    case TransformProblem::kNone:
      return "";
    case TransformProblem::kNoTransform:
      return "no transform " + from + " " + to;
    case TransformProblem::kStale:
      return "stale: no transform accepted with a newer stamp for longer than timeout";
    case TransformProblem::kPoseNotFinite:
      return "its pose is not finite or too large";
    case TransformProblem::kWaiting:
      return "the transform " + from + " at its stamp is not there yet";
    case TransformProblem::kGivenUp:
      return "there was no transform " + from + " at its stamp";
    case TransformProblem::kNotCarried:
      return "no transform " + from + ", in which it was placed, " + to;
  }
  return "";
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Why a link or an object has no box, if its geometry is not the cause.
#pragma once

#include <string>

namespace link_bounds {

enum class TransformProblem {
  kNone,
  kNoTransform,    ///< tf does not connect the frame with the fixed frame at the time of its pose
  kStale,          ///< an edge of the path got no newer stamp for longer than the timeout
  kPoseNotFinite,  ///< or it is so large that no box can be computed
  kWaiting,        ///< the object waits for the transform at its stamp
  kGivenUp,        ///< the object has waited longer than the timeout
  kNotCarried,     ///< the object was placed in another fixed frame, which has no transform yet
};

/// The problem in words; "" for kNone. `frame` is the one without a transform: of the link, of the
/// object's header, or the fixed frame in which the object was placed.
std::string describe(TransformProblem problem, const std::string& frame,
                     const std::string& fixed_frame);

}  // namespace link_bounds

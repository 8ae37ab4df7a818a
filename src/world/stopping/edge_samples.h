// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The transforms of an edge from which speeds are computed.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "world/tf/transform_buffer.h"

namespace link_bounds {

constexpr double kSecond = 1e9;          // ns
constexpr std::int64_t kMinPieces = 5;   // a piece takes a window / kMinPieces, see piecesOf()
constexpr double kStampRounding = 1e-9;  // s, of the difference of two stamps

/// A pose at a time [ns].
struct TimedPose {
  std::int64_t stamp;
  Eigen::Isometry3d pose;
};

/// The poses of a child in its parent that tf interpolates between during a window, or why speeds
/// cannot be computed from them.
struct EdgeSamples {
  std::vector<TimedPose> poses;  ///< at least two; one for a static edge
  bool is_static = false;
  std::string problem;  ///< why no speeds can be computed, with the remedy, or ""
};

/// The samples from `window` before `stamp` until `stamp` [ns], and the next one outside each end.
EdgeSamples edgeSamples(const TransformBuffer& tf, TransformBuffer::Frame child, std::int64_t stamp,
                        std::int64_t window);

/// Whether all poses are the same but for rounding.
bool isStill(const std::vector<TimedPose>& poses);

/// Where the window is cut into pieces: indices of stamps, including the first and the last. Each
/// piece takes at least a fifth of the window, unless all stamps together are shorter, so that
/// inexact stamps matter little.
std::vector<std::size_t> piecesOf(const std::vector<std::int64_t>& stamps, std::int64_t window);

}  // namespace link_bounds

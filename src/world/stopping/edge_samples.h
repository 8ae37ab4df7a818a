// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The transforms of a tf edge from which its speed is computed.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "world/tf/transform_buffer.h"

namespace link_bounds {

constexpr double kSecond = 1e9;          // ns
constexpr std::int64_t kMinPieces = 5;   // a piece takes >= 1 / kMinPieces of a window
constexpr double kStampRounding = 1e-9;  // s, of the difference of two stamps

/// A pose at a time [ns].
struct TimedPose {
  std::int64_t stamp;
  Eigen::Isometry3d pose;
};

/// The poses of a child in its parent between which tf interpolates during a window; or the
/// problem, if no speed can be computed from them.
struct EdgeSamples {
  std::vector<TimedPose> poses;  ///< at least two; one for a static edge
  bool is_static = false;
  std::string problem;  ///< with the remedy
};

/// The samples from `window` before `stamp` until `stamp` [ns], and those that enclose this time.
EdgeSamples edgeSamples(const TransformBuffer& tf, TransformBuffer::Frame child, std::int64_t stamp,
                        std::int64_t window);

/// Whether all poses are the same but for rounding.
bool isStill(const std::vector<TimedPose>& poses);

/// Cuts a window into pieces. Returns the indices of the stamps at the cuts, including the first
/// and the last stamp. A piece takes at least a fifth of the window, so inexact stamps matter
/// little.
std::vector<std::size_t> piecesOf(const std::vector<std::int64_t>& stamps, std::int64_t window);

}  // namespace link_bounds

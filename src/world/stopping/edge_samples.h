// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The transforms of an edge from which speeds come.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "world/tf/transform_buffer.h"

namespace link_bounds {

constexpr double kSecond = 1e9;          // ns
constexpr std::int64_t kMinPieces = 5;   // in a window
constexpr double kStampRounding = 1e-9;  // s, of the difference of two stamps

/// A pose at a time [ns].
struct TimedPose {
  std::int64_t stamp;
  Eigen::Isometry3d pose;
};

/// The poses of a child in its parent that tf interpolates between during a window, or why speeds
/// cannot be computed from them.
struct EdgeSamples {
  std::vector<TimedPose> poses;  ///< two at least; one of a static edge
  bool is_static = false;
  std::string problem;  ///< with the remedy
};

/// From `window` before `stamp` until `stamp` [ns], with the samples around both.
EdgeSamples edgeSamples(const TransformBuffer& tf, TransformBuffer::Frame child, std::int64_t stamp,
                        std::int64_t window);

/// Whether all poses are the same but for rounding.
bool isStill(const std::vector<TimedPose>& poses);

/// Where the window is cut: indices of the stamps, the first and the last among them. Pieces take
/// at least a fifth of the window, so that inexact stamps matter little.
std::vector<std::size_t> piecesOf(const std::vector<std::int64_t>& stamps, std::int64_t window);

}  // namespace link_bounds

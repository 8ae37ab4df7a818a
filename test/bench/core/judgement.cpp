// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The oracle is that of the tests.
#include "bench/core/judgement.h"

#include <algorithm>

#include "testing/brute_force.h"

namespace link_bounds::bench {
namespace {

constexpr double kExactTolerance = 1e-9;

bool isExact(const Aabb& box, const Aabb& exact) {
  const double error = std::max((box.min() - exact.min()).lpNorm<Eigen::Infinity>(),
                                (box.max() - exact.max()).lpNorm<Eigen::Infinity>());
  return error <= kExactTolerance * exact.sizes().maxCoeff();
}

}  // namespace

Boxes exactBoxes(const TriangleMesh& mesh, const Poses& poses) {
  Boxes boxes;
  for (std::size_t i = 0; i < kRandomPoses; ++i)
    boxes.push_back(brute_force::box(mesh.vertices, poses[i]));
  return boxes;
}

Judgement judge(const Boxes& boxes, const Boxes& exact) {
  Judgement result{true, 0};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    result.exact = result.exact && isExact(boxes[i], exact[i]);
    result.volume_ratio += boxes[i].volume() / exact[i].volume();
  }
  result.volume_ratio /= static_cast<double>(exact.size());
  return result;
}

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// This library, by each path of instructions that the processor has.
#include "bench/core/methods.h"
#include "geometry/shape/shape_extents.h"

namespace link_bounds::bench {
namespace {

/// The box of one shape, rounded outward, as LinkBoxes computes each.
struct Ours : Method {
  using Pose = Eigen::Affine3d;

  Ours(const MeasuredMesh& mesh, QueryPath query_path)
      : path(query_path), shape{mesh.points}, known(shape) {}

  static Pose toPose(const Eigen::Affine3d& pose) { return pose; }
  void begin() { useQueryPath(path); }
  std::optional<Aabb> box(const Pose& pose) {
    std::optional<Aabb> result(std::in_place);
    if (!placeShape(shape, pose, nullptr, known, *result)) result.reset();
    return result;
  }
  static Aabb toAabb(const std::optional<Aabb>& box) { return box.value(); }
  std::size_t bytes() const { return shape.points->bytes(); }

  QueryPath path;
  Shape shape;
  ShapeExtents known;
};

}  // namespace

std::string nameOfOurs(QueryPath path) {
  switch (path) {
    case QueryPath::kPlain:
      return "ours_plain";
    case QueryPath::kSse2:
      return "ours_sse2";
    case QueryPath::kAvx2:
      return "ours_avx2";
    case QueryPath::kNeon:
      return "ours_neon";
  }
  return "";
}

void addOurs(const Trial& trial, Suite& suite) {
  for (const QueryPath path : kQueryPaths) {
    if (isSupported(path))
      addCase(nameOfOurs(path), trial.mesh, trial.turning, Ours(trial.mesh, path), suite);
  }
  addCase("ours_unchanged", trial.mesh, trial.sliding, Ours(trial.mesh, queryPath()), suite);
}

}  // namespace link_bounds::bench

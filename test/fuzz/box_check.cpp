// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Containment by quadruple precision, and a loop over all vertices.
#include "box_check.h"

#include "testing/exactness.h"
#include "testing/quad.h"

namespace link_bounds {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr double kExcessOfUnderflow = 1e-307;  // metres

std::string faultAt(const BoundedLink& link, const Points& points,
                    const Eigen::Affine3d& world_from_link) {
  const std::optional<Aabb> box = linkBox(link, world_from_link);
  if (!box) return "there is no box";
  if (!box->min().allFinite() || !box->max().allFinite()) return "the box is not finite";
  const Eigen::Affine3d world_from_shape = world_from_link * link.shapes[0].link_from_shape;
  const std::string fault = faultOf(*box, points, world_from_shape, kExcessOfUnderflow);
  if (!fault.empty()) return fault;
  const bool is_exact =
      compare(points, *link.shapes[0].points, world_from_shape.linear()).wrong == 0;
  return is_exact ? "" : "the extents are not those of a loop over the vertices";
}

}  // namespace

std::vector<Eigen::Affine3d> obliquePoses(brute_force::Random& random) {
  Eigen::Affine3d yaw(brute_force::turned(30, Eigen::Vector3d::UnitZ()));
  Eigen::Affine3d roll(brute_force::turned(45, Eigen::Vector3d::UnitX()));
  Eigen::Affine3d tilt(brute_force::turned(45, {1, 1, 0}) *
                       brute_force::turned(30, Eigen::Vector3d::UnitY()));
  yaw.pretranslate(random.vector(2));
  roll.pretranslate(random.vector(1e3));
  return {yaw, roll, tilt, random.rigid(5), random.affine(5)};
}

std::string faultOfLoaded(const BoundedLink& link, const Points& points,
                          const std::vector<Eigen::Affine3d>& poses) {
  if (!link.isWhole()) return "it is loaded and called incomplete: " + link.missing;
  if (link.shapes.size() != 1 || !link.shapes[0].points) return "it has not one mesh";
  for (const Eigen::Affine3d& pose : poses) {
    const std::string fault = faultAt(link, points, pose);
    if (!fault.empty()) return fault;
  }
  return "";
}

std::string faultOfRefused(const BoundedLink& link) {
  if (link.isWhole()) return "it is refused without a reason";
  if (!link.shapes.empty()) return "it is refused and has a shape";
  return linkBox(link, Eigen::Affine3d::Identity()) ? "it is refused and has a box" : "";
}

}  // namespace link_bounds

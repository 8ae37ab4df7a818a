// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/pairs/pair_body.h"

namespace link_bounds {
namespace {

/// For a body of more shapes, only the hull of all of them is compared.
constexpr std::size_t kMaxParts = 12;

/// At a pose that is not rigid, as in a scaled mesh, the skin would not be known.
constexpr double kRigid = 1e-12;

PairHull hullOf(const Body& body) {
  Body hull = body;
  for (BodyShape& shape : hull.shapes)
    shape.triangles = nullptr;
  return {std::make_shared<const Body>(std::move(hull)), BodyCloud(body)};
}

/// Adds the core of a box, a ball or a cylinder, which is smaller by the skin on all sides.
void addCore(const BodyShape& body_shape, std::vector<SolidCore>& cores) {
  const Shape& shape = body_shape.shape;
  if (shape.solid == Solid::kNone || shape.points || body_shape.triangles || body_shape.tip) return;
  if (!shape.link_from_shape.linear().isUnitary(kRigid)) return;
  const double skin = shape.size.minCoeff() / 2;
  if (shape.solid == Solid::kEllipsoid && shape.size.maxCoeff() > 2 * skin) return;
  BodyShape core = body_shape;
  core.shape.size = (shape.size.array() - 2 * skin).max(0);
  cores.push_back({{{core}}, skin * (1 - kRigid)});
}

std::optional<BodyDistance> within(const Body& first, const Body& second,
                                   const Eigen::Affine3d& first_from_second, double max_distance) {
  if (!(max_distance > 0)) return {};
  const auto distance = bodyDistance(first, Eigen::Affine3d::Identity(), second, first_from_second);
  return distance && distance->upper <= max_distance ? distance : std::nullopt;
}

}  // namespace

PairBody pairBody(const Body& body) {
  PairBody result{std::make_shared<const Body>(body), hullOf(body), {}, {}};
  for (const BodyShape& shape : body.shapes) {
    if (body.shapes.size() > 1 && body.shapes.size() <= kMaxParts)
      result.parts.push_back(hullOf({{shape}}));
    addCore(shape, result.cores);
  }
  return result;
}

std::vector<const PairHull*> partsOf(const PairBody& body) {
  if (body.parts.empty()) return {&body.hull};
  std::vector<const PairHull*> result;
  for (const PairHull& part : body.parts)
    result.push_back(&part);
  return result;
}

std::optional<BodyDistance> coreContact(const PairBody& first, const PairBody& second,
                                        const Eigen::Affine3d& first_from_second,
                                        double max_distance) {
  for (const SolidCore& core : first.cores) {
    const auto found = within(core.body, *second.body, first_from_second, max_distance + core.skin);
    if (found) return found;
  }
  for (const SolidCore& core : second.cores) {
    const auto found = within(*first.body, core.body, first_from_second, max_distance + core.skin);
    if (found) return found;
  }
  return {};
}

}  // namespace link_bounds

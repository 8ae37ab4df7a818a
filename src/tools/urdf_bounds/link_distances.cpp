// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes choose the pairs.
#include "tools/urdf_bounds/link_distances.h"

#include <set>

#include "geometry/pairs/near_pairs.h"
#include "link_bounds/robot/urdf/overlap_filter.h"

namespace link_bounds {
namespace {

/// Links that have a box, by their index in BoundedRobot::links.
struct BoxedLinks {
  std::vector<std::size_t> links;
  std::vector<Aabb> boxes;
};

BoxedLinks boxedLinks(const BoundedRobot& bounded, const std::vector<Eigen::Affine3d>& poses) {
  BoxedLinks result;
  for (std::size_t i = 0; i < bounded.links.size(); ++i) {
    const std::optional<Aabb> box = linkBox(bounded.links[i], poses[i]);
    if (!box) continue;
    result.links.push_back(i);
    result.boxes.push_back(*box);
  }
  return result;
}

/// Links of one rigid body, and neighbours, are no pair.
bool hasPair(const std::vector<std::size_t>& links, const RigidBodies& rigid) {
  for (const std::size_t a : links) {
    for (const std::size_t b : links) {
      if (a != b && !areJoined(rigid, a, b)) return true;
    }
  }
  return false;
}

}  // namespace

DistanceTable linkDistances(const Robot& robot, const BoundedRobot& bounded,
                            const std::vector<Eigen::Isometry3d>& poses, double limit) {
  std::vector<Eigen::Affine3d> frame_from_link;
  for (const std::size_t index : bounded.indices)
    frame_from_link.emplace_back(poses[index]);
  const BoxedLinks boxed = boxedLinks(bounded, frame_from_link);
  const auto distanceOf = [&](std::size_t a, std::size_t b) {
    return bodyDistance(bounded.bodies[a], frame_from_link[a], bounded.bodies[b],
                        frame_from_link[b], {DistanceGoal().accuracy, limit});
  };
  const RigidBodies rigid = rigidBodies(robot);
  std::vector<std::size_t> indices;  // in the robot
  for (const std::size_t link : boxed.links)
    indices.push_back(bounded.indices[link]);
  DistanceTable table{limit, {}, {}, hasPair(indices, rigid)};
  std::set<std::size_t> without;
  NearPairs near;
  const auto are_compared = [&](std::size_t a, std::size_t b) {
    return !areJoined(rigid, indices[a], indices[b]);
  };
  NearPairSearch().find(boxed.boxes, {limit}, are_compared, near);
  for (const BoxPair& pair : near.compared) {
    const std::size_t a = boxed.links[pair.first];
    const std::size_t b = boxed.links[pair.second];
    const std::optional<BodyDistance> distance = distanceOf(a, b);
    if (distance && distance->lower <= limit)
      table.pairs.push_back({bounded.links[a].name, bounded.links[b].name, *distance});
    for (const std::size_t link : {a, b}) {
      if (!distance && !distanceOf(link, link)) without.insert(link);
    }
  }
  for (const std::size_t link : without)
    table.incomplete.emplace_back(bounded.links[link].name,
                                  "its size and pose give no finite distance");
  return table;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Models and transforms made by hand, for tests that need no master.
#pragma once

#include <geometry_msgs/TransformStamped.h>

#include "link_bounds/ros/messages.h"
#include "testing/brute_force.h"
#include "world/bodies/scene.h"

namespace link_bounds {

inline BoundedLink meshLink(const std::string& name, std::uint64_t seed) {
  brute_force::Random random(seed);
  Shape shape;
  shape.points = std::make_shared<const PointSet>(random.points(300, 0.5));
  return {name, {shape}, 0, ""};
}

/// A group of all links; frames have the links' names, and no link is joined to another.
inline std::shared_ptr<const Model> modelOf(const std::string& fixed_frame,
                                            const std::vector<BoundedLink>& links) {
  auto model = std::make_shared<Model>();
  model->fixed_frame = fixed_frame;
  model->links = links;
  SceneGroup robot;
  robot.name = "robot";
  for (const BoundedLink& link : links) {
    robot.members.push_back(model->frames.size());
    model->bodies.of_links.push_back(model->frames.size());
    model->bodies.parents.push_back(model->frames.size());
    model->frames.push_back(link.name);
  }
  model->groups.push_back(robot);
  return model;
}

inline geometry_msgs::TransformStamped edge(const std::string& parent, const std::string& child,
                                            double stamp, const Eigen::Quaterniond& rotation,
                                            const Eigen::Vector3d& translation) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.header.stamp = ros::Time(stamp);
  transform.child_frame_id = child;
  transform.transform.translation = toVector3(translation);
  transform.transform.rotation.w = rotation.w();
  transform.transform.rotation.x = rotation.x();
  transform.transform.rotation.y = rotation.y();
  transform.transform.rotation.z = rotation.z();
  return transform;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A robot of a URDF file that moves in tf before a sensor, and a scene around it: what each ray of
// the sensor hits, at its own time.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/PointCloud2.h>

#include <optional>
#include <string>

#include "link_bounds/robot/robot_loader.h"
#include "link_bounds/robot/urdf/kinematics.h"
#include "testing/brute_force.h"
#include "testing/ray_caster.h"
#include "testing/robot_files.h"
#include "testing/sanitized.h"
#include "world/cloud/robot_points.h"

namespace link_bounds {

/// Points as drivers send them: x, y, z in FLOAT32, and the time in nanoseconds after the stamp.
struct CloudPoint {
  float x, y, z;
  std::uint32_t time;
};

inline sensor_msgs::PointCloud2 cloudOfPoints(const std::vector<CloudPoint>& points,
                                              std::uint32_t width, double stamp,
                                              bool has_time = true) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = ros::Time(stamp);
  cloud.header.frame_id = "sensor";
  cloud.width = width;
  cloud.height = width == 0 ? 1 : static_cast<std::uint32_t>(points.size()) / width;
  cloud.point_step = sizeof(CloudPoint);
  cloud.row_step = width * cloud.point_step;
  const char* const names[] = {"x", "y", "z", "t"};
  for (std::uint32_t k = 0; k < (has_time ? 4u : 3u); ++k) {
    sensor_msgs::PointField& field = cloud.fields.emplace_back();
    field.name = names[k];
    field.offset = 4 * k;
    field.datatype = k < 3 ? sensor_msgs::PointField::FLOAT32 : sensor_msgs::PointField::UINT32;
    field.count = 1;
  }
  cloud.data.resize(points.size() * sizeof(CloudPoint));
  if (!points.empty()) std::memcpy(cloud.data.data(), points.data(), cloud.data.size());
  return cloud;
}

class ScannedRobot {
 public:
  struct Hit {
    double range;  ///< in units of the direction
    bool is_robot;
    std::size_t link;  ///< of a robot
  };

  ScannedRobot(const RobotFile& file, double padding) : padding_(padding) {
    Selection selection;
    selection.triangles = true;
    selection.padding = padding;
    LoadedRobot loaded = loadRobot(textOf(file.urdf), {file.package_path}, selection);
    robot = std::move(loaded.robot);
    bodies = std::move(loaded.bounded.bodies);
    problems = std::move(loaded.bounded.problems);
    for (const BoundedLink& link : loaded.bounded.links) {
      names.push_back(link.name);
      links.push_back({tf.frame(link.name), Aabb()});
    }
    for (const Body& body : bodies)
      casters_.emplace_back(body);
  }

  /// Not needed for casting rays. Small grids are made faster and leave more points to the
  /// distance.
  void makeGrids(bool are_small = kIsSanitized) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      grids.push_back(std::make_shared<BodyGrid>(
          BodySurface(bodies[i]),
          GridOptions{padding_, kMaxMotionError, (are_small ? 16 : 256) * 1024u}));
      links[i].box = grids[i]->box();
    }
  }

  /// Samples at 50 Hz from `begin` to `end` [s]; each joint turns back and forth at up to `speed`
  /// [rad/s] or slides by 2 cm, and the sensor stays at its place.
  void move(brute_force::Random& random, double speed, double begin, double end,
            const Eigen::Isometry3d& root_from_sensor) {
    std::map<std::string, std::pair<double, double>> phases;
    for (const Joint& joint : robot.joints) {
      if (hasValue(joint.motion) && !joint.mimic)
        phases[joint.name] = {random.uniform(-1, 1), random.uniform(0, 2 * M_PI)};
    }
    const std::string& root = robot.links[robot.root].name;
    for (double stamp = begin; stamp < end + 0.021; stamp += 0.02) {
      std::map<std::string, double> values;
      for (const Joint& joint : robot.joints) {
        const auto phase = phases.find(joint.name);
        if (phase == phases.end()) continue;
        // The derivative of a turn is at most `speed`. Fingers stay apart.
        const double swing = 0.5 * std::sin(phase->second.second + 2 * speed * (stamp - begin));
        values[joint.name] =
            joint.motion == Motion::kRotation ? phase->second.first + swing : 0.02 * (1.5 + swing);
      }
      const auto poses = linkPoses(robot, jointValues(robot, values));
      add(root, "sensor", stamp, root_from_sensor);
      for (const Joint& joint : robot.joints)
        add(robot.links[joint.parent].name, robot.links[joint.child].name, stamp,
            poses[joint.parent].inverse() * poses[joint.child]);
    }
  }

  /// A body of the scene, in the root frame.
  void addScene(const Body& body) { scene_.emplace_back(body); }

  Eigen::Affine3d linkFromSensor(std::size_t link, std::int64_t stamp) const {
    return MatrixPose(*tf.pose(links[link].frame, *tf.find("sensor"), stamp)).affine;
  }

  /// What a ray from the sensor's origin hits first.
  class Ray {
   public:
    /// At one time [ns]: the poses are computed once.
    Ray(const ScannedRobot& scanned, std::int64_t stamp) : scanned_(scanned) {
      for (std::size_t i = 0; i < scanned.links.size(); ++i)
        link_from_sensor.push_back(scanned.linkFromSensor(i, stamp));
      const auto root = scanned.tf.find(scanned.robot.links[scanned.robot.root].name);
      root_from_sensor =
          MatrixPose(*scanned.tf.pose(*root, *scanned.tf.find("sensor"), stamp)).affine;
    }

    std::optional<Hit> cast(const Eigen::Vector3d& direction) const {
      Hit best{std::numeric_limits<double>::infinity(), false, 0};
      for (const RayCaster& caster : scanned_.scene_) {
        const double range =
            caster.hit(root_from_sensor.translation(), root_from_sensor.linear() * direction);
        if (range < best.range) best = {range, false, 0};
      }
      for (std::size_t i = 0; i < link_from_sensor.size(); ++i) {
        const double range = scanned_.casters_[i].hit(link_from_sensor[i].translation(),
                                                      link_from_sensor[i].linear() * direction);
        if (range < best.range) best = {range, true, i};
      }
      if (!std::isfinite(best.range)) return std::nullopt;
      return best;
    }

    std::vector<Eigen::Affine3d> link_from_sensor;
    Eigen::Affine3d root_from_sensor;

   private:
    const ScannedRobot& scanned_;
  };

  Robot robot;
  std::vector<std::string> names;
  std::vector<Body> bodies;
  std::vector<std::string> problems;
  std::vector<ScannedLink> links;
  std::vector<std::shared_ptr<const BodyGrid>> grids;
  TransformBuffer tf;

 private:
  void add(const std::string& parent, const std::string& child, double stamp,
           const Eigen::Isometry3d& pose) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros::Time(stamp);
    transform.child_frame_id = child;
    const Eigen::Quaterniond rotation(pose.linear());
    transform.transform.rotation.x = rotation.x();
    transform.transform.rotation.y = rotation.y();
    transform.transform.rotation.z = rotation.z();
    transform.transform.rotation.w = rotation.w();
    transform.transform.translation.x = pose.translation().x();
    transform.transform.translation.y = pose.translation().y();
    transform.transform.translation.z = pose.translation().z();
    tf.add({transform}, false, ros::Time(stamp));
  }

  double padding_;
  std::vector<RayCaster> casters_;
  std::vector<RayCaster> scene_;
};

/// A sensor at `eye` that looks at `target`: z ahead, y down, as cameras do.
inline Eigen::Isometry3d lookingAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d z = (target - eye).normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  pose.linear() << x, z.cross(x), z;
  pose.translation() = eye;
  return pose;
}

/// Of a box of the scene.
inline Body boxBody(const Eigen::Vector3d& size, const Eigen::Affine3d& pose) {
  return {{{{nullptr, Solid::kBox, size, pose}}}};
}

}  // namespace link_bounds

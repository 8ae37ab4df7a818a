// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A random link on a random way: chains of edges of all kinds, each with its own sample times.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "testing/live_boxes_testing.h"
#include "testing/quad_motion.h"
#include "world/history/swept_box.h"

namespace link_bounds {

enum class EdgeKind {
  kStatic,
  kResting,    ///< samples are equal
  kSlow,       ///< small steps
  kFast,       ///< steps of up to 179 degrees
  kHalfTurns,  ///< steps of exactly 180 degrees
  kOpposite,   ///< the same rotation, every other quaternion with the opposite sign
  kShifting,   ///< no rotation
  kHair,       ///< steps near the smallest angle that tf2 knows
};
constexpr int kEdgeKinds = 8;

class RandomMotion {
 public:
  explicit RandomMotion(std::uint64_t seed)
      : random_(seed), is_sloppy_(seed % 4 == 0), reach_(seed % 7 == 0 ? 50 : 1) {
    const int up = 1 + pick(5), down = seed % 2 == 0 ? 0 : pick(4);
    span = {kBegin + pick(20000000), 0};
    span.end = span.begin + static_cast<std::int64_t>(1e9 * random_.magnitude(-2.5, -0.5));
    for (int i = 0; i < up; ++i)
      from_source.emplace_back(samples());
    for (int i = 0; i < down; ++i)
      from_target.emplace_back(samples());
    makeLink();
  }

  /// Gives all transforms of the edges to add(parent, child, sample, is_static).
  template <class Add>
  void send(Add add) {
    sendChain(from_source, "source", add);
    sendChain(from_target, "target", add);
  }

  /// True if no edge has more than one transform.
  bool isAtRest() const {
    const auto is_static = [](const QuadEdge& edge) { return edge.samples.size() == 1; };
    return std::all_of(from_source.begin(), from_source.end(), is_static) &&
           std::all_of(from_target.begin(), from_target.end(), is_static);
  }

  /// True if the lengths of its quaternions differ.
  bool isSloppy() const { return is_sloppy_; }

  static std::string sourceName() { return "source_0"; }
  std::string targetName() const { return from_target.empty() ? "top" : "target_0"; }

  MotionSpan span;
  std::vector<QuadEdge> from_source;
  std::vector<QuadEdge> from_target;
  std::vector<Eigen::Vector3f> points;  ///< of the link, each the centre of a ball
  double radius = 0;                    ///< of the balls; 0: the points alone
  BoundedLink link;

 private:
  static constexpr std::int64_t kBegin = 1700000000000000000;

  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

  template <class Add>
  void sendChain(const std::vector<QuadEdge>& edges, const std::string& name, Add add) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const std::string parent = i + 1 == edges.size() ? "top" : name + "_" + std::to_string(i + 1);
      std::vector<QuadEdge::Sample> order = edges[i].samples;
      if (order.size() > 3 && pick(2) == 0) std::swap(order[1], order[2]);  // one is late
      for (const QuadEdge::Sample& sample : order)
        add(parent, name + "_" + std::to_string(i), sample, edges[i].samples.size() == 1);
    }
  }

  std::vector<QuadEdge::Sample> samples() {
    const auto kind = static_cast<EdgeKind>(pick(kEdgeKinds));
    Tf2Pose pose = poseOf(Eigen::Quaterniond(random_.rotation()), random_.vector(reach_));
    if (kind == EdgeKind::kStatic) return {{0, pose}};
    const double period = 1e9 * std::max(random_.magnitude(-2.5, -0.5),
                                         static_cast<double>(span.end - span.begin) / 1e10);
    const double size = random_.magnitude(-3, 0);
    std::vector<QuadEdge::Sample> result;
    auto stamp = span.begin - static_cast<std::int64_t>(random_.uniform(0, period));
    if (pick(10) == 0) stamp = span.begin;
    while (result.empty() || result.back().stamp < span.end) {
      result.push_back({stamp, pose});
      stamp += 1 + static_cast<std::int64_t>(period * random_.uniform(0.8, 1.2));
      pose = next(kind, pose, size);
    }
    if (pick(5) == 0 && result.size() > 2) {
      const std::int64_t last_before = result[result.size() - 2].stamp;
      if (last_before > span.begin) span.end = last_before;
    }
    return result;
  }

  Tf2Pose next(EdgeKind kind, const Tf2Pose& pose, double size) {
    const tf2::Quaternion q = pose.rotation();
    Eigen::Quaterniond turn(q.w(), q.x(), q.y(), q.z());
    const tf2::Vector3 t = pose.translation();
    const Eigen::Vector3d place(t.x(), t.y(), t.z());
    const Eigen::Vector3d axis = random_.vector(1).normalized();
    const auto turned_by = [&](double angle) {
      return poseOf(turn.normalized() * Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)),
                    place + random_.vector(size / 10));
    };
    switch (kind) {
      case EdgeKind::kSlow:
        return turned_by(random_.uniform(0, size / 5));
      case EdgeKind::kFast:
        return turned_by(random_.uniform(0, 179 * M_PI / 180));
      case EdgeKind::kHalfTurns:
        return poseOf(turn * Eigen::Quaterniond(0, axis.x(), axis.y(), axis.z()), place);
      case EdgeKind::kOpposite:
        turn.coeffs() *= -1;
        return poseOf(turn, place + random_.vector(size));
      case EdgeKind::kShifting:
        return poseOf(turn, place + random_.vector(size));
      case EdgeKind::kHair:
        return turned_by(random_.magnitude(-9, -6));
      default:
        return pose;
    }
  }

  /// tf2 accepts squared lengths from 0.99 to 1.01.
  Tf2Pose poseOf(Eigen::Quaterniond turn, const Eigen::Vector3d& place) {
    if (is_sloppy_) turn.coeffs() *= std::sqrt(random_.uniform(0.9905, 1.0095)) / turn.norm();
    return {{turn.x(), turn.y(), turn.z(), turn.w()}, {place.x(), place.y(), place.z()}};
  }

  /// Half of them have a round end, some are long.
  void makeLink() {
    points = random_.points(static_cast<std::size_t>(1 + pick(8)), random_.magnitude(-2, 0.3));
    Shape shape;
    shape.points = std::make_shared<const PointSet>(points);
    if (pick(2) == 0) {
      shape.solid = Solid::kEllipsoid;
      radius = std::ldexp(random_.uniform(0, 1), -3);
      shape.size = Eigen::Vector3d::Constant(2 * radius);
    }
    link = {"link", {shape}, 0, ""};
  }

  brute_force::Random random_;
  bool is_sloppy_;
  double reach_;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The time of the boxes of a motion: 50 links in five arms of ten joints, transforms at 100 Hz. For
// comparison, the time of sampling: the boxes at the stamps of the transforms, which are no proof.
#include "bench/common/benchmarks.h"
#include "bench/common/table.h"
#include "bench/common/timing.h"
#include "testing/live_boxes_testing.h"
#include "world/history/swept_box.h"

namespace link_bounds::bench {
namespace {

constexpr std::size_t kArms = 5;
constexpr std::size_t kJoints = 10;        // of an arm
constexpr double kPeriod = 0.01;           // s
constexpr double kHistory = 10.2;          // s
constexpr double kStart = 1700000000;      // s
constexpr double kRadiansPerSecond = 1;    // of each joint, at most
constexpr double kSpans[] = {0.1, 1, 10};  // s

std::string frameOf(std::size_t arm, std::size_t joint) {
  return joint == 0 ? "base" : "arm_" + std::to_string(arm) + "_" + std::to_string(joint);
}

class Arms {
 public:
  Arms() {
    for (double time = 0; time < kHistory; time += kPeriod)
      send(time);
    for (std::size_t i = 0; i < kArms * kJoints; ++i) {
      const std::string name = frameOf(i / kJoints, i % kJoints + 1);
      links_.push_back(meshLink(name, i + 1));
      frames_.push_back(tf_.frame(name));
    }
    base_ = tf_.frame("base");
    end_ = tf_.newest(frames_.front());
  }

  void sweepAll(double span) const {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const MotionSpan times{end_ - nanoseconds(span), end_};
      if (!sweptBox(tf_, base_, frames_[i], times, links_[i], 0).box)
        throw std::runtime_error("no swept box of " + links_[i].name);
    }
  }

  void sampleAll(double span) const {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      Aabb hull;
      for (std::int64_t stamp = end_ - nanoseconds(span); stamp <= end_;
           stamp += nanoseconds(kPeriod))
        hull.extend(*linkBox(links_[i], MatrixPose(*tf_.pose(base_, frames_[i], stamp)).affine));
    }
  }

 private:
  static std::int64_t nanoseconds(double seconds) {
    return static_cast<std::int64_t>(std::llround(seconds * 1e9));
  }

  void send(double time) {
    std::vector<geometry_msgs::TransformStamped> transforms;
    for (std::size_t arm = 0; arm < kArms; ++arm) {
      for (std::size_t joint = 1; joint <= kJoints; ++joint) {
        const double angle = std::sin(kRadiansPerSecond * time + static_cast<double>(arm + joint));
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(static_cast<int>(joint % 3));
        transforms.push_back(edge(frameOf(arm, joint - 1), frameOf(arm, joint), kStart + time,
                                  Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)),
                                  {0, 0, 0.15}));
      }
    }
    tf_.add({transforms.begin(), transforms.end()}, false, ros::Time(1));
  }

  TransformBuffer tf_;
  TransformBuffer::Frame base_ = 0;
  std::vector<TransformBuffer::Frame> frames_;
  std::vector<BoundedLink> links_;
  std::int64_t end_ = 0;
};

Row measure(const Arms& arms, double span, bool quick) {
  const int repetitions = quick || span > 1 ? 5 : 50;
  const double swept = medianTime<std::milli>(repetitions, [&] { arms.sweepAll(span); });
  return {{"span", span},
          {"swept_ms", swept},
          {"swept_us_per_link", swept * 1e3 / (kArms * kJoints)},
          {"sampled_ms", medianTime<std::milli>(repetitions, [&] { arms.sampleAll(span); })}};
}

}  // namespace

Rows benchmarkSwept(bool quick) {
  const Arms arms;
  const Table table("50 links, 100 Hz", {{"span", "span [s]"},
                                         {"swept_ms", "swept boxes [ms]"},
                                         {"swept_us_per_link", "per link [us]"},
                                         {"sampled_ms", "boxes at the stamps alone [ms]"}});
  Rows rows;
  for (const double span : kSpans)
    table.add(rows.emplace_back(measure(arms, span, quick)));
  return rows;
}

}  // namespace link_bounds::bench

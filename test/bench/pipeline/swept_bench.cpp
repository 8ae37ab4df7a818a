// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The time of the boxes of a motion: 50 links in five arms of ten joints, transforms at 100 Hz. For
// comparison, the time of sampling: the boxes at the stamps of the transforms, which are no proof.
#include <algorithm>
#include <iomanip>
#include <iostream>

#include "bench/common/benchmark_main.h"
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

struct Row {
  double span;
  double swept_ms;    ///< all links, median
  double sampled_ms;  ///< likewise
};

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

void print(const std::vector<Row>& rows) {
  std::cout << "50 links, 100 Hz\n\n| span [s] | swept boxes [ms] | per link [us] | boxes at the "
               "stamps alone [ms] |\n|---:|---:|---:|---:|\n"
            << std::setprecision(3);
  for (const Row& row : rows) {
    std::cout << "| " << row.span << " | " << row.swept_ms << " | "
              << row.swept_ms * 1e3 / (kArms * kJoints) << " | " << row.sampled_ms << " |\n";
  }
}

void write(const std::vector<Row>& rows, std::ostream& json) {
  json << "[";
  for (const Row& row : rows) {
    json << (&row == &rows.front() ? "" : ",") << "\n  {\"span\": " << row.span
         << ", \"swept_ms\": " << row.swept_ms << ", \"sampled_ms\": " << row.sampled_ms << "}";
  }
  json << "\n]\n";
}

void measure(bool quick, std::ostream* json) {
  const Arms arms;
  std::vector<Row> rows;
  for (const double span : kSpans) {
    const int repetitions = quick || span > 1 ? 5 : 50;
    rows.push_back({span, medianTime<std::milli>(repetitions, [&] { arms.sweepAll(span); }),
                    medianTime<std::milli>(repetitions, [&] { arms.sampleAll(span); })});
  }
  print(rows);
  if (json) write(rows, *json);
}

}  // namespace
}  // namespace link_bounds::bench

int main(int argc, char** argv) {
  return link_bounds::bench::runBenchmark(argc, argv, link_bounds::bench::measure);
}

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A random recording of frames that carry links and markers near each other. Each frame rests,
// drifts, jumps or pauses for a while, at a rate and a delay of its own; the recorder may stall.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "link_bounds/ros/messages.h"
#include "testing/live_boxes_testing.h"
#include "testing/marker_testing.h"

namespace link_bounds {

/// What is recorded together: transforms, or a marker if there are none.
struct CarrierMessage {
  std::int64_t time = 0;  ///< of the recording [ns]
  std::vector<geometry_msgs::TransformStamped> transforms;
  bool is_static = false;
  visualization_msgs::Marker marker;
};

class RandomCarriers {
 public:
  static constexpr int kArms = 4;
  static constexpr int kMarkers = 4;
  static std::string armName(int i) { return "arm_" + std::to_string(i); }

  /// Pauses last about `pause` [s]; frames are in a cube of half width `spread` [m]. Every other
  /// recording has transforms that are late.
  RandomCarriers(std::uint64_t seed, double pause, double spread)
      : random_(seed),
        pause_(pause),
        spread_(spread),
        has_late_(seed % 2 == 0),
        markers_(kMarkers) {
    addCarrier("base", "world");
    for (int i = 0; i < kArms; ++i) {
      const std::string parents[] = {"world", "base", i == 0 ? "base" : armName(i - 1)};
      addCarrier(armName(i), parents[pick(3)]);
    }
    carriers_.back().is_static = pick(3) == 0;
  }

  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }
  std::int64_t begin() const { return kBegin; }

  CarrierMessage next() {
    if (pick(400) == 0) jumpBack();
    if (pick(100) == 0) stalled_until_ = now_ + nanoseconds(1.5 * pause_);
    CarrierMessage message = pick(8) == 0 ? markerMessage() : transformMessage();
    message.time = now_ = std::max(now_ + 1, stalled_until_);
    return message;
  }

 private:
  enum class Manner { kRests, kDrifts, kJumps };
  static constexpr std::int64_t kBegin = 1'000'000'000'000;  // ns

  struct Carrier {
    std::string frame;
    std::string parent;
    bool is_static = false;
    double period = 0;       ///< [s]
    std::int64_t delay = 0;  ///< from the stamp to the recording [ns]
    std::int64_t due = 0;    ///< record time of the next transform [ns]
    std::int64_t last = 0;   ///< stamp [ns]
    Manner manner = Manner::kRests;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    Eigen::Vector3d drift = Eigen::Vector3d::Zero();  ///< to the next transform
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  };

  static std::int64_t nanoseconds(double seconds) { return std::llround(seconds * 1e9); }

  void addCarrier(const std::string& frame, const std::string& parent) {
    Carrier carrier;
    carrier.frame = frame;
    carrier.parent = parent;
    carrier.period = random_.uniform(0.04, 0.4) * pause_;
    carrier.delay = nanoseconds(0.05 * pick(3));
    carrier.due = kBegin + nanoseconds(random_.uniform(0, 0.2));
    carriers_.push_back(carrier);
  }

  void jumpBack() {
    const std::int64_t jump = nanoseconds(3);
    now_ -= jump;
    stalled_until_ = 0;
    for (Carrier& carrier : carriers_) {
      carrier.due = std::max(carrier.due - jump, now_);
      carrier.last = std::min(carrier.last, now_);
    }
  }

  CarrierMessage transformMessage() {
    CarrierMessage message;
    Carrier& carrier =
        *std::min_element(carriers_.begin(), carriers_.end(),
                          [](const Carrier& a, const Carrier& b) { return a.due < b.due; });
    now_ = std::max(now_, carrier.due);
    std::int64_t stamp = carrier.due - carrier.delay;
    const bool repeats = stamp < carrier.last || pick(20) == 0;
    if (repeats && carrier.last > 0) stamp = carrier.last;
    if (has_late_ && pick(20) == 0) stamp -= nanoseconds(random_.uniform(0, 0.3));
    message.is_static = carrier.is_static;
    message.transforms.push_back(moved(carrier, stamp));
    if (!carrier.is_static && pick(3) == 0) addOther(message, stamp);
    carrier.due += nanoseconds(carrier.period * random_.uniform(0.7, 1.3));
    if (pick(25) == 0) carrier.due += nanoseconds(pause_ * random_.uniform(0.5, 3));
    if (carrier.is_static) carrier.due += nanoseconds(1000);
    return message;
  }

  /// Of the same stamp.
  void addOther(CarrierMessage& message, std::int64_t stamp) {
    Carrier& other = carriers_[static_cast<std::size_t>(pick(kArms))];
    if (!other.is_static && stamp > other.last) message.transforms.push_back(moved(other, stamp));
  }

  geometry_msgs::TransformStamped moved(Carrier& carrier, std::int64_t stamp) {
    if (pick(6) == 0) {
      carrier.manner = static_cast<Manner>(pick(3));
      carrier.drift = random_.vector(spread_ / 10) - carrier.place / 10;
    }
    if (carrier.manner == Manner::kDrifts) {
      carrier.place += carrier.drift;
      turn(carrier, 0.1);
    } else if (carrier.manner == Manner::kJumps) {
      carrier.place = random_.vector(spread_);
      turn(carrier, 3);
    }
    carrier.last = stamp;
    auto transform = edge(carrier.parent, carrier.frame, 1, carrier.turn, carrier.place);
    transform.header.stamp.fromNSec(static_cast<std::uint64_t>(stamp));
    return transform;
  }

  void turn(Carrier& carrier, double max_angle) {
    const double angle = random_.uniform(0, max_angle);
    const Eigen::AngleAxisd turn(angle, random_.vector(1).normalized());
    carrier.turn = (carrier.turn * turn).normalized();
  }

  /// A marker comes, comes with another pose, becomes another body in the same box, or goes.
  CarrierMessage markerMessage() {
    CarrierMessage message;
    const auto id = static_cast<std::size_t>(pick(kMarkers));
    visualization_msgs::Marker& marker = markers_[id];
    const bool is_known = marker.ns == "object" && marker.action == visualization_msgs::Marker::ADD;
    if (is_known && pick(3) == 0) {
      marker.type = marker.type == visualization_msgs::Marker::CUBE
                        ? visualization_msgs::Marker::SPHERE
                        : visualization_msgs::Marker::CUBE;
    } else {
      marker = newMarker();
    }
    marker.id = static_cast<int>(id);
    message.marker = marker;
    return message;
  }

  visualization_msgs::Marker newMarker() {
    const double size = random_.uniform(0.1, 0.3);
    visualization_msgs::Marker marker = markerOf(
        pick(2) == 0 ? visualization_msgs::Marker::CUBE : visualization_msgs::Marker::SPHERE,
        {size, size, size});
    marker.ns = "object";
    marker.action = pick(5) == 0 ? visualization_msgs::Marker::DELETE : 0;
    const int frame = pick(kArms + 2);
    marker.header.frame_id = frame < kArms ? armName(frame) : frame == kArms ? "base" : "world";
    if (pick(2) == 0) {
      const std::int64_t stamp = now_ + nanoseconds(random_.uniform(-0.2, 0.2));
      marker.header.stamp.fromNSec(static_cast<std::uint64_t>(stamp));
    }
    if (pick(4) == 0) marker.lifetime = ros::Duration(random_.uniform(0.1, 1));
    marker.pose.position = toPoint(random_.vector(spread_ / 2));
    return marker;
  }

  brute_force::Random random_;
  double pause_;
  double spread_;
  bool has_late_;
  std::vector<Carrier> carriers_;
  std::vector<visualization_msgs::Marker> markers_;  ///< the last ones, by id
  std::int64_t now_ = kBegin;
  std::int64_t stalled_until_ = 0;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A random life of tf: several publishers, each with its own frames and rate, and what goes wrong.
#pragma once

#include <string>
#include <vector>

#include "testing/live_boxes_testing.h"

namespace link_bounds {

inline std::string frameName(int i) {
  return "frame_" + std::to_string(i);
}

/// What is sent together.
struct RandomMessage {
  std::vector<geometry_msgs::TransformStamped> transforms;
  bool is_static = false;
};

/// What else may go wrong.
enum class Oddity {
  kNone,
  kLoops,  ///< a new parent may be any other frame
  kUneven  ///< quaternions are a little longer or shorter than 1
};

/// Frame 0 is the root; every frame hangs on one of a lower number. Deep trees are chains with some
/// branches, others branch everywhere.
class RandomTf {
 public:
  static constexpr int kPublishers = 4;

  explicit RandomTf(std::uint64_t seed, Oddity oddity = Oddity::kNone)
      : random_(seed), oddity_(oddity), depth_(seed % 5 == 0 ? 100 : 12) {
    edges_.resize(static_cast<std::size_t>(depth_ + pick(20)) + 1);
    for (int i = 1; i < frames(); ++i) {
      edge(i).parent = i <= depth_ && pick(10) > 0 ? i - 1 : pick(i);
      edge(i).publisher = pick(kPublishers);
      edge(i).is_static = pick(6) == 0;
      edge(i).has_both = pick(30) == 0;
    }
  }

  int frames() const { return static_cast<int>(edges_.size()); }
  int depth() const { return depth_; }
  int pick(int count) { return static_cast<int>(random_.uniform(0, count - 1e-9)); }

  /// The next message of some publisher. Now and then: the same again, one from long ago, frames
  /// that get another parent, seconds of silence.
  RandomMessage next() {
    if (pick(60) == 0) now_ += 0.5 * pick(25);
    if (pick(15) == 0) return last_;
    now_ += 0.001 * (1 + pick(20));
    const int publisher = pick(2) * pick(kPublishers);
    const double age = pick(12) == 0 ? 0.1 * pick(115) : 0;
    RandomMessage message;
    message.is_static = pick(8) == 0;
    for (int i = 1; i < frames(); ++i) {
      const bool is_its_kind = edge(i).has_both || edge(i).is_static == message.is_static;
      if (!is_its_kind || (!message.is_static && edge(i).publisher != publisher)) continue;
      if (pick(100) == 0) edge(i).parent = newParent(i);
      if (pick(50) > 0) message.transforms.push_back(transformOf(i, now_ - lag(publisher) - age));
    }
    last_ = message;
    return message;
  }

 private:
  struct Edge {
    int parent = 0;
    int publisher = 0;
    bool is_static = false;
    bool has_both = false;  ///< a static and a dynamic publisher
  };

  Edge& edge(int i) { return edges_[static_cast<std::size_t>(i)]; }

  int newParent(int child) {
    if (oddity_ != Oddity::kLoops || pick(2) == 0) return pick(child);
    return (child + 1 + pick(frames() - 1)) % frames();
  }

  /// Publishers stamp with clocks that differ a little; the first two agree.
  static double lag(int publisher) { return 0.004 * (publisher / 2); }

  geometry_msgs::TransformStamped transformOf(int child, double stamp) {
    const Eigen::Vector3d axis(random_.uniform(-1, 1), random_.uniform(-1, 1), 1.5);
    Eigen::Quaterniond turn(Eigen::AngleAxisd(random_.uniform(-3, 3), axis.normalized()));
    if (oddity_ == Oddity::kUneven) turn.coeffs() *= random_.uniform(0.996, 1.004);
    return link_bounds::edge(frameName(edge(child).parent), frameName(child), stamp, turn,
                             random_.vector(1));
  }

  brute_force::Random random_;
  Oddity oddity_;
  int depth_;
  std::vector<Edge> edges_;  ///< by child
  RandomMessage last_;
  double now_ = 1700000000;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Methods that find the distance of two links. All get the same links and the same poses. Ours
// proves its lower bound and ends at the limit, the peers do neither; all may err by the accuracy.
#pragma once

#include <functional>
#include <memory>

#include "bench/distances/distance_robots.h"

namespace link_bounds::bench {

constexpr double kAccuracy = 1e-4;  // m

/// What a method says. A method without bounds says the same number twice.
struct MeasuredDistance {
  double lower;
  double upper;
};

class DistanceMethod {
 public:
  virtual ~DistanceMethod() = default;

  /// Converts the poses. Not timed.
  virtual void prepare(const LinkPoses& poses) = 0;

  /// Where bodies are placed only when a pair needs it: places all. Not timed.
  virtual void place() {}

  /// Whether the method knows these links.
  virtual bool has(std::size_t first, std::size_t second) const = 0;

  /// Timed.
  virtual MeasuredDistance distance(std::size_t first, std::size_t second) = 0;

  /// Timed. May rest on the last update.
  virtual MeasuredDistance follow(std::size_t first, std::size_t second) {
    return distance(first, second);
  }
};

struct DistanceSetting {
  std::string method;
  std::string level;  ///< "hull" or "mesh"; "mesh to 0.01": to that part of the distance
  std::function<std::unique_ptr<DistanceMethod>(const DistanceRobot& robot, double limit)> make;
};

void addOurDistances(std::vector<DistanceSetting>& settings);
/// Ours with a relative accuracy, too.
void addRoughDistances(std::vector<DistanceSetting>& settings);
void addFclDistances(std::vector<DistanceSetting>& settings);
void addBulletDistances(std::vector<DistanceSetting>& settings);

}  // namespace link_bounds::bench

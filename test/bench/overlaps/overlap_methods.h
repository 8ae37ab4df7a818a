// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Methods that find overlaps. All do the same job: every step changes every box, and the method
// returns all pairs of boxes that overlap or touch (margin 0), each with its distance in double
// precision, computed by the same function. Our pairs are sorted, those of the peers are not.
//
// A peer lives as long as its scene, so it may use what it knows from earlier steps. It gets the
// boxes in its own format before the clock starts. Several settings from its documentation compete;
// the fastest one in a scene counts.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/overlaps/overlap_scenes.h"
#include "link_bounds/geometry/pairs/sweep_and_prune.h"

namespace link_bounds::bench {

constexpr double kOverlapMargin = 0;

class OverlapMethod {
 public:
  virtual ~OverlapMethod() = default;

  /// May convert the boxes of the next step. Not timed.
  virtual void prepare(const SceneBoxes&) {}

  /// Fills `pairs`. Timed.
  virtual void step(const SceneBoxes& boxes) = 0;

  std::vector<BoxPair> pairs;

 protected:
  void addIfNear(std::size_t a, std::size_t b, const SceneBoxes& boxes) {
    const double distance = signedDistance(boxes[a], boxes[b]);
    if (distance <= kOverlapMargin) pairs.push_back({std::min(a, b), std::max(a, b), distance});
  }
};

/// One setting of a method.
struct OverlapSetting {
  std::string method;
  std::string setting;
  std::function<std::unique_ptr<OverlapMethod>(const SceneBoxes& first)> make;
};

void addOurOverlaps(std::vector<OverlapSetting>& settings);
void addFclOverlaps(std::vector<OverlapSetting>& settings);
void addBulletOverlaps(std::vector<OverlapSetting>& settings);

}  // namespace link_bounds::bench

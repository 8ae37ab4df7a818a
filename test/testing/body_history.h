// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A body of a recording with all that was ever known of its motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "link_bounds/geometry/distance/body_distance.h"
#include "world/history/swept_box.h"
#include "world/moment/moment.h"

namespace link_bounds {

struct BodyHistory {
  /// Stamps are in nanoseconds.
  struct Entry {
    int step;
    std::int64_t stamp;  ///< 0: it does not move
  };

  Body body;
  std::optional<std::string> frame;  ///< that it follows
  std::int64_t placed = 0;           ///< stamp; 0: it was not placed once
  double radius = 0;                 ///< about the origin of its pose [m]
  std::int64_t timeout = 0;          ///< between two stamps of a motion
  std::vector<Entry> entries;        ///< one for each step with a box

  void add(const Moment& moment, const Moment::Body& seen, int step) {
    const bool follows = !seen.object || seen.object->follows();
    if (entries.empty()) describe(*moment.model, seen, follows);
    entries.push_back({step, follows ? seen.stamp : 0});
  }

  bool isStatic() const { return entries.back().stamp == 0; }

  bool isMotion(const Entry& from, const Entry& to) const {
    const std::int64_t passed = to.stamp - from.stamp;
    return passed >= 0 && passed <= timeout;
  }

  /// The motion that became known in the step.
  std::optional<MotionSpan> motionIn(int step) const {
    if (entries.size() < 2 || entries.back().step != step) return std::nullopt;
    const Entry& from = entries[entries.size() - 2];
    const Entry& to = entries.back();
    if (from.stamp == to.stamp || !isMotion(from, to)) return std::nullopt;
    return MotionSpan{from.stamp, to.stamp};
  }

  /// The motions that end in the step and are not yet compared with `other`: all, where that one
  /// was placed in the step.
  std::optional<MotionSpan> motionBeside(const BodyHistory& other, int step) const {
    if (other.placed == 0 || other.entries.front().step != step) return motionIn(step);
    return MotionSpan{std::max(other.placed, since(entries.size() - 1)), entries.back().stamp};
  }

  /// Whether a motion up to the step covers the stamp. Its begin is that of a moment.
  bool isKnownAt(std::int64_t stamp, int step) const {
    if (isStatic()) return entries.front().step < step || (placed != 0 && placed < stamp);
    for (std::size_t i = entries.size() - 1; i > 0 && entries[i].stamp >= stamp; --i) {
      if (!isMotion(entries[i - 1], entries[i])) return false;
      if (entries[i - 1].stamp < stamp) return true;
    }
    return false;
  }

  /// The entry of the last step before this one, in which the body was.
  std::size_t entryBefore(int step) const {
    return entries.size() - (entries.back().step == step ? 2 : 1);
  }

  /// Whether a motion leads from there to this step.
  bool goesOnIn(int step) const {
    return entries.back().step == step && isMotion(entries[entryBefore(step)], entries.back());
  }

  /// The first stamp of the motions that lead to this entry.
  std::int64_t since(std::size_t entry) const {
    while (entry > 0 && isMotion(entries[entry - 1], entries[entry]))
      --entry;
    return entries[entry].stamp;
  }

 private:
  void describe(const Model& model, const Moment::Body& seen, bool follows) {
    const BoundedLink& bounded = seen.link ? model.links[*seen.link] : seen.object->bounded;
    for (const Shape& shape : bounded.shapes)
      body.shapes.push_back({shape});
    if (!follows) placed = seen.stamp;
    if (follows) frame = seen.link ? model.frames[*seen.link] : seen.object->frame;
    radius = radiusOf(bounded);
    const double seconds = model.parameters.timeout;
    timeout = seconds > 0 ? std::llround(seconds * 1e9) : std::numeric_limits<std::int64_t>::max();
  }
};

}  // namespace link_bounds

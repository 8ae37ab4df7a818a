// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks at the path that there is now.
#include "world/history/pose_gap.h"

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

namespace link_bounds {
namespace {

using Frame = TransformBuffer::Frame;

/// The frame and those above it by the newest parents, up to the top or to a loop.
std::vector<Frame> wayUp(const TransformBuffer& tf, Frame frame) {
  std::vector<Frame> way{frame};
  while (way.size() <= tf.size() && tf.hasParent(way.back()))
    way.push_back(tf.parent(way.back()));
  return way;
}

/// The frames whose edges lead from one frame to the other; nothing if the two are not connected.
std::optional<std::vector<Frame>> path(const TransformBuffer& tf, Frame target, Frame source) {
  std::vector<Frame> up = wayUp(tf, source);
  std::vector<Frame> down = wayUp(tf, target);
  const std::set<Frame> above(down.begin(), down.end());
  const auto meeting =
      std::find_if(up.begin(), up.end(), [&](Frame frame) { return above.count(frame) > 0; });
  if (meeting == up.end()) return std::nullopt;
  down.erase(std::find(down.begin(), down.end(), *meeting), down.end());
  up.erase(meeting, up.end());
  up.insert(up.end(), down.begin(), down.end());
  return up;
}

Frame staticTop(const TransformBuffer& tf, Frame frame) {
  for (std::size_t i = 0; i < tf.size() && tf.isStatic(frame) && tf.hasParent(frame); ++i)
    frame = tf.parent(frame);
  return frame;
}

}  // namespace

std::string whyNoPose(const TfExcerpt& excerpt, Frame target, Frame source, std::int64_t stamp) {
  const TransformBuffer& tf = excerpt.buffer();
  const std::string text =
      "no transform from \"" + tf.name(source) + "\" to \"" + tf.name(target) + "\"";
  const auto frames = path(tf, target, source);
  if (!frames) return text;
  std::int64_t oldest = 0;
  std::int64_t newest = std::numeric_limits<std::int64_t>::max();
  for (const Frame frame : *frames) {
    if (tf.isStatic(frame)) continue;
    oldest = std::max(oldest, excerpt.oldest(frame));
    newest = std::min(newest, tf.newest(frame));
  }
  const std::string at = text + " at " + secondsText(stamp);
  if (oldest > newest) return at + "; tf has no time at which it knows all of that path";
  if (stamp >= oldest && stamp <= newest) return at + "; the frames had other parents then";
  return at + "; tf's history of that path reaches from " + secondsText(oldest) + " to " +
         secondsText(newest);
}

bool isStaticPath(const TransformBuffer& tf, Frame target, Frame source) {
  return staticTop(tf, target) == staticTop(tf, source);
}

std::string secondsText(std::int64_t nanoseconds) {
  constexpr std::int64_t kSecond = 1000000000;
  std::string fraction = std::to_string(kSecond + nanoseconds % kSecond).substr(1);
  fraction.erase(std::max<std::size_t>(fraction.find_last_not_of('0') + 1, 1));
  return std::to_string(nanoseconds / kSecond) + "." + fraction;
}

}  // namespace link_bounds

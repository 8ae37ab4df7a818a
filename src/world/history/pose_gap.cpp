// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks at the path between the frames according to their present parents.
#include "world/history/pose_gap.h"

#include <algorithm>
#include <limits>

#include "world/tf/frame_paths.h"

namespace link_bounds {
namespace {

using Frame = TransformBuffer::Frame;

Frame staticTop(const TransformBuffer& tf, Frame frame) {
  return climb(tf, frame, [&](Frame at) { return !tf.isStatic(at); });
}

}  // namespace

std::string whyNoPose(const TfExcerpt& excerpt, Frame target, Frame source, std::int64_t stamp) {
  const TransformBuffer& tf = excerpt.buffer();
  const std::string text =
      "no transform from \"" + tf.name(source) + "\" to \"" + tf.name(target) + "\"";
  std::int64_t oldest = 0;
  std::int64_t newest = std::numeric_limits<std::int64_t>::max();
  for (const Frame frame : edgesBetween(tf, target, source)) {
    if (!tf.hasParent(frame)) return text;
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
  std::string fraction = std::to_string(kSecond + std::abs(nanoseconds % kSecond)).substr(1);
  fraction.erase(std::max<std::size_t>(fraction.find_last_not_of('0') + 1, 1));
  const std::string sign = nanoseconds < 0 ? "-" : "";
  return sign + std::to_string(std::abs(nanoseconds / kSecond)) + "." + fraction;
}

}  // namespace link_bounds

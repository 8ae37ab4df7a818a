// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Its memory grows with the number of publishers, not of frames.
#include "world/tf/late_publishers.h"

namespace link_bounds {
namespace {

const ros::WallDuration kMemory(5.0);

}  // namespace

void LatePublishers::add(const std::string& publisher, std::string_view frame, double behind,
                         ros::SteadyTime now) {
  publishers_[publisher] = {std::string(frame), behind, now};
}

LatePublishers::Texts LatePublishers::take(ros::SteadyTime now) {
  Texts texts;
  for (auto entry = publishers_.begin(); entry != publishers_.end();) {
    const auto& [publisher, lateness] = *entry;
    if (now - lateness.time > kMemory) {
      entry = publishers_.erase(entry);
      continue;
    }
    texts[publisher] =
        "by " + std::to_string(lateness.behind) + " s (frame " + lateness.frame + ")";
    ++entry;
  }
  return texts;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/bodies/object_clock.h"

#include <algorithm>

#include "world/tf/nanoseconds.h"

namespace link_bounds {
namespace {

/// A stamp that is ahead of the clock by max this [ns] is put down to a clock that differs a
/// little.
constexpr std::int64_t kFarAhead = 500'000'000;

/// In ns; 0 means for ever.
std::int64_t lifetime(const LiveObject& object) {
  return std::max<std::int64_t>(object.lifetime.toNSec(), 0);
}

/// The part of the lifetime that has passed [ns]; for a neighbour, the time since its last message.
std::int64_t elapsed(const LiveObject& object, std::int64_t now) {
  const std::int64_t age = now - object.received;
  return object.content->is_neighbour ? age : std::min(age, lifetime(object));
}

}  // namespace

std::int64_t ObjectClock::observe(ros::Time now) {
  last_now_ = std::max(last_now_, nanosecondsOf(now));
  return nanosecondsOf(now);
}

std::int64_t ObjectClock::restart(ros::Time now) {
  newest_now_ = std::max(newest_now_, last_now_);
  start_ = last_now_ = nanosecondsOf(now);
  return last_now_;
}

std::int64_t ObjectClock::receivedAfterJump(const LiveObject& object, ros::Time now) const {
  return nanosecondsOf(now) - elapsed(object, last_now_);
}

bool ObjectClock::isSinceJump(const ObjectContent& content, std::int64_t now) const {
  return content.stamp >= start_ && content.stamp <= now + kFarAhead;
}

std::int64_t ObjectClock::stampOf(const ObjectContent& content, std::int64_t now) const {
  const bool is_late = content.stamp > now + kFarAhead && content.stamp <= newest_now_;
  return is_late ? now : content.stamp;
}

bool hasExpired(const LiveObject& object, std::int64_t now) {
  return lifetime(object) > 0 && elapsed(object, now) == lifetime(object);
}

}  // namespace link_bounds

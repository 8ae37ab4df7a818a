// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names and reasons come from the network, so they are shortened and sanitised.
#include "world/log/refusal_log.h"

#include <iterator>

#include "world/log/log_text.h"

namespace link_bounds {
namespace {

const ros::WallDuration kQuietTime(10.0);
constexpr std::size_t kMaxNames = 10;       // per kQuietTime; then one line for all others
constexpr std::size_t kMaxNameLength = 80;  // bytes

std::string shown(const std::string& name) {
  return '"' + logText(name.substr(0, kMaxNameLength)) + '"' +
         (name.size() > kMaxNameLength ? " (shortened)" : "");
}

}  // namespace

std::optional<std::string> RefusalLog::line(const std::string& name, const std::string& reason,
                                            const std::string& publisher, ros::SteadyTime now) {
  if (isQuiet(name, now)) return std::nullopt;
  if (reported_.size() >= kMaxNames) {
    others_time_ = now;
    return others_ + " are " + state_;
  }
  reported_[name] = now;
  return what_ + " " + shown(name) + " from " + shown(publisher) + " is " + state_ + ": " +
         logText(reason);
}

bool RefusalLog::isQuiet(std::string_view name, ros::SteadyTime now) {
  for (auto entry = reported_.begin(); entry != reported_.end();)
    entry = now - entry->second >= kQuietTime ? reported_.erase(entry) : std::next(entry);
  if (reported_.count(name) > 0) return true;
  return reported_.size() >= kMaxNames && !others_time_.isZero() && now - others_time_ < kQuietTime;
}

void RefusalLog::forget() {
  reported_.clear();
  others_time_ = {};
}

}  // namespace link_bounds

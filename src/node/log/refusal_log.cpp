// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names and reasons come from the network, so they are shortened and sanitised.
#include "node/log/refusal_log.h"

#include "node/log/log_text.h"

namespace link_bounds {
namespace {

const ros::WallDuration kPeriod(10.0);
constexpr std::size_t kMaxNames = 10;       // in a period: then one line for all others
constexpr std::size_t kMaxNameLength = 80;  // bytes

std::string shown(const std::string& name) {
  return '"' + logText(name.substr(0, kMaxNameLength)) + '"' +
         (name.size() > kMaxNameLength ? " (shortened)" : "");
}

}  // namespace

std::optional<std::string> RefusalLog::line(const std::string& name, const std::string& reason,
                                            const std::string& publisher, ros::SteadyTime now) {
  if (now - begin_ > kPeriod) {
    reported_.clear();
    begin_ = now;
  }
  if (reported_.size() > kMaxNames || !reported_.insert(name).second) return std::nullopt;
  if (reported_.size() > kMaxNames) return others_ + " are refused";
  return what_ + " " + shown(name) + " from " + shown(publisher) +
         " is refused: " + logText(reason);
}

}  // namespace link_bounds

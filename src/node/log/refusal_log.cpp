// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Names and reasons come from the network: they are shortened, and nothing in them acts on the log.
#include "node/log/refusal_log.h"

#include "node/log/log_text.h"

namespace link_bounds {
namespace {

const ros::WallDuration kPeriod(10.0);
constexpr std::size_t kMostNames = 10;
constexpr std::size_t kLongestName = 80;

std::string shown(const std::string& name) {
  return '"' + logText(name.substr(0, kLongestName)) + '"' +
         (name.size() > kLongestName ? " (shortened)" : "");
}

}  // namespace

std::optional<std::string> RefusalLog::line(const std::string& name, const std::string& reason,
                                            const std::string& publisher, ros::SteadyTime now) {
  if (now - begin_ > kPeriod) {
    told_.clear();
    begin_ = now;
  }
  if (told_.size() > kMostNames || !told_.insert(name).second) return std::nullopt;
  if (told_.size() > kMostNames) return others_ + " are refused";
  return what_ + " " + shown(name) + " from " + shown(publisher) +
         " is refused: " + logText(reason);
}

}  // namespace link_bounds

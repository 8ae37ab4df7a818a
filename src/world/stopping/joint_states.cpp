// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// As much history as tf has.
#include "world/stopping/joint_states.h"

#include <cmath>
#include <utility>

#include "world/tf/edge_history.h"

namespace link_bounds {

void JointStates::add(const std::string& joint, const JointReport& report) {
  if (report.stamp <= 0 || !std::isfinite(report.position)) return;
  if (joints_.size() >= kMaxJoints && joints_.count(joint) == 0) return;
  std::map<std::int64_t, JointReport>& reports = joints_[joint];
  const std::int64_t length = EdgeHistory::kLength;
  if (!reports.empty() && reports.rbegin()->first - length > report.stamp) reports.clear();
  JointReport& kept = reports[report.stamp] = report;
  if (kept.velocity && !std::isfinite(*kept.velocity)) kept.velocity.reset();
  reports.erase(reports.begin(), reports.lower_bound(reports.rbegin()->first - length));
}

void JointStates::clear() {
  joints_.clear();
}

void JointStates::observeEpoch(std::uint64_t epoch) {
  if (std::exchange(epoch_, epoch) != epoch) clear();
}

std::optional<std::vector<JointReport>> JointStates::reports(const std::string& joint,
                                                             std::int64_t stamp,
                                                             std::int64_t window) const {
  const auto found = joints_.find(joint);
  if (found == joints_.end()) return std::nullopt;
  std::vector<JointReport> result;
  for (auto next = found->second.lower_bound(stamp - window); next != found->second.end(); ++next) {
    result.push_back(next->second);
    if (next->first >= stamp) break;
  }
  return result;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/stopping/joint_states.h"

#include <cmath>
#include <iterator>
#include <utility>

#include "world/tf/edge_history.h"

namespace link_bounds {

void JointStates::add(const std::string& joint, const JointReport& report) {
  if (report.stamp <= 0 || !std::isfinite(report.position)) return;
  if (joints_.size() >= kMaxJoints && joints_.count(joint) == 0) return;
  JointReport kept = report;
  if (kept.velocity && !(std::abs(*kept.velocity) <= kMaxVelocity)) kept.velocity.reset();
  History& history = joints_[joint];
  const std::int64_t newest = history.reports.empty() ? 0 : history.reports.rbegin()->first;
  if (kept.stamp >= newest - EdgeHistory::kLength) {
    history.old.clear();
    keep(kept, history.reports);
    return;
  }
  keep(kept, history.old);
  if (history.old.size() >= kJump) history.reports = std::exchange(history.old, {});
}

void JointStates::keep(const JointReport& report, Reports& reports) {
  reports[report.stamp] = report;
  const std::int64_t oldest = reports.rbegin()->first - EdgeHistory::kLength;
  reports.erase(reports.begin(), reports.lower_bound(oldest));
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
  const Reports& all = found->second.reports;
  std::vector<JointReport> result;
  for (auto next = all.lower_bound(stamp - window); next != all.end(); ++next) {
    result.push_back(next->second);
    if (next->first >= stamp) break;
  }
  return result;
}

std::optional<JointReport> JointStates::lastBefore(const std::string& joint,
                                                   std::int64_t stamp) const {
  constexpr std::int64_t kLongest = 1'000'000'000;  // ns
  const auto found = joints_.find(joint);
  if (found == joints_.end()) return std::nullopt;
  const auto next = found->second.reports.lower_bound(stamp);
  if (next == found->second.reports.begin()) return std::nullopt;
  const JointReport& last = std::prev(next)->second;
  return stamp - last.stamp <= kLongest ? std::optional(last) : std::nullopt;
}

}  // namespace link_bounds

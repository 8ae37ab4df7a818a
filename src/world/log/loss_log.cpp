// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Uses the steady clock, because ROS time stands still while /clock is missing.
#include "world/log/loss_log.h"

namespace link_bounds {
namespace {

const ros::WallDuration kReportAfter(5.0);

}  // namespace

std::vector<std::size_t> LossLog::due(const std::vector<std::string>& lost, ros::SteadyTime now) {
  observe(lost, now);
  std::vector<std::size_t> result;
  if (!last_report_.isZero() && now - last_report_ < kReportAfter) return result;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    Loss& loss = losses_.at(lost[i]);
    if (loss.is_reported || now - loss.since < kReportAfter) continue;
    loss.is_reported = true;
    last_report_ = now;
    result.push_back(i);
  }
  return result;
}

void LossLog::postpone(const std::vector<std::string>& lost, ros::SteadyTime now) {
  observe(lost, now);
  for (auto& [name, loss] : losses_)
    loss.since = now;
}

/// Keeps losses that continue, adds new ones, and forgets those that have ended.
void LossLog::observe(const std::vector<std::string>& lost, ros::SteadyTime now) {
  for (auto& [name, loss] : losses_)
    loss.is_current = false;
  for (const std::string& name : lost)
    losses_.try_emplace(name, Loss{now}).first->second.is_current = true;
  for (auto loss = losses_.begin(); loss != losses_.end();)
    loss = loss->second.is_current ? std::next(loss) : losses_.erase(loss);
}

}  // namespace link_bounds

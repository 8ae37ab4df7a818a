// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Recent values of joints from /joint_states.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace link_bounds {

/// The value of a joint at a time [ns].
struct JointReport {
  std::int64_t stamp;
  double position;                 ///< [rad or m]
  std::optional<double> velocity;  ///< [rad/s or m/s], if it was sent
};

/// Keeps the last ten seconds of each joint. Messages may come in any order.
class JointStates {
 public:
  /// Ignores reports without a stamp or a finite position, velocities beyond kMaxVelocity, and more
  /// joints than kMaxJoints. Also ignores a stamp more than ten seconds before the newest one of
  /// the joint: it is a fault, or from a second publisher. But kJump such stamps in a row mean that
  /// time jumped back; then only they are kept for this joint. Other joints keep their reports: the
  /// clock of their publisher may be right.
  void add(const std::string& joint, const JointReport& report);

  void clear();

  /// Forgets all if `epoch`, from TransformBuffer::epoch(), has changed since the last call: then
  /// the clock has jumped back.
  void observeEpoch(std::uint64_t epoch);

  /// The reports of a joint from `window` before `stamp` [ns] to the first one at or after `stamp`,
  /// in order. Nothing for a joint that was never reported.
  std::optional<std::vector<JointReport>> reports(const std::string& joint, std::int64_t stamp,
                                                  std::int64_t window) const;

  /// The last report before that stamp, if it is at most a second older.
  std::optional<JointReport> lastBefore(const std::string& joint, std::int64_t stamp) const;

  /// Sums of velocities up to this are finite [rad/s or m/s].
  static constexpr double kMaxVelocity = 1e100;

  /// Bounds the memory if a publisher keeps inventing names.
  static constexpr std::size_t kMaxJoints = 10'000;

 private:
  using Reports = std::map<std::int64_t, JointReport>;  ///< by stamp

  struct History {
    Reports reports;
    Reports old;  ///< stamps too old for `reports`, since the last one that was not
  };

  static constexpr std::size_t kJump = 10;

  static void keep(const JointReport& report, Reports& reports);

  std::map<std::string, History> joints_;
  std::uint64_t epoch_ = 0;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The reports of joints in /joint_states.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace link_bounds {

/// The position and velocity of a joint at a time [ns].
struct JointReport {
  std::int64_t stamp;
  double position;                 ///< [rad or m]
  std::optional<double> velocity;  ///< [rad/s or m/s], if it was sent
};

/// Messages may come in any order.
class JointStates {
 public:
  /// Ignores reports without a stamp or a finite position, velocities that are not finite or beyond
  /// kMaxVelocity, and new joints beyond kMaxJoints. Ignores stamps more than 10 s before the
  /// newest one of the joint, which are a fault or of a second publisher. After kJump of these in a
  /// row, time has jumped back: then it forgets all other reports of this joint. It keeps those of
  /// other joints, whose publisher's clock may be right.
  void add(const std::string& joint, const JointReport& report);

  void clear();

  /// Forgets all reports if the epoch of tf has changed since the last call: the clock has jumped.
  void observeEpoch(std::uint64_t epoch);

  /// The reports of a joint from `window` [ns] before `stamp` to the first one at or after `stamp`,
  /// in order. Nothing for a joint that was never reported.
  std::optional<std::vector<JointReport>> reports(const std::string& joint, std::int64_t stamp,
                                                  std::int64_t window) const;

  /// The last report before that stamp, if it is at most a second older.
  std::optional<JointReport> lastBefore(const std::string& joint, std::int64_t stamp) const;

  /// Keeps sums of velocities finite [rad/s or m/s].
  static constexpr double kMaxVelocity = 1e100;

  /// A publisher may invent names without end.
  static constexpr std::size_t kMaxJoints = 10'000;

 private:
  using Reports = std::map<std::int64_t, JointReport>;  ///< by stamp

  struct History {
    Reports reports;
    Reports old;  ///< the latest reports, in a row, whose stamps are too old for `reports`
  };

  static constexpr std::size_t kJump = 10;

  static void keep(const JointReport& report, Reports& reports);

  std::map<std::string, History> joints_;
  std::uint64_t epoch_ = 0;
};

}  // namespace link_bounds

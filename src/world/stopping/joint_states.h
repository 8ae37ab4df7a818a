// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What /joint_states says of joints.
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

/// Messages may come in any order.
class JointStates {
 public:
  /// What is not finite and what has no stamp is ignored, and so are velocities beyond kMaxVelocity
  /// and further joints beyond kMaxJoints. A stamp of long before the newest one of the joint is a
  /// fault or of a second publisher, and is ignored. kJump of them in a row mean that time jumped
  /// back: then all else is forgotten of the joint. Others may have a publisher whose clock is
  /// right.
  void add(const std::string& joint, const JointReport& report);

  void clear();

  /// Forgets all if the clock has jumped back since the last call: then the epoch of tf is another
  /// one.
  void observeEpoch(std::uint64_t epoch);

  /// The reports of a joint that tell how it moves at `stamp`: those of `window` before it [ns],
  /// and the next one after it, in order. Nothing for a joint that was never reported.
  std::optional<std::vector<JointReport>> reports(const std::string& joint, std::int64_t stamp,
                                                  std::int64_t window) const;

  /// The last report before that stamp, if it is at most a second older.
  std::optional<JointReport> lastBefore(const std::string& joint, std::int64_t stamp) const;

  /// [rad/s or m/s] So that sums of them are finite.
  static constexpr double kMaxVelocity = 1e100;

  /// A publisher may invent names without end.
  static constexpr std::size_t kMaxJoints = 10'000;

 private:
  using Reports = std::map<std::int64_t, JointReport>;  ///< by stamp

  struct History {
    Reports reports;
    Reports old;  ///< those of long before, since the last one that was not
  };

  static constexpr std::size_t kJump = 10;

  static void keep(const JointReport& report, Reports& reports);

  std::map<std::string, History> joints_;
  std::uint64_t epoch_ = 0;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks whether messages come in the order of their record times.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "tools/bag_bounds/bag/bag_reader.h"

namespace link_bounds {

/// If a clock goes back, it does so for each publisher of a topic that sends again. If no publisher
/// goes back, the messages were not written in the order of their times. A bag that a script has
/// written names one publisher for a whole topic, so the first frame or joint of a message counts
/// as part of the publisher.
class RecordOrder {
 public:
  /// Call it with each message. `is_jump_back`: its time is so far back that tf takes it for a jump
  /// of the clock.
  void watch(const BagMessage& message, bool is_jump_back);

  /// Times of the messages that step back because they are not in order [ns].
  const std::vector<std::int64_t>& stepsBack() const { return steps_back_; }

 private:
  struct Newest {
    std::int64_t time = 0;
    std::uint64_t steps_back = 0;  ///< all_steps_back_ when it came
  };

  std::unordered_map<std::string, Newest> newest_;  ///< by publisher, see watch()
  std::string key_;                                 ///< in newest_; kept for its memory
  std::vector<std::int64_t> steps_back_;
  std::uint64_t all_steps_back_ = 0;  ///< number, with jumps of the clock
  std::int64_t last_ = 0;             ///< newest time since the clock jumped back, or seemed to
  std::int64_t before_step_ = 0;      ///< value of last_ before the last step
  /// The last step may be a jump of the clock: time has not passed what it was before.
  bool may_be_jump_ = false;
};

}  // namespace link_bounds

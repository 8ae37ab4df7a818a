// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// TFMessages as bytes, as they arrive at 1 kHz; only the stamps are written anew for each.
#pragma once

#include "bench/pipeline/pipelines.h"

namespace link_bounds::bench {

class TfTraffic {
 public:
  /// The robot moves or stands still.
  TfTraffic(const TfRobot& robot, bool moves);

  /// Makes the next messages, each a millisecond after the one before.
  void prepare();

  /// Ten seconds of messages: after as many, memory is reused.
  static constexpr std::size_t kHistory = 10000;

  /// The messages that were prepared, in order, and their stamps.
  static constexpr std::size_t kMessages = 16;
  Bytes& bytes(std::size_t i) { return bytes_[i]; }
  ros::Time stamp(std::size_t i) const { return stamps_[i]; }

 private:
  std::vector<Bytes> bytes_;
  std::vector<ros::Time> stamps_;
  std::vector<std::size_t> stamp_offsets_;  ///< the same in all messages
  ros::Time now_{1700000000.0};
};

}  // namespace link_bounds::bench

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Messages of boxes against one assertion.
#pragma once

#include <string>

#include "link_bounds/AxisAlignedBoxArray.h"
#include "tools/assert_box/assert_box_parameters.h"

namespace link_bounds {

/// Times are seconds of a steady clock.
class BoxWatch {
 public:
  explicit BoxWatch(const BoxAssertion& assertion) : assertion_(assertion), hold_(assertion.hold) {}

  void see(const AxisAlignedBoxArray::ConstPtr& message, double now);
  /// Nobody publishes any more, so that nobody knows whether the last box still holds.
  void losePublisher(double now);
  bool isPassed(double now) const { return hold_.isKept(now); }
  /// What was asked for and what came instead.
  std::string failure(double now) const;

 private:
  std::string lastSeen() const;

  BoxAssertion assertion_;
  Hold hold_;
  AxisAlignedBoxArray::ConstPtr last_;       ///< null before the first message
  AxisAlignedBoxArray::ConstPtr last_with_;  ///< the last one that has the box
  bool has_lost_publisher_ = false;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
/// Ends work that takes long.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace link_bounds {

/// Called again and again during long work; throws to end it. Null: the work is never ended.
using CheckInterrupt = std::function<void()>;

/// Calls a CheckInterrupt only now and then, because it may read a clock and take a lock.
class WorkMeter {
 public:
  explicit WorkMeter(CheckInterrupt check) : check_(std::move(check)) {}

  /// `amount` is the number of points or triangles that the work looks at next; each takes some ns.
  void add(std::size_t amount) {
    sum_ += amount;
    if (sum_ < kAmountPerCheck) return;
    sum_ = 0;
    if (check_) check_();
  }

 private:
  static constexpr std::size_t kAmountPerCheck = 1 << 16;  // about a millisecond

  CheckInterrupt check_;
  std::size_t sum_ = 0;
};

}  // namespace link_bounds

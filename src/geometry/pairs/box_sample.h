// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A sample that represents all boxes. Decisions based on it affect the speed, not the result.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "link_bounds/geometry/box/aabb.h"

namespace link_bounds {

/// At most 32 boxes at equal steps through the list.
class BoxSample {
 public:
  explicit BoxSample(const std::vector<Aabb>& boxes) : size_(std::min(boxes.size(), kMaxSize)) {
    for (std::size_t i = 0; i < size_; ++i)
      boxes_[i] = &boxes[i * boxes.size() / size_];
  }

  const Aabb* const* begin() const { return boxes_.data(); }
  const Aabb* const* end() const { return boxes_.data() + size_; }

  /// The median of value_of(box), for a list that is not empty. A mean would follow a single box
  /// far away.
  template <class ValueOf>
  double median(ValueOf value_of) const {
    std::array<double, kMaxSize> values{};
    std::transform(begin(), end(), values.begin(), [&](const Aabb* box) { return value_of(*box); });
    const auto middle = values.begin() + size_ / 2;
    std::nth_element(values.begin(), middle, values.begin() + size_);
    return *middle;
  }

 private:
  /// The rank of such a median differs from a half by 9 % (0.5 / sqrt(32), one standard deviation).
  static constexpr std::size_t kMaxSize = 32;

  std::size_t size_;
  std::array<const Aabb*, kMaxSize> boxes_;
};

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// How long something took, over millions of times, in a few hundred bytes.
#pragma once

#include <array>
#include <cstdint>

namespace link_bounds {

/// Counts durations from 1 us to 65 ms in classes that are at most a quarter wide of where they
/// begin; what is shorter or longer counts in the first or the last class.
class DurationHistogram {
 public:
  void add(double milliseconds);

  /// The end of the class in which this part of all durations ends, but not more than the longest;
  /// 0 if there was none. `part` is above 0 and at most 1.
  double quantile(double part) const;

  double longest() const { return longest_; }
  std::uint64_t count() const { return count_; }

 private:
  static constexpr int kPerOctave = 4;
  static constexpr int kOctaves = 16;

  std::array<std::uint64_t, kOctaves * kPerOctave> counts_{};
  std::uint64_t count_ = 0;
  double longest_ = 0;  ///< ms
};

}  // namespace link_bounds

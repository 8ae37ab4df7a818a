// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Counts by format what became of mutated meshes.
#pragma once

#include <array>
#include <map>
#include <string>

namespace link_bounds {

/// The columns of the table. kDied and kTimedOut are refusals, too.
enum class Outcome { kRefused, kSameBox, kOtherBox, kDied, kTimedOut };

/// The kind of refusal, by the reason for the user.
Outcome refusalOf(const std::string& reason);

class Outcomes {
 public:
  void add(const std::string& format, Outcome outcome);
  void print() const;

  /// A complaint if less than a fifth of the meshes of this format are refused, or less than a
  /// fifth get another box: then the mutations are too weak or too strong to test much. ""
  /// otherwise.
  std::string imbalanceOf(const std::string& format) const;

 private:
  static constexpr std::size_t kOutcomes = 5;
  std::map<std::string, std::array<long, kOutcomes>> rows_;
};

}  // namespace link_bounds

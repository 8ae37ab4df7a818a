// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What became of mutated meshes, counted by format.
#pragma once

#include <array>
#include <map>
#include <string>

namespace link_bounds {

/// In the order of the table's columns. A mesh whose reader died or took too long is refused, too.
enum class Outcome { kRefused, kSameBox, kOtherBox, kDied, kTimedOut };

/// Which way a mesh was refused, by the words for the user.
Outcome refusalOf(const std::string& reason);

class Outcomes {
 public:
  void add(const std::string& format, Outcome outcome);
  void print() const;

  /// Empty unless fewer than a fifth of the format's meshes are refused, or fewer than a fifth get
  /// another box: then the mutations are too rude or too gentle to test anything.
  std::string imbalanceOf(const std::string& format) const;

 private:
  static constexpr std::size_t kOutcomes = 5;
  std::map<std::string, std::array<long, kOutcomes>> rows_;
};

}  // namespace link_bounds

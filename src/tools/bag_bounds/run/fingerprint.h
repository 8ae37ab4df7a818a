// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A fingerprint of 16 characters that shows whether two files or two questions are the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace link_bounds {

/// 64-bit FNV-1a: finds accidental changes, but not files that were made to deceive it.
class Fingerprint {
 public:
  /// The length of each text goes before it, so "ab", "c" differs from "a", "bc".
  void add(std::string_view field);

  /// Adds at most `limit` bytes from the begin of a file. False if it cannot be read.
  bool addFile(const std::string& name, std::uint64_t limit = UINT64_MAX);

  std::uint64_t value() const { return state_; }

  /// In hexadecimal.
  std::string text() const;

 private:
  void addBytes(const char* bytes, std::size_t count);

  std::uint64_t state_ = 0xcbf29ce484222325;
};

}  // namespace link_bounds

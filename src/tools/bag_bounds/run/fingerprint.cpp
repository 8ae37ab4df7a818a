// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// FNV-1a: an exclusive or and a multiplication per byte.
#include "tools/bag_bounds/run/fingerprint.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <vector>

namespace link_bounds {

void Fingerprint::addBytes(const char* bytes, std::size_t count) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  for (std::size_t i = 0; i < count; ++i)
    state_ = (state_ ^ static_cast<std::uint8_t>(bytes[i])) * kPrime;
}

void Fingerprint::add(std::string_view field) {
  const std::string length = std::to_string(field.size()) + ":";
  addBytes(length.data(), length.size());
  addBytes(field.data(), field.size());
}

bool Fingerprint::addFile(const std::string& name, std::uint64_t limit) {
  std::ifstream in(name, std::ios::binary);
  std::vector<char> block(1 << 16);
  while (in && limit > 0) {
    const auto wanted = static_cast<std::streamsize>(std::min<std::uint64_t>(block.size(), limit));
    in.read(block.data(), wanted);
    const auto count = static_cast<std::size_t>(in.gcount());
    addBytes(block.data(), count);
    limit -= count;
  }
  return !in.bad() && (in.eof() || limit == 0);
}

std::string Fingerprint::text() const {
  char text[17];
  std::snprintf(text, sizeof(text), "%016" PRIx64, state_);
  return text;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each function returns a damaged copy.
#include "block_mutation.h"

#include <utility>

namespace link_bounds {

using brute_force::Random;

std::size_t below(std::size_t count, Random& random) {
  return static_cast<std::size_t>(random.uniform(0, static_cast<double>(count)));
}

namespace {

constexpr int kMostBytesHit = 4;

/// The offset of a block and its length.
std::pair<std::size_t, std::size_t> block(const std::string& text, Random& random) {
  const std::size_t begin = below(text.size(), random);
  return {begin, below((text.size() - begin) / 2 + 1, random)};
}

}  // namespace

std::string hitBytes(std::string text, Random& random) {
  if (text.empty()) return text;
  for (std::size_t i = 0, count = 1 + below(kMostBytesHit, random); i < count; ++i) {
    char& byte = text[below(text.size(), random)];
    const auto bit = static_cast<char>(1 << below(8, random));
    byte = static_cast<char>(random.sign() > 0 ? byte ^ bit : static_cast<int>(below(256, random)));
  }
  return text;
}

std::string cutShort(std::string text, Random& random) {
  text.resize(below(text.size() + 1, random));
  return text;
}

std::string duplicateBlock(std::string text, Random& random) {
  const auto [begin, size] = block(text, random);
  const std::string copy = text.substr(begin, size);
  return text.insert(random.sign() > 0 ? begin + size : below(text.size() + 1, random), copy);
}

std::string deleteBlock(std::string text, Random& random) {
  const auto [begin, size] = block(text, random);
  return text.erase(begin, size);
}

}  // namespace link_bounds

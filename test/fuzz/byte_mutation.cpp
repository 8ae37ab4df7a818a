// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Binary files: words of four bytes at any offset.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <vector>

#include "block_mutation.h"
#include "mutation.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr std::size_t kWord = 4;  // bytes
constexpr double kSmallFloat = 0.01;
constexpr double kLargeFloat = 100;

template <class Value>
void writeWord(Value value, char* out) {
  static_assert(sizeof(value) == kWord);
  std::memcpy(out, &value, sizeof(value));
}

/// The offsets of floats of typical size, which are mostly coordinates.
std::vector<std::size_t> floatsOf(const std::string& bytes) {
  std::vector<std::size_t> offsets;
  for (std::size_t i = 0; i + kWord <= bytes.size(); ++i) {
    float value = 0;
    std::memcpy(&value, bytes.data() + i, kWord);
    if (std::abs(value) > kSmallFloat && std::abs(value) < kLargeFloat) offsets.push_back(i);
  }
  return offsets;
}

std::string changeFloat(std::string bytes, Random& random) {
  const std::vector<std::size_t> floats = floatsOf(bytes);
  if (floats.empty()) return bytes;
  const auto value = static_cast<float>(random.sign() * random.magnitude(-1, 3));
  writeWord(value, &bytes[floats[below(floats.size(), random)]]);
  return bytes;
}

std::string changeWord(std::string bytes, Random& random) {
  static constexpr std::array<std::uint32_t, 9> kOddIntegers{
      0, 1, 6, 24, 255, 65536, 0x7fffffff, 0x80000000, 0xffffffff};
  static constexpr std::array<float, 6> kOddFloats{std::numeric_limits<float>::quiet_NaN(),
                                                   std::numeric_limits<float>::infinity(),
                                                   std::numeric_limits<float>::max(),
                                                   std::numeric_limits<float>::denorm_min(),
                                                   -0.0f,
                                                   -12.5f};
  if (bytes.size() < kWord) return bytes;
  char* word = &bytes[below(bytes.size() - kWord + 1, random)];
  if (random.sign() > 0) {
    writeWord(kOddIntegers[below(kOddIntegers.size(), random)], word);
  } else {
    writeWord(kOddFloats[below(kOddFloats.size(), random)], word);
  }
  return bytes;
}

std::string swapWords(std::string bytes, Random& random) {
  if (bytes.size() < 2 * kWord) return bytes;
  const auto word = [&] {
    return bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size() - kWord + 1, random));
  };
  const std::string::iterator first = word();
  const std::string::iterator second = word();
  if (std::abs(first - second) >= static_cast<std::ptrdiff_t>(kWord)) {
    std::swap_ranges(first, first + kWord, second);
  }
  return bytes;
}

}  // namespace

std::string mutatedBytes(const std::string& bytes, Random& random) {
  using Mutator = std::string (*)(std::string, Random&);
  static constexpr Mutator kMutators[] = {hitBytes,       changeWord,  changeFloat,
                                          changeFloat,    changeFloat, swapWords,
                                          duplicateBlock, deleteBlock, cutShort};
  return kMutators[below(std::size(kMutators), random)](bytes, random);
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Chooses the damage.
#include "mutation.h"

namespace link_bounds {
namespace {

using brute_force::Random;

constexpr double kShareOfSingleMutations = 0.7;
constexpr double kShareOfWholeGlb = 0.8;

/// Damage at random seldom affects the JSON of a GLB file, because wrong sizes are refused first.
std::string mutatedGlb(const std::string& content, Random& random) {
  return random.sign() > 0 ? glb(mutatedText(jsonOf(content), random), binaryOf(content))
                           : glb(jsonOf(content), mutatedBytes(binaryOf(content), random));
}

}  // namespace

std::string mutated(const MeshSeed& seed, Random& random) {
  std::string content = seed.content;
  const int count = random.uniform(0, 1) < kShareOfSingleMutations ? 1 : 2;
  for (int i = 0; i < count; ++i) {
    if (seed.is_text) {
      content = mutatedText(content, random);
    } else if (i == 0 && seed.extension == ".glb" && random.uniform(0, 1) < kShareOfWholeGlb) {
      content = mutatedGlb(content, random);
    } else {
      content = mutatedBytes(content, random);
    }
  }
  return content;
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A map whose keys never come again does not grow for ever, and loses nothing that is alive.
#include "robot/mesh/erase_dead.h"

#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <memory>

namespace link_bounds {
namespace {

TEST(EraseDead, KeepsWhatIsAliveAndAtMostTwiceAsMany) {
  std::size_t limit = kManyMeshes, looks = 0;
  std::map<int, std::weak_ptr<int>> map;
  std::deque<std::shared_ptr<int>> alive;
  const auto is_dead = [&looks](const std::weak_ptr<int>& value) {
    ++looks;
    return value.expired();
  };
  constexpr int kCount = 500000;
  for (int i = 0; i < kCount; ++i) {
    alive.push_back(std::make_shared<int>(i));
    if (alive.size() > 20000) alive.pop_front();
    eraseDead(map, limit, is_dead);
    map[i] = alive.back();
    ASSERT_LE(map.size(), 2 * alive.size() + kManyMeshes);
  }
  for (const auto& value : alive)
    EXPECT_EQ(map.at(*value).lock(), value);
  EXPECT_LT(looks, 4u * kCount);
}

}  // namespace
}  // namespace link_bounds

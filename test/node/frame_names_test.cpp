// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A guess may be wrong, a number never is.
#include "frame_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace link_bounds {
namespace {

TEST(FrameNames, NumbersAreTheSameInAnyOrder) {
  std::vector<std::string> names;
  for (int i = 0; i < 50; ++i)
    names.push_back("frame_" + std::to_string(i));
  FrameNames frames;
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_EQ(frames.frame(names[i]), i);
  std::mt19937 engine(1);
  for (int round = 0; round < 100; ++round) {
    if (round % 3 == 0) std::shuffle(names.begin(), names.end(), engine);
    frames.beginMessage();
    for (const std::string& name : names)
      EXPECT_EQ(frames.next(name), frames.frame(name));
  }
  EXPECT_EQ(frames.size(), names.size());
}

TEST(FrameNames, WrongGuessesAreHarmless) {
  FrameNames frames;
  EXPECT_EQ(frames.frame("a", 7), 0u);
  EXPECT_EQ(frames.frame("b", 0), 1u);
  EXPECT_EQ(frames.frame("a", 1), 0u);
}

}  // namespace
}  // namespace link_bounds

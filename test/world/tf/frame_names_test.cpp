// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A guess may be wrong, a number never is.
#include "world/tf/frame_names.h"

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
    for (std::size_t i = 1; i < names.size(); ++i) {
      const std::string key = names[i] + " in " + names[i - 1];
      const FrameNames::Edge edge = frames.next(names[i - 1], names[i], key);
      EXPECT_EQ(edge.child, frames.frame(names[i]));
      EXPECT_EQ(edge.parent, frames.frame(names[i - 1]));
    }
  }
  EXPECT_EQ(frames.size(), names.size());
}

TEST(FrameNames, AnEdgeThatIsKnownIsNotLookedAtAgain) {
  FrameNames frames;
  const FrameNames::Edge edge = frames.next("a", "b", "a b");
  frames.beginMessage();
  const FrameNames::Edge again = frames.next("", "", "a b");
  EXPECT_EQ(again.child, edge.child);
  EXPECT_EQ(again.parent, edge.parent);
}

TEST(FrameNames, WithoutAKeyNamesAreLookedAt) {
  FrameNames frames;
  for (const char* parent : {"a", "b", "a"}) {
    frames.beginMessage();
    const FrameNames::Edge edge = frames.next(parent, "child", "");
    EXPECT_EQ(edge.child, frames.frame("child"));
    EXPECT_EQ(edge.parent, frames.frame(parent));
  }
}

TEST(FrameNames, OfABorrowedNameOnlyTheNumberIsKnown) {
  const std::string name = "a";
  FrameNames frames;
  EXPECT_EQ(frames.borrow(name), 0u);
  EXPECT_EQ(&frames.name(0), &name);
  EXPECT_FALSE(frames.known("a"));
  EXPECT_EQ(frames.frame("a"), 1u);
  EXPECT_EQ(frames.name(1), "a");
  EXPECT_EQ(frames.known("a"), 1u);
}

}  // namespace
}  // namespace link_bounds

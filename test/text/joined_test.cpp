// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text/joined.h"

#include <gtest/gtest.h>

#include <vector>

namespace link_bounds {
namespace {

using Texts = std::vector<std::string>;

TEST(Joined, HasASeparatorBetweenAllElements) {
  EXPECT_EQ(joined(Texts{}, ", "), "");
  EXPECT_EQ(joined(Texts{"a"}, ", "), "a");
  EXPECT_EQ(joined(Texts{"", "", "b", ""}, ","), ",,b,");
  EXPECT_EQ(joined(std::vector<int>{1, 2}, "; ", [](int i) { return std::to_string(i); }), "1; 2");
}

}  // namespace
}  // namespace link_bounds

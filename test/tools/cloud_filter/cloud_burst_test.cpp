// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// More clouds than may wait come while the filter is busy.
#include "tools/cloud_filter/filter_in_process.h"

namespace link_bounds {
namespace {

TEST_F(FilterInProcess, WhatCannotWaitIsNotLateIfNothingWaitedBefore) {
  ASSERT_TRUE(isServed([this] { return message_.find("no cloud or scan") == 0; }));
  send();
  ASSERT_TRUE(becomesTrue([this] { return gate_.isReached(); })) << "it is late, and the last one";
  for (std::uint32_t i = 0; i < FilterHealth::kQueue; ++i)
    send();
  ASSERT_TRUE(isServed([this] { return heard_ == sent_; }));
  gate_.open();
  ASSERT_TRUE(isServed([&] { return values_.count(kTooMany) > 0; }));
  EXPECT_EQ(values_[kTooMany], "1");
  EXPECT_EQ(values_["times that a queue of clouds was full"], "1");
}

}  // namespace
}  // namespace link_bounds

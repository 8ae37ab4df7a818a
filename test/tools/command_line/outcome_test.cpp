// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Exit codes: the first that applies in the order 1, 3, 4, 2, 0.
#include "tools/command_line/outcome.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace link_bounds {

namespace {

/// Of every kind of trouble.
Outcome worst() {
  Outcome outcome;
  outcome.is_unusable = outcome.has_finding = outcome.lost_geometry = true;
  outcome.addOpen("pairs", 2);
  return outcome;
}

TEST(Outcome, TheFirstThatAppliesDecides) {
  const Demand strict{true, false};
  Outcome outcome = worst();
  EXPECT_EQ(exitCode(outcome, strict), 1);
  outcome.is_unusable = false;
  EXPECT_EQ(exitCode(outcome, strict), 3);
  outcome.has_finding = false;
  EXPECT_EQ(exitCode(outcome, strict), 4);
  outcome.open.clear();
  EXPECT_EQ(exitCode(outcome, strict), 2);
  outcome.lost_geometry = false;
  EXPECT_EQ(exitCode(outcome, strict), 0);
}

TEST(Outcome, OnlyWhatIsOpenCanBeAllowed) {
  const Demand lenient{false, true};
  Outcome outcome = worst();
  EXPECT_EQ(exitCode(outcome, lenient), 1);
  outcome.is_unusable = false;
  EXPECT_EQ(exitCode(outcome, lenient), 3);
  outcome.has_finding = false;
  EXPECT_EQ(exitCode(outcome, lenient), 0);
  EXPECT_EQ(exitCode(outcome, {true, true}), 2);
  EXPECT_EQ(exitCode(outcome, {}), 4);
}

TEST(Outcome, WhatIsOpenIsSaidUnlessItIsAccepted) {
  Outcome outcome;
  outcome.addOpen("names", 0);
  outcome.addOpen("pairs", 2);
  outcome.addOpen("topics", 1);
  testing::internal::CaptureStderr();
  EXPECT_EQ(exitCode(outcome, {}), 4);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            std::string(program_invocation_short_name) +
                ": warning: not everything was answered: pairs: 2; topics: 1; "
                "--allow-incomplete accepts that\n");
  testing::internal::CaptureStderr();
  outcome.has_finding = true;
  EXPECT_EQ(exitCode(outcome, {}), 3);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            std::string(program_invocation_short_name) +
                ": warning: not everything was answered: pairs: 2; topics: 1\n");
  testing::internal::CaptureStderr();
  EXPECT_EQ(exitCode(outcome, {false, true}), 3);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Outcome, TheWorseOfTwoCodesIsTheFirstOfTheirOrder) {
  EXPECT_EQ(worseCode(0, 0), 0);
  EXPECT_EQ(worseCode(0, 2), 2);
  EXPECT_EQ(worseCode(4, 2), 4);
  EXPECT_EQ(worseCode(4, 3), 3);
  EXPECT_EQ(worseCode(3, 1), 1);
  for (const int none : {5, 7, -1, 255}) {
    EXPECT_EQ(worseCode(0, none), 1);
    EXPECT_EQ(worseCode(none, 3), 1);
  }
}

}  // namespace
}  // namespace link_bounds

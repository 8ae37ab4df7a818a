// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Which characters of a text reach a log.
#include "world/log/log_text.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

TEST(LogText, PlainTextStays) {
  const std::string text =
      "cannot use /home/jürgen/机器人/底座 🤖.stl: it is empty; replace it";
  EXPECT_EQ(logText(text), text);
  EXPECT_EQ(logText(""), "");
}

TEST(LogText, NothingBreaksTheLineOrMovesTheCursor) {
  for (int i = 0; i < 256; ++i) {
    if (i >= ' ' && i <= '~') continue;
    EXPECT_EQ(logText(std::string("a") + static_cast<char>(i) + "b"), "a?b") << i;
  }
  for (const char* character :
       {"\u0085", "\u009b", "\u200f", "\u2028", "\u2029", "\u202e", "\u2066"})
    EXPECT_EQ(logText(std::string("a") + character + "b"), "a?b");
}

TEST(LogText, WhatIsNotUtf8IsReplacedByteByByte) {
  EXPECT_EQ(logText("\xc3"), "?");
  EXPECT_EQ(logText("\xc3\x28"), "?(");
  EXPECT_EQ(logText("\xc0\xaf"), "??") << "an overlong slash";
  EXPECT_EQ(logText("\xe0\x80\xaf"), "???");
  EXPECT_EQ(logText("\xed\xa0\x80"), "???") << "a surrogate";
  EXPECT_EQ(logText("\xf4\x90\x80\x80"), "????") << "beyond Unicode";
}

TEST(LogText, OfALongTextBothEndsStay) {
  const std::string text =
      logText("cannot use /" + std::string(1'000'000, 'x') + ": it is empty; replace it");
  EXPECT_LT(text.size(), 1000u);
  EXPECT_EQ(text.find("cannot use /xxx"), 0u);
  EXPECT_NE(text.find("xxx ... xxx"), std::string::npos);
  EXPECT_EQ(text.substr(text.size() - 12), "; replace it");
}

}  // namespace
}  // namespace link_bounds

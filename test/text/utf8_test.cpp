// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The borders of well-formed UTF-8 by table 3-7 of the Unicode Standard.
#include "text/utf8.h"

#include <gtest/gtest.h>

namespace link_bounds {
namespace {

std::string valid(const std::string& text) {
  return sanitized(
      text, [](std::uint32_t) { return true; }, "?");
}

TEST(Utf8, WellFormedTextStays) {
  const std::string zero(1, '\0');
  for (const std::string& text :
       {std::string(), zero, std::string("\x7f"), std::string("\xc2\x80\xdf\xbf"),
        std::string("\xe0\xa0\x80\xed\x9f\xbf\xee\x80\x80\xef\xbf\xbf"),
        std::string("\xf0\x90\x80\x80\xf4\x8f\xbf\xbf")}) {
    EXPECT_EQ(valid(text), text);
  }
}

TEST(Utf8, EachByteThatIsNotWellFormedIsReplaced) {
  EXPECT_EQ(valid("\x80\xbf"), "??") << "no lead";
  EXPECT_EQ(valid("\xc0\xaf\xc1\xbf"), "????") << "overlong";
  EXPECT_EQ(valid("\xe0\x9f\xbf"), "???") << "overlong";
  EXPECT_EQ(valid("\xf0\x8f\xbf\xbf"), "????") << "overlong";
  EXPECT_EQ(valid("\xed\xa0\x80\xed\xbf\xbf"), "??????") << "surrogates";
  EXPECT_EQ(valid("\xf4\x90\x80\x80\xf5\x80\xff"), "???????") << "beyond Unicode";
  EXPECT_EQ(valid("a\xc3(\xe2\x82"), "a?(??") << "cut short";
}

TEST(Utf8, RefusedCharactersAreReplacedAsAWhole) {
  const auto is_ascii = [](std::uint32_t code) { return code < 0x80; };
  EXPECT_EQ(sanitized("aé\xf0\x9f\xa4\x96\xff", is_ascii, "<>"), "a<><><>");
}

}  // namespace
}  // namespace link_bounds

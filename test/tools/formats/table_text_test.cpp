// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers as people and programs read them: there is no minus zero.
#include "tools/formats/table_text.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tools/formats/safe_text.h"

namespace link_bounds {
namespace {

TEST(TableText, ATableHasNoMinusZero) {
  for (const double value : {0.0, -0.0, -1e-300, -4.9e-7, -5e-7})
    EXPECT_EQ(shortRow("", {value})[1], "0.000000") << value;
  EXPECT_EQ(shortRow("", {-5.1e-7})[1], "-0.000001");
}

TEST(TableText, CsvAndJsonHaveNoMinusZero) {
  std::ostringstream csv;
  writeCsvRow("link", {-0.0, -1e-300}, csv);
  EXPECT_EQ(csv.str(), "link,0,-1e-300\n") << "exact, but for the sign of 0";
  EXPECT_EQ(jsonNumbers(Eigen::Vector2d(-0.0, -0.5)), "[0, -0.5]");
}

TEST(TableText, NamesAreTheSameUtf8InAllFormats) {
  const std::string name = "k\xf6rper";
  EXPECT_EQ(csvField(name), "k\xef\xbf\xbdrper");
  EXPECT_EQ(jsonString(name), '"' + csvField(name) + '"');
  EXPECT_EQ(printable(name), csvField(name));
}

}  // namespace
}  // namespace link_bounds

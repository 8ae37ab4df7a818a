// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The result of one test as the XML that rostest and catkin_test_results read.
#pragma once

#include <string>

namespace link_bounds {

struct TestReport {
  std::string suite;
  std::string test;
  double seconds = 0.0;
  std::string failure;  ///< "" = passed
};

/// JUnit's format, as of gtest; any text is made fit for XML.
std::string junitXml(const TestReport& report);

/// Makes the folder if it is missing. The file is there as a whole or not at all; throws
/// std::runtime_error with the reason.
void writeFile(const std::string& path, const std::string& text);

}  // namespace link_bounds

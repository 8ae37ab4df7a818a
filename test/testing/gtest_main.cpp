// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs the tests of one program; not every catkin links gtest's own main.
#include <gtest/gtest.h>

#include <iostream>
#include <optional>
#include <string>
#include <string_view>

/// Tells ctest that all was well, but not everything could run; see gtest.cmake.
constexpr int kSkipped = 4;

/// NAME of the argument --file=NAME: only the tests that stand in this file are to run.
std::optional<std::string> fileOf(int argc, char** argv) {
  constexpr std::string_view kOption = "--file=";
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument.substr(0, kOption.size()) == kOption)
      return std::string(argument.substr(kOption.size()));
  }
  return std::nullopt;
}

/// Their names, as gtest's filter has them.
std::string testsIn(const std::string& file) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  const std::string end = "/" + file;
  std::string filter;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      const std::string path = std::string("/") + test.file();
      if (path.size() >= end.size() && path.substr(path.size() - end.size()) == end)
        filter += std::string(suite.name()) + "." + test.name() + ":";
    }
  }
  return filter;
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (const auto file = fileOf(argc, argv)) {
    const std::string tests = testsIn(*file);
    if (tests.empty()) {
      std::cerr << argv[0] << " has no test in " << *file << std::endl;
      return 1;
    }
    testing::GTEST_FLAG(filter) = tests;
  }
  const int result = RUN_ALL_TESTS();
  const bool has_skipped = testing::UnitTest::GetInstance()->skipped_test_count() > 0;
  return result == 0 && has_skipped ? kSkipped : result;
}

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Each row is worked on once, on as many threads as there are.
#include "robot/threads/row_threads.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "testing/ordinary_user.h"

namespace link_bounds {
namespace {

/// Whether each of 100 rows from 5 on is worked on once.
bool worksOnAll(unsigned threads, std::size_t at_once) {
  std::vector<std::atomic<int>> counts(110);
  forRows(5, 105, threads, at_once, [&](unsigned thread, std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      counts[row] += thread < threads ? 1 : 100;
  });
  for (std::size_t row = 0; row < counts.size(); ++row) {
    if (counts[row] != (row >= 5 && row < 105 ? 1 : 0)) return false;
  }
  return true;
}

TEST(RowThreads, WorkOnEachRowOnce) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    for (const std::size_t at_once : {1u, 3u, 1000u})
      EXPECT_TRUE(worksOnAll(threads, at_once)) << threads << " threads, " << at_once << " rows";
  }
}

TEST(RowThreads, WhereNoThreadCanStartTheCallingOneDoesAll) {
  EXPECT_TRUE(isTrueWithoutThreads([] { return worksOnAll(4, 3); }));
}

TEST(RowThreads, OneThreadOrOneChunkStartsNoOther) {
  const auto isFirst = [](unsigned threads, std::size_t at_once) {
    bool is_first = true;
    const std::thread::id self = std::this_thread::get_id();
    forRows(0, 10, threads, at_once, [&](unsigned thread, std::size_t, std::size_t) {
      is_first = is_first && thread == 0 && std::this_thread::get_id() == self;
    });
    return is_first;
  };
  EXPECT_TRUE(isFirst(1, 1));
  EXPECT_TRUE(isFirst(8, 10));
}

TEST(RowThreads, NoRowBeginsAfterOneThrew) {
  std::size_t rows = 0;
  const auto work = [&](unsigned, std::size_t begin, std::size_t) {
    ++rows;
    if (begin == 3) throw std::runtime_error("of row 3");
  };
  EXPECT_THROW(forRows(0, 1000, 1, 1, work), std::runtime_error);
  EXPECT_EQ(rows, 4u);
}

TEST(RowThreads, ThrowWhatAnotherThreadThrew) {
  std::atomic<bool> has_thrown{false};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  const auto work = [&](unsigned thread, std::size_t, std::size_t) {
    if (thread == 1) {
      has_thrown = true;
      throw std::runtime_error("of thread 1");
    }
    while (!has_thrown && std::chrono::steady_clock::now() < deadline)
      std::this_thread::yield();
  };
  EXPECT_THROW(forRows(0, 2, 2, 1, work), std::runtime_error);
}

/// A thread that went on would do all rows.
TEST(RowThreads, NoThreadGoesOnAfterOneThrew) {
  std::atomic<bool> has_thrown{false};
  std::atomic<std::size_t> later{0};
  const auto work = [&](unsigned, std::size_t begin, std::size_t) {
    if (begin == 0) {
      has_thrown = true;
      throw std::runtime_error("of row 0");
    }
    while (!has_thrown)
      std::this_thread::yield();
    ++later;
  };
  EXPECT_THROW(forRows(0, 10'000'000, 2, 1, work), std::runtime_error);
  EXPECT_LT(later, 9'000'000u);
}

TEST(CoreCount, IsWhatTasksetLeaves) {
  cpu_set_t before;
  ASSERT_EQ(sched_getaffinity(0, sizeof(before), &before), 0);
  EXPECT_EQ(coreCount(), static_cast<unsigned>(CPU_COUNT(&before)));
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
  EXPECT_EQ(coreCount(), 1u);
  ASSERT_EQ(sched_setaffinity(0, sizeof(before), &before), 0);
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Small meshes wait for no large one, the newest request of a key counts, and none is lost.
#include "node/loading/mesh_readers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <map>
#include <mutex>
#include <random>
#include <thread>

#include "testing/patience.h"

namespace link_bounds {
namespace {

using IsCancelled = MeshReaders::IsCancelled;

constexpr std::uint64_t kLarge = 1 << 30;

MeshReaders::Job job(std::uint64_t bytes, std::function<void(const IsCancelled&)> work) {
  return {[bytes] { return bytes; }, std::move(work)};
}

TEST(MeshReaders, SmallMeshesWaitForNoLargeOne) {
  MeshReaders readers;
  std::promise<void> begun, open;
  std::atomic<int> done{0};
  std::atomic<bool> is_large_done{false};
  readers.post("large", job(kLarge, [&](const IsCancelled&) {
                 begun.set_value();
                 open.get_future().wait_for(deadline());
                 is_large_done = true;
               }));
  valueOf(begun.get_future());
  for (int i = 0; i < 100; ++i)
    readers.post("small " + std::to_string(i), job(1, [&](const IsCancelled&) { ++done; }));
  EXPECT_TRUE(becomesTrue([&] { return done == 100; }));
  EXPECT_FALSE(is_large_done);
  open.set_value();
  EXPECT_TRUE(becomesTrue([&] { return is_large_done.load(); }));
}

TEST(MeshReaders, ASuccessorEndsTheOneThatRuns) {
  for (const std::uint64_t first : {std::uint64_t{1}, kLarge}) {
    for (const std::uint64_t second : {std::uint64_t{1}, kLarge}) {
      MeshReaders readers;
      std::promise<void> begun;
      std::atomic<bool> is_told{false}, is_done{false};
      readers.post("a", job(first, [&](const IsCancelled& is_cancelled) {
                     begun.set_value();
                     is_told = becomesTrue(is_cancelled);
                   }));
      valueOf(begun.get_future());
      readers.post(
          "a", job(second, [&](const IsCancelled& is_cancelled) { is_done = !is_cancelled(); }));
      EXPECT_TRUE(becomesTrue([&] { return is_told && is_done; }));
    }
  }
}

TEST(MeshReaders, StopEndsWhatRunsAndDoesNotDoWhatWaits) {
  MeshReaders readers;
  std::promise<void> begun;
  std::atomic<int> done{0};
  readers.post("large", job(kLarge, [&](const IsCancelled& is_cancelled) {
                 begun.set_value();
                 done += !becomesTrue(is_cancelled);
               }));
  readers.post("second", job(kLarge, [&](const IsCancelled&) { ++done; }));
  valueOf(begun.get_future());
  readers.stop();
  readers.post("third", job(1, [&](const IsCancelled&) { ++done; }));
  EXPECT_EQ(done, 0);
}

/// Each key's last answer is that of its last request, as if each had been done at once.
TEST(MeshReaders, RandomRequestsEndAsTheLastOfEachKey) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    MeshReaders readers;
    std::mutex mutex;
    std::map<std::string, int> answers, last;
    for (int i = 0; i < 200; ++i) {
      const std::string key(1, static_cast<char>('a' + random() % 8));
      const std::uint64_t bytes = random() % 3 == 0 ? kLarge : 1;
      const auto pause = std::chrono::microseconds(random() % 200);
      last[key] = i;
      readers.post(key, job(bytes, [&, key, i, pause](const IsCancelled& is_cancelled) {
                     std::this_thread::sleep_for(pause);
                     const std::lock_guard<std::mutex> lock(mutex);
                     if (!is_cancelled()) answers[key] = i;
                   }));
      if (random() % 4 == 0) std::this_thread::sleep_for(pause);
    }
    EXPECT_TRUE(becomesTrue([&] {
      const std::lock_guard<std::mutex> lock(mutex);
      return answers == last;
    })) << "round "
        << round;
    readers.stop();
  }
}

}  // namespace
}  // namespace link_bounds

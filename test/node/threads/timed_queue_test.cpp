// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The order of callbacks, what waits, and how an owner ends.
#include "node/threads/timed_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <future>
#include <stdexcept>
#include <vector>

#include "node/threads/queued_function.h"
#include "testing/patience.h"

namespace link_bounds {
namespace {

constexpr std::chrono::seconds kLong(60);

void add(TimedQueue& queue, std::function<void()> function, std::uint64_t owner = 0) {
  queue.addCallback(boost::make_shared<QueuedFunction>(std::move(function)), owner);
}

TEST(TimedQueue, CallsInTheOrderOfArrival) {
  TimedQueue queue;
  std::vector<int> calls;
  for (int i = 0; i < 3; ++i)
    add(queue, [&calls, i] { calls.push_back(i); });
  EXPECT_EQ(queue.backlog().count, 3u);
  while (queue.callOne()) {
  }
  EXPECT_EQ(calls, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(queue.backlog().count, 0u);
}

TEST(TimedQueue, TellsForHowLongTheFirstOneWaits) {
  TimedQueue queue;
  EXPECT_EQ(queue.backlog().oldest.count(), 0);
  const auto before = std::chrono::steady_clock::now();
  add(queue, [] {});
  const auto after = std::chrono::steady_clock::now();
  EXPECT_TRUE(becomesTrue([&] { return queue.backlog().oldest >= std::chrono::milliseconds(5); }));
  add(queue, [] {});
  const auto oldest = queue.backlog().oldest;
  const auto now = std::chrono::steady_clock::now();
  EXPECT_LE(oldest, now - before);
  EXPECT_GE(oldest, std::chrono::milliseconds(5));
  queue.callOne();
  EXPECT_LT(queue.backlog().oldest, std::chrono::steady_clock::now() - after);
}

TEST(TimedQueue, ACallbackKnowsWhenItWasAdded) {
  TimedQueue queue;
  const ros::SteadyTime before = ros::SteadyTime::now();
  ros::SteadyTime first, second;
  add(queue, [&] {
    first = queue.arrival();
    add(queue, [&] { second = queue.arrival(); });
  });
  const ros::SteadyTime after = ros::SteadyTime::now();
  while (ros::SteadyTime::now() == after) {
  }
  const ros::SteadyTime called = ros::SteadyTime::now();
  while (queue.callOne()) {
  }
  EXPECT_GE(first, before);
  EXPECT_LE(first, after);
  EXPECT_GE(second, called);
}

TEST(TimedQueue, WaitEndsWithACallback) {
  TimedQueue queue;
  queue.wait(std::chrono::nanoseconds(0));
  auto waiting = std::async(std::launch::async, [&] { queue.wait(kLong); });
  add(queue, [] {});
  EXPECT_EQ(waiting.wait_for(kLong / 2), std::future_status::ready);
}

TEST(TimedQueue, ACallbackMayAddAndRemoveOthers) {
  TimedQueue queue;
  int calls = 0;
  add(
      queue,
      [&] {
        queue.removeByID(7);  // of itself
        add(
            queue, [&] { ++calls; }, 8);
      },
      7);
  add(
      queue, [&] { FAIL() << "was removed"; }, 7);
  while (queue.callOne()) {
  }
  EXPECT_EQ(calls, 1);
}

/// One that throws, too: who waits for its end would wait for ever.
TEST(TimedQueue, ACallbackThatThrowsHasEnded) {
  class Thrower : public ros::CallbackInterface {
    CallResult call() override { throw std::runtime_error("a test"); }
  };
  TimedQueue queue;
  queue.addCallback(boost::make_shared<Thrower>(), 7);
  EXPECT_THROW(queue.callOne(), std::runtime_error);
  auto removed = std::async(std::launch::async, [&] { queue.removeByID(7); });
  EXPECT_EQ(removed.wait_for(kLong / 2), std::future_status::ready);
  EXPECT_FALSE(queue.callOne());
}

TEST(TimedQueue, AnOwnerEndsAfterItsCallback) {
  TimedQueue queue;
  std::promise<void> begun;
  std::atomic<bool> is_done{false};
  std::promise<void> open;
  add(
      queue,
      [&] {
        begun.set_value();
        open.get_future().wait_for(kLong);
        is_done = true;
      },
      7);
  std::thread caller([&] { queue.callOne(); });
  begun.get_future().wait();
  queue.removeByID(8);  // does not wait
  std::thread opener([&] { open.set_value(); });
  queue.removeByID(7);
  EXPECT_TRUE(is_done);
  opener.join();
  caller.join();
}

/// Asks to be called again, once.
class Again : public ros::CallbackInterface {
 public:
  explicit Again(std::function<void()> work) : work_(std::move(work)) {}

  CallResult call() override {
    work_();
    return std::exchange(is_called_, true) ? Success : TryAgain;
  }

 private:
  std::function<void()> work_;
  bool is_called_ = false;
};

TEST(TimedQueue, CallsAgainWhatAsksForIt) {
  TimedQueue queue;
  int calls = 0;
  queue.addCallback(boost::make_shared<Again>([&] { ++calls; }));
  while (queue.callOne()) {
  }
  EXPECT_EQ(calls, 2);
}

TEST(TimedQueue, DoesNotCallAgainWhatWasRemovedMeanwhile) {
  TimedQueue queue;
  int calls = 0;
  const auto work = [&] {
    ++calls;
    queue.removeByID(7);
  };
  queue.addCallback(boost::make_shared<Again>(work), 7);
  while (queue.callOne()) {
  }
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Short calls beside long ones, turns, clients that are gone, and what a call keeps.
#include "node/threads/turn_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <boost/make_shared.hpp>
#include <cstdint>
#include <future>
#include <map>
#include <mutex>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "testing/patience.h"
#include "testing/worker_gate.h"

namespace link_bounds {
namespace {

/// What roscpp makes of a call: not begun if the client is gone; then the handler.
class FakeCall : public ros::CallbackInterface {
 public:
  FakeCall(std::function<void(TurnQueue::Call&)> handler, std::function<bool()> is_gone)
      : handler_(std::move(handler)), is_gone_(std::move(is_gone)) {}
  CallResult call() override {
    if (is_gone_()) return Invalid;
    try {
      handler_(TurnQueue::current());
    } catch (const std::exception&) {
      ADD_FAILURE() << "roscpp would answer with it";
    }
    return Success;
  }

 private:
  std::function<void(TurnQueue::Call&)> handler_;
  std::function<bool()> is_gone_;
};

class TurnQueueTest : public testing::Test {
 protected:
  ~TurnQueueTest() override {
    short_.stop();
    long_.stop();
  }

  void add(
      std::function<void(TurnQueue::Call&)> handler, std::uint64_t owner = 0,
      std::function<bool()> is_gone = [] { return false; }) {
    queue_.addCallback(boost::make_shared<FakeCall>(std::move(handler), std::move(is_gone)), owner);
  }

  /// A call that needs so many turns as a long one.
  void addLong(
      int turns, const std::string& name, std::uint64_t owner = 0,
      std::function<bool()> is_gone = [] { return false; }) {
    add(
        [=](TurnQueue::Call& call) {
          const bool is_first = !call.is_long;
          call.is_long = true;
          if (is_first) throw TurnQueue::NextTurn();
          if (!call.state) call.state = std::make_shared<int>(0);
          const std::lock_guard<std::mutex> lock(mutex_);
          done_.push_back(name);
          if (++*std::static_pointer_cast<int>(call.state) < turns) throw TurnQueue::NextTurn();
        },
        owner, is_gone);
  }

  /// Returns when both workers have nothing to do.
  void drain() {
    drainOne(short_);
    drainOne(long_);
  }

  static void drainOne(Worker& worker) {
    std::promise<void> done;
    worker.post("drain", [&done] { done.set_value(); });
    valueOf(done.get_future());
  }

  std::mutex mutex_;
  std::vector<std::string> done_;
  Worker short_{{"short"}};
  Worker long_{{"long"}};
  TurnQueue queue_{short_, long_};
};

TEST_F(TurnQueueTest, AShortCallDoesNotWaitForLongOnes) {
  Gate gate(long_);
  for (int i = 0; i < 3; ++i)
    addLong(1, "long");
  std::promise<bool> is_long;
  add([&](TurnQueue::Call& call) { is_long.set_value(call.is_long); });
  EXPECT_FALSE(valueOf(is_long.get_future()));
  EXPECT_TRUE(done_.empty());
  gate.open();
  drain();
  EXPECT_EQ(done_.size(), 3u);
}

TEST_F(TurnQueueTest, LongCallsTakeTurns) {
  Gate gate(long_);
  addLong(3, "a");
  addLong(1, "b");
  addLong(2, "c");
  std::promise<void> moved;
  add([&](TurnQueue::Call&) { moved.set_value(); });
  valueOf(moved.get_future());
  gate.open();
  drain();
  EXPECT_EQ(done_, (std::vector<std::string>{"a", "b", "c", "a", "c", "a"}));
}

TEST_F(TurnQueueTest, ALongCallMayEndAmongTheShortOnes) {
  const auto here = [] { return std::this_thread::get_id(); };
  std::vector<std::thread::id> threads;
  std::promise<void> done;
  add([&](TurnQueue::Call& call) {
    threads.push_back(here());
    if (threads.size() == 4) return done.set_value();
    call.is_long = threads.size() < 3;
    throw TurnQueue::NextTurn();
  });
  valueOf(done.get_future());
  EXPECT_EQ(threads[0], threads[3]);
  EXPECT_EQ(threads[1], threads[2]);
  EXPECT_NE(threads[0], threads[1]);
}

/// Its state is freed where it was made.
TEST_F(TurnQueueTest, WhyALongCallFailedIsAnsweredAmongTheShortOnes) {
  std::vector<std::thread::id> turns;
  std::promise<std::string> answer;
  std::thread::id freed;
  add([&](TurnQueue::Call& call) {
    turns.push_back(std::this_thread::get_id());
    if (call.isNew()) {
      call.is_long = true;
      throw TurnQueue::NextTurn();
    }
    try {
      queue_.answer(call, [&] {
        call.state = {&turns, [&](void*) { freed = std::this_thread::get_id(); }};
        throw std::runtime_error("why");
      });
    } catch (const std::exception& error) {
      answer.set_value(error.what());
    }
  });
  EXPECT_EQ(valueOf(answer.get_future()), "why");
  ASSERT_EQ(turns.size(), 3u);
  EXPECT_EQ(turns[2], turns[0]);
  EXPECT_NE(turns[1], turns[0]);
  EXPECT_EQ(freed, turns[1]);
}

TEST_F(TurnQueueTest, WhyALongCallFailedIsAnsweredAtOnceAtTheEnd) {
  std::promise<std::string> answer;
  std::atomic<bool> is_held{true};
  add([&](TurnQueue::Call& call) {
    if (call.isNew()) {
      call.is_long = true;
      throw TurnQueue::NextTurn();
    }
    becomesTrue([&] { return !is_held; });
    try {
      queue_.answer(call, [] { throw std::runtime_error("it stops"); });
    } catch (const std::exception& error) {
      answer.set_value(error.what());
    }
  });
  drainOne(short_);
  short_.stop();
  is_held = false;
  EXPECT_EQ(valueOf(answer.get_future()), "it stops");
}

TEST_F(TurnQueueTest, ACallWhoseClientIsGoneGetsNoFurtherTurn) {
  std::atomic<bool> is_gone{false};
  std::promise<void> second;
  std::weak_ptr<void> state;
  add(
      [&](TurnQueue::Call& call) {
        if (call.state) {
          second.set_value();
          is_gone = true;
        } else {
          state = call.state = std::make_shared<int>(0);
        }
        throw TurnQueue::NextTurn();
      },
      0, [&] { return is_gone.load(); });
  valueOf(second.get_future());
  drain();
  EXPECT_TRUE(state.expired());
}

TEST_F(TurnQueueTest, TimeCountsFromTheArrival) {
  Gate gate(long_);
  const auto before = std::chrono::steady_clock::now();
  std::vector<std::chrono::steady_clock::time_point> arrivals;
  add([&](TurnQueue::Call& call) {
    arrivals.push_back(call.arrival);
    call.is_long = true;
    if (arrivals.size() < 3) throw TurnQueue::NextTurn();
  });
  const auto after = std::chrono::steady_clock::now();
  gate.open();
  drain();
  ASSERT_EQ(arrivals.size(), 3u);
  for (const auto& arrival : arrivals) {
    EXPECT_GE(arrival, before);
    EXPECT_LE(arrival, after);
  }
}

// Each time while some wait and one runs.
TEST_F(TurnQueueTest, AfterRemovingNoCallOfTheOwnerRuns) {
  for (int round = 0; round < 200; ++round) {
    std::atomic<bool> is_removed{false};
    std::atomic<int> turns{0};
    for (int i = 0; i < 3; ++i) {
      add(
          [&, count = 0](TurnQueue::Call& call) mutable {
            EXPECT_FALSE(is_removed);
            ++turns;
            call.is_long = ++count < 5;  // goes there once and comes back once
            throw TurnQueue::NextTurn();
          },
          7);
    }
    ASSERT_TRUE(becomesTrue([&] { return turns >= round % 20; }));
    queue_.removeByID(7);
    is_removed = true;
    drain();
  }
}

/// Beside a model without threads: each call gets its turns, until its client is gone.
TEST_F(TurnQueueTest, RandomCallsGetTheirTurns) {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    std::map<std::string, int> expected;
    std::map<std::string, int> left;  // looks at a client before it is gone
    done_.clear();
    for (int i = 0; i < 20; ++i) {
      const std::string name = std::to_string(i);
      const int turns = 1 + static_cast<int>(random() % 5);
      // The first look is on the worker for short calls.
      left[name] = random() % 3 == 0 ? static_cast<int>(random() % 5) : 100;
      expected[name] = std::min(turns, std::max(left[name] - 1, 0));
      int& looks = left[name];
      addLong(turns, name, 0, [&looks] { return looks-- <= 0; });
    }
    drain();
    std::map<std::string, int> found;
    for (const auto& [name, turns] : expected)
      found[name] = 0;
    for (const std::string& name : done_)
      ++found[name];
    ASSERT_EQ(found, expected) << round;
  }
}

}  // namespace
}  // namespace link_bounds

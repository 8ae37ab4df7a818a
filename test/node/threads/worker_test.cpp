// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The newest work of a key, in order; bounds, cancelling, and who frees a value.
#include "node/threads/worker.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/time.h>

#include <atomic>
#include <cstdint>
#include <future>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "node/threads/queued_function.h"
#include "testing/patience.h"
#include "testing/worker_gate.h"
#include "world/log/guarded.h"

namespace link_bounds {
namespace {

/// Returns when everything posted before was done.
void drain(Worker& worker) {
  std::promise<void> done;
  worker.post("drain", [&done] { done.set_value(); });
  valueOf(done.get_future());
}

TEST(Worker, DoesTheNewestOfEachKeyInTheOrderOfTheFirst) {
  Worker worker({"test"});
  Gate gate(worker);
  std::vector<std::string> done;
  for (const char* work : {"a1", "b1", "a2", "c1", "b2", "a3"})
    worker.post(std::string(work, 1), [&done, work] { done.push_back(work); });
  gate.open();
  drain(worker);
  EXPECT_EQ(done, (std::vector<std::string>{"a3", "b2", "c1"}));
}

TEST(Worker, ReplacesNoWorkWithoutKey) {
  Worker worker({"test"});
  Gate gate(worker);
  std::vector<int> done;
  for (int i = 0; i < 3; ++i)
    worker.post([&, i] {
      if (i == 0) worker.post([&done] { done.push_back(3); });
      EXPECT_FALSE(worker.isCancelled());
      done.push_back(i);
    });
  gate.open();
  drain(worker);
  drain(worker);  // the first one may have come before the last of the work
  EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3}));
}

/// What replaces other work has waited since that was posted.
TEST(Worker, TellsForHowLongWorkWaits) {
  Worker worker({"test"});
  drain(worker);
  worker.takeLongest();
  const auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] { return std::chrono::steady_clock::now() - begin; };
  Gate gate(worker);
  worker.post("a", [] {});
  ASSERT_TRUE(becomesTrue([&] { return passed() > std::chrono::milliseconds(20); }));
  worker.post("a", [] {});
  EXPECT_GE(worker.takeLongest(), std::chrono::milliseconds(15)) << "while it waits";
  gate.open();
  drain(worker);
  const auto longest = worker.takeLongest();
  EXPECT_GE(longest, std::chrono::milliseconds(15)) << "after it is done";
  EXPECT_LE(longest, passed());
  EXPECT_LT(worker.takeLongest(), longest) << "each call begins anew";
}

TEST(Worker, DoesUrgentWorkFirst) {
  Worker worker({"test"});
  Gate gate(worker);
  std::vector<int> done;
  worker.post("a", [&] { done.push_back(3); });
  enqueue(worker, [&] { done.push_back(1); });
  enqueue(worker, [&] { done.push_back(2); });
  gate.open();
  drain(worker);
  EXPECT_EQ(done, (std::vector<int>{1, 2, 3}));
}

/// Whoever passes on the boxes from which the work follows goes first.
TEST(Worker, BeginsLaterIfItIsNice) {
  std::promise<void> idle;
  Worker::Options nice{"test"};
  nice.is_nice = true;
  nice.on_tick = [&idle, is_first = true]() mutable {
    if (std::exchange(is_first, false)) idle.set_value();
    return false;
  };
  Worker worker(nice);
  valueOf(idle.get_future());
  const auto posted = std::chrono::steady_clock::now();
  std::promise<std::chrono::steady_clock::time_point> begun;
  worker.post("a", [&begun] { begun.set_value(std::chrono::steady_clock::now()); });
  EXPECT_GE(valueOf(begun.get_future()) - posted, std::chrono::milliseconds(1));
}

TEST(Worker, TellsRunningWorkThatNobodyWaitsForIt) {
  for (const bool is_replaced : {false, true}) {
    Worker worker({"test"});
    std::promise<void> begun;
    std::atomic<bool> is_told{false};
    worker.post("a", [&] {
      begun.set_value();
      is_told = becomesTrue([&] { return worker.isCancelled(); });
    });
    valueOf(begun.get_future());
    worker.post("b", [] {});
    worker.cancel("b");
    EXPECT_FALSE(worker.isCancelled());
    if (is_replaced) {
      worker.post("a", [] {});
    } else {
      worker.cancel("a");
    }
    drain(worker);
    EXPECT_TRUE(is_told);
    EXPECT_FALSE(worker.isCancelled());
  }
}

TEST(Worker, GoesOnAfterWorkThatThrows) {
  ros::Time::init();  // for the log
  const std::uint64_t before = unexpectedErrors();
  Worker worker({"test"});
  worker.post("a", [] { throw std::bad_alloc(); });
  enqueue(worker, [] { throw std::runtime_error("a test"); });
  drain(worker);
  EXPECT_EQ(unexpectedErrors(), before + 2);
}

/// Where it was freed.
struct Traced {
  explicit Traced(std::thread::id& thread) : freed_on(thread) {}
  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;
  ~Traced() { freed_on = std::this_thread::get_id(); }
  std::thread::id& freed_on;
};

TEST(Worker, OwnedValuesAreFreedOnItsThread) {
  std::thread::id freed, own;
  {
    Worker worker({"test"});
    worker.post("a", [&] { own = std::this_thread::get_id(); });
    auto value = worker.owned(std::make_shared<const Traced>(freed));
    auto copy = value;
    value.reset();
    drain(worker);
    EXPECT_EQ(freed, std::thread::id());
    copy.reset();
    drain(worker);
  }
  EXPECT_NE(own, std::thread::id());
  EXPECT_EQ(freed, own);
}

/// Callers that always wait for urgent work must not make the values pile up.
TEST(Worker, OwnedValuesAreFreedBeforeUrgentWorkThatWaits) {
  Worker worker({"test"});
  Gate gate(worker);
  std::thread::id freed, own;
  bool was_freed = false;
  enqueue(worker, [&] {
    own = std::this_thread::get_id();
    was_freed = freed == own;
  });
  worker.owned(std::make_shared<const Traced>(freed)).reset();
  gate.open();
  drain(worker);
  EXPECT_TRUE(was_freed);
}

TEST(Worker, OwnedValuesMayOutliveIt) {
  std::thread::id freed;
  std::shared_ptr<const Traced> value;
  {
    Worker worker({"test"});
    value = worker.owned(std::make_shared<const Traced>(freed));
  }
  EXPECT_EQ(freed, std::thread::id());
  value.reset();
  EXPECT_EQ(freed, std::this_thread::get_id());
}

TEST(Worker, AwaitsAnotherThreadPieceByPiece) {
  Worker worker({"test"});
  ros::CallbackQueue queue;
  int pieces = 0;
  std::promise<bool> answer;
  worker.post("a", [&] { answer.set_value(worker.await(queue, [&] { return ++pieces == 3; })); });
  auto result = answer.get_future();
  ASSERT_TRUE(becomesTrue([&] {
    queue.callOne(ros::WallDuration(0.001));
    return result.wait_for(std::chrono::milliseconds(0)) == std::future_status::ready;
  }));
  EXPECT_TRUE(result.get());
  EXPECT_EQ(pieces, 3);
}

TEST(Worker, AwaitingThrowsWhatThePieceThrows) {
  Worker worker({"test"});
  ros::CallbackQueue queue;
  std::promise<std::string> answer;
  worker.post("a", [&] {
    try {
      worker.await(queue, []() -> bool { throw std::runtime_error("no"); });
      answer.set_value("nothing");
    } catch (const std::exception& error) {
      answer.set_value(error.what());
    }
  });
  queue.callOne(ros::WallDuration(60));
  EXPECT_EQ(valueOf(answer.get_future()), "no");
}

TEST(Worker, StopEndsAwaitingAndThePieceIsNotCalledAnyMore) {
  ros::CallbackQueue queue;
  int pieces = 0;
  bool answer = true;
  {
    Worker worker({"test"});
    std::promise<void> begun;
    worker.post("a", [&] {
      begun.set_value();
      answer = worker.await(queue, [&] { return ++pieces > 0; });
    });
    valueOf(begun.get_future());
    worker.stop();
    worker.post("b", [] { ADD_FAILURE() << "it was stopped"; });
  }
  queue.callAvailable();
  EXPECT_FALSE(answer);
  EXPECT_EQ(pieces, 0);
}

TEST(Worker, StopDropsUrgentWorkThatWaits) {
  Worker::Options options{"test"};
  std::promise<void> begun;
  std::promise<const Worker*> made;
  options.on_tick = [&] {
    begun.set_value();
    const Worker* const worker = valueOf(made.get_future());
    becomesTrue([&] { return worker->isStopping(); });
    return false;
  };
  Worker worker(options);
  valueOf(begun.get_future());
  enqueue(worker, [] { ADD_FAILURE() << "it was stopped"; });
  made.set_value(&worker);
  worker.stop();
}

TEST(Worker, TicksWhileItIsWanted) {
  Worker::Options options{"test"};
  std::atomic<int> ticks{0};
  options.tick_period = std::chrono::milliseconds(1);
  options.on_tick = [&ticks] { return ++ticks < 3; };
  Worker worker(options);
  EXPECT_TRUE(becomesTrue([&] { return ticks >= 3; }));
  EXPECT_EQ(ticks, 3);
  drain(worker);  // wakes it up, after which it ticks again
  EXPECT_TRUE(becomesTrue([&] { return ticks >= 4; }));
}

TEST(Worker, TicksOnAfterATickThatThrows) {
  ros::Time::init();  // for the log
  Worker::Options options{"test"};
  std::atomic<int> ticks{0};
  options.tick_period = std::chrono::milliseconds(1);
  options.on_tick = [&ticks] {
    if (++ticks < 3) throw std::runtime_error("a test");
    return false;
  };
  Worker worker(options);
  EXPECT_TRUE(becomesTrue([&] { return ticks >= 3; }));
  EXPECT_EQ(ticks, 3);
}

TEST(Worker, RemovesTheCallbacksOfAnOwnerAndWaitsForTheOneThatRuns) {
  Worker worker({"test"});
  std::promise<void> begun, added;
  std::atomic<bool> is_done{false};
  boost::weak_ptr<QueuedFunction> waiting;
  worker.addCallback(boost::make_shared<QueuedFunction>([&] {
                       begun.set_value();
                       added.get_future().wait_for(deadline());
                       is_done = becomesTrue([&] { return waiting.expired(); });
                     }),
                     7);
  valueOf(begun.get_future());
  auto removed = boost::make_shared<QueuedFunction>([&] { ADD_FAILURE() << "was removed"; });
  waiting = removed;
  worker.addCallback(std::move(removed), 7);
  added.set_value();
  worker.removeByID(7);
  EXPECT_TRUE(is_done);
}

TEST(Worker, KeepsTheCallbacksOfOtherOwners) {
  Worker worker({"test"});
  Gate gate(worker);
  int others = 0;
  for (const std::uint64_t owner : {8u, 7u, 8u})
    worker.addCallback(boost::make_shared<QueuedFunction>([&, owner] {
                         EXPECT_EQ(owner, 8u);
                         ++others;
                       }),
                       owner);
  worker.removeByID(7);
  gate.open();
  drain(worker);
  EXPECT_EQ(others, 2);
}

TEST(Worker, ARemovedCallbackThatRunsIsNotTriedAgain) {
  Worker worker({"test"});
  class Trier : public ros::CallbackInterface {
   public:
    CallResult call() override {
      ++calls;
      return TryAgain;
    }
    std::atomic<int> calls{0};
  };
  const auto trier = boost::make_shared<Trier>();
  for (int round = 1; round <= 200; ++round) {
    const int calls = trier->calls;
    worker.addCallback(trier, 7);
    ASSERT_TRUE(becomesTrue([&] { return trier->calls >= calls + round % 20; }));
    worker.removeByID(7);
    const int removed = trier->calls;
    drain(worker);
    EXPECT_EQ(trier->calls, removed);
  }
}

TEST(Worker, AwaitsNoLongerThanTheDeadline) {
  Worker worker({"test"});
  ros::CallbackQueue queue;
  int pieces = 0;
  std::promise<bool> answer;
  worker.post("a", [&] {
    answer.set_value(worker.await(
        queue, [&] { return ++pieces > 0; }, std::chrono::steady_clock::now()));
  });
  EXPECT_FALSE(valueOf(answer.get_future()));
  queue.callAvailable();
  EXPECT_EQ(pieces, 0);
}

/// Beside a model without threads.
TEST(Worker, RandomPostsAndCancelsAreDoneAsAMapSays) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    Worker worker({"test"});
    Gate gate(worker);
    std::vector<std::pair<std::string, int>> done;
    std::map<std::string, int> expected;  // of each key
    for (int i = 0; i < 40; ++i) {
      const std::string key(1, static_cast<char>('a' + random() % 6));
      if (random() % 4 == 0) {
        worker.cancel(key);
        expected.erase(key);
        continue;
      }
      worker.post(key, [&done, key, i] { done.push_back({key, i}); });
      expected[key] = i;
    }
    gate.open();
    drain(worker);
    ASSERT_EQ(done.size(), expected.size());
    for (const auto& [key, i] : done)
      ASSERT_EQ(expected[key], i);
  }
}

}  // namespace
}  // namespace link_bounds

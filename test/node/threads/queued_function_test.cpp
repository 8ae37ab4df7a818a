// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// What a function throws does not reach the thread that serves the queue.
#include "node/threads/queued_function.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/time.h>

#include <new>

namespace link_bounds {
namespace {

TEST(QueuedFunctions, OneThatThrowsStopsNeitherTheQueueNorTheNextOne) {
  ros::Time::init();  // for the log
  ros::CallbackQueue queue;
  int calls = 0;
  queue.addCallback(boost::make_shared<QueuedFunction>([] { throw std::bad_alloc(); }));
  queue.addCallback(boost::make_shared<QueuedFunction>([&calls] { ++calls; }));
  EXPECT_NO_THROW(queue.callAvailable());
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(queue.isEmpty());
}

}  // namespace
}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// A piece of a copy runs between two callbacks of the update thread, which then go first.
#include "node/history/history_thread.h"

#include <ros/init.h>

#include <future>
#include <utility>

#include "node/threads/be_nice.h"
#include "node/threads/queued_function.h"
#include "node/threads/start_thread.h"

namespace link_bounds {
namespace {

/// About as long as one update of 200 links.
constexpr std::chrono::microseconds kPiece(50);
constexpr std::chrono::milliseconds kPollPeriod(20);
const ros::WallDuration kQueuePeriod(10.0);  // a request or the end wakes the thread

/// Most copies are made before a sleeping thread would wake up: without this a request for 50 links
/// takes 1.2 times as long (`scripts/bench get-boxes`).
constexpr std::chrono::microseconds kAwake(200);

template <class Test>
void yieldWhile(Test test) {
  const auto end = std::chrono::steady_clock::now() + kAwake;
  while (test() && std::chrono::steady_clock::now() < end)
    std::this_thread::yield();
}

}  // namespace

struct HistoryThread::Job {
  std::unique_ptr<SceneCopy> copy;
  std::promise<std::unique_ptr<PastScene>> result;
};

HistoryThread::HistoryThread(const Scene& scene, Guard guard)
    : scene_(scene), guard_(std::move(guard)), thread_(startThread("history", [this] { run(); })) {}

void HistoryThread::run() {
  beNice();
  while (!isStopping())
    queue_.callAvailable(kQueuePeriod);
}

void HistoryThread::adopt(std::shared_ptr<const Model> model) {
  const std::lock_guard<std::mutex> lock(mutex_);
  model_ = std::move(model);
}

std::shared_ptr<const Model> HistoryThread::model() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return model_;
}

std::unique_ptr<PastScene> HistoryThread::copy(const BoxRequest& request) {
  const auto job = std::make_shared<Job>();
  job->copy = std::make_unique<SceneCopy>(request, model());
  auto result = job->result.get_future();
  enqueuePiece(job);
  yieldWhile([&] { return result.wait_for(std::chrono::seconds(0)) != std::future_status::ready; });
  while (result.wait_for(kPollPeriod) != std::future_status::ready) {
    if (isStopping()) return nullptr;
  }
  return result.get();
}

void HistoryThread::enqueuePiece(std::shared_ptr<Job> job) {
  enqueue(*ros::getGlobalCallbackQueue(),
          [this, job = std::move(job)] { guard_([&] { copyPiece(job); }); });
}

/// The copy goes back with the result: freeing the last reference to a model takes long and is not
/// for the update thread.
void HistoryThread::copyPiece(const std::shared_ptr<Job>& job) {
  try {
    if (!job->copy->proceed(scene_, ros::Time::now(), kPiece)) return enqueuePiece(job);
    job->result.set_value(job->copy->take());
  } catch (...) {
    job->result.set_exception(std::current_exception());
  }
}

/// While roscpp shuts down, ros::ok() is still true, and it waits for services that work.
bool HistoryThread::isStopping() const {
  return stops_ || ros::isShuttingDown() || !ros::ok();
}

void HistoryThread::stop() {
  stops_ = true;
  queue_.disable();
  if (thread_.joinable()) thread_.join();
}

}  // namespace link_bounds

// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// No lock is needed: the loader thread waits while the update thread uses the members.
#include "node/loading/model_hand_over.h"

#include <chrono>
#include <future>

#include "node/log/guarded.h"
#include "node/threads/queued_function.h"

namespace link_bounds {
namespace {

constexpr std::chrono::milliseconds kPollPeriod(20);  // how late a cancellation is noticed

}  // namespace

ModelHandOver::ModelHandOver(ros::CallbackQueueInterface& queue,
                             std::function<void(ModelPtr)> adopt)
    : queue_(queue), adopt_(std::move(adopt)) {}

bool ModelHandOver::give(ModelPtr model, const std::function<bool()>& is_cancelled) {
  if (next_) return false;
  next_ = std::move(model);
  const auto task = std::make_shared<std::packaged_task<void()>>([this] { adoptNext(); });
  std::future<void> is_adopted = task->get_future();
  enqueue(queue_, [task] { (*task)(); });
  while (is_adopted.wait_for(kPollPeriod) != std::future_status::ready) {
    if (is_cancelled()) return false;
  }
  const ModelPtr given = std::exchange(next_, nullptr);
  is_adopted.get();
  in_use_ = given;
  return true;
}

void ModelHandOver::adoptNext() {
  try {
    adopt_(next_);
  } catch (...) {
    if (in_use_) guarded([this] { adopt_(in_use_); });
    throw;
  }
}

}  // namespace link_bounds

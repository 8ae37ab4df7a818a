// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Pairs without a verdict go first, then those that have had fewer turns.
#include "robot/pairs/pair_queue.h"

#include <algorithm>
#include <tuple>

#include "robot/threads/row_threads.h"

namespace link_bounds {
namespace {

/// Slices of work in the first turn of a pair. Most pairs need one turn.
constexpr std::size_t kFirstTurn = 24;

}  // namespace

bool PairQueue::IsLater::operator()(const Task* a, const Task* b) const {
  return std::tie(a->is_decided, a->turns, a->pair) > std::tie(b->is_decided, b->turns, b->pair);
}

PairQueue::PairQueue(const std::vector<std::size_t>& pairs, PairWork work,
                     const ProofControl& control)
    : work_(std::move(work)), control_(control), tasks_(pairs.size()) {
  std::vector<Task*> waiting;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    tasks_[i].pair = pairs[i];
    waiting.push_back(&tasks_[i]);
  }
  waiting_ = decltype(waiting_)(IsLater(), std::move(waiting));
}

void PairQueue::run() {
  const unsigned wanted = control_.threads > 0 ? control_.threads : coreCount();
  const auto threads = static_cast<unsigned>(std::min<std::size_t>(wanted, tasks_.size()));
  forRows(0, threads, threads, 1, [this](unsigned, std::size_t, std::size_t) { work(); });
  for (Task& task : tasks_) {
    if (task.search) store(task);
    task.search = nullptr;
  }
}

/// The loop of each thread.
void PairQueue::work() {
  while (Task* task = take()) {
    if (!task->search) task->search = work_.begin(task->pair);
    if (!task->search) continue;
    advance(*task);
    giveBack(*task);
  }
}

/// The next task; null if none is waiting or the control says that it is over.
PairQueue::Task* PairQueue::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (control_.is_over() || waiting_.empty()) return nullptr;
  Task* task = waiting_.top();
  waiting_.pop();
  if (task->search) kept_bytes_ -= task->search->bytes();
  return task;
}

/// Works until the turn is over or the pair becomes decided. After a collision it goes on, because
/// such a search is done after its next slice.
void PairQueue::advance(Task& task) const {
  PairSearch& search = *task.search;
  const std::size_t end = search.slices() + (kFirstTurn << task.turns);
  do {
    search.advance();
  } while (!search.isDone() && (task.is_decided || !search.isDecided() || search.collides()) &&
           search.slices() < end && !control_.is_over());
  ++task.turns;
}

void PairQueue::giveBack(Task& task) {
  const bool is_done = task.search->isDone();
  const std::size_t bytes = task.search->bytes();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    note(task);
    if (!is_done && kept_bytes_ + bytes <= control_.max_kept_bytes) {
      kept_bytes_ += bytes;
      return waiting_.push(&task);
    }
  }
  store(task);
  task.search = nullptr;
  if (is_done) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_.push(&task);
}

void PairQueue::note(Task& task) {
  if (task.is_decided || !task.search->isDecided()) return;
  task.is_decided = true;
  ++decided_;
  if (control_.progress) control_.progress(decided_, tasks_.size());
}

/// A search that began again repeats the same work. It is not stored until it has done as much as
/// the stored one.
void PairQueue::store(Task& task) const {
  if (task.search->slices() < task.stored_slices) return;
  task.stored_slices = task.search->slices();
  work_.store(task.pair, *task.search);
}

}  // namespace link_bounds
